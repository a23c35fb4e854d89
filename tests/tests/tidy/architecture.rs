//! ARCHITECTURE.md names what is there.

use std::collections::BTreeSet;

use super::{expect_none, fs, source};

fn text() -> String {
    fs::read_to_string(source::root().join("ARCHITECTURE.md"))
        .unwrap_or_else(|error| panic!("ARCHITECTURE.md in the top folder: {error}"))
}

#[test]
fn it_names_every_crate() {
    let text = text();
    let mut crates = BTreeSet::new();
    for file in source::rust_files() {
        if let Some(("crates", inside)) = file.path.split_once('/') {
            let (name, _) = inside.split_once('/').unwrap();
            crates.insert(name.to_owned());
        }
    }
    let complaints: Vec<String> = crates
        .iter()
        .filter(|name| !text.contains(name.as_str()))
        .map(|name| format!("ARCHITECTURE.md does not name {name}"))
        .collect();
    expect_none(&complaints);
}

/// Paths that it names in backquotes, where they look like one of ours.
#[test]
fn every_path_that_it_names_is_there() {
    let text = text();
    let mut complaints = Vec::new();
    for named in text.split('`').skip(1).step_by(2) {
        let is_path = named.contains('/') && !named.contains(' ') && !named.contains('*');
        let begins = [
            "giveway-", "tests/", "static/", "scripts/", "docs/", "web/", "crates/",
        ];
        if !is_path || !begins.iter().any(|begin| named.starts_with(begin)) {
            continue;
        }
        let here = source::root().join(named);
        let in_crates = source::root().join("crates").join(named);
        if !here.exists() && !in_crates.exists() {
            complaints.push(format!("ARCHITECTURE.md names {named}, which is not there"));
        }
    }
    expect_none(&complaints);
}
