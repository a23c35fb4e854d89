//! The solver's Wasm: what a worker of the page runs at first.
//!
//! A program of its own, so that the page is painted and moves before the search
//! has come over the network, and so that the search may be built for speed. It
//! finds plans and follows changes; all else the analyst does.

fn main() {
    giveway_wasm::serve_basic_messages();
}
