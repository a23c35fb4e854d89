//! `docs/code-map.md` is what the sources say.
#![allow(
    clippy::unwrap_used,
    reason = "a test that cannot go on ends with a panic"
)]

use std::{env, fs};

use giveway_tests::{code_map::code_map, source};

#[test]
fn the_code_map_is_current() {
    let path = source::root().join("docs/code-map.md");
    let map = code_map();
    if env::var_os("GIVEWAY_UPDATE").is_some() {
        fs::write(&path, &map).unwrap();
    }
    let written = fs::read_to_string(&path).unwrap_or_default();
    assert!(
        written == map,
        "docs/code-map.md is not current: GIVEWAY_UPDATE=1 cargo test -p giveway-tests --test code_map"
    );
}

#[test]
fn every_folder_says_what_it_is() {
    // Each file in a folder of tests is a program of its own: no module says what they are together.
    let is_told =
        |line: &str| line.contains("/`: ") || line.contains("tests/") || line.contains("`.`");
    let folders = code_map();
    let folders = folders
        .lines()
        .filter(|line| line.trim_start().starts_with("- `"));
    let silent: Vec<&str> = folders.filter(|line| !is_told(line)).collect();
    assert!(
        silent.is_empty(),
        "no first sentence:\n{}",
        silent.join("\n")
    );
}
