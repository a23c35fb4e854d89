//! The components in a browser: `wasm-pack test --headless --chrome web`.
#![cfg(target_arch = "wasm32")]
#![allow(
    clippy::expect_used,
    clippy::panic,
    reason = "a test that cannot go on fails"
)]
#![allow(
    clippy::disallowed_methods,
    reason = "what a test notes is borrowed for no longer than a line"
)]

mod app;
mod board;
mod dock;
mod inspector;
mod stage;

wasm_bindgen_test::wasm_bindgen_test_configure!(run_in_browser);
