//! Questions: asked, answered bit by bit, left, and what is taken from them.

mod kept;
mod missing;
mod names;
mod nearby;
mod other;
mod pays;
mod taken;
mod tight;
mod told;

use std::collections::BTreeMap;

use giveway_model::{Cell, Cost, Costs, Plan, Question, Version};
use giveway_solve::explain::{Edit, ExplainAnswer, Part, Repair, Verdict};
use giveway_solve::{Progress, Response, Stats};

use crate::reduce::tests::after;
use crate::sample::{reach, solved};
use crate::{Action, AskAction, State, WorkerAction};

fn question() -> Question {
    Question::Charge {
        agent: "A1".to_owned(),
        at: Some(Cell::new(6, 2)),
        time: Some(9),
    }
}

fn asked() -> State {
    after(&solved(), [Action::Ask(AskAction::Ask(question()))])
}

fn id(state: &State) -> u64 {
    state.work.id().unwrap()
}

/// An answer whose other plan is the plan itself, at one more charge.
fn told(state: &State) -> ExplainAnswer {
    let plan: Plan = state
        .document
        .answer
        .as_ref()
        .unwrap()
        .plan()
        .unwrap()
        .clone();
    let costs = state
        .document
        .answer
        .as_ref()
        .unwrap()
        .solved
        .costs
        .unwrap();
    let costs = Costs {
        charges: costs.charges + 1,
        ..costs
    };
    let repair = Repair {
        edits: vec![Edit::DropWaypoint {
            agent: "A1".to_owned(),
            cell: Cell::new(4, 2),
        }],
        least: true,
        costs,
        arrival: None,
        proved: true,
        plan: plan.clone(),
        text: "Drop A1's waypoint (4, 2)".to_owned(),
    };
    ExplainAnswer {
        giveway: Version,
        question: question(),
        since: None,
        here: None,
        near: None,
        plan: None,
        verdict: Verdict::Costly,
        costs: Some(costs),
        deltas: BTreeMap::from([
            (Cost::Makespan, 0),
            (Cost::SumOfCosts, 0),
            (Cost::Charges, 1),
        ]),
        at_most: false,
        reach: reach(None),
        alternative: Some(plan),
        closest: false,
        how: Vec::new(),
        pays: Vec::new(),
        witness: Vec::new(),
        core: None,
        repairs: vec![repair],
        further_repairs: 0,
        exhaustive: false,
        alone: Vec::new(),
        valid: None,
        violations: None,
        optimal: None,
        excess: Vec::new(),
        pending: vec![Part::Witness, Part::Core],
        words: "1 more charge.".to_owned(),
        stats: Stats::default(),
    }
}

fn learn(state: &State) -> State {
    let answer = Box::new(told(state));
    let event = Progress::Explained { answer };
    let run = id(state);
    after(
        state,
        [Action::Worker(WorkerAction::Progress { job: run, event })],
    )
}

/// The warehouse with a question that was answered.
pub(crate) fn asked_and_answered() -> State {
    answered(&asked())
}

fn answered(state: &State) -> State {
    let answer = ExplainAnswer {
        pending: Vec::new(),
        ..told(state)
    };
    let response = Box::new(Response::Explained(Box::new(answer)));
    let run = id(state);
    after(
        state,
        [Action::Worker(WorkerAction::Respond { job: run, response })],
    )
}

fn hear(state: &State, answer: ExplainAnswer) -> State {
    let event = Progress::Explained {
        answer: Box::new(answer),
    };
    let job = id(state);
    after(
        state,
        [Action::Worker(WorkerAction::Progress { job, event })],
    )
}
