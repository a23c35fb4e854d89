//! The world changes while the plan of the literature's example runs.

mod adopted;
mod breakdown;
mod for_good;
mod goes_on;
mod list;
mod methods;
mod sentence;
mod stuck;

use giveway_model::Costs;
use giveway_model::format::native;
use giveway_solve::Response;

use crate::changing::facts;
use crate::reduce::tests::{after, stroke};
use crate::sample::proved;
use crate::tests::{answered, seek};
use crate::{Action, ChangeAction, Draft, SolveAction, State, Tool, WorkerAction, reduce};

/// The scene of the example with the paper's plan, at time 1.
fn running() -> State {
    let scene = include_str!("../../../../../tests/data/seed/dynamic-3x3.json");
    let plan = include_str!("../../../../../tests/data/seed/dynamic-3x3.plan.json");
    let draft = Draft::new(native::read_scene(scene).unwrap()).unwrap();
    let state = reduce(&State::new(draft), Action::Solve(SolveAction::Solve));
    let costs = Costs {
        makespan: 4,
        sum_of_costs: 8,
        charges: 0,
        moves: 8,
        waits: 0,
        penalty: 0,
    };
    let objective = state.document.draft.scene().objective.clone();
    let solved = proved(&objective, costs, native::read_plan(plan).unwrap());
    let response = Box::new(Response::Solved(solved));
    after(
        &state,
        [
            Action::Worker(WorkerAction::Respond { job: 1, response }),
            seek(1),
        ],
    )
}

/// The same with the world changing.
fn changing() -> State {
    after(&running(), [Action::Change(ChangeAction::Begin)])
}

/// A3 joins as in the paper, by the tool.
fn joined() -> State {
    after(&changing(), stroke(Tool::Agent, &[(2, 2), (1, 0)]))
}

pub(crate) fn compared() -> State {
    answered(&after(&joined(), [Action::Change(ChangeAction::Adapt)]))
}

pub(crate) fn adopted() -> State {
    after(&compared(), [Action::Change(ChangeAction::Adopt(2))])
}

fn list(state: &State) -> Vec<String> {
    let list = facts(state).unwrap().list;
    list.into_iter().map(|listed| listed.text).collect()
}
