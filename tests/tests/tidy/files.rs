//! The files of the project: length, names, words.

use super::{expect_none, source};

#[test]
fn every_source_begins_with_what_it_is() {
    let files = source::rust_files();
    let silent = files.iter().filter(|file| !file.text.starts_with("//! "));
    let complaints: Vec<String> = silent
        .map(|file| format!("{} does not begin with //!", file.path))
        .collect();
    expect_none(&complaints);
}

/// From here on a file should be divided, lines.
const LONG: usize = 400;
/// No file is longer, lines.
const TOO_LONG: usize = 600;

#[test]
fn no_source_is_too_long() {
    let mut complaints = Vec::new();
    for file in source::rust_files() {
        let lines = file.text.lines().count();
        if file.path.contains("tests/") {
            continue;
        }
        if lines > LONG {
            println!("{} has {lines} lines, more than {LONG}", file.path);
        }
        if lines > TOO_LONG {
            let path = file.path;
            complaints.push(format!("{path} has {lines} lines, more than {TOO_LONG}"));
        }
    }
    expect_none(&complaints);
}

/// The page: its state, its components, its style sheets.
const PAGE: [&str; 4] = [
    "crates/giveway-page/",
    "crates/giveway-course/src/",
    "web/",
    "static/css/",
];
/// No file of the page is longer, lines in all: comments and tests, too.
const TOO_LONG_FOR_THE_PAGE: usize = 300;

#[test]
fn no_file_of_the_page_is_too_long() {
    let mut complaints = Vec::new();
    for place in PAGE {
        let files = source::files(place.trim_end_matches('/'));
        let mut seen = 0;
        for file in files {
            let end = file.path.rsplit('.').next();
            if !matches!(end, Some("rs" | "css")) {
                continue;
            }
            seen += 1;
            let lines = file.text.lines().count();
            if lines > TOO_LONG_FOR_THE_PAGE {
                let path = file.path;
                complaints.push(format!(
                    "{path} has {lines} lines, more than {TOO_LONG_FOR_THE_PAGE}"
                ));
            }
        }
        assert!(seen > 10, "there is little in {place}");
    }
    expect_none(&complaints);
}

#[test]
fn no_line_ends_in_a_blank_or_has_a_tab() {
    let mut complaints = Vec::new();
    for file in source::rust_files() {
        for (number, line) in (1..).zip(file.text.lines()) {
            if line.ends_with(char::is_whitespace) || line.contains('\t') {
                complaints.push(format!("{}:{number}", file.path));
            }
        }
    }
    expect_none(&complaints);
}

#[test]
fn every_exception_to_a_lint_has_a_reason() {
    let mut complaints = Vec::new();
    for file in source::rust_files() {
        for name in ["allow", "expect"] {
            for (line, arguments) in source::attributes(&file, name) {
                if !arguments.to_string().contains("reason =") {
                    complaints.push(format!("{}:{line} has no reason", file.path));
                }
            }
        }
    }
    for file in source::files("") {
        if file.path.ends_with("Cargo.toml") {
            for (number, line) in (1..).zip(file.text.lines()) {
                if line.contains("\"allow\"") && !line.contains('#') {
                    complaints.push(format!("{}:{number} has no reason", file.path));
                }
            }
        }
    }
    expect_none(&complaints);
}

#[test]
fn no_file_names_a_folder_of_one_machine() {
    // Put together here, so that this file does not name them itself.
    let folders = ["work", "root", "home", "Users"].map(|name| format!("/{name}/"));
    let mut complaints = Vec::new();
    for file in source::files("") {
        for (number, line) in (1..).zip(file.text.lines()) {
            let named = |folder: &String| {
                let mut places = line.match_indices(folder.as_str());
                // Inside an address or a longer path it is none.
                places
                    .any(|(at, _)| !line[..at].ends_with(|c: char| c.is_alphanumeric() || c == '.'))
            };
            if folders.iter().any(named) {
                complaints.push(format!("{}:{number} {line}", file.path));
            }
        }
    }
    expect_none(&complaints);
}

#[test]
fn every_package_comes_from_the_public_registry() {
    let lock = source::files("");
    let lock = lock.iter().find(|file| file.path == "Cargo.lock").unwrap();
    let public = "source = \"registry+https://github.com/rust-lang/crates.io-index\"";
    let sources = lock.text.lines().filter(|line| line.starts_with("source"));
    let complaints: Vec<String> = sources
        .filter(|line| *line != public)
        .map(str::to_owned)
        .collect();
    expect_none(&complaints);
}
