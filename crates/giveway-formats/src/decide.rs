//! Tries the conventions of a plan and takes those that fit.

use borsh::{BorshDeserialize, BorshSerialize};
use serde::{Deserialize, Serialize};

use super::place::{self, Known};
use super::{Conventions, Fit, WrittenAgent, WrittenPlan};
use giveway_model::{Cell, Grid};

/// Another way to read a plan.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
pub struct Alternative {
    /// The conventions.
    pub conventions: Conventions,
    /// The first thing that does not fit then; `None` where all fits.
    pub misfit: Option<String>,
}

/// The conventions that were taken, and why.
#[derive(Clone, Debug)]
pub(super) struct Decision {
    pub(super) conventions: Conventions,
    pub(super) fit: Fit,
    /// A sentence.
    pub(super) why: String,
    /// All others.
    pub(super) alternatives: Vec<Alternative>,
}

/// A task as the files give it: start and goal, where there is one.
pub(super) type Task = (Cell, Option<Cell>);

/// The name of an agent: its own, or `A1` and so on.
pub(super) fn name(agent: &WrittenAgent, index: usize) -> String {
    agent
        .name
        .clone()
        .unwrap_or_else(|| format!("A{}", index + 1))
}

/// Takes the conventions under which every move is legal and every agent ends at
/// its goal; where there are none, those with the fewest misfits. The order of
/// [`Conventions::candidates`] decides where several fit. `chosen` are those that
/// a person wants instead.
pub(super) fn decide(
    plan: &WrittenPlan,
    grid: &Grid,
    tasks: Option<&[Option<Task>]>,
    chosen: Option<Conventions>,
) -> Decision {
    let mut tried: Vec<(Conventions, Fit)> = Vec::new();
    let mut is_found = false;
    for conventions in Conventions::candidates(plan) {
        let fit = fit(plan, grid, tasks, conventions, is_found);
        is_found |= fit.is_perfect();
        tried.push((conventions, fit));
    }
    let wanted = tried.iter().position(|(one, _)| Some(*one) == chosen);
    let best = wanted.or_else(|| {
        let fits = tried.iter().enumerate();
        fits.min_by_key(|(_, (_, fit))| fit.misfits).map(|(i, _)| i)
    });
    let (conventions, mut fit_taken) = tried
        .get(best.unwrap_or_default())
        .cloned()
        .unwrap_or((plan.documented, Fit::default()));
    if wanted.is_some() {
        fit_taken = fit(plan, grid, tasks, conventions, false);
    }
    let alternatives: Vec<Alternative> = tried
        .into_iter()
        .filter(|(one, _)| *one != conventions)
        .map(|(conventions, fit)| Alternative {
            conventions,
            misfit: fit.first,
        })
        .collect();
    let why = why(&fit_taken, &alternatives, wanted.is_some());
    Decision {
        conventions,
        fit: fit_taken,
        why,
        alternatives,
    }
}

fn why(fit: &Fit, alternatives: &[Alternative], is_chosen: bool) -> String {
    let other = alternatives.iter().find_map(|one| one.misfit.as_ref());
    let also = alternatives.iter().any(|one| one.misfit.is_none());
    match &fit.first {
        _ if is_chosen && fit.is_perfect() => "You chose this reading; everything fits.".to_owned(),
        Some(first) if is_chosen => format!("You chose this reading; {first}."),
        Some(first) if alternatives.is_empty() => format!("It does not fit: {first}."),
        Some(first) => format!("No reading fits; in this one the least is wrong: {first}."),
        None if alternatives.is_empty() => "There is only one way to read it.".to_owned(),
        None if also => {
            "Other readings fit, too; this is the one that its makers document.".to_owned()
        }
        None => match other {
            Some(other) => format!("Else {other}."),
            None => "Everything fits.".to_owned(),
        },
    }
}

/// How well a plan fits under some conventions; with `is_hasty` only up to the
/// first misfit.
fn fit(
    plan: &WrittenPlan,
    grid: &Grid,
    tasks: Option<&[Option<Task>]>,
    conventions: Conventions,
    is_hasty: bool,
) -> Fit {
    let mut fit = Fit::default();
    for (i, agent) in plan.agents.iter().enumerate() {
        let known = known((i, agent), tasks, conventions);
        let (path, _) = place::path(agent, known.start, conventions);
        place::judge(&mut fit, &name(agent, i), &path, known, grid);
        if is_hasty && !fit.is_perfect() {
            break;
        }
    }
    fit
}

/// Start and goal: of the tasks where there are some, else what the file says of
/// its own agent. An agent without a task has neither.
fn known(
    (i, agent): (usize, &WrittenAgent),
    tasks: Option<&[Option<Task>]>,
    conventions: Conventions,
) -> Known {
    match tasks {
        Some(tasks) => {
            let task = tasks.get(i).copied().flatten();
            Known {
                start: task.map(|(start, _)| start),
                goal: task.and_then(|(_, goal)| goal),
            }
        }
        None => Known {
            start: agent.start.map(|cell| place::cell(cell.pair, conventions)),
            goal: agent.goal.map(|cell| place::cell(cell.pair, conventions)),
        },
    }
}
