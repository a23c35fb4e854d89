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

use crate::format::foreign::limits::Steps;
use crate::format::foreign::{
    Claimed, Conventions, Held, Walk, WrittenAgent, WrittenAt, WrittenPlan,
};
use crate::format::json;
use crate::format::locate::{Fields, Locator, segments};
use crate::format::text::position;
use crate::{Fault, tr};
use fields::{Download, Paths, Problem, Upload};

pub(super) use write::write;

/// What a text is, told by its keys.
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

/// Whether a text has the keys of a problem, a download, an upload, or is a list
/// of paths.
pub(super) fn sniff(text: &str) -> bool {
    shape(text).is_some()
}

/// Reads a problem, a solution, or both. Of several the first is read.
pub(super) fn read(text: &str) -> Result<Held, Vec<Fault>> {
    let held = match shape(text) {
        Some(Shape::Download) => json::read_large(text).and_then(|download| first(text, &download)),
        Some(Shape::Upload) => json::read_large(text)
            .and_then(|upload: Upload| of_upload(upload).map_err(|it| placed(text, it))),
        Some(Shape::Paths) => json::read_large(text).and_then(|paths: Paths| {
            plan("", paths)
                .map(Held::Plan)
                .map_err(|it| placed(text, it))
        }),
        Some(Shape::Problem) | None => {
            json::read_large(text).and_then(|problem| of_problem(text, problem))
        }
    };
    held.map_err(|fault| vec![fault])
}

/// The fault with the line and column of its place.
fn placed(text: &str, fault: Fault) -> Fault {
    let offset = Locator::new(text).find(&segments(&fault.place), false);
    let (line, column) = position(text, offset.unwrap_or_default());
    fault.in_text(line, column)
}

fn of_problem(text: &str, problem: Problem) -> Result<Held, Fault> {
    let (solution, problem) = problem.split();
    let mut notes = Vec::new();
    let scene = problem::scene(&problem, &mut notes).map_err(|fault| placed(text, fault))?;
    let Some(paths) = solution else {
        return Ok(Held::Scene(scene, notes));
    };
    let mut plan = plan("solution", paths).map_err(|fault| {
        let place = format!("solution{}", fault.place);
        placed(text, Fault { place, ..fault })
    })?;
    plan.notes = notes;
    Ok(Held::Both(scene, plan))
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
    let held = held.map_err(|fault| {
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
    let others = download.problems.len() - 1;
    let note = format!("The file has {} problems; the first is read.", others + 1);
    Ok(match held {
        Held::Scene(scene, mut notes) if others > 0 => {
            notes.insert(0, note);
            Held::Scene(scene, notes)
        }
        held => held,
    })
}

fn of_upload(upload: Upload) -> Result<Held, Fault> {
    let all = upload.solutions.len();
    let Some(first) = upload.solutions.into_iter().next() else {
        let expected = tr!("at least one solution");
        return Err(Fault::at("solutions", tr!("an empty list"), expected));
    };
    let list = "solutions[0].solution";
    let mut plan = plan(list, first.solution).map_err(|fault| Fault {
        place: format!("{list}{}", fault.place),
        ..fault
    })?;
    if all > 1 {
        let note = format!("The file has {all} solutions; the first is read.");
        plan.notes.push(note);
    }
    Ok(Held::Plan(plan))
}

/// The plan of some paths; `list` are the keys on the way to them.
fn plan(list: &'static str, Paths(paths): Paths) -> Result<WrittenPlan, Fault> {
    let mut steps = Steps::default();
    let mut agents = Vec::with_capacity(paths.len());
    for (i, route) in paths.into_iter().enumerate() {
        let place = || format!("[{i}]");
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
    Ok(WrittenPlan {
        map: None,
        agents,
        claimed: Claimed::default(),
        documented: Conventions::OWN,
        notes: Vec::new(),
    })
}
