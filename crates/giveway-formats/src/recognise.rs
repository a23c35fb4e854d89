//! Recognises the format of a text by its content, never by its name alone.

use super::{
    Format, Remarks, WrittenPlan, asprilo, class_project, clingo, grid, league,
    limits::MAX_TEXT_BYTES, mapfw, multi_robot, paths, result, tracker, unknown_format,
};
use crate::movingai;
use giveway_model::change::Changes;
use giveway_model::format::own::{self, Own};
use giveway_model::format::text::without_mark;
use giveway_model::{Fault, Grid, Plan, Question, Scene, tr};

/// A file: its name, for messages and for what it is matched with, and its text.
#[derive(Clone, Copy, Debug)]
pub struct Source<'a> {
    /// Its name; folders before it are not looked at.
    pub name: &'a str,
    /// Its content.
    pub text: &'a str,
}

/// The content of a file.
#[derive(Clone, Debug, PartialEq)]
pub enum Held {
    /// A map alone, with what a person should know about how it was read.
    Map(Grid, Vec<String>),
    /// The tasks of agents, for a map beside it.
    Scenario(movingai::Scenario),
    /// A whole instance, with what its file says beyond it.
    Scene(Scene, Remarks),
    /// A plan of this project, by the names of agents, with what a person should know.
    OwnPlan(Plan, Vec<String>),
    /// The changes while a plan runs.
    Changes(Changes),
    /// A result of this project without a plan: what it says, a sentence.
    NoPlan(String),
    /// The answer to a question, which has no plan.
    Asked(Box<Question>),
    /// A plan that needs a map, and perhaps tasks.
    Plan(WrittenPlan),
    /// An instance and a plan for it.
    Both(Scene, Remarks, WrittenPlan),
    /// A problem of the League of Robot Runners, which is in other files.
    Problem(league::Problem),
}

/// Whether a text looks like one of a format.
type Sniff = fn(&str) -> bool;

/// A reader of the texts of one format.
#[derive(Clone, Copy)]
enum Reader {
    /// One that ends at the first fault.
    One(fn(&str) -> Result<Held, Fault>),
    /// One that lists all faults.
    All(fn(&str) -> Result<Held, Vec<Fault>>),
}

use Reader::{All, One};

/// The readers in the order in which they are asked whether a text is theirs, by a
/// look at its beginning or its keys. The project's own JSON is last, since it
/// explains best what is wrong with JSON of no format at all.
const READERS: &[(Format, Sniff, Reader)] = &[
    (Format::MovingAi, is_movingai, One(read_movingai)),
    (Format::Paths, paths::sniff, One(paths::read)),
    (Format::Result, result::sniff, One(result::read)),
    (Format::Tracker, tracker::sniff, One(tracker::read)),
    (Format::Asprilo, asprilo::is_asprilo, One(asprilo::read)),
    (Format::Asprilo, clingo::sniff, One(clingo::read)),
    (Format::League, league::sniff, One(league::read)),
    (Format::Mapfw, mapfw::sniff, One(mapfw::read)),
    (
        Format::MultiRobot,
        multi_robot::sniff,
        One(multi_robot::read),
    ),
    (
        Format::ClassProject,
        class_project::sniff,
        All(class_project::read),
    ),
    (Format::Grid, grid::sniff, One(grid::read)),
    (Format::Giveway, is_json, All(read_own)),
];

/// The format of a text, with its reader.
fn reader(text: &str) -> Result<(Format, Reader), Fault> {
    let found = READERS.iter().find(|(_, is_theirs, _)| is_theirs(text));
    found
        .map(|&(format, _, read)| (format, read))
        .ok_or_else(|| unknown_format::refusal(text))
}

/// The format of a text.
///
/// # Errors
/// When it is of none that is known.
///
/// ```
/// use giveway_formats::{Format, recognise};
/// assert_eq!(recognise("version 1\n"), Ok(Format::MovingAi));
/// assert!(recognise("good morning").is_err());
/// ```
pub fn recognise(text: &str) -> Result<Format, Fault> {
    reader(without_mark(text)).map(|(format, _)| format)
}

/// Reads a text, whatever it is.
///
/// # Errors
/// When it is of no known format, too long, or not as its format demands; each
/// fault has a line and a column.
pub fn read(text: &str) -> Result<(Format, Held), Vec<Fault>> {
    if text.len() > MAX_TEXT_BYTES {
        let found = tr!("{n} MB", n = text.len().div_ceil(1_000_000));
        let expected = tr!("at most {most} MB", most = MAX_TEXT_BYTES / 1_000_000);
        return Err(vec![Fault::at("", found, expected).in_text(1, 1)]);
    }
    let text = without_mark(text);
    let (format, read) = reader(text).map_err(|fault| vec![fault])?;
    let held = match read {
        One(read) => read(text).map_err(|fault| vec![fault]),
        All(read) => read(text),
    };
    Ok((format, held?))
}

fn is_movingai(text: &str) -> bool {
    movingai::is_map(text) || movingai::is_scenario(text)
}

fn read_movingai(text: &str) -> Result<Held, Fault> {
    if movingai::is_scenario(text) {
        movingai::read_scenario(text).map(Held::Scenario)
    } else {
        movingai::read_map(text).map(|grid| Held::Map(grid, Vec::new()))
    }
}

fn is_json(text: &str) -> bool {
    text.trim_start().starts_with(['{', '['])
}

/// The project's own JSON; JSON of another kind is refused by name.
fn read_own(text: &str) -> Result<Held, Vec<Fault>> {
    if let Some(fault) = unknown_format::other_json(text) {
        return Err(vec![fault]);
    }
    Ok(match own::read(text)? {
        Own::Scene(instance) => Held::Scene(instance.to_scene(), Remarks::default()),
        Own::Plan(plan, notes) => Held::OwnPlan(plan, notes),
        Own::Changes(changes) => Held::Changes(changes),
        Own::NoPlan(sentence) => Held::NoPlan(sentence),
        Own::Asked(_, Some(plan)) => {
            let note = tr!("The plan is the one in the answer to a question.");
            Held::OwnPlan(plan, vec![note.to_owned()])
        }
        Own::Asked(question, None) => Held::Asked(question),
    })
}
