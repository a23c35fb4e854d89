//! Leading agents by hand, in a plan of one's own.

use std::rc::Rc;

use giveway_model::tr_data;
use giveway_model::words::Sentence;

use super::document::{drop_gesture, enter, settle};
use super::{ask, stroke};
use crate::steering::{Lead, Steering};
use crate::{Activity, Notice, Selection, State, Tab, Tool};

/// Whether a plan of one's own keeps something from being done; then a notice says
/// so.
pub(super) fn is_in_the_way(state: &mut State) -> bool {
    let Some(own) = state.document.mode.steering() else {
        return false;
    };
    let name = own.name();
    state.view.notice = Some(
        Notice::refusal(tr_data!(
            "You lead {name} by hand. Discard your plan before you do this.",
            name
        ))
        .with([tr_data!("Undo brings it back.").to_owned()]),
    );
    true
}

/// What a person does while leading an agent.
#[inline(never)]
pub(super) fn steer(state: &mut State, lead: Lead) {
    let Some(own) = state.document.mode.steering().cloned() else {
        if lead == Lead::Begin {
            begin(state);
        }
        return;
    };
    match lead {
        Lead::Begin => {
            let agent = state.can_steer();
            let led = agent.and_then(|agent| own.lead(agent, state.view.playback.time));
            if let Some(led) = led {
                put(state, led);
            }
        }
        Lead::Step(by) => made(state, &own, own.step(by)),
        Lead::Charge => made(state, &own, own.charge()),
        Lead::Back => made(state, &own, own.back()),
        Lead::To(cell) => {
            let from = own.cell();
            if let Some(agent) = state.agent_at(cell).filter(|_| !cell.touches(from)) {
                return super::board::select(state, Selection::Agent(agent));
            }
            let by = |to: u32, from: u32| to.cast_signed().wrapping_sub(from.cast_signed());
            if cell == from {
                let name = own.name();
                let told = tr_data!(
                    "{name} is there already. Press the cell that it goes to next.",
                    name
                );
                return made(state, &own, Err(told));
            }
            let by = (by(cell.x, from.x), by(cell.y, from.y));
            made(state, &own, own.step(by));
        }
        Lead::Discard => enter(state, Activity::Editing),
    }
}

/// In a lesson, the agent that is selected is the one that is led, if it is to be led: from
/// where it is by now. That changes no plan, so it is no step of undo.
pub(super) fn follow(state: &mut State) {
    let Selection::Agent(agent) = state.view.selection else {
        return;
    };
    let Some(own) = state.document.mode.steering() else {
        return;
    };
    let who = state.document.agents().get(agent);
    let led = who.filter(|who| {
        let lesson = state.lesson();
        own.agent != agent && lesson.is_some_and(|lesson| lesson.leads(&who.name))
    });
    let last = led.map(|who| own.led().0.path(&who.name).len().saturating_sub(1));
    let last = last.and_then(|last| u32::try_from(last).ok());
    if let Some(led) = last.and_then(|last| own.lead(agent, last)) {
        state.document.mode = Activity::Steering(Rc::new(led)).into();
        settle(state);
    }
}

/// The agent that is selected is led from the time shown.
fn begin(state: &mut State) {
    stroke::release(state);
    let agent = state.can_steer();
    let answer = state.document.fresh_answer();
    let own = agent
        .zip(answer)
        .and_then(|(agent, answer)| Steering::begin(answer, agent, state.view.playback.time));
    let Some(own) = own else {
        return ask::refuse(
            state,
            tr_data!("Solve first and select a robot: then you can lead it by hand."),
        );
    };
    drop_gesture(state);
    state.view.tool = Tool::Select;
    put(state, own);
}

/// A step was made, or why it was not.
fn made(state: &mut State, own: &Steering, step: Result<Steering, Sentence>) {
    match step {
        Ok(after) => put(state, after),
        Err(told) => {
            state.document.mode = Activity::Steering(Rc::new(own.refusing(told))).into();
            settle(state);
        }
    }
}

/// Puts a plan of one's own in the place of what was, as one step of undo.
fn put(state: &mut State, own: Steering) {
    state.view.notice = None;
    state.view.tab = Tab::Inspector;
    enter(state, Activity::Steering(Rc::new(own)));
}
