//! The invariants of the architecture and the rules of the house, as tests.
//!
//! Most are absences: what a crate or a folder does not name.
#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    clippy::panic,
    reason = "a test that cannot go on ends with a panic"
)]

mod architecture;
mod files;
mod layers;

use std::fs;

use giveway_tests::source::{self, File};

/// Fails with all complaints at once.
#[track_caller]
fn expect_none(complaints: &[String]) {
    assert!(complaints.is_empty(), "\n{}", complaints.join("\n"));
}

/// The sources under one of the folders.
fn under<'a>(files: &'a [File], folder: &'a str) -> impl Iterator<Item = &'a File> {
    files
        .iter()
        .filter(move |file| file.path.starts_with(folder))
}

/// Every use of one of the paths under a folder, but for some places.
fn uses(folder: &str, but_for: &[&str], paths: &[&str]) -> Vec<String> {
    let files = source::rust_files();
    let mut complaints = Vec::new();
    let mut seen = 0;
    for file in under(&files, folder) {
        seen += 1;
        if but_for.iter().any(|place| file.path.starts_with(place)) {
            continue;
        }
        for used in source::paths(file) {
            for path in paths.iter().filter(|path| used.contains(path)) {
                let line = used.line;
                complaints.push(format!("{}:{line} names {path}", file.path));
            }
        }
    }
    assert!(seen > 0, "there is no {folder}");
    complaints.dedup();
    complaints
}

/// What only a page in a browser has.
const BROWSER: &[&str] = &["web_sys", "js_sys", "wasm_bindgen", "gloo", "yew"];
