//! The sentences of the sources and the catalogues of the languages: what `tr!` says,
//! what a PO file says, and a PO file brought up to date.
//!
//! A language has two catalogues: the page's, and one of the course, which the course's
//! program reads together with the page's. So what both say stands in the page's alone.

mod lessons;
mod said;
mod unsaid;
mod update;

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::LazyLock;

use crate::source;

pub use lessons::Files;
pub use said::{Said, key, of_file};
pub use unsaid::unsaid;
pub use update::updated;

/// Where people find sentences of the page; the rest is for programs or not said in other
/// languages yet.
pub const FOLDERS: [&str; 9] = [
    "web/src",
    "crates/giveway-page/src",
    "crates/giveway-solve/src",
    "crates/giveway-planners/src",
    "crates/giveway-order/src",
    "crates/giveway-picture/src",
    "crates/giveway-formats/src",
    "crates/giveway-model/src",
    "crates/giveway-proof/src",
];

/// Where people find sentences of the course, beside those of its lessons.
pub const COURSE: [&str; 2] = ["web/src/course", "crates/giveway-course/src"];

/// The list of examples, whose words are said, too.
const EXAMPLES: &str = "static/examples/index.json";

/// What a catalogue is of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// The page, with all that it shows.
    Page,
    /// The course: its lessons and its program.
    Course,
}

impl Part {
    /// Both.
    pub const ALL: [Self; 2] = [Self::Page, Self::Course];

    /// Where its catalogues are.
    pub const fn folder(self) -> &'static str {
        match self {
            Self::Page => "static/languages",
            Self::Course => "static/languages/course",
        }
    }

    /// Every text that it says, each once, in the order of the files.
    ///
    /// # Panics
    ///
    /// If one text has two plurals, or `tr!` is not read.
    pub fn said(self) -> &'static [Said] {
        static PAGE: LazyLock<Vec<Said>> =
            LazyLock::new(|| once(of_folders(&FOLDERS).into_iter().chain(examples())));
        static COURSE_ALONE: LazyLock<Vec<Said>> = LazyLock::new(|| {
            let mut own = once(of_folders(&COURSE).into_iter().chain(lessons::said()));
            let known: Vec<String> = PAGE.iter().map(Said::key).collect();
            own.retain(|one| !known.contains(&one.key()));
            own
        });
        match self {
            Self::Page => &PAGE,
            Self::Course => &COURSE_ALONE,
        }
    }
}

/// What the sources in some folders say.
fn of_folders(folders: &[&str]) -> Vec<Said> {
    let is_page = folders == FOLDERS;
    let files = folders.iter().flat_map(|folder| source::files(folder));
    let files =
        files.filter(|file| is_source(&file.path) && !(is_page && is_of_course(&file.path)));
    files.flat_map(|file| of_file(&file)).collect()
}

/// Each text once, with all files that say it.
fn once(all: impl Iterator<Item = Said>) -> Vec<Said> {
    let mut each: Vec<Said> = Vec::new();
    let mut places: BTreeMap<String, usize> = BTreeMap::new();
    for one in all {
        let place = *places.entry(one.key()).or_insert(each.len());
        if place == each.len() {
            each.push(one);
            continue;
        }
        let before = &mut each[place];
        assert!(
            before.plural == one.plural || one.plural.is_none() || before.plural.is_none(),
            "two plurals of {}: {:?}, {:?}",
            one.text,
            before.plural,
            one.plural
        );
        before.plural = before.plural.take().or(one.plural);
        for file in one.files {
            if !before.files.contains(&file) {
                before.files.push(file);
            }
        }
    }
    each
}

fn examples() -> Vec<Said> {
    let text = std::fs::read_to_string(source::root().join(EXAMPLES)).expect("the examples");
    let examples: Vec<BTreeMap<String, String>> = serde_json::from_str(&text).expect("a list");
    let texts = examples.into_iter().flatten();
    let texts = texts.filter(|(key, _)| key != "file");
    texts
        .map(|(_, text)| Said::of_data(&text, EXAMPLES))
        .collect()
}

/// Whether a path is a Rust source that is no test.
pub fn is_source(path: &str) -> bool {
    let is_rust = Path::new(path).extension().is_some_and(|end| end == "rs");
    is_rust && !path.contains("/tests")
}

/// Whether a path is one of the course's sources.
fn is_of_course(path: &str) -> bool {
    COURSE
        .iter()
        .any(|folder| path.starts_with(&format!("{folder}/")))
}

/// The places `{name}` of a text, sorted, each once.
pub fn places(text: &str) -> Vec<String> {
    let parts = text.split('{').skip(1);
    let names = parts.filter_map(|part| Some(part.split_once('}')?.0.to_owned()));
    let mut names: Vec<String> = names.collect();
    names.sort();
    names.dedup();
    names
}
