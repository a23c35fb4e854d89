//! What a change would lead to if everyone went on as planned: who would run into what, and when.

use std::collections::BTreeSet;

use giveway_model::change::{History, What};
use giveway_model::check::{Rule, Violation, check_history};
use giveway_model::words::and;
use giveway_model::{Cell, tr};

use super::Changing;
use super::stopped::place;
use crate::timeline::Lane;
use crate::words::at;

/// The sentences about the changes that are listed, each with its place in the list.
pub(super) fn meets(changing: &Changing) -> Vec<(usize, String)> {
    let mut all = Vec::new();
    for (index, what) in changing.list.iter().enumerate() {
        let (cell, from, to, name, obstacle) = match what {
            What::AddObstacle { cell } | What::MoveObstacle { to: cell, .. } => {
                (*cell, changing.at, u32::MAX, None, at(*cell))
            }
            What::DelayAgent { agent, steps } => {
                let Some(lane) = others(changing).find(|lane| lane.name == *agent) else {
                    continue;
                };
                let (cell, from) = stands(&lane, changing.at);
                let to = from.saturating_add(*steps);
                (cell, from, to, Some(agent.as_str()), agent.clone())
            }
            What::StopAgent { agent } => {
                let Some(lane) = others(changing).find(|lane| lane.name == *agent) else {
                    continue;
                };
                let (cell, from) = stands(&lane, changing.at);
                (cell, from, u32::MAX, Some(agent.as_str()), agent.clone())
            }
            What::RemoveObstacle { .. }
            | What::SetSlow { .. }
            | What::SetNormal { .. }
            | What::AddCharger { .. }
            | What::RemoveCharger { .. }
            | What::AddAgent { .. }
            | What::RemoveAgent { .. }
            | What::SetGoal { .. }
            | What::AddWaypoint { .. }
            | What::DropWaypoint { .. }
            | What::SetBattery { .. }
            | What::RemoveConstraint { .. } => continue,
            What::AddConstraint { .. } => {
                all.extend(breaks(changing, what).map(|sentence| (index, sentence)));
                continue;
            }
        };
        let met = met_by(changing, name, cell, (from, to));
        let [(time, first), rest @ ..] = met.as_slice() else {
            continue;
        };
        let sentence = match rest.len() {
            0 => tr!(
                "{agent} would run into {obstacle} at {time}",
                agent = first,
                obstacle,
                time
            ),
            more => tr!(
                "{agent} would run into {obstacle} at {time}, and {n} more robot later"
                    | "{agent} would run into {obstacle} at {time}, and {n} more robots later"
                        % more,
                agent = first,
                obstacle,
                time
            ),
        };
        all.push((index, sentence));
    }
    all
}

/// Who would break a rule that is added, if everyone went on as planned.
fn breaks(changing: &Changing, what: &What) -> Option<String> {
    let plan = changing.about.plan()?;
    let mut history = History::clone(&changing.history);
    let change = changing.change(what);
    history.apply(changing.at, &[(0, &change)], plan).ok()?;
    let violations = check_history(&history, plan).violations;
    let broken = |violation: &&Violation| {
        violation.rule == Rule::Constraint && violation.time >= changing.at
    };
    let first = violations.iter().filter(broken).min_by_key(|it| it.time)?;
    let robots = and(&first.agents);
    Some(match first.agents.len() {
        0 => tr!(
            "The plan would break the new rule at {time}",
            time = first.time
        ),
        n => tr!(
            "{robots} would break the new rule at {time}"
                | "{robots} would break the new rule at {time}" % n,
            robots,
            time = first.time
        ),
    })
}

/// The robots that are in some cells when the world changes.
pub(crate) fn inside(changing: &Changing, cells: &BTreeSet<Cell>) -> Vec<String> {
    let Some(plan) = changing.about.plan() else {
        return Vec::new();
    };
    let names = others(changing).map(|lane| lane.name);
    let cell_of = |name: &str| place(plan, name, changing.at);
    names
        .filter(|name| cell_of(name).is_some_and(|cell| cells.contains(&cell)))
        .collect()
}

/// Who enters a cell or stands on it within some times if all go on as planned, the first one
/// first; but for one robot.
pub(super) fn met_by(
    changing: &Changing,
    but: Option<&str>,
    cell: Cell,
    (from, to): (u32, u32),
) -> Vec<(u32, String)> {
    let lanes = others(changing).filter(|lane| but != Some(&*lane.name));
    let met = lanes.filter_map(|lane| Some((first_at(&lane, cell, from, to)?, lane.name)));
    let mut met: Vec<(u32, String)> = met.collect();
    giveway_model::sorting::sort(&mut met);
    met
}

/// The plans of the robots that are not removed.
fn others(changing: &Changing) -> impl Iterator<Item = Lane> {
    let agents = 0..changing.about.agents().len();
    let is_removed = |name: &str| {
        let removed = |what: &What| matches!(what, What::RemoveAgent { agent } if agent == name);
        changing.list.iter().any(removed)
    };
    let lanes = agents.filter_map(|agent| Lane::of(&changing.about, agent));
    lanes.filter(move |lane| lane.removed.is_none() && !is_removed(&lane.name))
}

/// Where a robot stands from a time on, and since when: at the end of the move under way.
pub(super) fn stands(lane: &Lane, at: u32) -> (Cell, u32) {
    let begun = lane.steps.iter().rev().find(|step| step.begins < at);
    begun.map_or((lane.entry, at.max(lane.begins)), |step| {
        (step.to, at.max(step.ends))
    })
}

/// The first time from `from` on and before `to` at which a robot enters or stands on a cell.
fn first_at(lane: &Lane, cell: Cell, from: u32, to: u32) -> Option<u32> {
    let entered = lane.steps.iter().filter(|step| step.to == cell);
    let mut times = entered
        .map(|step| step.ends)
        .filter(|time| (from..to).contains(time));
    let rests = || (lane.stays && lane.end() == cell && lane.arrival <= from).then_some(from);
    times.next().or_else(rests)
}
