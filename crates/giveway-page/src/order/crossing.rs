//! Who passes a cell, in order, with times.

use std::collections::BTreeMap;

use giveway_model::{Cell, Plan};
use giveway_order::{AgentOrder, Link, Order};

use crate::State;

/// A robot's pass through a cell.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Pass {
    /// Its name.
    pub(super) name: String,
    /// The number of its visit, from 0.
    pub(super) visit: usize,
    /// The first time at which it is there.
    pub(super) arrives: u32,
    /// The last time at which it is there; `None` where it stays for good.
    pub(super) leaves: Option<u32>,
    /// When it begins its move into the cell; `None` where its way begins.
    pub(super) begins: Option<u32>,
}

/// From one robot of a cell to the next.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Step {
    /// How many steps later the first may leave before the second has to wait.
    pub(super) slack: u32,
    /// Whether one follows the other in the same step.
    pub(super) is_tight: bool,
}

/// The cell with the most links; the first of them, row by row.
pub(crate) fn busiest(order: &Order) -> Option<Cell> {
    let mut counts: BTreeMap<(u32, u32), usize> = BTreeMap::new();
    for link in &order.links {
        *counts.entry((link.cell.y, link.cell.x)).or_default() += 1;
    }
    let most = counts.values().copied().max()?;
    let (&(y, x), _) = counts.iter().find(|(_, count)| **count == most)?;
    Some(Cell::new(x, y))
}

/// The visits of a cell by a robot, by their numbers from 0.
pub(crate) fn visits_at(agent: &AgentOrder, cell: Cell) -> impl Iterator<Item = usize> + '_ {
    let visits = agent.visits.iter().enumerate();
    visits
        .filter(move |(_, visit)| visit.cell == cell)
        .map(|(number, _)| number)
}

/// Who passes a cell, in order, at the times of the plan that is shown.
pub(super) fn passes(state: &State, cell: Cell) -> Vec<Pass> {
    let Some(order) = state.order() else {
        return Vec::new();
    };
    let late = super::late::outcome(state).map(|late| &late.outcome.plan);
    let mut all: Vec<(u32, Pass)> = Vec::new();
    for agent in &order.agents {
        let mut visits = visits_at(agent, cell).peekable();
        if visits.peek().is_none() {
            continue;
        }
        let stays = late.map(|plan| stays(plan, &agent.agent));
        for visit in visits {
            let pass = match &stays {
                None => planned(agent, visit),
                Some(stays) => carried_out(agent, visit, stays),
            };
            if let Some(pass) = pass
                && let Some(at) = agent.visits.get(visit)
            {
                all.push((at.arrives, pass));
            }
        }
    }
    giveway_model::sorting::sort_by_key(&mut all, |(at, _)| *at);
    all.into_iter().map(|(_, pass)| pass).collect()
}

fn planned(agent: &AgentOrder, visit: usize) -> Option<Pass> {
    let it = agent.visits.get(visit)?;
    Some(Pass {
        name: agent.agent.clone(),
        visit,
        arrives: it.arrives,
        leaves: it.leaves,
        begins: it.comes,
    })
}

/// The pass in the late plan; `None` where the robot is removed before.
fn carried_out(agent: &AgentOrder, visit: usize, stays: &[(u32, u32)]) -> Option<Pass> {
    let it = agent.visits.get(visit)?;
    let &(arrives, leaves) = stays.get(visit)?;
    let before = visit.checked_sub(1).and_then(|before| stays.get(before));
    Some(Pass {
        name: agent.agent.clone(),
        visit,
        arrives,
        leaves: it.leaves.map(|_| leaves),
        begins: it.comes.and(before).map(|&(_, leaves)| leaves),
    })
}

/// The first and the last time of each of a robot's stays in a plan.
fn stays(plan: &Plan, name: &str) -> Vec<(u32, u32)> {
    let from = plan.from.get(name).copied().unwrap_or(0);
    let mut stays: Vec<(u32, u32)> = Vec::new();
    let mut before = None;
    for (time, &place) in (from..).zip(plan.path(name)) {
        match (place, stays.last_mut()) {
            (Some(cell), Some(stay)) if before == Some(cell) => stay.1 = time,
            (Some(_), _) => stays.push((time, time)),
            (None, _) => {}
        }
        before = place;
    }
    stays
}

/// From one pass to the next, at the times of the plan that is shown; `None` where they are of
/// one robot.
pub(super) fn between(state: &State, cell: Cell, first: &Pass, second: &Pass) -> Option<Step> {
    let is_between = |link: &&Link| {
        link.first.agent == first.name
            && link.first.visit as usize == first.visit
            && link.second.agent == second.name
            && link.second.visit as usize == second.visit
    };
    let link = state.order()?.at(cell).find(is_between)?;
    // One that comes to its first cell begins a step before it is there.
    let begins = second.begins.unwrap_or(second.arrives.saturating_sub(1));
    let slack = match first.leaves.filter(|_| state.late_plan().is_some()) {
        Some(leaves) => begins.saturating_sub(leaves).saturating_sub(link.gap),
        None => link.slack,
    };
    Some(Step {
        slack,
        is_tight: slack == 0 && link.gap == 0,
    })
}

/// The index of a robot of the plan.
pub(super) fn index(state: &State, name: &str) -> Option<usize> {
    let answer = state.document.fresh_answer()?;
    let mut agents = answer.agents().iter();
    agents.position(|agent| agent.name == name)
}
