//! The solver's Wasm: what a worker of the page runs.
//!
//! A program of its own, so that the page is painted and moves before the
//! search, the explanations and the checker of proofs have come over the
//! network, and so that these may be built for speed.

fn main() {
    giveway_wasm::serve_messages();
}
