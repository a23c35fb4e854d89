//! The warehouse and a plan for it, for tests.

use std::rc::Rc;

use giveway_model::format::native;
use giveway_model::{Cell, Costs, Objective, Plan, Version};
use giveway_solve::{Reach, Response, SolveAnswer, Stats, Status};

use crate::{Action, Answer, BoardAction, Draft, SolveAction, State, WorkerAction, reduce};

/// The warehouse.
pub(crate) fn draft() -> Draft {
    let scene = include_str!("../../../static/examples/warehouse.json");
    Draft::new(native::read_scene(scene).unwrap()).unwrap()
}

/// A path in digits, `xy` a cell, `--` in transit.
fn path(cells: &str) -> Vec<Option<Cell>> {
    let digit = |c: char| c.to_digit(10);
    let cell = |word: &str| {
        let mut letters = word.chars();
        let (x, y) = (digit(letters.next()?)?, digit(letters.next()?)?);
        Some(Cell::new(x, y))
    };
    cells.split(' ').map(cell).collect()
}

fn plan() -> Plan {
    let mut plan = Plan::default();
    let paths = [
        (
            "A1",
            "00 10 20 -- 30 31 32 42 52 62 61 60 -- 70 80 90 91 92",
            vec![9],
        ),
        (
            "A2",
            "92 82 72 62 61 60 -- 50 -- 40 -- 30 31 32 22 12 02 01 00",
            vec![3, 13],
        ),
    ];
    for (name, cells, charges) in paths {
        plan.paths.insert(name.to_owned(), path(cells));
        plan.charges.insert(name.to_owned(), charges);
    }
    plan
}

/// How far a claim reaches: up to a makespan, or for every horizon.
pub(crate) fn reach(within: Option<u32>) -> Reach {
    let written = serde_json::json!({ "complete": within.is_none(), "within": within });
    serde_json::from_value(written).unwrap()
}

/// A plan as it comes when it is proved optimal.
pub(crate) fn proved(objective: &Objective, costs: Costs, plan: Plan) -> SolveAnswer {
    let bounds = objective.costs().iter();
    SolveAnswer {
        giveway: Version,
        status: Status::Optimal,
        costs: Some(costs),
        bounds: bounds.map(|&cost| (cost, costs.get(cost))).collect(),
        reach: reach(None),
        ended: Some(giveway_solve::Ended::Proof),
        reason: None,
        plan: Some(plan),
        stats: Stats::default(),
        trace: None,
    }
}

/// The page after the warehouse was solved, playing.
pub(crate) fn solved() -> State {
    let state = reduce(&State::new(draft()), Action::Solve(SolveAction::Begin));
    let costs = Costs {
        makespan: 18,
        sum_of_costs: 35,
        charges: 3,
        moves: 30,
        waits: 0,
        penalty: 0,
    };
    let objective = state.document.draft.scene().objective.clone();
    let response = Box::new(Response::Solved(proved(&objective, costs, plan())));
    reduce(
        &state,
        Action::Worker(WorkerAction::Respond { job: 1, response }),
    )
}

/// Its answer.
pub(crate) fn warehouse() -> Rc<Answer> {
    solved().document.answer.unwrap()
}

/// The page after an edit that its plan does not know.
pub(crate) fn stale() -> State {
    let paint = [
        Action::Board(BoardAction::PickTool(crate::Tool::Charger)),
        Action::Board(BoardAction::Press(Cell::new(1, 0))),
        Action::Board(BoardAction::Release),
    ];
    let state = solved();
    paint
        .into_iter()
        .fold(state, |state, action| reduce(&state, action))
}
