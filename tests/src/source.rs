//! The sources of the workspace, as the tests of tidiness read them.

use std::fs;
use std::path::{Path, PathBuf};

use proc_macro2::{Delimiter, Group, TokenStream, TokenTree};

/// The folder of the workspace.
pub fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// A text file of the workspace.
#[derive(Clone, Debug)]
pub struct File {
    /// Its path from the folder of the workspace, with `/` between the names.
    pub path: String,
    /// Its text.
    pub text: String,
}

/// Folders that hold nothing written by hand.
const SKIPPED: &[&str] = &["target", "dist", "node_modules"];

/// Every text file under a folder of the workspace, sorted; hidden folders and
/// build products are left out.
pub fn files(folder: &str) -> Vec<File> {
    let mut found = Vec::new();
    collect(&root().join(folder), folder, &mut found);
    found
}

/// Every Rust file of the workspace.
pub fn rust_files() -> Vec<File> {
    let mut found = files("");
    found.retain(|file| {
        Path::new(&file.path)
            .extension()
            .is_some_and(|end| end == "rs")
    });
    assert!(found.len() > 10, "the sources were not found");
    found
}

fn collect(folder: &Path, name: &str, found: &mut Vec<File>) {
    let Ok(entries) = fs::read_dir(folder) else {
        return;
    };
    let mut paths: Vec<PathBuf> = entries.map(|entry| entry.unwrap().path()).collect();
    paths.sort();
    for path in paths {
        let last = path.file_name().unwrap().to_str().unwrap().to_owned();
        let path_here = [name, &last].join("/");
        let path_here = path_here.trim_start_matches('/');
        if path.is_dir() {
            if !last.starts_with('.') && !SKIPPED.contains(&last.as_str()) {
                collect(&path, path_here, found);
            }
        } else if let Ok(text) = fs::read_to_string(&path) {
            let path = path_here.to_owned();
            found.push(File { path, text });
        }
    }
}

/// A path such as `std::fs::read` as it is used in a source.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Used {
    /// The names between the `::`.
    pub names: Vec<String>,
    /// The line, from 1.
    pub line: usize,
}

impl Used {
    /// Whether `names`, separated by `::`, stand in the path one after another.
    pub fn contains(&self, names: &str) -> bool {
        let wanted: Vec<&str> = names.split("::").collect();
        self.names.windows(wanted.len()).any(|part| part == wanted)
    }
}

/// The tokens of a source, without comments.
pub fn tokens(file: &File) -> TokenStream {
    file.text
        .parse()
        .unwrap_or_else(|error| panic!("{}: {error}", file.path))
}

/// Every path that a source uses, `use` trees spelt out; comments and texts are
/// none.
pub fn paths(file: &File) -> Vec<Used> {
    let mut found = Vec::new();
    collect_paths(tokens(file), &[], &mut found);
    found
}

fn collect_paths(tokens: TokenStream, before: &[String], found: &mut Vec<Used>) {
    let mut path = before.to_vec();
    let mut colons = if before.is_empty() { 0 } else { 2 };
    for token in tokens {
        match token {
            TokenTree::Punct(p) if p.as_char() == ':' => colons += 1,
            TokenTree::Ident(name) => {
                if colons != 2 {
                    path.clear();
                }
                path.push(name.to_string());
                colons = 0;
                let line = name.span().start().line;
                let names = path.clone();
                found.push(Used { names, line });
            }
            TokenTree::Group(group) => {
                let in_tree = colons == 2 && group.delimiter() == Delimiter::Brace;
                let inner = if in_tree { path.as_slice() } else { &[] };
                collect_paths(group.stream(), inner, found);
                path.clear();
                colons = 0;
            }
            TokenTree::Punct(p) if p.as_char() == ',' => {
                path = before.to_vec();
                colons = if before.is_empty() { 0 } else { 2 };
            }
            TokenTree::Punct(_) | TokenTree::Literal(_) => {
                path.clear();
                colons = 0;
            }
        }
    }
}

/// The attributes `#[name(...)]` and `#![name(...)]` of a source: the line and
/// the tokens in the parentheses.
pub fn attributes(file: &File, name: &str) -> Vec<(usize, TokenStream)> {
    let mut found = Vec::new();
    collect_attributes(tokens(file), name, &mut found);
    found
}

fn collect_attributes(tokens: TokenStream, name: &str, found: &mut Vec<(usize, TokenStream)>) {
    let mut after_hash = false;
    for token in tokens {
        match token {
            TokenTree::Group(group) => {
                if after_hash && group.delimiter() == Delimiter::Bracket {
                    found.extend(arguments(&group, name));
                }
                collect_attributes(group.stream(), name, found);
                after_hash = false;
            }
            TokenTree::Punct(p) => after_hash = matches!(p.as_char(), '#' | '!'),
            _ => after_hash = false,
        }
    }
}

fn arguments(attribute: &Group, name: &str) -> Option<(usize, TokenStream)> {
    let mut tokens = attribute.stream().into_iter();
    match (tokens.next(), tokens.next()) {
        (Some(TokenTree::Ident(first)), Some(TokenTree::Group(inner))) if first == name => {
            Some((first.span().start().line, inner.stream()))
        }
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::{File, attributes, paths};

    fn file(text: &str) -> File {
        File {
            path: "test.rs".to_owned(),
            text: text.to_owned(),
        }
    }

    #[test]
    fn use_trees_are_spelt_out() {
        let used = paths(&file(
            "use a::{b, c::{d, e as f}, g};\nfn h() { i::<j>(\"k::l\"); } // m::n",
        ));
        let names: Vec<String> = used.iter().map(|used| used.names.join("::")).collect();
        for expected in ["a::b", "a::c::d", "a::c::e", "a::g", "i"] {
            assert!(
                names.contains(&expected.to_owned()),
                "{expected}: {names:?}"
            );
        }
        assert!(
            !names
                .iter()
                .any(|name| name.contains('k') || name.contains('m'))
        );
        assert!(used.iter().any(|used| used.contains("c::d")));
        assert!(!used.iter().any(|used| used.contains("a::d")));
    }

    #[test]
    fn attributes_are_found_wherever_they_stand() {
        let found = attributes(
            &file("#![allow(a)]\nmod m {\n #[allow(b, reason = \"\")] fn f() { g![allow(c)]; }\n}"),
            "allow",
        );
        let lines: Vec<usize> = found.iter().map(|(line, _)| *line).collect();
        assert_eq!(lines, [1, 3, 3]);
    }
}
