//! The page with the scene that it opens on, and its plan.

use giveway_model::Scene;
use giveway_page::{Action, PlayAction, SolveAction, State, WorkerAction, opening, reduce};
use giveway_picture::whole;
use giveway_solve::{Request, Response, SolveRequest};

/// The scene.
pub(crate) fn scene() -> Scene {
    opening::draft().scene().clone()
}

/// A page with the scene on it, after the solver has answered: at the time that
/// is shown already.
pub(crate) fn solved(state: &State) -> State {
    let asked = reduce(state, Action::Solve(SolveAction::Begin));
    let (Some((job, Request::Solve(request))), Some(answer)) =
        (asked.work.request(), opening::answer())
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
    let response = Box::new(Response::Solved(answer.solved.clone()));
    let answered = reduce(
        &asked,
        Action::Worker(WorkerAction::Respond { job, response }),
    );
    let step = whole(time());
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
