//! The board that who writes a lesson takes into it.

use giveway_course::port::{Board, BoardPlan, FromPage, Happened, ToPage};

use super::aside::own;
use super::{board, opened, say, told};
use crate::State;
use crate::lesson::as_it_is;

#[test]
fn who_writes_a_lesson_takes_the_board_as_it_is_seen() {
    let own = own();
    let plan = own.document.plan().cloned().unwrap();
    let all = [
        told(
            0,
            Happened::Board(Box::new(own.document.draft.scene().clone())),
        ),
        told(0, Happened::Led(Box::new(plan))),
        told(0, Happened::Time(3)),
    ];
    assert_eq!(as_it_is(&own), all);
    // While another lesson is on the board its board is seen; to ask changes nothing.
    let lesson = opened(&own, board(1));
    let seen = Happened::Board(Box::new(board(1).scene));
    assert_eq!(as_it_is(&lesson)[0], told(0, seen));
    assert_eq!(say(&lesson, ToPage::Take), lesson);
    // A plan that is to be guessed is not told.
    let hiding = opened(
        &own,
        Board {
            plan: BoardPlan::Hidden,
            ..board(1)
        },
    );
    let is_plan = |told: &FromPage| matches!(told.what, Happened::Led(_));
    assert!(!as_it_is(&hiding).iter().any(is_plan));
    assert_eq!(as_it_is(&State::new(crate::Draft::default())).len(), 2);
}
