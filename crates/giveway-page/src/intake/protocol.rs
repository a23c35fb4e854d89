//! The messages between the page and the reader, which reads and writes other
//! people's files in a worker of its own.

use std::collections::BTreeMap;

use borsh::{BorshDeserialize, BorshSerialize};
use giveway_formats::{Conventions, ForeignPlan, Format};
use giveway_model::change::Changes;
use giveway_model::{Cost, Plan, Question, Scene};
use giveway_picture::Look;
use giveway_picture::gif::Shot;
use giveway_solve::ExportAnswer;
use giveway_solve::freedom::FreedomAnswer;

use crate::files::Opened;

/// From the page: do this.
#[derive(Clone, Debug, PartialEq, BorshSerialize, BorshDeserialize)]
pub struct Ask {
    /// A number that the reply carries.
    pub id: u64,
    /// What to do.
    pub task: Task,
}

/// What the reader is to do.
#[derive(Clone, Debug, PartialEq, BorshSerialize, BorshDeserialize)]
pub enum Task {
    /// Read files.
    Read(Read),
    /// Write a scene, and its plan if it has one.
    Write {
        /// The format.
        format: Format,
        /// How the names of the files begin.
        stem: String,
        /// The scene.
        scene: Scene,
        /// The plan.
        plan: Option<Plan>,
    },
    /// Pack certificates into one file.
    Pack {
        /// Its name.
        name: String,
        /// The certificates.
        answer: ExportAnswer,
    },
    /// Draw a plan that moves.
    Picture {
        /// As what.
        kind: PictureKind,
        /// How the name of the file begins.
        stem: String,
        /// The scene.
        scene: Scene,
        /// The plan.
        plan: Plan,
        /// How it looks.
        look: Look,
    },
    /// The pixels of what was to be drawn last for a picture, row by row.
    Pixels(Vec<u8>),
    /// Write what must be so in every best plan.
    Freedom {
        /// The name of the file.
        name: String,
        /// What is known.
        told: FreedomAnswer,
    },
    /// Write a report of an audit.
    Report {
        /// As what.
        kind: ReportKind,
        /// The document with the audit, as the browser keeps it.
        kept: String,
        /// What the search that runs has proved so far.
        bounds: BTreeMap<Cost, u32>,
        /// A link that opens the audit.
        link: String,
    },
}

/// Files to be read.
#[derive(Clone, Debug, Default, PartialEq, BorshSerialize, BorshDeserialize)]
pub struct Read {
    /// The files that were opened together.
    pub files: Vec<Opened>,
    /// Files that were opened before and lacked something.
    pub waiting: Vec<Opened>,
    /// The scene on the board, for a plan that names no map.
    pub board: Option<Opened>,
    /// The plan of that scene, for changes that come alone.
    pub plan: Option<Opened>,
    /// How plans are to be read, where a person chose that.
    pub conventions: Option<Conventions>,
}

/// What a picture that moves is written as.
#[derive(Clone, Copy, Debug, PartialEq, Eq, BorshSerialize, BorshDeserialize)]
pub enum PictureKind {
    /// One file of shapes, with their motion.
    Svg,
    /// Frames of pixels.
    Gif,
}

/// What a report is written as.
#[derive(Clone, Copy, Debug, PartialEq, Eq, BorshSerialize, BorshDeserialize)]
pub enum ReportKind {
    /// A page.
    Html,
    /// Text for a wiki or an issue.
    Markdown,
    /// For programs.
    Json,
}

/// From the reader.
#[derive(Clone, Debug, PartialEq, BorshSerialize, BorshDeserialize)]
pub enum Message {
    /// It listens.
    Ready,
    /// How far it is: a sentence.
    Progress {
        /// Of the [`Ask`].
        id: u64,
        /// What it does.
        sentence: String,
    },
    /// The page is to draw this, and to send its pixels.
    Draw {
        /// Of the [`Ask`].
        id: u64,
        /// What.
        shot: Shot,
    },
    /// What came of it.
    Reply {
        /// Of the [`Ask`].
        id: u64,
        /// What.
        reply: Reply,
    },
    /// A fault of the program; the worker is of no more use.
    Failed(String),
}

/// What came of it.
#[derive(Clone, Debug, PartialEq, BorshSerialize, BorshDeserialize)]
pub enum Reply {
    /// A scene with its plans.
    Found(Box<Found>),
    /// A scene with its plan, and what changed while that ran, of the project's own
    /// JSON.
    Run(Box<Run>),
    /// The files are the page's own business: it reads them by itself.
    Own,
    /// Another file is missing.
    Missing {
        /// What to do, as a sentence.
        sentence: String,
        /// The files that lack it.
        files: Vec<Opened>,
        /// The map's name, where it is one that is missing and the file names it.
        map: Option<String>,
        /// What the files hold on the scene of the board, if that fits.
        on_board: Option<Box<Found>>,
    },
    /// The files cannot be read: a sentence, and more of it.
    Refused(String, Vec<String>),
    /// Files to be saved (name and text), and what they cannot hold.
    Written(Vec<(String, String)>, Vec<String>),
    /// One file, to be saved.
    Packed(Vec<u8>),
    /// A file to be saved: its name and its bytes.
    Drawn(String, Vec<u8>),
}

/// A scene with its plan, what changed while that ran, and a question.
#[derive(Clone, Debug, PartialEq, BorshSerialize, BorshDeserialize)]
pub struct Run {
    /// The scene.
    pub scene: Scene,
    /// The plan; none where a question was read alone.
    pub plan: Option<Plan>,
    /// What changed.
    pub changes: Option<Changes>,
    /// What is to change while the plan runs, which it does not know of; all at one time.
    pub listed: Option<Changes>,
    /// A question about the plan.
    pub question: Option<Question>,
    /// What a person should know, each a sentence.
    pub notes: Vec<String>,
}

/// A scene with its plans, as files tell them.
#[derive(Clone, Debug, PartialEq, BorshSerialize, BorshDeserialize)]
pub struct Found {
    /// The scene.
    pub scene: Scene,
    /// Its plans, in the order of the files.
    pub plans: Vec<ForeignPlan>,
    /// What a person should know about the scene, each a sentence.
    pub notes: Vec<String>,
    /// All files that it was read from.
    pub files: Vec<Opened>,
}
