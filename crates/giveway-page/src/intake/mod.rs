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

use giveway_formats::Format;
use giveway_model::format::read_text;
use giveway_model::tr;

use crate::State;
use crate::files::{self, Opened, Saved, plan_file, scene_file};
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
    /// What all best plans share, as far as it is known.
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

    /// What could not be done, as the reader broke off or did not even start.
    pub(crate) fn crashed(&self, had_started: bool) -> &'static str {
        match (self.is_reading(), had_started) {
            (true, true) => {
                tr!("The reader of other people's files broke off. Your scene is as it was.")
            }
            (true, false) => {
                tr!(
                    "The file cannot be read here: the reader did not start. Your scene is as it was."
                )
            }
            (false, _) if self.is_picture() => tr!("The moving picture could not be made."),
            (false, true) => tr!("The file could not be written: its writer broke off."),
            (false, false) => tr!("The file cannot be written here: its writer did not start."),
        }
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

/// The plan of the scene on the board, around which nothing has changed yet.
fn running_plan(state: &State) -> Option<Saved> {
    let answer = state.document.fresh_answer()?;
    let is_running = answer.course.is_none() && state.document.mode.is_editing();
    is_running.then(|| plan_file(state)).flatten()
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
        plan: running_plan(own).map(|plan| Opened {
            name: plan.name,
            bytes: plan.text.into_bytes(),
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
    files.iter().any(|file| waits || !is_read_here(file))
}

fn is_read_here(file: &Opened) -> bool {
    let text = read_text(&file.bytes);
    text.is_ok_and(|text| files::is_read_here(&file.name, &text))
}
