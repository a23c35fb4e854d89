//! Other people's files on their way in: what the reader is to do, what waits
//! for another file, what was written.
//!
//! The reader is a program of its own, loaded when it is first needed. What it
//! tells of a job that is over is known by the job's number, as with the solver.

mod film;
mod known;
pub mod protocol;
mod work;

use std::rc::Rc;

use giveway_model::format::foreign::Format;
use giveway_model::tr;

use crate::State;
use crate::files::{Opened, scene_file};
use protocol::{PictureKind, Read, ReportKind, Task};

pub use film::Reader;
pub use known::beside;
#[cfg(test)]
pub(crate) use work::work;

/// The longest files that the reader takes together, in bytes.
pub const MAX_BYTES: u64 = 20_000_000;

/// Other people's files on their way in.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Intake {
    job: Option<Job>,
    started: u64,
    /// Files that lack another one, which may come next.
    waiting: Rc<Vec<Opened>>,
    /// What was written last, to be saved.
    pub written: Option<Rc<Written>>,
    /// What was packed, until it is saved.
    pub packed: Option<Rc<Packed>>,
}

/// What the reader does, or waits for.
#[derive(Clone, Debug, PartialEq)]
pub struct Job {
    /// Its number, from 1.
    pub id: u64,
    /// What is to be done.
    pub task: Rc<Task>,
    /// The page's own files that are to be fetched first.
    pub fetches: Vec<String>,
    /// How far it is, as a sentence.
    pub sentence: String,
    /// Whether the page's own files were looked for already.
    has_fetched: bool,
}

/// What was written in another format: the files, and what they cannot hold.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Written {
    /// The format; a report has none.
    pub format: Option<Format>,
    /// Each file: its name, and its text.
    pub files: Vec<(String, String)>,
    /// What is lost; where there are no files, why there are none.
    pub losses: Vec<String>,
}

/// A file that is saved as soon as it is there.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Packed {
    /// Its name.
    pub name: String,
    /// What is in it.
    pub bytes: Vec<u8>,
}

/// What is to be written by the reader.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Save {
    /// The scene, and the plan that is shown.
    As(Format),
    /// A report of the audit, with a link that opens it.
    Report(ReportKind, String),
    /// What must be so in every best plan, as far as it is known.
    Freedom,
    /// The plan that is shown as a picture that moves.
    Picture(PictureKind, giveway_picture::Theme),
}

impl Job {
    /// The files that are to be read.
    pub fn files(&self) -> &[Opened] {
        match &*self.task {
            Task::Read(read) => &read.files,
            _ => &[],
        }
    }

    /// Whether files are read.
    pub fn is_reading(&self) -> bool {
        matches!(&*self.task, Task::Read(_))
    }

    /// Whether it is a picture, which may take longer than any reading.
    pub fn is_picture(&self) -> bool {
        matches!(&*self.task, Task::Picture { .. })
    }
}

impl Intake {
    /// What is to be done, if there is anything.
    pub const fn job(&self) -> Option<&Job> {
        self.job.as_ref()
    }

    /// The message for the reader, an [`Ask`](protocol::Ask), with its number;
    /// `None` while files are to be fetched.
    pub fn ask(&self) -> Option<(u64, Vec<u8>)> {
        let job = self.job.as_ref().filter(|job| job.fetches.is_empty())?;
        // Memory is all that could run out.
        let bytes = borsh::to_vec(&(job.id, &*job.task)).unwrap_or_default();
        Some((job.id, bytes))
    }

    /// The number that the next job gets.
    #[cfg(test)]
    pub(crate) const fn next_id(&self) -> u64 {
        self.started + 1
    }

    /// Starts a job in the place of what ran.
    pub(crate) fn start(&mut self, task: Task) {
        self.started += 1;
        let sentence = match &task {
            Task::Read(read) => tr!("Reading {names} …", names = names(&read.files)),
            Task::Picture { .. } => tr!("Drawing the moving picture …").to_owned(),
            _ => tr!("Writing …").to_owned(),
        };
        self.job = Some(Job {
            id: self.started,
            task: Rc::new(task),
            fetches: Vec::new(),
            sentence,
            has_fetched: false,
        });
    }

    /// Ends what runs.
    pub(crate) fn end(&mut self) -> Option<Job> {
        self.job.take()
    }

    /// The job of this number, if it is not over.
    pub(crate) fn at(&mut self, id: u64) -> Option<&mut Job> {
        self.job.as_mut().filter(|job| job.id == id)
    }

    /// Reads on with files of the page; `false` where they were looked for already.
    pub(crate) fn fetch(&mut self, mut job: Job, fetches: Vec<String>) -> bool {
        if job.has_fetched || fetches.is_empty() {
            return false;
        }
        job.has_fetched = true;
        job.fetches = fetches;
        self.job = Some(job);
        true
    }

    /// The page's own files came; those that are not there are none.
    pub(crate) fn fetched(&mut self, id: u64, files: Vec<Opened>) {
        let Some(mut job) = self.job.take_if(|job| job.id == id) else {
            return;
        };
        if let Task::Read(read) = Rc::make_mut(&mut job.task) {
            read.files.extend(files);
        }
        self.started += 1;
        job.id = self.started;
        job.fetches.clear();
        self.job = Some(job);
    }

    /// Keeps files that lack another one.
    pub(crate) fn wait(&mut self, files: Vec<Opened>) {
        self.waiting = Rc::new(files);
    }

    /// The files that lack another one.
    pub fn waiting(&self) -> &[Opened] {
        &self.waiting
    }
}

/// What is to be read when files are opened.
pub(crate) fn read(state: &State, files: Vec<Opened>) -> Read {
    let own = state.own();
    let scene = scene_file(own);
    let has_robots = !own.document.draft.agents().is_empty();
    Read {
        files,
        waiting: state.intake.waiting.to_vec(),
        board: has_robots.then(|| Opened {
            name: scene.name,
            bytes: scene.text.into_bytes(),
        }),
        conventions: None,
    }
}

/// `paths.txt`, or `paths.txt and 2 more`.
fn names(files: &[Opened]) -> String {
    match files {
        [] => tr!("no files" => "nothing").to_owned(),
        [one] => one.name.clone(),
        [first, more @ ..] => tr!(
            "{name} and {more} more",
            name = first.name,
            more = more.len()
        ),
    }
}

/// Whether files are for the reader: one of them is nothing that the page reads
/// by itself, its own JSON included, or others wait for them.
///
/// ```
/// use giveway_page::{Draft, State, files::Opened, intake::is_for_reader};
/// let state = State::new(Draft::default());
/// let file = |name: &str, text: &str| Opened { name: name.into(), bytes: text.into() };
/// let is = |files: &[Opened]| is_for_reader(&state, files);
/// assert!(is(&[file("paths.txt", "Agent 0: (0,0)->(0,1)->\n")]));
/// assert!(!is(&[file("a.map", "type octile\nheight 1\nwidth 2\nmap\n..\n")]));
/// assert!(is(&[file("scene.json", "{\"giveway\": 1")]));
/// ```
pub fn is_for_reader(state: &State, files: &[Opened]) -> bool {
    let waits = !state.intake.waiting.is_empty();
    let is_own = |file: &Opened| is_own_json(file) || is_foreign(file);
    files.iter().any(is_own) || (waits && files.iter().all(is_text))
}

/// Whether files are the page's own JSON: a scene, with a plan and changes at most.
pub(crate) fn are_own(read: &Read) -> bool {
    let plans = read.files.iter().filter(|file| is_own_plan(file)).count();
    let any = read.files.iter().any(is_own_json);
    any && plans <= 1 && read.waiting.is_empty() && !read.files.iter().any(is_foreign)
}

fn is_own_plan(file: &Opened) -> bool {
    let text = std::str::from_utf8(&file.bytes).unwrap_or_default();
    text.contains("\"giveway\"") && text.contains("\"paths\"") && !text.contains("\"map\"")
}

fn is_text(file: &Opened) -> bool {
    std::str::from_utf8(&file.bytes).is_ok()
}

/// Whether a file is JSON of the project's own, or claims to be.
fn is_own_json(file: &Opened) -> bool {
    let ending = file.name.rsplit_once('.').map(|(_, ending)| ending);
    let text = std::str::from_utf8(&file.bytes).unwrap_or_default();
    let start = text.trim_start_matches('\u{feff}').trim_start();
    ending == Some("json") || start.starts_with(['{', '['])
}

/// Whether a file is nothing that the page reads by itself, by a look at it.
fn is_foreign(file: &Opened) -> bool {
    let Ok(text) = std::str::from_utf8(&file.bytes) else {
        return false;
    };
    let start = text.trim_start_matches('\u{feff}').trim_start();
    let ending = file.name.rsplit_once('.').map(|(_, ending)| ending);
    let has_own_ending = matches!(ending, Some("map" | "scen" | "giveway"));
    let own = [
        "type ",
        "version ",
        "giveway-kept=",
        "giveway=",
        "https:",
        "http:",
    ];
    let is_own = has_own_ending
        || start.is_empty()
        || own.iter().any(|own| start.starts_with(own))
        // Its own JSON says so, and so does what is left of it.
        || (start.starts_with(['{', '[']) && text.contains("\"giveway\""));
    !is_own
}
