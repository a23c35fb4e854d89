//! The keys of somebody who speaks: a keyboard, or a clicker, which has two.

use super::{END, Presenting};
use crate::{Action, AskAction, PlayAction, State, ViewAction, ask};

/// What a key does while the page is shown to a room; `None` where it does nothing, or
/// what it always does.
pub(crate) fn pressed(name: &str, state: &State) -> Option<Action> {
    let asked = state.document.mode.asking().is_some();
    match name {
        "Escape" | "p" | "P" => Some(END),
        "h" | "H" => Some(Action::View(ViewAction::Present(
            match state.view.presenting {
                Presenting::Bare => Presenting::Told,
                Presenting::Told | Presenting::Off => Presenting::Bare,
            },
        ))),
        "ArrowUp" => turn(state, false),
        "ArrowDown" => turn(state, true),
        // A clicker goes through what there is: questions while one is open, else times.
        "PageUp" if asked => turn(state, false),
        "PageDown" if asked => turn(state, true),
        "ArrowLeft" | "PageUp" => step(state, false),
        "ArrowRight" | "PageDown" => step(state, true),
        _ => None,
    }
}

fn step(state: &State, on: bool) -> Option<Action> {
    let action = if on {
        PlayAction::StepForward
    } else {
        PlayAction::StepBack
    };
    (state.last_time() > 0).then_some(Action::Play(action))
}

/// The next question of those that fit what is selected, or the one before; before the
/// first one there is none.
fn turn(state: &State, on: bool) -> Option<Action> {
    if state.lesson().is_some() {
        return None;
    }
    let asking = state.document.mode.asking();
    let groups = ask::offers(state);
    let mut offers = groups.into_iter().flat_map(|group| group.offers);
    let questions: Vec<_> = offers.by_ref().map(|offer| offer.question).collect();
    let at = asking.and_then(|asking| questions.iter().position(|it| it == asking.question()));
    let to = match at {
        Some(at) if on => at + 1,
        None if on => 0,
        Some(at) if at > 0 => at - 1,
        _ => return asking.map(|_| Action::Ask(AskAction::Close)),
    };
    let question = questions.into_iter().nth(to)?;
    Some(Action::Ask(AskAction::Ask(question)))
}
