//! The worker's part of the Wasm: solves what the page asks for.

fn main() {
    giveway_wasm::serve_messages();
}
