//! The keys that work wherever the focus is.

mod escape;
mod help;
#[cfg(test)]
mod tests;

use crate::area::AreaAction;
use crate::audit::AuditAction;
use crate::draw::{self, Shape};
use crate::find::FindAction;
use crate::freedom::FreedomAction;
use crate::inside::{HandAction, InsideAction};
use crate::reduce::only_looks;
use crate::steering::Lead;
use crate::{
    Action, AskAction, BoardAction, ChangeAction, PlayAction, SolveAction, State, Tool, ViewAction,
};
use crate::{freedom, present};

pub use help::{HELP, Row, key_name};

use escape::escape;

/// A key as it was pressed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Key<'a> {
    /// Its name as the browser has it: `a`, `Enter`, ` `.
    pub name: &'a str,
    /// Whether Ctrl was held, or Command.
    pub ctrl: bool,
    /// Whether Shift was held.
    pub shift: bool,
    /// Whether Alt was held.
    pub alt: bool,
}

/// What a key asks for.
#[derive(Clone, Debug, PartialEq)]
pub enum Command {
    /// A change of the state.
    Act(Action),
    /// To see the keys.
    Help,
}

/// What a key does; `None` where it does nothing, so that the browser keeps it.
///
/// ```
/// use giveway_page::{Action, BoardAction, Draft, State, Tool, keys::{Command, Key, command}};
/// let state = State::new(Draft::default());
/// let key = Key { name: "o", ..Key::default() };
/// assert_eq!(command(key, &state), Some(Command::Act(Action::Board(BoardAction::PickTool(Tool::Obstacle)))));
/// ```
pub fn command(key: Key<'_>, state: &State) -> Option<Command> {
    let is_letter = key.name.chars().count() == 1 && key.name != " ";
    if key.alt || (is_letter && !key.ctrl && !state.settings.letter_keys) {
        return None;
    }
    let found = meant(key, state)?;
    let fits = match &found {
        Command::Act(action) => only_looks(action),
        Command::Help => false,
    };
    (fits || !state.is_embedded()).then_some(found)
}

fn meant(key: Key<'_>, state: &State) -> Option<Command> {
    if key.ctrl {
        return of_area(key, state)
            .or_else(|| by_hand(key, state))
            .or_else(|| with_ctrl(key))
            .map(Command::Act);
    }
    if let Some(action) = by_hand(key, state) {
        return Some(Command::Act(action));
    }
    let is_presented = state.is_presented();
    let lead = leads(key.name, state).filter(|lead| !is_presented || *lead != Lead::Begin);
    if let Some(lead) = lead {
        return Some(Command::Act(Action::Steer(lead)));
    }
    if is_presented && let Some(action) = present::pressed(key.name, state) {
        return Some(Command::Act(action));
    }
    // Keys step through how the plan was found where that is shown.
    let (playing, has_plan) = if state.is_inside() {
        (state.inside.is_playing, state.inside_steps() > 0)
    } else {
        (state.view.playback.playing, state.last_time() > 0)
    };
    let on_plan = |action| has_plan.then_some(action);
    let action = match key.name {
        "?" => return Some(Command::Help),
        "Escape" => escape(state),
        " " => on_plan(if playing {
            Action::Play(PlayAction::Pause)
        } else {
            Action::Play(PlayAction::Play)
        }),
        "," => on_plan(Action::Play(PlayAction::StepBack)),
        "." => on_plan(Action::Play(PlayAction::StepForward)),
        "Home" => on_plan(Action::Play(PlayAction::Seek(0))),
        "End" => on_plan(Action::Play(PlayAction::Seek(state.last_time()))),
        "f" | "F" => {
            let follow = Action::View(ViewAction::Follow(!state.view.follow));
            state.selected_agent().and_then(|_| on_plan(follow))
        }
        "/" => {
            let has_agents = !state.world().agents().is_empty();
            has_agents.then_some(Action::Find(FindAction::Open))
        }
        "h" | "H" | "t" | "T" if state.has_area() => of_area(key, state),
        "Delete" => Some(Action::Board(BoardAction::Delete)),
        "n" | "N" => difference(!key.shift, state)
            .or_else(|| state.audit().map(|_| Action::Audit(AuditAction::Next))),
        "x" | "X" => state
            .can_change()
            .then_some(Action::Change(ChangeAction::Begin)),
        "m" | "M" => {
            let show = FreedomAction::Show(state.freedom().is_none());
            freedom::is_offered(state).then_some(Action::Freedom(show))
        }
        "p" | "P" => Some(present::BEGIN),
        name if group(name, state).is_some() => group(name, state),
        name if shape(name, state).is_some() => {
            shape(name, state).map(|shape| Action::Board(BoardAction::PickShape(shape)))
        }
        name => tool(name).map(|tool| Action::Board(BoardAction::PickTool(tool))),
    };
    // Before a room, what else a key does cannot be seen.
    let action = action.filter(|action| !is_presented || matches!(action, Action::Play(_)));
    action.map(Command::Act)
}

/// The group of facts that a digit lights up, while an answer has groups and nothing is drawn; 0
/// lights nothing.
fn group(name: &str, state: &State) -> Option<Action> {
    let asking = state.document.mode.asking()?;
    let groups = asking.told.as_deref()?.core.as_ref()?.groups.len();
    if state.view.tool != Tool::Select {
        return None;
    }
    let number: usize = name.parse().ok()?;
    let action = match number.checked_sub(1) {
        None => AskAction::Light(None),
        Some(index) => AskAction::Group(index),
    };
    (number <= groups && groups > 0).then_some(Action::Ask(action))
}

/// The next difference of two plans, or the one before; it opens the other plan of an answer.
fn difference(is_forward: bool, state: &State) -> Option<Action> {
    if let Some(asking) = state.document.mode.asking() {
        asking.other.as_ref()?;
        if !asking.shows_other {
            return Some(Action::Ask(AskAction::ShowOther(true)));
        }
    }
    let is_compared = state.compared().is_some();
    is_compared.then_some(Action::Play(PlayAction::Difference(is_forward)))
}

/// While an agent is led, keys lead it; else one begins that.
fn leads(name: &str, state: &State) -> Option<Lead> {
    let own = state.document.mode.steering();
    let lead = match name {
        "l" | "L" => return state.can_steer().map(|_| Lead::Begin),
        "ArrowLeft" => Lead::Step((-1, 0)),
        "ArrowRight" => Lead::Step((1, 0)),
        "ArrowUp" => Lead::Step((0, -1)),
        "ArrowDown" => Lead::Step((0, 1)),
        "w" | "W" => Lead::Step((0, 0)),
        "c" | "C" => Lead::Charge,
        "Backspace" => Lead::Back,
        _ => return None,
    };
    own.map(|_| lead)
}

/// What a key does in a search by hand: figures choose a conflict, Enter splits, Ctrl and Z
/// take back.
fn by_hand(key: Key<'_>, state: &State) -> Option<Action> {
    // Beside the text of a lesson figures pick its answers.
    let is_read = state.lesson().is_some() && !state.covers_lesson();
    if !state.is_by_hand() || is_read {
        return None;
    }
    let figure = key
        .name
        .parse::<usize>()
        .ok()
        .filter(|_| key.name.len() == 1);
    let action = match (key.name, key.ctrl, key.shift) {
        ("z" | "Z", true, false) => HandAction::TakeBack,
        ("z" | "Z", true, true) | ("y" | "Y", true, false) => HandAction::Again,
        ("Enter", false, false) => HandAction::Split,
        (_, false, false) => HandAction::Conflict(figure?.checked_sub(1)?),
        _ => return None,
    };
    Some(Action::Inside(InsideAction::Hand(action)))
}

/// What a key does with a part of the floor.
fn of_area(key: Key<'_>, state: &State) -> Option<Action> {
    let has_area = state.has_area();
    let action = match (key.name, key.ctrl) {
        ("a" | "A", true) if state.can_select_area() => AreaAction::All,
        ("c" | "C", true) if has_area => AreaAction::Copy,
        ("d" | "D", true) if has_area => AreaAction::Repeat(true),
        ("h" | "H", false) if has_area => AreaAction::Mirror(!key.shift),
        ("t" | "T", false) if has_area => AreaAction::Turn,
        _ => return None,
    };
    Some(Action::Area(action))
}

fn with_ctrl(key: Key<'_>) -> Option<Action> {
    match (key.name, key.shift) {
        ("Enter", _) => Some(Action::Solve(SolveAction::Solve)),
        ("z" | "Z", false) => Some(Action::Undo),
        ("z" | "Z", true) | ("y" | "Y", false) => Some(Action::Redo),
        _ => None,
    }
}

/// The shape that a figure picks for the tool.
fn shape(name: &str, state: &State) -> Option<Shape> {
    let shapes = draw::row(state)?.shapes;
    let is_key = |shape: &&Shape| name.chars().eq([shape.key()]);
    shapes.iter().find(is_key).copied()
}

fn tool(name: &str) -> Option<Tool> {
    let mut letters = name.chars();
    let key = letters.next()?.to_ascii_lowercase();
    if letters.next().is_some() {
        return None;
    }
    Tool::ALL.into_iter().find(|tool| tool.key() == key)
}
