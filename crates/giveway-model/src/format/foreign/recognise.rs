//! What a text is, told by what it holds and never by its name alone.

use super::{
    Format, WrittenPlan, asprilo, league, limits::MAX_TEXT_BYTES, mapfw, multi_robot, paths,
    result, tracker,
};
use crate::format::text::{shorten, without_mark};
use crate::format::{movingai, native};
use crate::{Fault, Grid, Plan, Scene, tr};

/// A file: its name, for messages and for what it is matched with, and its text.
#[derive(Clone, Copy, Debug)]
pub struct Source<'a> {
    /// Its name; folders before it are not looked at.
    pub name: &'a str,
    /// What is in it.
    pub text: &'a str,
}

/// What a file holds.
#[derive(Clone, Debug, PartialEq)]
pub enum Held {
    /// A map alone.
    Map(Grid),
    /// The tasks of agents, for a map beside it.
    Scenario(movingai::Scenario),
    /// A whole instance, with what a person should know about how it was read.
    Scene(Scene, Vec<String>),
    /// A plan of this project, by the names of agents.
    OwnPlan(Plan),
    /// A plan that needs a map, and perhaps tasks.
    Plan(WrittenPlan),
    /// An instance and a plan for it.
    Both(Scene, WrittenPlan),
}

/// Whether a text looks like one of a format.
type Sniff = fn(&str) -> bool;

/// Reads the text of one format.
type Reader = fn(&str) -> Result<Held, Vec<Fault>>;

/// The readers in the order in which they are asked whether a text is theirs, by a
/// look at its beginning or its keys. The project's own JSON is last, since it
/// explains best what is wrong with JSON of no format at all.
const READERS: &[(Format, Sniff, Reader)] = &[
    (Format::MovingAi, is_movingai, read_movingai),
    (Format::Paths, paths::sniff, paths::read),
    (Format::Result, result::sniff, result::read),
    (Format::Tracker, tracker::sniff, tracker::read),
    (Format::Asprilo, asprilo::is_asprilo, asprilo::read),
    (Format::League, league::sniff, league::read),
    (Format::Mapfw, mapfw::sniff, mapfw::read),
    (Format::MultiRobot, multi_robot::sniff, multi_robot::read),
    (Format::Giveway, is_json, read_own),
];

/// The format of a text, with its reader.
fn reader(text: &str) -> Result<(Format, Reader), Fault> {
    let found = READERS.iter().find(|(_, is_theirs, _)| is_theirs(text));
    found
        .map(|&(format, _, read)| (format, read))
        .ok_or_else(|| {
            let expected = tr!("a map, a scenario, an instance or a plan of a known format");
            Fault::at("", format!("\"{}\"", shorten(text.trim_start())), expected).in_text(1, 1)
        })
}

/// The format of a text.
///
/// # Errors
/// When it is of none that is known.
///
/// ```
/// use giveway_model::format::foreign::{Format, recognise};
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
    Ok((format, read(text)?))
}

fn is_movingai(text: &str) -> bool {
    let start = text.trim_start();
    start.starts_with("type ") || start.starts_with("version ")
}

fn read_movingai(text: &str) -> Result<Held, Vec<Fault>> {
    let held = if text.trim_start().starts_with("version") {
        movingai::read_scenario(text).map(Held::Scenario)
    } else {
        movingai::read_map(text).map(Held::Map)
    };
    held.map_err(|fault| vec![fault])
}

fn is_json(text: &str) -> bool {
    text.trim_start().starts_with(['{', '['])
}

/// A plan or an instance of the project's own; where it is neither, the faults of
/// what it looks like.
fn read_own(text: &str) -> Result<Held, Vec<Fault>> {
    let faults = match native::read_instance(text) {
        Ok(instance) => return Ok(Held::Scene(instance.to_scene(), Vec::new())),
        Err(faults) => faults,
    };
    match native::read_plan(text) {
        Ok(plan) => Ok(Held::OwnPlan(plan)),
        Err(fault) if text.contains("\"paths\"") => Err(vec![fault]),
        Err(_) => Err(faults),
    }
}
