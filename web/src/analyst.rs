//! The analyst's Wasm: the solver with all that it can answer.
//!
//! A program of its own, loaded when a question is asked first: a first visit
//! need not wait for the explanations, the checker of proofs, and the planners
//! of the textbook.

fn main() {
    giveway_wasm::serve_messages();
}
