//! The page's examples are listed, can be read, and fit the page.

#![allow(
    clippy::unwrap_used,
    reason = "a test that cannot go on ends with a panic"
)]

use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};

use expect_test::expect_file;
use giveway_model::Scene;
use giveway_model::format::native;
use giveway_page::{Draft, State, examples, link};
use serde::Deserialize;

/// An example, as its list for people has it.
#[derive(Deserialize)]
struct Listed {
    file: String,
    title: String,
    line: String,
    #[serde(default)]
    group: String,
}

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../static/examples")
}

fn text(name: &str) -> String {
    fs::read_to_string(folder().join(name)).unwrap()
}

fn listed() -> Vec<Listed> {
    serde_json::from_str(&text("index.json")).unwrap()
}

fn scene(example: &Listed) -> Scene {
    let instance = native::read_instance(&text(&example.file)).unwrap();
    instance.to_scene()
}

#[test]
fn every_example_can_be_opened() {
    let examples = listed();
    assert!(examples.len() > 3);
    for example in &examples {
        assert!(Draft::new(scene(example)).is_ok(), "{}", example.file);
        assert!(!example.title.is_empty() && example.line.ends_with('.'));
    }
    let files = fs::read_dir(folder()).unwrap();
    let scenes = files.filter(|file| {
        let path = file.as_ref().unwrap().path();
        path.extension()
            .is_some_and(|extension| extension == "json")
            && !path.ends_with("index.json")
    });
    assert_eq!(scenes.count(), examples.len(), "each is listed");
}

/// `UPDATE_EXPECT=1` writes the page's list anew.
#[test]
fn the_list_of_the_page_has_the_same_scenes() {
    let mut list = String::new();
    let mut group = String::new();
    for example in listed() {
        if example.group != group {
            group.clone_from(&example.group);
            // Writing to a string cannot fail.
            let _ = writeln!(list, "# {group}");
        }
        let state = State::new(Draft::new(scene(&example)).unwrap());
        let link = link::write(&state);
        let _ = writeln!(list, "{}\n{}\n{link}", example.title, example.line);
    }
    expect_file![folder().join("examples.txt")].assert_eq(&list);
    let read = examples::read(&list).unwrap();
    for (example, listed) in read.iter().zip(listed()) {
        assert_eq!(example.scene().unwrap(), scene(&listed), "{}", listed.file);
        assert_eq!(example.group, listed.group, "{}", listed.file);
    }
}
