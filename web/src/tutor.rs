//! The course's Wasm: its contents, its lessons, its glossary.
//!
//! A program of its own, loaded when somebody opens the course: a page on which
//! nobody does weighs no more.

fn main() {
    giveway_web::course::mount();
}
