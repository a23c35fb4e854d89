//! Keys and presses that lead an agent.

use giveway_model::{AtGoal, Cell};

use super::{cells, leading, path, rows};
use crate::keys::{Command, Key, command};
use crate::reduce::tests::after;
use crate::tests::select;
use crate::{Action, BoardAction, Selection, State, link, reduce};

#[test]
fn keys_lead_and_escape_leaves() {
    let act = |name, state: &State| {
        let key = Key {
            name,
            ..Key::default()
        };
        match command(key, state) {
            Some(Command::Act(action)) => Some(reduce(state, action)),
            _ => None,
        }
    };
    let fresh = rows(AtGoal::Stay);
    for name in ["l", "ArrowDown", "Backspace"] {
        assert_eq!(act(name, &fresh), None, "{name}");
    }
    let state = after(&fresh, [select(0)]);
    let mut state = act("l", &state).unwrap();
    for name in [
        "ArrowDown",
        "ArrowRight",
        "w",
        "ArrowLeft",
        "ArrowUp",
        "Backspace",
    ] {
        state = act(name, &state).unwrap();
    }
    let led = cells(&[(0, 0), (0, 1), (1, 1), (1, 1), (0, 1)]);
    assert_eq!(path(&state, "A1"), led);
    // With the focus on the board.
    let step = Action::Board(BoardAction::StepCursor {
        by: (1, 0),
        carries: false,
    });
    let state = after(&state, [step]);
    assert_eq!(path(&state, "A1").len(), 6);
    let look = Action::Board(BoardAction::StepCursor {
        by: (1, 0),
        carries: true,
    });
    let state = after(&state, [look, Action::Board(BoardAction::UseTool)]);
    assert_eq!(path(&state, "A1").len(), 7, "Enter goes to the cursor");
    let other = after(&state, [select(1)]);
    let kept = link::kept(&link::keep(&other)).unwrap();
    assert_eq!(
        link::keep(&kept),
        link::keep(&other),
        "it is kept as it opens"
    );
    let back = act("Escape", &other).unwrap();
    assert_eq!(back.view.selection, Selection::Agent(0));
    assert_eq!(act("Escape", &back).unwrap().document.mode.steering(), None);
}

#[test]
fn a_press_on_the_board_leads_or_selects() {
    let state = after(
        &leading(0, 0),
        [Action::Board(BoardAction::Press(Cell::new(0, 1)))],
    );
    assert_eq!(path(&state, "A1"), cells(&[(0, 0), (0, 1)]));
    let same = after(&state, [Action::Board(BoardAction::Press(Cell::new(0, 1)))]);
    assert_eq!(
        same.document.mode.steering(),
        state.document.mode.steering()
    );
    let other = after(&state, [Action::Board(BoardAction::Press(Cell::new(2, 1)))]);
    assert_eq!(other.view.selection, Selection::Agent(1), "A2 is there");
    assert_eq!(
        other.document.mode.steering(),
        state.document.mode.steering()
    );
}
