//! What must be so, in sentences.

use giveway_model::words::name;
use giveway_model::{Cost, Objective};
use giveway_solve::Status;
use giveway_solve::freedom::{Closed, FreedomAnswer, FreedomPart, PlanCount};

use super::{Freedom, cells, is_best};
use crate::words::{count, grouped};
use crate::{Mode, State};

/// What it is called.
pub const TITLE: &str = "What must be so";

/// Why it cannot be told of the plan on the board; `None` where it can.
pub(crate) fn refusal(state: &State) -> Option<&'static str> {
    let document = &state.document;
    if !matches!(document.mode, Mode::Editing | Mode::Asking(_)) {
        return Some("This is about the best plan of the scene. Finish what you are doing first.");
    }
    if state.work.solving().is_some() {
        return Some("The search for the best plan is still running.");
    }
    let Some(answer) = document.fresh_answer() else {
        return Some(if document.is_stale() {
            "The scene has changed since this plan. Solve again."
        } else {
            "Solve first: this is about the best plan."
        });
    };
    if answer.solved.status == Status::Impossible {
        return Some("There is no plan, so no best plans to compare.");
    }
    if answer.course.is_some() {
        return Some("The world changes in this plan: this is about plans in one world.");
    }
    if document.own_front().is_some() {
        return Some("This is about the best plan, not about the plans of a Pareto front.");
    }
    (!is_best(answer)).then_some("This plan is not proved to be a best one. Solve first.")
}

/// What is added to the status: ` There are 15 such plans.`
pub(crate) fn such_plans(number: PlanCount) -> String {
    match number {
        PlanCount::Exactly(1) => " No other plan is as good.".to_owned(),
        PlanCount::AtLeast(1) => String::new(),
        number => format!(" There are {} such plans.", how_many(number)),
    }
}

/// `15`, `over 1 000`, `at least 15`.
pub(super) fn how_many(number: PlanCount) -> String {
    let n = grouped(u64::from(number.number()));
    match number {
        PlanCount::Exactly(_) => n,
        PlanCount::MoreThan(_) => format!("over {n}"),
        PlanCount::AtLeast(_) => format!("at least {n}"),
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
        None => "Checking that no plan is better.".to_owned(),
        Some(FreedomPart::Backbone) => "Looking for what every best plan has.".to_owned(),
        Some(FreedomPart::Slack) => "Looking for who may be late.".to_owned(),
        Some(FreedomPart::Plans) => match freedom.count() {
            Some(number) => format!("Counting: {} best plans.", how_many(number)),
            None => "Counting the best plans.".to_owned(),
        },
        Some(FreedomPart::Critical) => {
            let cells = told.into_iter().flat_map(|told| told.critical.iter());
            let open = cells.flatten().filter(|it| it.closed.is_open()).count();
            match open {
                0 => "Closing cells, one by one.".to_owned(),
                open => format!("Closing cells, one by one: {open} to go."),
            }
        }
        Some(FreedomPart::Farthest) => "Looking for the plan that differs most.".to_owned(),
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
        return Some("no plan is left".to_owned());
    }
    let (_, cost, delta) = worse(&told.objective, closed)?;
    let before = told.costs.unwrap_or_default().get(cost);
    let after = i64::from(before) + delta;
    Some(format!("{} {after}, not {before}", name(cost)))
}

/// How far what closing a cell comes to is proved.
pub(super) fn reach(closed: &Closed) -> Option<String> {
    let (Closed::Optimal { proved, .. } | Closed::Impossible { proved, .. }) = closed else {
        return None;
    };
    cells::within(*proved).map(|n| format!("Among plans of makespan at most {n}."))
}

/// `2 steps`, `2 in the sum of costs`, `2 more moves`.
pub(super) fn price(cost: Cost, delta: i64) -> String {
    match cost {
        Cost::Makespan => count(u32::try_from(delta).unwrap_or_default(), "step"),
        Cost::SumOfCosts => format!("{delta} in the sum of costs"),
        Cost::Charges | Cost::Moves | Cost::Waits => format!("{delta} more {}", name(cost)),
    }
}
