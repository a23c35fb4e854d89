//! The worker's part of the Wasm: solves what the page asks for.

fn main() {}
