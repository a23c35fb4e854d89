//! A cell that is closed for a look: what then is the best plan, beside the one before,
//! and the way back.

use giveway_model::Cell;

use super::{act, told};
use crate::board::Cast;
use crate::freedom::{Chip, FreedomAction, chip, claim, part};
use crate::reduce::tests::after;
use crate::tests::{answered, saying};
use crate::{Action, BoardAction, Phase, Selection, State, Tool, ViewAction, keys, table};

const NARROW: Action = act(FreedomAction::Close(Cell::new(5, 2)));
const LAST: Action = act(FreedomAction::Close(Cell::new(1, 3)));
const OPEN: Action = act(FreedomAction::Open);

fn escape(state: &State) -> Option<Action> {
    let key = keys::Key {
        name: "Escape",
        ..keys::Key::default()
    };
    match keys::command(key, state)? {
        keys::Command::Act(action) => Some(action),
        keys::Command::Help => None,
    }
}

#[test]
fn it_shows_the_plan_without_the_cell_beside_the_one_with_it() {
    let state = after(&told(), [NARROW]);
    assert_eq!(state.phase(), Phase::Solving);
    assert!(state.beside().is_none(), "there is no plan yet");
    let closed = state.closed_cell().unwrap();
    assert_eq!(closed.title(), "(5, 2) is closed");
    assert_eq!(closed.sentence, "Makespan 10, not 8.");
    let state = answered(&state);
    assert!(saying(&state).starts_with("Optimal: makespan 10"));
    assert_eq!(claim(&state), Some("while the cell was open"));
    let before = state.beside().unwrap();
    assert_eq!(before.makespan(), 8);
    // All of its robots go there, also over the cell that is closed now.
    let world = state.world_of(state.beside());
    assert_eq!(table::lanes(before, world).len(), 3);
    let cast = Cast::by(&state, Some(before));
    assert!(cast.tracks.iter().all(|track| track.path().len() > 1));
    assert!(
        !state
            .world_of(state.shown())
            .grid()
            .is_vertex(Cell::new(5, 2))
    );
    assert!(world.grid().is_vertex(Cell::new(5, 2)));
}

#[test]
fn escape_opens_it_again_with_all_that_was_known() {
    let before = told();
    let state = answered(&after(&before, [NARROW]));
    assert_eq!(escape(&state), Some(OPEN));
    let back = after(&state, [OPEN]);
    assert!(back.closed_cell().is_none());
    assert_eq!(back.document, before.document);
    assert_eq!(chip(&back), Chip::On);
    assert!(saying(&back).ends_with(" There are 15 such plans."));
}

#[test]
fn undo_and_redo_open_and_close_it() {
    let state = answered(&after(&told(), [NARROW]));
    let open = after(&state, [Action::Undo]);
    assert!(open.closed_cell().is_none() && open.is_laid_over());
    let closed = after(&open, [Action::Redo]);
    assert!(closed.closed_cell().is_some());
    let open = after(&closed, [OPEN]);
    assert!(open.closed_cell().is_none() && open.is_laid_over());
}

#[test]
fn without_a_plan_nothing_stands_beside() {
    let state = answered(&after(&told(), [LAST]));
    assert_eq!(state.phase(), Phase::None);
    assert_eq!(state.closed_cell().unwrap().sentence, "No plan is left.");
    assert!(state.beside().is_none());
    let back = after(&state, [OPEN]);
    assert!(back.is_laid_over());
}

#[test]
fn what_is_edited_meanwhile_is_not_lost_by_opening() {
    let state = answered(&after(&told(), [NARROW]));
    let edited = crate::reduce::tests::stroke(Tool::Obstacle, &[(2, 1)]);
    let state = after(&state, edited);
    assert!(state.closed_cell().is_none(), "it is another scene");
    assert_eq!(after(&state, [OPEN]).document, state.document);
}

#[test]
fn a_cell_that_costs_nothing_or_is_needed_is_not_closed() {
    let state = told();
    for cell in [Cell::new(2, 1), Cell::new(7, 2), Cell::new(99, 0)] {
        let same = after(&state, [act(FreedomAction::Close(cell))]);
        assert_eq!(same, state, "{cell:?}");
    }
}

#[test]
fn the_card_of_a_cell_closes_it_by_the_keyboard_too() {
    let cell = Cell::new(5, 2);
    let select = Action::Board(BoardAction::Select(Selection::Cell(cell)));
    let state = after(&told(), [select]);
    assert_eq!(part(&state).unwrap().closing.map(|it| it.0), Some(cell));
    let closed = after(&state, [NARROW]);
    assert_eq!(closed.view.selection, Selection::Nothing);
}

#[test]
fn on_a_narrow_page_the_plan_before_has_no_place() {
    let narrow = Action::View(ViewAction::SetWide(false));
    let state = answered(&after(&told(), [narrow, NARROW]));
    assert!(state.beside().is_none());
    assert_eq!(state.shown().map(|answer| answer.makespan()), Some(10));
}
