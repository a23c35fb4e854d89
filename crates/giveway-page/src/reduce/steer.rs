//! Leading agents by hand, in a plan of one's own.

use std::rc::Rc;

use super::{ask, change, solve, stroke};
use crate::steering::{Lead, Steering};
use crate::{Notice, Selection, State, Tab, Tool};

/// Whether a plan of one's own keeps something from being done; then a notice says
/// so.
pub(super) fn is_in_the_way(state: &mut State) -> bool {
    let Some(steering) = state.steering.as_deref() else {
        return false;
    };
    let name = steering.name().to_owned();
    state.notice = Some(Notice {
        sentence: format!("You lead {name} by hand: discard your plan before you do this."),
        details: vec!["Undo brings it back.".to_owned()],
    });
    true
}

/// What a person does while leading an agent.
pub(super) fn steer(state: &mut State, lead: Lead) {
    let Some(own) = state.steering.clone() else {
        if lead == Lead::Begin {
            begin(state);
        }
        return;
    };
    match lead {
        Lead::Begin => {
            let agent = state.can_steer();
            let led = agent.and_then(|agent| own.lead(agent, state.playback.time));
            if led.is_some() {
                put(state, led);
            }
        }
        Lead::Step(by) => made(state, &own, own.step(by)),
        Lead::Charge => made(state, &own, own.charge()),
        Lead::Back => made(state, &own, own.back()),
        Lead::To(cell) => {
            let from = own.cell();
            if let Some(agent) = state.agent_at(cell).filter(|_| !cell.touches(from)) {
                return super::select(state, Selection::Agent(agent));
            }
            let by = |to: u32, from: u32| to.cast_signed().wrapping_sub(from.cast_signed());
            if cell != from {
                made(
                    state,
                    &own,
                    own.step((by(cell.x, from.x), by(cell.y, from.y))),
                );
            }
        }
        Lead::Discard => put(state, None),
    }
}

/// The agent that is selected is led from the time shown.
fn begin(state: &mut State) {
    stroke::release(state);
    let agent = state.can_steer();
    let answer = state.answer.as_ref().filter(|_| !state.is_stale());
    let own = agent
        .zip(answer)
        .and_then(|(agent, answer)| Steering::begin(answer, agent, state.playback.time));
    let Some(own) = own else {
        return ask::refuse(
            state,
            "Solve the scene and select an agent first: then it can be led by hand.",
        );
    };
    state.placing = None;
    state.tool = Tool::Select;
    put(state, Some(own));
}

/// A step was made, or why it was not.
fn made(state: &mut State, own: &Steering, step: Result<Steering, String>) {
    match step {
        Ok(after) => put(state, Some(after)),
        Err(told) => {
            state.steering = Some(Rc::new(own.refusing(told)));
            change::settle(state);
        }
    }
}

/// Puts a plan of one's own in the place of what was, as one step of undo.
fn put(state: &mut State, own: Option<Steering>) {
    ask::close(state);
    solve::cancel(state);
    let before = change::moment(state);
    state.history.record(before);
    state.notice = None;
    state.view.tab = Tab::Inspector;
    state.steering = own.map(Rc::new);
    change::settle(state);
}
