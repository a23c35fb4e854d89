//! `docs/code-map.md`, written from the sources: every folder with the first sentence of
//! its module and the names of its files.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use crate::source::{self, File};

/// What stands before the map.
const HEAD: &str = "# Code map

Every folder of Rust sources, with what it is and the files in it. It is written from the first sentences of the
sources: `GIVEWAY_UPDATE=1 cargo test -p giveway-tests --test code_map`. [ARCHITECTURE.md](../ARCHITECTURE.md) says how
the parts work together.
";

/// A folder of sources.
#[derive(Default)]
struct Folder {
    /// The first sentence of its module.
    sentence: String,
    /// Its files, without the one that is the module.
    files: Vec<String>,
}

/// The text of the map for the sources as they are.
pub fn code_map() -> String {
    let mut folders: BTreeMap<String, Folder> = BTreeMap::new();
    let files = source::rust_files();
    for file in &files {
        let (folder, name) = split(&file.path);
        folders.entry(folder.to_owned()).or_default();
        if let Some(module) = module_of(folder, name) {
            folders.entry(module).or_default().sentence = first_sentence(file);
        } else {
            let stem = name.trim_end_matches(".rs").to_owned();
            folders
                .entry(folder.to_owned())
                .or_default()
                .files
                .push(stem);
        }
    }
    folders.retain(|_, folder| !folder.files.is_empty() || !folder.sentence.is_empty());
    // The module of a folder may stand beside it: it is then the folder's, and no file of its own.
    let names: Vec<String> = folders.keys().cloned().collect();
    for name in names {
        let (parent, last) = split(&name);
        let beside = files.iter().find(|file| file.path == format!("{name}.rs"));
        if let (Some(file), Some(above)) = (beside, folders.get_mut(parent)) {
            above.files.retain(|stem| stem != last);
            let sentence = first_sentence(file);
            if let Some(folder) = folders.get_mut(&name) {
                folder.sentence = sentence;
            }
        }
    }
    written(&folders)
}

fn split(path: &str) -> (&str, &str) {
    path.rsplit_once('/').unwrap_or(("", path))
}

/// The folder whose module a file is.
fn module_of(folder: &str, name: &str) -> Option<String> {
    let is_module =
        matches!(name, "mod.rs" | "lib.rs") || (name == "main.rs" && !folder.ends_with("/bin"));
    is_module.then(|| folder.to_owned())
}

/// The first sentence of a source's documentation, on one line.
fn first_sentence(file: &File) -> String {
    let lines = file.text.lines().map_while(|line| line.strip_prefix("//!"));
    let text = lines.map(str::trim).take_while(|line| !line.is_empty());
    let text = text.collect::<Vec<_>>().join(" ");
    match text.find(". ") {
        Some(end) => text[..=end].to_owned(),
        None => text,
    }
}

fn written(folders: &BTreeMap<String, Folder>) -> String {
    let mut text = HEAD.to_owned();
    let mut package = "";
    for (path, folder) in folders {
        let here = package_of(path);
        if here != package {
            package = here;
            let _ = write!(text, "\n## `{package}/`\n\n");
        }
        let inside = path[package.len()..].trim_start_matches('/');
        let place = if inside.is_empty() {
            String::from("`.`")
        } else {
            format!("`{inside}/`")
        };
        let depth = inside.matches('/').count();
        let indent = "  ".repeat(depth);
        let _ = write!(text, "{indent}- {place}");
        if !folder.sentence.is_empty() {
            let _ = write!(text, ": {}", folder.sentence);
        }
        if !folder.files.is_empty() {
            let files: Vec<String> = folder
                .files
                .iter()
                .map(|stem| format!("`{stem}`"))
                .collect();
            let _ = write!(text, " ({})", files.join(", "));
        }
        text.push('\n');
    }
    text
}

/// The folder of the package that holds a path.
fn package_of(path: &str) -> &str {
    let names = if path.starts_with("crates/") { 2 } else { 1 };
    let end = path
        .match_indices('/')
        .nth(names - 1)
        .map_or(path.len(), |(at, _)| at);
    &path[..end]
}
