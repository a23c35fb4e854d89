//! What all best plans share, in sentences.

use giveway_model::words::Later;
use giveway_model::words::name;
use giveway_model::{Cost, Objective, tr, tr_later};
use giveway_solve::Status;
use giveway_solve::freedom::{Closed, FreedomAnswer, FreedomPart, PlanCount};

use super::{Freedom, is_best};
use crate::words::grouped;
use crate::{Activity, State};

/// What it is called.
pub const TITLE: Later = tr_later!("What all best plans share");

/// Why it cannot be told of the plan on the board; `None` where it can.
pub(crate) fn refusal(state: &State) -> Option<&'static str> {
    let document = &state.document;
    if document.mode.activity != Activity::Editing {
        return Some(tr!(
            "This is about the best plan of the scene. Finish what you are doing first."
        ));
    }
    if state.work.solving().is_some() {
        return Some(tr!("The search for the best plan is still running."));
    }
    let Some(answer) = document.fresh_answer() else {
        return Some(if document.is_stale() {
            tr!("The scene has changed since this plan. Solve again.")
        } else {
            tr!("Solve first: this is about the best plan.")
        });
    };
    if answer.solved.status == Status::Impossible {
        return Some(tr!("There is no plan, so no best plans to compare."));
    }
    if document
        .draft
        .agents()
        .iter()
        .any(|agent| agent.goal.is_none())
    {
        return Some(tr!(
            "Best plans are compared by how robots reach their goals. Give each robot a goal first."
        ));
    }
    if answer.course.is_some() {
        return Some(tr!(
            "This works for scenes without changes only: the world changes while this plan runs."
        ));
    }
    if document.own_front().is_some() {
        return Some(tr!(
            "This is about the best plan, not about the plans of a Pareto front."
        ));
    }
    (!is_best(answer)).then_some(tr!(
        "This plan is not proved to be a best one. Solve first."
    ))
}

/// What is added to the status: ` There are 15 such plans.`
pub(crate) fn such_plans(number: PlanCount) -> String {
    match number {
        PlanCount::Exactly(1) => tr!(" No other plan is as good.").to_owned(),
        PlanCount::AtLeast(1) => String::new(),
        number => tr!(" There are {many} such plans.", many = how_many(number)),
    }
}

/// `15`, `over 1 000`, `at least 15`.
pub(super) fn how_many(number: PlanCount) -> String {
    let n = grouped(u64::from(number.number()));
    match number {
        PlanCount::Exactly(_) => n,
        PlanCount::MoreThan(_) => tr!("over {n}", n),
        PlanCount::AtLeast(_) => tr!("at least {n}", n),
    }
}

/// What is being looked for, while something is.
pub fn doing(state: &State) -> Option<String> {
    let freedom = state.document.freedom().filter(|_| state.is_counting())?;
    Some(looking_for(freedom))
}

fn looking_for(freedom: &Freedom) -> String {
    let told = freedom.told.as_deref();
    let next = told.and_then(|told| told.pending.first());
    match next {
        None => tr!("Checking that no plan is better.").to_owned(),
        Some(FreedomPart::Backbone) => tr!("Looking for what every best plan has.").to_owned(),
        Some(FreedomPart::Slack) => tr!("Looking for who may be late.").to_owned(),
        Some(FreedomPart::Plans) => match freedom.count() {
            Some(number) => tr!("Counting: {many} best plans.", many = how_many(number)),
            None => tr!("Counting the best plans.").to_owned(),
        },
        Some(FreedomPart::Critical) => {
            let cells = told.into_iter().flat_map(|told| told.critical.iter());
            let open = cells.flatten().filter(|it| it.closed.is_open()).count();
            match open {
                0 => tr!("Closing cells, one by one.").to_owned(),
                open => tr!("Closing cells, one by one: {open} to go.", open),
            }
        }
        Some(FreedomPart::Farthest) => tr!("Looking for the plan that differs most.").to_owned(),
    }
}

/// The first cost that closing a cell makes worse, and by how much.
pub(super) fn worse(objective: &Objective, closed: &Closed) -> Option<(usize, Cost, i64)> {
    let Closed::Optimal { deltas, .. } = closed else {
        return None;
    };
    let costs = objective.costs().iter().enumerate();
    let mut deltas = costs.filter_map(|(place, cost)| Some((place, *cost, *deltas.get(cost)?)));
    deltas.find(|&(_, _, delta)| delta != 0)
}

/// `makespan 10, not 8`, `no plan is left`; nothing where it is open or costs nothing.
pub(super) fn outcome(told: &FreedomAnswer, closed: &Closed) -> Option<String> {
    if let Closed::Impossible { .. } = closed {
        return Some(tr!("no plan is left").to_owned());
    }
    let (_, cost, delta) = worse(&told.objective, closed)?;
    let before = told.costs.unwrap_or_default().get(cost);
    let after = i64::from(before) + delta;
    Some(tr!(
        "{cost} {after}, not {before}",
        cost = name(cost),
        after,
        before
    ))
}

/// How far what closing a cell comes to is proved.
pub(super) fn reach(closed: &Closed) -> Option<String> {
    let (Closed::Optimal { reach, .. } | Closed::Impossible { reach, .. }) = closed else {
        return None;
    };
    reach
        .within()
        .map(|n| tr!("Among plans of makespan at most {n}.", n))
}
