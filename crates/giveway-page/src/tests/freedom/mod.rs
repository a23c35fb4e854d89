//! What all best plans share, with the solver's own answers: asked, laid over the plan, cut off,
//! closed cells, and undo in between.

mod certificates;
mod closed;
mod steps;
mod told;

use std::cell::RefCell;

use giveway_model::{Agent, Cell, Scene};
use giveway_solve::freedom::FreedomAnswer;
use giveway_solve::{Host, Progress, serve};

use super::answered;
use crate::freedom::{Column, FreedomAction, Section, column};
use crate::reduce::tests::after;
use crate::{Action, Draft, SolveAction, State, ViewAction, WorkerAction};

/// Three robots, of which one has no choice: 3 x 1 x 5 best plans.
const THREE: [&str; 5] = ["##......", "##......", "#...#...", "......##", "#.#....."];

fn page(map: &[&str], agents: &[[(u32, u32); 2]]) -> State {
    let cell = |(x, y)| Cell::new(x, y);
    let agents = (1..).zip(agents).map(|(number, &[start, goal])| Agent {
        name: format!("A{number}"),
        start: cell(start),
        goal: Some(cell(goal)),
        waypoints: Vec::new(),
        battery: None,
        heading: None,
    });
    let scene = Scene {
        name: "three ways".to_owned(),
        map: map.iter().map(ToString::to_string).collect(),
        agents: agents.collect(),
        ..Scene::default()
    };
    State::new(Draft::new(scene).unwrap())
}

/// The page with a plan that is proved a best one.
fn solved() -> State {
    let agents = [[(6, 1), (4, 3)], [(7, 2), (1, 4)], [(3, 2), (7, 0)]];
    let wide = Action::View(ViewAction::SetWide(true));
    let actions = [wide, Action::Solve(SolveAction::Solve)];
    answered(&after(&page(&THREE, &agents), actions))
}

const fn act(action: FreedomAction) -> Action {
    Action::Freedom(action)
}

const SHOW: Action = act(FreedomAction::Show(true));

/// All that is known is laid over the plan.
fn told() -> State {
    answered(&after(&solved(), [SHOW]))
}

/// Hears what is told on the way, and stops the solver after so many parts.
struct Ear {
    heard: RefCell<Vec<FreedomAnswer>>,
    most: usize,
}

impl Host for Ear {
    fn wall_seconds(&self) -> f64 {
        0.0
    }

    fn cancelled(&self) -> bool {
        self.heard.borrow().len() >= self.most
    }

    fn progress(&self, event: &Progress) {
        if let Progress::Freedom { answer } = event {
            self.heard.borrow_mut().push((**answer).clone());
        }
    }
}

/// What the solver tells on the way to what runs, each as an action.
fn on_the_way(state: &State, most: usize) -> Vec<Action> {
    let (job, request) = state.work.request().expect("it works");
    let ear = Ear {
        heard: RefCell::default(),
        most,
    };
    let _ = serve(&request, &ear);
    let event = |answer| Progress::Freedom {
        answer: Box::new(answer),
    };
    let action = |answer| {
        Action::Worker(WorkerAction::Progress {
            job,
            event: event(answer),
        })
    };
    ear.heard.into_inner().into_iter().map(action).collect()
}

fn told_of(state: &State) -> Column {
    column(state).expect("it is laid over the plan")
}

fn known<T>(section: Section<T>) -> T {
    match section {
        Section::Known(known) => known,
        Section::Coming => panic!("it is coming"),
        Section::Open => panic!("it is open"),
    }
}
