//! The layer `here`: what the plan shows where something is asked about.

use std::rc::Rc;

use giveway_model::{Cell, Question, sorting::sort_by_key};

use super::{
    fitting::FittingQuestion,
    layers::{Here, Passing},
    losses::loss,
    own_way,
    waits::{TakenOut, without_waits},
    words,
};
use crate::budget::Budget;

/// What the plan shows; `None` where no single agent would do otherwise.
pub(crate) fn here(case: &FittingQuestion, budget: &Rc<Budget>) -> Option<Here> {
    let loss = loss(case, budget);
    let lost = || Some((loss.as_ref()?.agent.clone(), Vec::new()));
    let (agent, violations) = own_way::witness(case, budget).or_else(lost)?;
    let passing = match case.question {
        Question::Wait { .. } => without_waits(case.instance, case.question, case.plan)
            .map_or_else(Vec::new, |taken| passing(case, &agent, &taken)),
        Question::Yield { to, at, .. } => first_visit(case, to, *at).into_iter().collect(),
        Question::Charge { .. }
        | Question::NoCharge { .. }
        | Question::Visit { .. }
        | Question::NoVisit { .. }
        | Question::Move { .. }
        | Question::NoMove { .. }
        | Question::Slow { .. }
        | Question::Order { .. }
        | Question::Arrival { .. }
        | Question::Length { .. }
        | Question::Makespan
        | Question::SumOfCosts
        | Question::Charges { .. }
        | Question::Moves { .. }
        | Question::Waits { .. }
        | Question::Penalty
        | Question::Rule { .. }
        | Question::Unsolvable
        | Question::Plan => Vec::new(),
    };
    let mut here = Here {
        agent,
        passing,
        violations,
        words: String::new(),
    };
    here.words = words::here_sentence(case, &here, loss.as_ref());
    Some(here)
}

/// The agents that use the next cells of an agent's way during its first wait that is asked
/// about: as many cells as it would enter meanwhile.
fn passing(case: &FittingQuestion, agent: &str, taken: &TakenOut) -> Vec<Passing> {
    let path = taken.plan.path(agent);
    let (first, last) = (taken.from as usize, taken.to as usize);
    let next = path.get(first..).unwrap_or_default();
    let here = next.first().copied().flatten();
    let mut ahead: Vec<Cell> = Vec::new();
    for &cell in next.iter().take(last - first + 2).flatten() {
        if Some(cell) != here && !ahead.contains(&cell) {
            ahead.push(cell);
        }
    }
    let mut found: Vec<(usize, Passing)> = Vec::new();
    for other in case.instance.agents().iter().filter(|it| it.name != agent) {
        let at = |time: usize| {
            let path = case.plan.path(&other.name);
            path.get(time).copied().unwrap_or(other.goal)
        };
        let uses = |&cell: &Cell| (first..=last + 1).find(|&time| at(time) == Some(cell));
        let used = ahead.iter().enumerate();
        let used = used.filter_map(|(place, cell)| Some((place, *cell, uses(cell)?)));
        found.extend(used.min().map(|(place, cell, time)| {
            let passing = Passing {
                agent: other.name.clone(),
                cell,
                time: case.whole.time(time as u32),
            };
            (place, passing)
        }));
    }
    sort_by_key(&mut found, |(place, it)| (*place, it.time));
    found.into_iter().map(|(_, passing)| passing).collect()
}

/// When an agent is at a cell first.
fn first_visit(case: &FittingQuestion, agent: &str, cell: Cell) -> Option<Passing> {
    let mut path = case.plan.path(agent).iter();
    let time = path.position(|&entry| entry == Some(cell))?;
    Some(Passing {
        agent: agent.to_owned(),
        cell,
        time: case.whole.time(time as u32),
    })
}
