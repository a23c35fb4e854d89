//! From the keys of a result to a plan.

use super::errands;
use super::fields::{Fields, Start};
use super::steps::{Unknown, letters, most, plain, turning};
use super::ticks;
use crate::format::foreign::limits::Steps;
use crate::format::foreign::{
    CellOrder, Claimed, Conventions, Heading, Held, Origin, Pair, Up, Walk, WrittenAgent,
    WrittenAt, WrittenCell, WrittenPlan,
};
use crate::format::json;
use crate::format::locate::{Locator, segments};
use crate::format::text::{position, shorten};
use crate::words::count;
use crate::{Fault, tr};

/// What the League documents.
const DOCUMENTED: Conventions = Conventions {
    cells: CellOrder::RowColumn,
    origin: Origin::Zero,
    up: Up::Raises,
};

/// The ticks of a move where a file does not say.
const TICKS: u32 = 10;

/// Reads a result.
pub(in crate::format::foreign) fn read(text: &str) -> Result<Held, Vec<Fault>> {
    let fields: Fields<'_> = json::read_large(text).map_err(|fault| vec![fault])?;
    plan(&fields)
        .map(Held::Plan)
        .map_err(|fault| vec![placed(text, fault)])
}

/// The fault with the line and column of its place.
fn placed(text: &str, fault: Fault) -> Fault {
    let offset = Locator::new(text).find(&segments(&fault.place), false);
    let (line, column) = position(text, offset.unwrap_or_default());
    fault.in_text(line, column)
}

fn plan(fields: &Fields<'_>) -> Result<WrittenPlan, Fault> {
    let robots = fields.start.len();
    if fields.actual_paths.len() != robots {
        let found = tr!("{n} path" | "{n} paths" % fields.actual_paths.len());
        let expected = tr!("{robots}, one for each start", robots);
        return Err(Fault::at("actualPaths", found, expected));
    }
    let model = match &*fields.action_model.0 {
        "MAPF" => Model::Plain,
        "MAPF_T" => Model::Turning,
        other => {
            let found = format!("\"{}\"", shorten(other));
            return Err(Fault::at("actionModel", found, tr!("MAPF or MAPF_T")));
        }
    };
    let visited = errands::done(fields).map_err(errands::fault)?;
    let mut steps = Steps::default();
    let mut agents = Vec::with_capacity(robots);
    let mut is_in_ticks = false;
    let paths = fields.actual_paths.iter().map(|path| &*path.0);
    for (i, ((start, path), waypoints)) in fields.start.iter().zip(paths).zip(visited).enumerate() {
        let place = format!("actualPaths[{i}]");
        is_in_ticks |= path.starts_with('[');
        let walk = match model {
            Model::Plain => plain_walk(path, &mut steps).map(Walk::Moves),
            Model::Turning => {
                let full = fields.agent_max_counter.unwrap_or(TICKS);
                let actions = if path.starts_with('[') {
                    ticks::actions(path, full, &mut steps)
                } else {
                    turning_walk(path, &mut steps)
                };
                let heading = heading(i, start)?;
                actions.map(|actions| Walk::Turns(heading, actions))
            }
        };
        let walk = walk.map_err(|refused| match refused {
            ticks::Refused::TooMany(fault) => Fault { place, ..fault },
            ticks::Refused::Unknown(unknown) => unexpected(&place, path, &unknown),
        })?;
        agents.push(WrittenAgent {
            start: Some(WrittenCell {
                pair: Pair::new(start.row, start.column),
                at: WrittenAt::Entry("start", i),
            }),
            waypoints,
            ..WrittenAgent::walking(walk, WrittenAt::Entry("actualPaths", i))
        });
    }
    Ok(WrittenPlan {
        map: None,
        agents,
        claimed: Claimed {
            makespan: fields.makespan,
            sum_of_costs: fields.sum_of_cost,
        },
        documented: DOCUMENTED,
        notes: notes(fields, is_in_ticks),
    })
}

#[derive(Clone, Copy)]
enum Model {
    Plain,
    Turning,
}

fn plain_walk(
    path: &str,
    steps: &mut Steps,
) -> Result<Vec<crate::format::foreign::Move>, ticks::Refused> {
    steps.add(most(path)).map_err(ticks::Refused::TooMany)?;
    Ok(letters(path, plain, "U D L R W T")?)
}

fn turning_walk(
    path: &str,
    steps: &mut Steps,
) -> Result<Vec<crate::format::foreign::Action>, ticks::Refused> {
    steps.add(most(path)).map_err(ticks::Refused::TooMany)?;
    Ok(letters(path, turning, "F R C W T")?)
}

fn unexpected(place: &str, path: &str, unknown: &Unknown) -> Fault {
    let rest = path.get(unknown.offset..).unwrap_or("");
    let found = rest.chars().next().map_or_else(
        || tr!("the end of the path").to_owned(),
        |c| format!("\"{}\"", shorten(&c.to_string())),
    );
    let place = format!("{place}[{}]", unknown.offset);
    Fault::at(place, found, &*unknown.expected)
}

fn heading(i: usize, start: &Start<'_>) -> Result<Heading, Fault> {
    match start.heading.as_deref() {
        Some("E") => Ok(Heading::East),
        Some("S") => Ok(Heading::South),
        Some("W") => Ok(Heading::West),
        Some("N") => Ok(Heading::North),
        other => {
            let found = other.map_or_else(
                || tr!("no heading").to_owned(),
                |other| tr!("the heading \"{heading}\"", heading = shorten(other)),
            );
            Err(Fault::at(format!("start[{i}]"), found, tr!("E, S, W or N")))
        }
    }
}

fn notes(fields: &Fields<'_>, is_in_ticks: bool) -> Vec<String> {
    let mut notes = Vec::new();
    let is_invalid = fields
        .all_valid
        .as_ref()
        .is_some_and(|valid| valid.0.eq_ignore_ascii_case("no"));
    let errors = fields.errors.len();
    match (is_invalid, errors) {
        (false, 0) => {}
        (true, 0) => notes.push("The file says itself that the plan is not valid.".to_owned()),
        (_, _) => notes.push(format!(
            "The file lists {} of its planner. Robots wait where its moves were refused, so the steps that they took may be legal.",
            count(errors, "error")
        )),
    }
    if is_in_ticks {
        let full = fields.agent_max_counter.unwrap_or(TICKS);
        notes.push(format!(
            "A step is a tick: a move or a turn takes {}, and a robot counts as at its old cell until it is done.",
            count(full, "step")
        ));
    }
    if !fields.tasks.is_empty() {
        notes.push(
            "What a robot visited for its tasks are its waypoints, each once and in any order. Its goal is where its path ends."
                .to_owned(),
        );
    }
    if let Some(version) = &fields.version {
        notes.push(format!(
            "The file is of the version \"{}\".",
            shorten(&version.0)
        ));
    }
    notes
}
