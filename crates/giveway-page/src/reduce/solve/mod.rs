//! Solving: begun, on its way, answered, stopped.

mod answered;
mod begin;
mod known;
mod preview;
mod tightened;
mod time;

use super::{area, ask, fleet, floor_plan, grow, inside, planners, proof};
use crate::{Document, SolveAction, Solving, State, Task};

pub(super) use answered::{answered, front};
pub(super) use begin::{Start, start};
pub(super) use preview::preview;

use answered::show_point;
use giveway_model::tr;

/// A plan of at most so many agents is proved as soon as it is opened.
const SMALL: usize = 12;

pub(super) fn solve(state: &mut State, action: &SolveAction) {
    match *action {
        SolveAction::Begin => start(state, Start::quiet()),
        SolveAction::Solve => {
            fleet::settle(state);
            floor_plan::settle(state);
            area::keep(state);
            grow::keep(state);
            start(state, Start::step());
        }
        SolveAction::Plan(planner) => start(state, Start::by(planner)),
        SolveAction::ShowPlan(by) => planners::show(state, by),
        SolveAction::ShowBeside(by) => planners::beside(state, by),
        SolveAction::Cancel if state.intake.job().is_some() => drop(state.intake.end()),
        SolveAction::Cancel => cancel(state),
        SolveAction::ShowPoint(point) => show_point(state, point),
        SolveAction::CheckProof => proof::start(state),
        SolveAction::SaveProof => proof::export(state),
    }
}

/// Whether a scene is small enough to be proved without being asked.
pub(super) fn is_small(document: &Document) -> bool {
    document.draft.agents().len() <= SMALL
}

/// An edit ends the search: the plan that it has found so far is not lost with it. Whether there is
/// one.
pub(super) fn keep_so_far(state: &mut State) -> bool {
    let run = state.work.solving().filter(|run| run.planner.is_none());
    let found = run.and_then(Solving::stopped);
    let is_found = found.is_some_and(|solved| solved.plan.is_some());
    if is_found {
        cancel(state);
        state.view.playback.playing = false;
    }
    is_found
}

/// Ends what runs; what is known of an answer stays.
pub(super) fn cancel(state: &mut State) {
    match state.work.end() {
        Some(Task::Solve(run)) => {
            if let Some(solved) = run.stopped() {
                match run.planner {
                    Some(planner) => planners::arrive(state, &run, planner, solved, None),
                    None => answered(state, run, solved),
                }
            }
        }
        Some(Task::Explain(_)) => {
            let asking = state.document.mode.asking();
            if asking.is_some_and(|asking| asking.told.is_none()) {
                ask::close(state);
            }
        }
        Some(Task::Look(looking)) => {
            inside::not_told(state, &looking, tr!("You stopped it."));
        }
        Some(Task::Delays(_)) => {
            let known = state.document.ledger();
            if known.is_none_or(|known| known.told.is_none()) {
                super::ledger::refused(state);
            }
        }
        Some(
            Task::Certify(_)
            | Task::Export(_)
            | Task::Change(_)
            | Task::Freedom(_)
            | Task::Sizing(_)
            | Task::Order(_)
            | Task::Price(..),
        )
        | None => {}
    }
}
