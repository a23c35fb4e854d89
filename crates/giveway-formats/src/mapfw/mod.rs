//! Benchmarks and solutions of mapfw.nl (waypoints) and mapf.nl (colours).
//!
//! ```text
//! problem  = { "grid": [[0, 1, ..], ..],  a list for each row; 1 is a wall
//!              "width": W, "height": H,
//!              "starts": [[X, Y], ..], "goals": [[X, Y], ..],
//!              "waypoints": [[[X, Y], ..], ..] }       a list for each robot
//! download = { "problems": [{ "id": N, "problem": "..a problem as a text.." }, ..], .. }
//! upload   = { "solutions": [{ "problem": N, "time": MS, "solution": paths }, ..] }
//! paths    = [[[X, Y], ..], ..]           from time 0, a list for each robot
//! ```
//!
//! At mapf.nl cells are `{"x": X, "y": Y, "color": C}`, a robot may go to any goal
//! of its colour, and paths are `{"paths": [{"route": [..]}, ..]}`. A problem may
//! have a `solution` with it, and paths may stand alone. Source: the public clients
//! mapfw and mapfmclient.

mod fields;
mod problem;
mod write;

use serde::Deserialize;
use serde_json::value::RawValue;

use crate::limits::Steps;
use crate::unknown_keys::UnknownKeys;
use crate::{Conventions, Held, Walk, WrittenAgent, WrittenAt, WrittenPlan};
use fields::{Download, Paths, Problem, Upload};
use giveway_model::format::json::{self, placed};
use giveway_model::format::locate::Fields;
use giveway_model::{Fault, tr};

pub(super) use write::write;

/// The kinds of texts, known by their keys.
enum Shape {
    Problem,
    Download,
    Upload,
    Paths,
}

fn shape(text: &str) -> Option<Shape> {
    let blank = |c: &char| !c.is_whitespace();
    let mut beginning = text.chars().filter(blank);
    match beginning.next()? {
        '[' => {
            let is_list_of_lists = beginning.by_ref().take(2).all(|c| c == '[');
            let is_number = beginning
                .next()
                .is_some_and(|c| c.is_ascii_digit() || c == '-');
            return (is_list_of_lists && is_number).then_some(Shape::Paths);
        }
        '{' => {}
        _ => return None,
    }
    if !["\"grid\"", "\"problems\"", "\"solutions\""]
        .iter()
        .any(|key| text.contains(key))
    {
        return None;
    }
    let keys: Fields<'_> = serde_json::from_str(text).ok()?;
    if keys.has("grid") && keys.has("starts") {
        Some(Shape::Problem)
    } else if keys.has("problems") {
        Some(Shape::Download)
    } else {
        keys.has("solutions").then_some(Shape::Upload)
    }
}

/// The keys of a download and an upload, and of their entries, that are not read.
fn unknown_keys_of(text: &str) -> UnknownKeys {
    const KNOWN: [&str; 8] = [
        "problems",
        "solutions",
        "problem",
        "solution",
        "attempt",
        "batch",
        "debug",
        "progressive",
    ];
    let is_known = |key: &str| KNOWN.contains(&key) || problem::ABOUT.contains(&key);
    let mut unknown = UnknownKeys::in_object(text, is_known);
    let parts: Option<Entries<'_>> = serde_json::from_str(text).ok();
    for (way, entries) in parts.iter().flat_map(Entries::all) {
        for entry in entries {
            unknown.note_object(way, entry.get(), is_known);
        }
    }
    unknown
}

/// The keys of problems and solutions that stand in a list.
#[derive(Deserialize)]
struct Entries<'a> {
    #[serde(borrow, default)]
    problems: Vec<&'a RawValue>,
    #[serde(borrow, default)]
    solutions: Vec<&'a RawValue>,
}

impl<'a> Entries<'a> {
    fn all(&self) -> [(&'static str, &[&'a RawValue]); 2] {
        [("problems", &self.problems), ("solutions", &self.solutions)]
    }
}

/// Whether a text has the keys of a problem, a download, an upload, or is a list
/// of paths.
pub(super) fn sniff(text: &str) -> bool {
    shape(text).is_some()
}

/// Reads a problem, a solution, or both. Of several the first is read.
pub(super) fn read(text: &str) -> Result<Held, Fault> {
    let placed = |fault| placed(text, fault);
    match shape(text) {
        Some(Shape::Download) => first(text, &json::read_large(text)?),
        Some(Shape::Upload) => {
            let mut plan = of_upload(json::read_large(text)?).map_err(placed)?;
            plan.notes.extend(unknown_keys_of(text).sentence());
            Ok(Held::Plan(plan))
        }
        Some(Shape::Paths) => {
            let plan = plan("", json::read_large(text)?);
            plan.map(Held::Plan).map_err(placed)
        }
        Some(Shape::Problem) | None => of_problem(text, json::read_large(text)?),
    }
}

fn of_problem(text: &str, problem: Problem) -> Result<Held, Fault> {
    let (solution, problem) = problem.split();
    let (scene, remarks) = problem::scene(text, &problem).map_err(|fault| placed(text, fault))?;
    let Some(paths) = solution else {
        return Ok(Held::Scene(scene, remarks));
    };
    let plan = plan("solution", paths).map_err(|fault| placed(text, fault))?;
    Ok(Held::Both(scene, remarks, plan))
}

/// The first problem of a download. A fault in it has the place of the whole, since
/// it is a text in a text.
fn first(text: &str, download: &Download<'_>) -> Result<Held, Fault> {
    let Some(first) = download.problems.first() else {
        let fault = Fault::at(
            "problems",
            tr!("an empty list"),
            tr!("at least one problem"),
        );
        return Err(placed(text, fault));
    };
    let inner = &*first.problem.0;
    let held = json::read_large(inner).and_then(|problem| of_problem(inner, problem));
    let passed = unknown_keys_of(text);
    let mut held = held.map_err(|fault| {
        let inside = if fault.place.is_empty() { "" } else { "." };
        let place = format!("problems[0].problem{inside}{}", fault.place);
        let whole = placed(text, Fault::at("problems[0].problem", "", ""));
        Fault {
            place,
            line: whole.line,
            column: whole.column,
            ..fault
        }
    })?;
    let all = download.problems.len();
    let note = format!("The file has {all} problems; the first is read.");
    if let Held::Scene(scene, remarks) | Held::Both(scene, remarks, _) = &mut held {
        remarks.notes.splice(0..0, (all > 1).then_some(note));
        scene.assumptions.extend(passed.assumptions());
    }
    Ok(held)
}

fn of_upload(upload: Upload) -> Result<WrittenPlan, Fault> {
    let all = upload.solutions.len();
    let Some(first) = upload.solutions.into_iter().next() else {
        let expected = tr!("at least one solution");
        return Err(Fault::at("solutions", tr!("an empty list"), expected));
    };
    let mut plan = plan("solutions[0].solution", first.solution)?;
    if all > 1 {
        let note = format!("The file has {all} solutions; the first is read.");
        plan.notes.push(note);
    }
    Ok(plan)
}

/// The plan of some paths; `list` are the keys on the way to them.
fn plan(list: &'static str, Paths(paths): Paths) -> Result<WrittenPlan, Fault> {
    let mut steps = Steps::default();
    let mut agents = Vec::with_capacity(paths.len());
    for (i, route) in paths.into_iter().enumerate() {
        let place = || format!("{list}[{i}]");
        steps.add(route.0.len()).map_err(|fault| Fault {
            place: place(),
            ..fault
        })?;
        if route.0.is_empty() {
            return Err(Fault::at(
                place(),
                tr!("an empty path"),
                tr!("a cell at least"),
            ));
        }
        agents.push(WrittenAgent::walking(
            Walk::Cells(route.0),
            WrittenAt::Entry(list, i),
        ));
    }
    Ok(WrittenPlan::new(agents, Conventions::OWN))
}
