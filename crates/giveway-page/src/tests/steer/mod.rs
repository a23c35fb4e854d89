//! Agents are led by hand, and the plan is checked.

mod collisions;
mod hand;
mod judged;
mod path;
mod undo;

use giveway_model::{Agent, AtGoal, Cell, Rules, Scene};

use crate::reduce::tests::after;
use crate::steering::{Facts, Lead, facts};
use crate::tests::{answered, seek, select};
use crate::{Action, Draft, SolveAction, State, sample};

const RIGHT: Action = Action::Steer(Lead::Step((1, 0)));
const LEFT: Action = Action::Steer(Lead::Step((-1, 0)));
const UP: Action = Action::Steer(Lead::Step((0, -1)));
const DOWN: Action = Action::Steer(Lead::Step((0, 1)));
const WAIT: Action = Action::Steer(Lead::Step((0, 0)));
const BACK: Action = Action::Steer(Lead::Back);
const BEGIN: Action = Action::Steer(Lead::Begin);
const DISCARD: Action = Action::Steer(Lead::Discard);

fn agent(name: &str, start: (u32, u32), goal: (u32, u32)) -> Agent {
    Agent {
        name: name.to_owned(),
        start: start.into(),
        goal: Some(goal.into()),
        waypoints: Vec::new(),
        battery: None,
        heading: None,
    }
}

/// Two rows of four cells: A1 goes along the upper one, A2 along the lower one,
/// the other way.
fn rows(at_goal: AtGoal) -> State {
    let scene = Scene {
        map: vec!["....".into(), "....".into(), "####".into()],
        agents: vec![agent("A1", (0, 0), (3, 0)), agent("A2", (3, 1), (0, 1))],
        rules: Rules {
            at_goal,
            ..Rules::default()
        },
        ..Scene::default()
    };
    let state = State::new(Draft::new(scene).unwrap());
    let state = answered(&after(&state, [Action::Solve(SolveAction::Solve)]));
    after(&state, [seek(0)])
}

/// An agent of that scene is led from a time on.
fn leading(agent: usize, time: u32) -> State {
    after(&rows(AtGoal::Stay), [select(agent), seek(time), BEGIN])
}

/// The warehouse's first agent is led from a time on.
fn warehouse(time: u32) -> State {
    after(&sample::solved(), [select(0), seek(time), BEGIN])
}

fn told(state: &State) -> Facts {
    facts(state).expect("an agent is led")
}

fn path(state: &State, agent: &str) -> Vec<Option<Cell>> {
    state.plan().unwrap().path(agent).to_vec()
}

fn cells(path: &[(u32, u32)]) -> Vec<Option<Cell>> {
    path.iter().map(|&cell| Some(cell.into())).collect()
}
