//! Files that a person opens, and those that are saved.

mod blank;
mod course;
mod dropped;
mod kind;
mod save;
mod scenario;

#[cfg(test)]
mod tests;

use std::borrow::Cow;

use giveway_formats::movingai;
use giveway_model::format::read_text;
use giveway_model::words::Later;
use giveway_model::words::Sentence;
use giveway_model::{Fault, Scene, tr_data, tr_later};

use crate::link;
use crate::{Notice, State, intake};
use kind::Kind;
pub(crate) use kind::is_read_here;

pub use blank::blank;
pub use course::Together;
pub use dropped::{are_hand_ins, read_beside};
pub use save::{
    Saved, changes_file, kept_file, picture_name, plan_file, robots_file, scene_file, sizing_file,
    trace_file,
};
pub(crate) use save::{certificate_name, freedom_name, name_of};
pub use scenario::Choice;

/// The largest file that is read, in bytes.
pub const MAX_BYTES: u64 = 10_000_000;

/// A file, read wholly.
#[derive(Clone, Debug, PartialEq, Eq, borsh::BorshSerialize, borsh::BorshDeserialize)]
pub struct Opened {
    /// Its name, without folders.
    pub name: String,
    /// What is in it.
    pub bytes: Vec<u8>,
}

/// What files hold together.
#[derive(Clone, Debug, PartialEq)]
pub enum Reading {
    /// A scene.
    Scene(Box<Scene>),
    /// A scene with its plan, with what changed while that ran, and with a question.
    Linked(Box<Together>),
    /// A map and a scenario: a person chooses how many of its agents.
    Scenario(Box<Choice>),
    /// A lesson, for the course: its text, or the part of a link that holds it; or hand-ins of
    /// lessons, as they were pasted.
    Lesson(String),
    /// A scene with a plan that breaks a rule: the reader brings it into an audit.
    Illegal(Vec<Opened>),
}

/// Why a file is too large to be read at all, by its size in bytes: plans of
/// elsewhere may be larger than files of the page's own.
pub fn too_large(name: &str, bytes: u64) -> Option<Notice> {
    larger_than(name, bytes, intake::MAX_BYTES)
}

fn larger_than(name: &str, bytes: u64, most: u64) -> Option<Notice> {
    let megabytes = |bytes: u64| bytes.div_ceil(1_000_000);
    (bytes > most).then(|| {
        let (found, most) = (megabytes(bytes), megabytes(most));
        refusal(
            name,
            tr_data!("found {found} MB, expected at most {most} MB", found, most),
        )
    })
}

/// Reads the files that were opened together, without the project's own JSON: code
/// that reads that is a large part of a program, so the page leaves it to the reader.
/// `None` where some file is for the reader.
pub(crate) fn read_here(files: &[Opened]) -> Option<Result<Reading, Notice>> {
    let mut texts = Vec::new();
    for file in files {
        match text(file) {
            Ok(text) => texts.push((file, text)),
            Err(notice) => return Some(Err(notice)),
        }
    }
    let kinds = texts.iter();
    let kinds: Vec<_> = kinds
        .map(|(file, text)| (Kind::of(&file.name, text), *file, &**text))
        .collect();
    match *kinds {
        [(Kind::Kept, file, text)] => Some(kept(file, text)),
        [(Kind::Map, file, text)] => Some(map(file, text)),
        [(Kind::Scenario, file, text)] => Some(Err(map_missing(file, text))),
        [(Kind::Map, map, map_text), (Kind::Scenario, file, text)]
        | [(Kind::Scenario, file, text), (Kind::Map, map, map_text)] => {
            Some(scenario::read((map, map_text), (file, text)))
        }
        _ => None,
    }
}

/// Reads the files that were opened together: a scene in the project's own JSON, alone
/// or with its plan, what changed while that ran and a question; or a MovingAI
/// map, with or without one scenario for it.
///
/// # Errors
/// What is wrong, with file, line and column where there are some; or what is
/// missing.
///
/// ```
/// use giveway_page::files::{Opened, Reading, read};
/// let map = Opened { name: "a.map".into(), bytes: b"type octile\nheight 1\nwidth 2\nmap\n..\n".into() };
/// assert!(matches!(read(&[map]), Ok(Reading::Scene(_))));
/// ```
pub fn read(files: &[Opened]) -> Result<Reading, Notice> {
    let files = files.iter().map(|file| Ok((file, text(file)?)));
    let files: Vec<(&Opened, Cow<'_, str>)> = files.collect::<Result<_, Notice>>()?;
    let files: Vec<(&Opened, &str)> = files.iter().map(|(file, text)| (*file, &**text)).collect();
    let of = |kind: Kind| {
        let files = files.iter().copied();
        files.filter(move |(file, text)| Kind::of(&file.name, text) == kind)
    };
    let (scenes, maps): (Vec<_>, Vec<_>) = (of(Kind::Json).collect(), of(Kind::Map).collect());
    let scenarios: Vec<_> = of(Kind::Scenario).collect();
    if let (&[(file, text)], Some(_)) = (&*files, of(Kind::Kept).next()) {
        return kept(file, text);
    }
    if let (true, Some(read)) = (
        maps.is_empty() && scenarios.is_empty(),
        course::read(&scenes),
    ) {
        return read;
    }
    match (&*scenes, &*maps, &*scenarios) {
        ([], [], []) => Err(Notice::refusal(tr_data!("There is no file to open."))),
        ([], &[(file, text)], []) => map(file, text),
        ([], [], &[(file, text)]) => Err(map_missing(file, text)),
        ([], [map], [scenario]) => scenario::read(*map, *scenario),
        _ => Err(Notice::refusal(tr_data!("Open one scene at a time.")).with([
                tr_data!("found {scenes}, {maps}, {scenarios}", scenes = tr_data!("{n} JSON file" | "{n} JSON files" % scenes.len()), maps = tr_data!("{n} map" | "{n} maps" % maps.len()), scenarios = tr_data!("{n} scenario" | "{n} scenarios" % scenarios.len())),
                tr_data!("expected one JSON file, or those of a scene, its plan and its changes, or one .map and one .scen").to_owned(),
            ])),
    }
}

/// What a pasted text is called.
const PASTED: Later = tr_later!("Pasted text");

/// Reads a text that was pasted: what a file may hold, or a link of this page.
/// `Ok` with files are those for the reader.
///
/// # Errors
/// Why it is nothing to be opened.
///
/// ```
/// use giveway_page::{Draft, State, files::{Pasted, pasted}};
/// let state = State::new(Draft::default());
/// let scene = r#"{"giveway": 1, "map": [".."], "agents": []}"#;
/// assert!(matches!(pasted(&state, scene), Ok(Pasted::File(_))));
/// let link = "https://example.org/#giveway=1&map=1.f&rules=0.0&costs=012&agents=";
/// assert!(matches!(pasted(&state, link), Ok(Pasted::Read(_))));
/// let facts = "init(object(node,1),value(at,(1,1))).";
/// assert!(matches!(pasted(&state, facts), Ok(Pasted::File(_))));
/// ```
pub fn pasted(state: &State, text: &str) -> Result<Pasted, Notice> {
    let text = text.trim();
    let behind = |mark| text.split_once(mark).map(|(_, link)| link);
    let link = behind("#").or_else(|| behind("%23")).unwrap_or(text);
    let is_link = link.len() >= "giveway=".len() && link::is_link(link);
    if is_link && !text.starts_with(['{', '[']) {
        let linked = link::read(link, link::From::Anywhere)?;
        return Ok(Pasted::Read(Reading::Linked(Box::new(linked.into()))));
    }
    let files = [Opened {
        name: PASTED.text().to_owned(),
        bytes: text.as_bytes().to_vec(),
    }];
    if let Some(notice) = larger_than(PASTED.text(), text.len() as u64, MAX_BYTES) {
        return Err(notice);
    }
    if are_hand_ins(&files) {
        return Ok(Pasted::Read(Reading::Lesson(text.to_owned())));
    }
    if let Some(lesson) = link::lesson(link).filter(|_| link.len() < text.len()) {
        return Ok(Pasted::Read(Reading::Lesson(lesson)));
    }
    match read_beside(state, &files) {
        Some(read) => read.map(Pasted::Read),
        None => Ok(Pasted::File(files.into())),
    }
}

/// What a text that was pasted comes to.
#[derive(Clone, Debug, PartialEq)]
pub enum Pasted {
    /// This.
    Read(Reading),
    /// A file for the reader.
    File(Vec<Opened>),
}

fn text(file: &Opened) -> Result<Cow<'_, str>, Notice> {
    if let Some(notice) = larger_than(&file.name, file.bytes.len() as u64, MAX_BYTES) {
        return Err(notice);
    }
    read_text(&file.bytes).map_err(|fault| faulty(&file.name, &[fault]))
}

fn kept(file: &Opened, text: &str) -> Result<Reading, Notice> {
    let linked = link::kept_elsewhere(text).map_err(|notice| notice.under(unopened(&file.name)))?;
    Ok(Reading::Linked(Box::new(linked.into())))
}

fn map(file: &Opened, text: &str) -> Result<Reading, Notice> {
    let grid = movingai::read_map(text).map_err(|fault| faulty(&file.name, &[fault]))?;
    let scene = Scene {
        map: grid.rows(),
        ..Scene::default()
    };
    Ok(Reading::Scene(Box::new(named(scene, &file.name))))
}

fn map_missing(file: &Opened, text: &str) -> Notice {
    let scenario = match movingai::read_scenario(text) {
        Ok(scenario) => scenario,
        Err(fault) => return faulty(&file.name, &[fault]),
    };
    let name = scenario.map_name().map(base).unwrap_or_default();
    let map = match name {
        "" => tr_data!("its map"),
        name => name.into(),
    };
    refusal(
        &file.name,
        tr_data!("it is a scenario for {map}: open both files together", map),
    )
}

/// The scene with the name of its file, where it has none of its own.
fn named(mut scene: Scene, file: &str) -> Scene {
    if scene.name.is_empty() {
        stem(file).clone_into(&mut scene.name);
    }
    scene
}

/// The most faults that are told of one file.
const TOLD: usize = 5;

fn faulty(file: &str, faults: &[Fault]) -> Notice {
    let told = faults.iter().take(TOLD);
    let mut details: Vec<Sentence> = told
        .map(|fault| format!("{file}, {fault}").into())
        .collect();
    if let more @ 1.. = faults.len().saturating_sub(TOLD) {
        details.push(tr_data!(
            "and {n} more fault" | "and {n} more faults" % more
        ));
    }
    Notice::refusal(unopened(file)).with(details)
}

fn refusal(file: &str, why: impl Into<Sentence>) -> Notice {
    Notice::refusal(unopened(file)).with([why])
}

fn unopened(file: &str) -> Sentence {
    tr_data!("{file} cannot be opened; the scene stays as it is.", file)
}

/// A name without folders.
fn base(path: &str) -> &str {
    path.rsplit(['/', '\\']).next().unwrap_or(path)
}

/// A file's name without its ending.
fn stem(file: &str) -> &str {
    match file.rsplit_once('.') {
        Some((stem, _)) if !stem.is_empty() => stem,
        _ => file,
    }
}
