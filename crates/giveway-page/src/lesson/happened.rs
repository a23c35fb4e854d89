//! What the lesson hears of its board: the difference of two states.

use giveway_course::port::{BoardNumber, FromPage, Happened, Sight};

use super::Lesson;
use crate::{State, Tool};

/// The board as it is seen now, also that of a lesson, for who writes a lesson: its scene, its plan
/// (also one from elsewhere that breaks rules), the time shown. A plan that is hidden still is not
/// told.
pub fn as_it_is(state: &State) -> Vec<FromPage> {
    let hides_plan = state.lesson().is_some_and(Lesson::hides_plan);
    let document = &state.document;
    let scene = document.draft.scene().clone();
    let plan = match document.mode.audit() {
        _ if hides_plan => None,
        Some(audit) => Some(audit.plan.file.plan.clone()),
        None => document.plan().cloned(),
    };
    let all = [
        Some(Happened::Board(Box::new(scene))),
        plan.map(|plan| Happened::Led(Box::new(plan))),
        Some(Happened::Time(state.view.playback.time)),
    ];
    let number = BoardNumber::default();
    let all = all.into_iter().flatten();
    all.map(|what| FromPage { number, what }).collect()
}

/// What happened on the board of a lesson between two states of the page.
pub fn happened(before: &State, after: &State) -> Vec<FromPage> {
    let Some(was) = &before.lesson else {
        return Vec::new();
    };
    let number = was.board.number;
    let told = |what| FromPage { number, what };
    let Some(is) = &after.lesson else {
        return vec![told(Happened::Closed)];
    };
    if is.board.number != number {
        return Vec::new();
    }
    if is.is_tour() {
        let sight = seen(after, is);
        let is_new = sight != seen(before, was);
        let said = is_new.then(|| told(Happened::Seen(sight)));
        return said.into_iter().collect();
    }
    let mut all = Vec::new();
    let scene = after.document.draft.scene();
    // A stroke is told when it ends.
    if scene != before.document.draft.scene() {
        all.push(Happened::Board(Box::new(scene.clone())));
    }
    let led = |state: &State| {
        state
            .document
            .mode
            .steering()
            .map(|own| own.led().0.clone())
    };
    if let Some(plan) = led(after)
        && led(before).as_ref() != Some(&plan)
    {
        all.push(Happened::Led(Box::new(plan)));
    }
    let leads = |state: &State| {
        let own = state.document.mode.steering()?;
        let agent = state.document.agents().get(own.agent)?;
        Some(agent.name.clone())
    };
    if let Some(name) = leads(after)
        && leads(before).as_ref() != Some(&name)
    {
        all.push(Happened::Leads(name));
    }
    let pick = |lesson: &Lesson| lesson.pick.clone();
    if let Some((_, picked)) = pick(is).filter(|_| pick(is) != pick(was)) {
        all.push(Happened::Picked(picked));
    }
    let time = after.view.playback.time;
    if time != before.view.playback.time {
        all.push(Happened::Time(time));
    }
    all.into_iter().map(told).collect()
}

/// Whether the prices of all rules are told.
fn is_priced(state: &State) -> bool {
    let told = state.prices().is_some_and(|prices| prices.told.is_some());
    told && !state.is_pricing()
}

/// What a tour sees.
fn seen(state: &State, tour: &Lesson) -> Sight {
    let agents = state.document.agents();
    let robot = state.selected_agent().and_then(|agent| agents.get(agent));
    Sight {
        time: state.view.playback.time,
        last: state.last_time(),
        robot: robot.map(|agent| agent.name.clone()),
        is_asking: state.document.mode.asking().is_some(),
        paints: state.view.tool == Tool::Obstacle,
        is_edited: *state.document.draft.scene() != tour.board.scene,
        is_solved: state.document.fresh_answer().is_some() && state.work.solving().is_none(),
        marks: state.view.tool == Tool::Zone,
        is_writing: state.is_writing_rule(),
        is_ruled: !state.document.draft.scene().constraints.is_empty(),
        is_priced: is_priced(state),
    }
}
