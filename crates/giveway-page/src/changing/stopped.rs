//! Robots that broke down for good: each stays where it is as an obstacle with its name.

use giveway_model::change::What;
use giveway_model::words::Sentence;
use giveway_model::{Cell, Plan, tr, tr_data};

use super::Changing;
use crate::{Answer, State};

/// A robot that broke down for good.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Stopped {
    /// Its name.
    pub name: String,
    /// Its index on the board.
    pub agent: Option<usize>,
    /// Where it stays.
    pub cell: Cell,
}

impl Changing {
    /// The changes by which an agent breaks down for good.
    ///
    /// # Errors
    /// That it is between two cells.
    pub(super) fn stop(&self, agent: usize) -> Result<Vec<What>, Sentence> {
        let Some(agent) = self.draft().agents().get(agent).map(|own| own.name.clone()) else {
            return Ok(Vec::new());
        };
        let plan = self.about.plan();
        match plan.and_then(|plan| place(plan, &agent, self.at)) {
            Some(cell) => Ok(vec![
                What::RemoveAgent { agent },
                What::AddObstacle { cell },
            ]),
            None => Err(tr_data!(
                "{agent} is between two cells then. Show another time, or let it break down for some steps.",
                agent
            )),
        }
    }
}

/// Where a plan has an agent at a time, by its name; `None` in transit and where it is not there.
pub(super) fn place(plan: &Plan, agent: &str, at: u32) -> Option<Cell> {
    let path = plan.path(agent);
    let from = plan.from.get(agent).copied().unwrap_or(0);
    let time = at.checked_sub(from)? as usize;
    let last = path.len().checked_sub(1)?;
    *path.get(time.min(last))?
}

/// The obstacle that a removed agent of the list stays as, by its index.
pub(crate) fn obstacle_of(
    plan: Option<&Plan>,
    list: &[What],
    at: u32,
    index: usize,
) -> Option<(usize, Cell)> {
    let What::RemoveAgent { agent } = list.get(index)? else {
        return None;
    };
    let plan = plan?;
    if let Some(cell) = place(plan, agent, at) {
        let obstacle = What::AddObstacle { cell };
        if let Some(found) = list.iter().position(|what| *what == obstacle) {
            return Some((found, cell));
        }
    }
    // The plan that went on ends before: there the obstacle follows the removal, a step on.
    let last = plan.path(agent).iter().rev().find_map(|cell| *cell)?;
    let Some(What::AddObstacle { cell }) = list.get(index + 1) else {
        return None;
    };
    let ends = plan.until.contains_key(agent);
    let away = last.x.abs_diff(cell.x) + last.y.abs_diff(cell.y);
    (ends && away <= 1).then_some((index + 1, *cell))
}

/// How many robots have broken down for good, beside those that are there.
#[inline(never)]
pub(crate) fn stopped_in_words(n: usize) -> String {
    tr!("{n} broken down for good", n)
}

/// When and where an agent of a plan that went on broke down for good.
#[inline(never)]
pub(crate) fn stopped(answer: &Answer, agent: &str) -> Option<(u32, Cell)> {
    past(answer).find_map(|(at, list)| {
        let is_it = |what: &What| matches!(what, What::RemoveAgent { agent: own } if own == agent);
        let index = list.iter().position(is_it)?;
        let (_, cell) = obstacle_of(answer.plan(), &list, at, index)?;
        Some((at, cell))
    })
}

/// The robots that have broken down for good in a world that changes.
pub(super) fn of_changes(state: &State) -> Vec<Stopped> {
    let mut all = Vec::new();
    let mut add = |plan: Option<&Plan>, list: &[What], at: u32| {
        for (index, what) in list.iter().enumerate() {
            let What::RemoveAgent { agent } = what else {
                continue;
            };
            if let Some((_, cell)) = obstacle_of(plan, list, at, index) {
                let mut agents = state.world().agents().iter();
                all.push(Stopped {
                    name: agent.clone(),
                    agent: agents.position(|own| own.name == *agent),
                    cell,
                });
            }
        }
    };
    let time = state.view.playback.time;
    if let Some(answer) = state.shown() {
        for (at, list) in past(answer).filter(|(at, _)| *at <= time) {
            add(answer.plan(), &list, at);
        }
    }
    let compares = state.document.mode.comparing().is_some();
    if let Some(changing) = state
        .document
        .mode
        .changing()
        .filter(|own| own.at <= time && !compares)
    {
        add(changing.about.plan(), &changing.list, changing.at);
    }
    all.dedup();
    all
}

/// What changed around the plan of an answer, by time.
fn past(answer: &Answer) -> impl Iterator<Item = (u32, Vec<What>)> {
    let course = answer.course.as_deref();
    let changes = course.map_or(&[][..], |course| &course.changes.changes);
    let times = changes.chunk_by(|one, other| one.at == other.at);
    times.filter_map(|chunk| {
        let at = chunk.first()?.at;
        Some((at, chunk.iter().map(|change| change.what.clone()).collect()))
    })
}
