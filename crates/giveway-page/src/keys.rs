//! The keys that work wherever the focus is.

use crate::reduce::only_looks;
use crate::steering::Lead;
use crate::{
    Action, AskAction, BoardAction, ChangeAction, Phase, PlayAction, Selection, SolveAction, State,
    Tool, ViewAction,
};

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
        return with_ctrl(key).map(Command::Act);
    }
    if let Some(lead) = leads(key.name, state) {
        return Some(Command::Act(Action::Steer(lead)));
    }
    let playing = state.view.playback.playing;
    let has_plan = state.last_time() > 0;
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
        "x" | "X" => state
            .can_change()
            .then_some(Action::Change(ChangeAction::Begin)),
        name => tool(name).map(|tool| Action::Board(BoardAction::PickTool(tool))),
    };
    action.map(Command::Act)
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

fn with_ctrl(key: Key<'_>) -> Option<Action> {
    match (key.name, key.shift) {
        ("Enter", _) => Some(Action::Solve(SolveAction::Solve)),
        ("z" | "Z", false) => Some(Action::Undo),
        ("z" | "Z", true) | ("y" | "Y", false) => Some(Action::Redo),
        _ => None,
    }
}

/// One thing after the other: what is being placed, the solver, the notice, the
/// selection.
fn escape(state: &State) -> Option<Action> {
    if state.has_gesture() {
        Some(Action::Board(BoardAction::Abandon))
    } else if matches!(
        state.phase(),
        Phase::Solving | Phase::Asking | Phase::Checking | Phase::Adapting
    ) {
        Some(Action::Solve(SolveAction::Cancel))
    } else if state.view.notice.is_some() {
        Some(Action::View(ViewAction::DismissNotice))
    } else if state.document.mode.asking().is_some() {
        Some(Action::Ask(AskAction::Close))
    } else if let Some(own) = state.document.mode.steering() {
        // Another agent or a cell is looked at in between.
        let led = Selection::Agent(own.agent);
        Some(match state.view.selection {
            Selection::Nothing => Action::Steer(Lead::Discard),
            selection if selection == led => Action::Steer(Lead::Discard),
            _ => Action::Board(BoardAction::Select(led)),
        })
    } else if state.view.selection != Selection::Nothing {
        Some(Action::Board(BoardAction::Select(Selection::Nothing)))
    } else if state.document.mode.changing().is_some() {
        Some(Action::Change(ChangeAction::Discard))
    } else {
        None
    }
}

fn tool(name: &str) -> Option<Tool> {
    let mut letters = name.chars();
    let key = letters.next()?.to_ascii_lowercase();
    if letters.next().is_some() {
        return None;
    }
    Tool::ALL.into_iter().find(|tool| tool.key() == key)
}

/// A row of the help: keys that belong together, and what they do.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Row {
    /// The keys, each as it stands on a keyboard; those of a chord joined by `+`.
    pub keys: &'static [&'static str],
    /// What they do.
    pub what: &'static str,
}

/// The help: groups of rows, each with a title.
pub const HELP: [(&str, &[Row]); 5] = [
    (
        "Solving",
        &[
            row(&["Ctrl+Enter"], "Solve"),
            row(&["Escape"], "Cancel; close what is open"),
            row(&["Ctrl+Z"], "Undo"),
            row(&["Ctrl+Shift+Z"], "Redo"),
            row(
                &["Ctrl+V"],
                "Open what was copied: a scene, a plan, a map, a link",
            ),
        ],
    ),
    (
        "Time",
        &[
            row(&["Space"], "Play or pause"),
            row(&[",", "."], "One step back, one step forward"),
            row(&["Home", "End"], "To the start, to the end"),
            row(&["X"], "Change the world at the time shown"),
        ],
    ),
    (
        "Tools",
        &[
            row(&["V"], "Select"),
            row(&["O"], "Obstacle"),
            row(&["C"], "Charger"),
            row(&["S"], "Slow zone"),
            row(&["E"], "Erase"),
            row(&["A"], "Robot"),
            row(&["G"], "Goal"),
            row(&["W"], "Waypoint"),
        ],
    ),
    (
        "Board",
        &[
            row(
                &["\u{2190}", "\u{2191}", "\u{2192}", "\u{2193}"],
                "Move the cursor",
            ),
            row(&["Enter", "Space"], "Use the tool on the cell"),
            row(
                &[
                    "Shift+\u{2190}",
                    "Shift+\u{2191}",
                    "Shift+\u{2192}",
                    "Shift+\u{2193}",
                ],
                "Move what is on the cell (Select)",
            ),
            row(&["+", "\u{2212}", "0"], "Zoom in, zoom out, fit"),
            row(&["F"], "Follow the robot selected"),
            row(&["?"], "This list"),
        ],
    ),
    (
        "A robot by hand",
        &[
            row(&["L"], "Lead the robot that is selected"),
            row(
                &["\u{2190}", "\u{2191}", "\u{2192}", "\u{2193}"],
                "Lead it a step",
            ),
            row(&["W"], "Let it wait a step"),
            row(&["C"], "Let it charge in its next step"),
            row(&["Backspace"], "Take a step back"),
            row(&["Ctrl+Enter"], "Check your plan"),
        ],
    ),
];

const fn row(keys: &'static [&'static str], what: &'static str) -> Row {
    Row { keys, what }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Draft, Notice, reduce};

    fn state() -> State {
        State::new(Draft::default())
    }

    fn key(name: &str) -> Key<'_> {
        Key {
            name,
            ..Key::default()
        }
    }

    fn act(key: Key<'_>, state: &State) -> Option<Action> {
        match command(key, state) {
            Some(Command::Act(action)) => Some(action),
            _ => None,
        }
    }

    #[test]
    fn every_tool_has_its_key_and_its_row() {
        let rows = HELP.iter().flat_map(|(_, rows)| rows.iter());
        let rows: Vec<_> = rows.collect();
        for tool in Tool::ALL {
            let name = tool.key().to_string();
            assert_eq!(
                act(key(&name), &state()),
                Some(Action::Board(BoardAction::PickTool(tool)))
            );
            let upper = name.to_uppercase();
            let told = rows.iter().find(|row| row.keys == [upper.as_str()]);
            assert_eq!(told.map(|row| row.what), Some(tool.name()));
        }
    }

    #[test]
    fn chords() {
        let ctrl = |name, shift| Key {
            name,
            ctrl: true,
            shift,
            alt: false,
        };
        assert_eq!(
            act(ctrl("Enter", false), &state()),
            Some(Action::Solve(SolveAction::Solve))
        );
        assert_eq!(act(ctrl("z", false), &state()), Some(Action::Undo));
        assert_eq!(act(ctrl("Z", true), &state()), Some(Action::Redo));
        assert_eq!(act(ctrl("c", false), &state()), None, "copying stays");
        assert_eq!(act(ctrl("o", false), &state()), None);
    }

    #[test]
    fn without_a_plan_there_is_no_time() {
        for name in [" ", ",", ".", "Home", "End"] {
            assert_eq!(command(key(name), &state()), None, "{name:?}");
        }
    }

    #[test]
    fn escape_takes_one_thing_after_the_other() {
        let mut state = reduce(&state(), Action::Solve(SolveAction::Solve));
        state.view.notice = Some(Notice {
            sentence: String::new(),
            details: Vec::new(),
        });
        state.view.selection = Selection::Agent(0);
        for expect in [
            Action::Solve(SolveAction::Cancel),
            Action::View(ViewAction::DismissNotice),
            Action::Board(BoardAction::Select(Selection::Nothing)),
        ] {
            let action = act(key("Escape"), &state);
            assert_eq!(action, Some(expect.clone()));
            state = reduce(&state, expect);
        }
        assert_eq!(command(key("Escape"), &state), None);
    }

    #[test]
    fn other_keys_are_left_alone() {
        let alt = Key {
            alt: true,
            ..key("o")
        };
        assert_eq!(command(alt, &state()), None);
        for name in ["x", "F5", "Tab", "Dead", ""] {
            assert_eq!(command(key(name), &state()), None, "{name}");
        }
        assert_eq!(command(key("?"), &state()), Some(Command::Help));
    }
}
