//! The scene that the page opens on, with its plan.
//!
//! The plan comes with the page, so that its robots move before the solver has
//! arrived; a test holds it to be what the solver answers
//! (`tests/tests/opening.rs`).

use std::collections::BTreeMap;

use giveway_model::format::native;
use giveway_model::{Cost, Costs, Plan, Scene, Version};
use giveway_page::{Action, PlayAction, SolveAction, State, reduce};
use giveway_solve::{Request, Response, SolveAnswer, SolveRequest, Stats, Status};
use serde::Deserialize;

const SCENE: &str = include_str!("../../static/examples/warehouse.json");
const ANSWER: &str = include_str!("../../static/opening.json");

/// An answer that tells neither a reason nor a trace: what else an answer may hold takes
/// 50 kB of program to be read, and this one has none of it.
#[derive(Deserialize)]
struct Plain {
    giveway: Version,
    status: Status,
    costs: Option<Costs>,
    bounds: BTreeMap<Cost, u32>,
    within: Option<u32>,
    complete: bool,
    plan: Option<Plan>,
    stats: Stats,
}

impl From<Plain> for SolveAnswer {
    fn from(plain: Plain) -> Self {
        Self {
            giveway: plain.giveway,
            status: plain.status,
            costs: plain.costs,
            bounds: plain.bounds,
            within: plain.within,
            complete: plain.complete,
            reason: None,
            plan: plain.plan,
            stats: plain.stats,
            trace: None,
        }
    }
}

/// The scene.
pub(crate) fn scene() -> Scene {
    native::read_scene(SCENE).unwrap_or_default()
}

/// A page with the scene on it, after the solver has answered: at the time that
/// is shown already.
pub(crate) fn solved(state: &State) -> State {
    let asked = reduce(state, Action::Solve(SolveAction::Begin));
    let (Some((job, Request::Solve(request))), Ok(answer)) =
        (asked.work.request(), serde_json::from_str::<Plain>(ANSWER))
    else {
        return asked;
    };
    // A person may have asked for more than what the answer answers.
    let plain = SolveRequest {
        scene: scene(),
        limits: request.limits,
        // Its record is not worth the bytes: who wants it solves again.
        trace: request.trace,
        ..SolveRequest::default()
    };
    if request != plain {
        return asked;
    }
    let response = Box::new(Response::Solved(answer.into()));
    let answered = reduce(
        &asked,
        Action::Solve(SolveAction::Respond { job, response }),
    );
    #[expect(
        clippy::cast_sign_loss,
        reason = "a conversion of floats saturates, and no time is below 0"
    )]
    let step = time() as u32;
    reduce(&answered, Action::Play(PlayAction::Reach(step)))
}

/// The time that the picture of the scene shows, which moves before the
/// application is there (`static/opening.js`); 0 where there is no such picture.
pub(crate) fn time() -> f64 {
    let page = gloo::utils::document().get_element_by_id("page");
    let time = page.and_then(|page| page.get_attribute("data-time"));
    // Read by the browser: to read a float takes a table of 10 kB that nothing compresses.
    let time = time.map(|time| js_sys::Number::parse_float(&time));
    time.filter(|time| *time >= 0.0).unwrap_or(0.0)
}
