//! Flows with the solver's own answers.

mod audit;
mod cell;
mod change;
mod charge;
mod compare;
mod freedom;
mod gives_way;
mod handed_on;
mod inside;
mod ledger;
mod ledger_foot;
mod lesson;
mod moving;
mod opening;
mod order;
mod picture;
mod planners;
mod present;
mod report;
mod rules;
mod sizing;
mod soak;
mod steer;
mod units;

use giveway_solve::{Request, Response, SilentHost, serve};

use crate::reduce::tests::after;
use crate::{Action, BoardAction, PlayAction, Selection, State, WorkerAction, words};

pub(crate) use change::{adopted, compared};
use picture::page;

/// What the solver answers to what runs.
fn answer(state: &State) -> Action {
    let (job, mut request) = state.work.request().expect("it works");
    if let Request::Plan(plan) = &mut request {
        // CBS searches for ever where there is no plan, and there is no clock here.
        plan.limits.memory_bytes = Some(1 << 24);
    }
    let response = Box::new(serve(&request, &SilentHost));
    Action::Worker(WorkerAction::Respond { job, response })
}

/// The state after the solver answered; it does not refuse.
fn answered(state: &State) -> State {
    let answer = answer(state);
    if let Action::Worker(WorkerAction::Respond { response, .. }) = &answer {
        assert!(!matches!(**response, Response::Refused(_)), "{response:?}");
    }
    after(state, [answer])
}

/// The status sentence.
fn saying(state: &State) -> String {
    words::standing(state).sentence
}

pub(crate) const fn select(agent: usize) -> Action {
    Action::Board(BoardAction::Select(Selection::Agent(agent)))
}

const fn seek(time: u32) -> Action {
    Action::Play(PlayAction::Seek(time))
}
