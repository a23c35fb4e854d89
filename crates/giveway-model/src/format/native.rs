//! The project's own JSON: instances and plans.

use serde::Deserialize;
use serde_json::value::RawValue;

use super::json;
use super::locate::{Fields, Locator, segments};
use super::text::{Positions, without_mark};
use crate::change::Changes;
use crate::{Fault, Instance, Plan, Scene, Version, tr};

pub use super::layout::{write_changes, write_plan, write_scene};

/// Reads an instance as it is written, without judging it.
///
/// # Errors
/// When the text is no JSON, is of a newer version, lacks a key, or has one
/// that is unknown, repeated or of another type. The fault has a line and a
/// column.
///
/// ```
/// use giveway_model::format::native;
/// let fault = native::read_scene("{ \"giveway\": 1,\n  \"mapp\": [] }").unwrap_err();
/// assert_eq!((fault.line, fault.column), (Some(2), Some(3)));
/// assert_eq!(fault.found, "the unknown key \"mapp\"");
/// ```
pub fn read_scene(text: &str) -> Result<Scene, Fault> {
    read(text, Kind::Instance)
}

/// Reads an instance and checks it.
///
/// # Errors
/// As [`read_scene`], or else every fault that [`Instance::new`] finds; all
/// have a line and a column.
pub fn read_instance(text: &str) -> Result<Instance, Vec<Fault>> {
    let scene = read_scene(text).map_err(|fault| vec![fault])?;
    Instance::new(scene).map_err(|faults| in_text(text, faults))
}

/// Reads a plan.
///
/// # Errors
/// As [`read_scene`]; also when an agent has two paths or two lists of charges.
pub fn read_plan(text: &str) -> Result<Plan, Fault> {
    read(text, Kind::Plan)
}

/// Reads changes.
///
/// # Errors
/// As [`read_scene`]; also when a change lacks a key of its kind or has one of
/// another.
///
/// ```
/// use giveway_model::format::native;
/// let text = r#"{ "giveway": 1, "changes": [{ "at": -1, "change": "remove-agent", "agent": "A" }] }"#;
/// let fault = native::read_changes(text).unwrap_err();
/// assert_eq!(fault.place, "changes[0].at");
/// ```
pub fn read_changes(text: &str) -> Result<Changes, Fault> {
    read(text, Kind::Changes)
}

/// Reads an object that holds others of the format, such as a request.
///
/// # Errors
/// When the text is no JSON or is not of the type. The fault has a line and a
/// column, and the keys on the way to its place.
///
/// ```
/// use giveway_model::{Scene, format::native};
/// let text = r#"[{ "giveway": 1, "map": [3], "agents": [] }]"#;
/// let fault = native::read_object::<Vec<Scene>>(text).unwrap_err();
/// assert_eq!(fault.place, "[0].map[0]");
/// ```
pub fn read_object<'a, T: Deserialize<'a>>(text: &'a str) -> Result<T, Fault> {
    json::read(without_mark(text))
}

/// Reads an object of a file of its own, which has a key that no other file has; the phrase says
/// what it is.
///
/// # Errors
/// As [`read_object`]; where the text is another file of the format, what it is.
///
/// ```
/// use giveway_model::{Plan, format::native};
/// let text = r#"{ "giveway": 1, "map": ["."], "agents": [] }"#;
/// let fault = native::read_file::<Plan>(text, "hand-in", "a hand-in").unwrap_err();
/// assert_eq!((fault.found, fault.expected), (
///     "an instance, with \"map\" and \"agents\"".into(), "a hand-in".into()));
/// ```
pub fn read_file<'a, T: Deserialize<'a>>(
    text: &'a str,
    key: &str,
    phrase: &str,
) -> Result<T, Fault> {
    let text = without_mark(text);
    json::read(text).map_err(|fault| mistaken(text, key, phrase).unwrap_or(fault))
}

/// Gives faults of a scene their lines and columns in the text that it was
/// read from. Places that are not in the text get those of what is around them.
pub fn in_text(text: &str, faults: Vec<Fault>) -> Vec<Fault> {
    let text = without_mark(text);
    let mut locator = Locator::new(text);
    let mut positions = Positions::new(text);
    faults
        .into_iter()
        .map(|fault| match locator.find(&segments(&fault.place), false) {
            Some(offset) => {
                let (line, column) = positions.of(offset);
                fault.in_text(line, column)
            }
            None => fault,
        })
        .collect()
}

fn read<'a, T: Deserialize<'a>>(text: &'a str, kind: Kind) -> Result<T, Fault> {
    read_file(text, kind.key(), kind.phrase())
}

/// The objects of the format, each told by a key that only it has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    Instance,
    Plan,
    Changes,
    Result,
}

impl Kind {
    const ALL: [Self; 4] = [Self::Instance, Self::Plan, Self::Changes, Self::Result];

    const fn key(self) -> &'static str {
        match self {
            Self::Instance => "map",
            Self::Plan => "paths",
            Self::Changes => "changes",
            Self::Result => "status",
        }
    }

    fn phrase(self) -> &'static str {
        match self {
            Self::Instance => tr!("an instance, with \"map\" and \"agents\""),
            Self::Plan => tr!("a plan, with \"paths\""),
            Self::Changes => tr!("a list of changes, with \"changes\""),
            Self::Result => tr!("a result, with \"status\""),
        }
    }
}

/// Two mistakes that explain all others: a newer version, and another kind of
/// file than the one asked for.
fn mistaken(text: &str, key: &str, phrase: &str) -> Option<Fault> {
    let fields: Fields<'_> = serde_json::from_str(text).ok()?;
    if let Some(fault) = version_fault(text) {
        return Some(fault);
    }
    if fields.has(key) {
        return None;
    }
    let found = Kind::ALL.into_iter().find(|kind| fields.has(kind.key()))?;
    Some(Fault::at("", found.phrase(), phrase).in_text(1, 1))
}

fn version_fault(text: &str) -> Option<Fault> {
    #[derive(Deserialize)]
    struct Head<'a> {
        #[serde(borrow)]
        giveway: &'a RawValue,
    }

    let head: Head<'_> = serde_json::from_str(text).ok()?;
    let number: u64 = head.giveway.get().parse().ok()?;
    if number == u64::from(Version::NUMBER) {
        return None;
    }
    let fault = Fault::at(
        "giveway",
        tr!("version {number} of the format", number),
        tr!(
            "version {number}, the only one known here",
            number = Version::NUMBER
        ),
    );
    in_text(text, vec![fault]).pop()
}
