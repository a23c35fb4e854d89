//! The command `giveway`.

fn main() {}
