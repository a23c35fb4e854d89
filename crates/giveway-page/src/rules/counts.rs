//! How many robots are in a zone at each time of the plan on the board.

use giveway_model::{Constraint, Plan};

use super::outdated::judged_by;
use super::zone_of;
use crate::{Answer, State};

/// How many robots are in the zone at some times on end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Count {
    /// For how many times.
    pub times: u32,
    /// The number of robots.
    pub robots: u32,
    /// Whether the rule holds then.
    pub is_in: bool,
    /// Whether the rule is broken then.
    pub is_over: bool,
}

/// How many robots are in a zone at each time of the plan on the board, equal ones as one.
pub(super) fn counts(state: &State, rule: &Constraint, broken: &[u32]) -> Vec<Count> {
    let answer = judged_by(state);
    let plan = answer.and_then(Answer::plan);
    let (Some(answer), Some(plan), Some(zone)) = (answer, plan, zone_of(&rule.kind)) else {
        return Vec::new();
    };
    let last = answer.makespan();
    let bound = rule.agents.as_deref();
    let agents = state.document.agents().iter();
    let agents = agents.filter(|agent| bound.is_none_or(|names| names.contains(&agent.name)));
    let inside: Vec<Vec<u32>> = agents
        .map(|agent| times_in(state, plan, zone, &agent.name, last))
        .collect();
    let mut kind = rule.kind.clone();
    let times = super::parts(&mut kind).times.map(|times| *times);
    let count = |time: u32| Count {
        times: 1,
        robots: inside.iter().filter(|times| times.contains(&time)).count() as u32,
        is_in: times.is_none_or(|times| times.contains(time)),
        is_over: broken.contains(&time),
    };
    let mut counts: Vec<Count> = Vec::new();
    for count in (0..=last).map(count) {
        match counts.last_mut() {
            Some(run) if (Count { times: 1, ..*run }) == count => run.times += 1,
            Some(_) | None => counts.push(count),
        }
    }
    counts
}

/// The times at which a robot is in a zone: at a cell of it, or in transit over an edge with
/// an end in it.
pub(super) fn times_in(state: &State, plan: &Plan, zone: &str, name: &str, last: u32) -> Vec<u32> {
    let scene = state.document.draft.scene();
    let Some(zone) = scene.zones.iter().find(|of| of.name == zone) else {
        return Vec::new();
    };
    let cells = zone.cell_set();
    let path = plan.path(name);
    let stays = scene.rules.at_goal == giveway_model::AtGoal::Stay;
    let at = |time: usize| match path.get(time) {
        Some(cell) => *cell,
        None if stays => path.last().copied().flatten(),
        None => None,
    };
    let is_in = |&time: &u32| {
        let time = time as usize;
        let Some(cell) = at(time) else {
            // Between two cells, or gone.
            let is_passing = time < path.len();
            let ends = [time.checked_sub(1).and_then(at), at(time + 1)];
            return is_passing && ends.into_iter().flatten().any(|end| cells.contains(&end));
        };
        cells.contains(&cell)
    };
    (0..=last).filter(is_in).collect()
}
