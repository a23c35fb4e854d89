//! Nothing is lost: what a page keeps, how tabs tell their documents apart, and what
//! is said of it. By way of the public door, as the page in the browser does it.

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "a test stops at the first surprise"
)]

mod displaced;
mod kept;
mod tabs;
mod unkept;
mod welcome;

use giveway_model::{Agent, Cell, Scene};
use giveway_page::files::blank;
use giveway_page::link;
use giveway_page::slot::{Message, Press, message};
use giveway_page::{Action, Draft, Edit, SolveAction, State, WorkerAction, reduce};
use giveway_solve::Progress;

fn scene(name: &str) -> Scene {
    let agent = Agent {
        name: "A1".to_owned(),
        start: Cell::new(0, 0),
        goal: Some(Cell::new(3, 0)),
        waypoints: Vec::new(),
        battery: None,
        heading: None,
    };
    Scene {
        agents: vec![agent],
        ..blank(name, 4, 2)
    }
}

fn opened(name: &str) -> State {
    State::new(Draft::new(scene(name)).unwrap())
}

fn edited(state: &State, columns: u32) -> State {
    reduce(state, Action::Edit(Edit::Resize(columns, 2)))
}

fn link_to(name: &str) -> Action {
    link::open(&link::write(&opened(name)))
}

fn title(state: &State) -> Option<&'static str> {
    message(state).map(|message| message.title)
}

fn name(state: &State) -> &str {
    &state.document.draft.scene().name
}

fn act(state: &State, name: &str) -> State {
    let Message { buttons, .. } = message(state).unwrap();
    let button = buttons.into_iter().find(|button| button.name == name);
    let Press::Act(action) = button.unwrap().press else {
        panic!("{name} is no action of the page");
    };
    reduce(state, *action)
}

/// Solved as the worker does it.
fn solved(state: &State) -> State {
    answered(&reduce(state, Action::Solve(SolveAction::Solve)))
}

/// What runs is answered.
fn answered(run: &State) -> State {
    struct Alone;
    impl giveway_solve::Host for Alone {
        fn wall_seconds(&self) -> f64 {
            0.0
        }
        fn progress(&self, _: &Progress) {}
    }
    let (job, request) = run.work.request().unwrap();
    let response = Box::new(giveway_solve::serve(&request, &Alone));
    reduce(run, Action::Worker(WorkerAction::Respond { job, response }))
}
