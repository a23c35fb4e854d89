//! From the keys of a result to a plan.

use super::Problem;
use super::errands;
use super::fields::{Fields, Start};
use super::steps::{letters, plain, turning};
use super::ticks;
use crate::limits::Steps;
use crate::{
    CellOrder, Conventions, Heading, Held, Origin, Pair, Up, Walk, WrittenAgent, WrittenAt,
    WrittenCell, WrittenPlan,
};
use giveway_model::compare::Claimed;
use giveway_model::format::json::{self, placed};
use giveway_model::format::locate::Fields as Keys;
use giveway_model::format::text::shorten;
use giveway_model::words::count;
use giveway_model::{Fault, LeftOutRule, tr};

/// The numbers as the League documents them.
const DOCUMENTED: Conventions = Conventions {
    cells: CellOrder::RowColumn,
    origin: Origin::Zero,
    up: Up::Raises,
};

/// The ticks of a move where a file does not say.
const TICKS: u32 = 10;

/// Reads a result.
pub(crate) fn read(text: &str) -> Result<Held, Fault> {
    if let Some(problem) = Problem::read(text) {
        return problem.map(Held::Problem);
    }
    if serde_json::from_str::<Keys<'_>>(text).is_ok_and(|keys| super::is_summary(&keys)) {
        let found = tr!(
            "a summary of the League of Robot Runners, which has no paths: there is nothing to judge"
        );
        let expected =
            tr!("a result with \"actualPaths\", as the Start-Kit writes it with --outputScreen 1");
        return Err(Fault::at("", found, expected).in_text(1, 1));
    }
    let mut fields: Fields<'_> = json::read_large(text)?;
    let starts = fields.start.len();
    if let Some(team) = fields.team_size.filter(|&team| team > starts) {
        let expected = tr!(
            "{starts}, as there are starts: the robots of the team",
            starts
        );
        let fault = Fault::at("teamSize", team.to_string(), expected);
        return Err(placed(text, fault));
    }
    let note = limit_to_team(&mut fields);
    plan(&fields)
        .map(|mut plan| {
            plan.notes.extend(note);
            plan.notes.extend(unknown_keys_of(text));
            Held::Plan(plan)
        })
        .map_err(|fault| placed(text, fault))
}

/// The keys that the League writes.
const KNOWN: [&str; 22] = [
    "actionModel",
    "version",
    "AllValid",
    "teamSize",
    "start",
    "numTaskFinished",
    "numPlannerErrors",
    "numScheduleErrors",
    "numEntryTimeouts",
    "sumOfCost",
    "makespan",
    "actualPaths",
    "plannerPaths",
    "plannerTimes",
    "errors",
    "scheduleErrors",
    "events",
    "tasks",
    "actualSchedule",
    "plannerSchedule",
    "agentMaxCounter",
    "outputSegmentSize",
];

/// The keys that no result of the League has, and that are not read, as a sentence.
fn unknown_keys_of(text: &str) -> Option<String> {
    let keys: Keys<'_> = serde_json::from_str(text).ok()?;
    let others: Vec<&str> = keys.names().filter(|name| !KNOWN.contains(name)).collect();
    let names = shorten(&others.join(", "));
    (!others.is_empty()).then(|| tr!("Keys that are not read: {names}.", names))
}

/// Leaves out the starts beyond the size of the team, which have no paths; where the file
/// has more paths than robots in its team, the note says so.
fn limit_to_team(fields: &mut Fields<'_>) -> Option<String> {
    let team = fields.team_size?;
    let starts = fields.start.len();
    if starts <= team {
        return None;
    }
    let beyond = fields.actual_paths.iter().skip(team);
    if beyond.into_iter().any(|path| !path.0.is_empty()) {
        let n = fields.actual_paths.len();
        return Some(tr!(
            "teamSize is {team}, and the file has the paths of {n} robots: all of them are read.",
            team,
            n
        ));
    }
    fields.start.truncate(team);
    fields.actual_paths.truncate(team);
    let others = starts - team;
    Some(tr!(
        "teamSize is {team}: further starts ({others}) are left out, since they have no paths.",
        team,
        others
    ))
}

fn plan(fields: &Fields<'_>) -> Result<WrittenPlan, Fault> {
    let robots = fields.start.len();
    if fields.actual_paths.len() != robots {
        let found = tr!("{n} path" | "{n} paths" % fields.actual_paths.len());
        let expected = tr!("{robots}, one for each start", robots);
        return Err(Fault::at("actualPaths", found, expected));
    }
    let turns = match &*fields.action_model.0 {
        "MAPF" => false,
        "MAPF_T" => true,
        other => {
            let found = format!("\"{}\"", shorten(other));
            return Err(Fault::at("actionModel", found, tr!("MAPF or MAPF_T")));
        }
    };
    let visited = errands::done(fields)?;
    let mut steps = Steps::default();
    let mut agents = Vec::with_capacity(robots);
    let mut is_in_ticks = false;
    let paths = fields.actual_paths.iter().map(|path| &*path.0);
    for (i, ((start, path), waypoints)) in fields.start.iter().zip(paths).zip(visited).enumerate() {
        is_in_ticks |= path.starts_with('[');
        let walk = if turns {
            let heading = heading(i, start)?;
            let actions = if path.starts_with('[') {
                let full = fields.agent_max_counter.unwrap_or(TICKS);
                ticks::actions(path, full, &mut steps)
            } else {
                letters(path, (turning, "F R C W T"), &mut steps)
            };
            actions.map(|actions| Walk::Turns(heading, actions))
        } else {
            letters(path, (plain, "U D L R W T"), &mut steps).map(Walk::Moves)
        };
        let walk = walk.map_err(|fault| Fault {
            place: format!("actualPaths[{i}]{}", fault.place),
            ..fault
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
        left_out: left_out(&agents, is_in_ticks, turns),
        claimed: Claimed {
            makespan: fields.makespan,
            sum_of_costs: fields.sum_of_cost,
        },
        notes: notes(fields, is_in_ticks, turns),
        ..WrittenPlan::new(agents, DOCUMENTED)
    })
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

/// The rules of the League that scenes do not have.
fn left_out(agents: &[WrittenAgent], is_in_ticks: bool, turns: bool) -> Vec<LeftOutRule> {
    let has_errands = agents.iter().any(|agent| agent.waypoints.len() > 1);
    let rules = [
        (turns, LeftOutRule::Turning),
        (is_in_ticks, LeftOutRule::LongMoves),
        (has_errands, LeftOutRule::ErrandOrder),
    ];
    let rules = rules.into_iter();
    rules
        .filter_map(|(is_there, rule)| is_there.then_some(rule))
        .collect()
}

fn notes(fields: &Fields<'_>, is_in_ticks: bool, turns: bool) -> Vec<String> {
    let mut notes = Vec::new();
    if turns {
        notes.push("The robots turn, and a turn is shown as a wait.".to_owned());
    }
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
