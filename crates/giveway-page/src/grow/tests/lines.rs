//! Columns and rows in the middle of the floor.

use giveway_model::Cell;
use giveway_model::constraint::ConstraintKind;

use super::{act, floor};
use crate::area::{AreaAction, Frame};
use crate::edit::{Axis, Lines, Lost};
use crate::grow::{GrowAction, LineOffer, card, offers};
use crate::reduce::tests::after;
use crate::{Action, BoardAction, Selection, State, words};

fn selected(x: u32, y: u32) -> State {
    let select = BoardAction::Select(Selection::Cell(Cell::new(x, y)));
    after(&floor(), [Action::Board(select)])
}

fn offer(state: &State, name: &str) -> GrowAction {
    let offers = offers(state);
    let found = offers.iter().find(|offer| offer.name == name);
    GrowAction::Lines(found.unwrap_or_else(|| panic!("{name}: {offers:?}")).lines)
}

#[test]
fn a_column_comes_in_the_middle_and_goes_again() {
    let before = selected(3, 0);
    let made = act(&before, &[offer(&before, "Insert 1 column right")]);
    let scene = made.document.draft.scene();
    assert_eq!(scene.map, ["......", "..#...", "...~.+", "......"]);
    assert_eq!(scene.agents[0].goal, Some(Cell::new(5, 0)));
    assert_eq!(scene.agents[1].start, Cell::new(5, 1));
    // The zone on both sides of it is wider, and the lane runs on.
    assert_eq!(scene.zones[0].rect, Some([3, 0, 5, 1]));
    let lane = (2..6).map(|x| Cell::new(x, 0)).collect();
    assert_eq!(scene.constraints[0].kind, ConstraintKind::OneWay { lane });
    let lane = vec![Cell::new(5, 2), Cell::new(5, 3)];
    assert_eq!(scene.constraints[1].kind, ConstraintKind::OneWay { lane });
    // Nothing is on it: it goes without a question.
    let select = BoardAction::Select(Selection::Cell(Cell::new(4, 3)));
    let there = after(&made, [Action::Board(select)]);
    let back = act(&there, &[offer(&there, "Remove column 4")]);
    assert!(card(&back).is_none());
    assert_eq!(back.document.draft, before.document.draft);
    let undone = after(&made, [Action::Undo]);
    assert_eq!(undone.document.draft, before.document.draft);
}

#[test]
fn a_row_with_something_on_it_asks_before_it_goes() {
    let before = selected(0, 1);
    let open = act(&before, &[offer(&before, "Remove row 1")]);
    assert_eq!(open.document, before.document, "it asks first");
    let told = card(&open).unwrap();
    assert!(told.sides.is_none());
    assert_eq!(told.after, "5 \u{d7} 3");
    assert_eq!(
        told.losses,
        ["1 robot starts there: A2", "2 waypoints", "1 obstacle"]
    );
    assert_eq!(told.moved.unwrap(), "(0, 2) becomes (0, 1), and so on.");
    let status = words::standing(&open).sentence;
    assert_eq!(
        status,
        "A smaller floor: 1 robot would lose its start or goal."
    );
    let strip = &open.size_strips()[0];
    assert_eq!(
        (strip.area, strip.told.as_str()),
        ([0, 1, 5, 2], "1 row less")
    );
    let made = act(&open, &[GrowAction::Make]);
    let scene = made.document.draft.scene();
    assert_eq!(scene.map, [".....", "...~+", "....."]);
    assert_eq!(
        scene.agents[1].start,
        Cell::new(4, 1),
        "the nearest free cell"
    );
    assert_eq!(scene.zones[0].rect, Some([3, 0, 4, 0]));
    let removed = act(&open, &[GrowAction::Lost(Lost::Remove), GrowAction::Make]);
    assert_eq!(removed.document.draft.agents().len(), 1);
}

#[test]
fn as_many_come_and_go_as_are_selected() {
    let frame = [
        Action::Area(AreaAction::Begin(Cell::new(1, 0), Frame::Replace)),
        Action::Board(BoardAction::Drag(vec![Cell::new(2, 2)])),
        Action::Board(BoardAction::Release),
    ];
    let state = after(&floor(), frame);
    let names: Vec<String> = offers(&state).into_iter().map(|offer| offer.name).collect();
    assert_eq!(
        names,
        [
            "Insert 2 columns left",
            "Insert 2 columns right",
            "Remove columns 1 to 2",
            "Insert 3 rows above",
            "Insert 3 rows below",
            "Remove rows 0 to 2",
        ]
    );
    let made = act(&state, &[offer(&state, "Insert 2 columns left")]);
    assert_eq!(made.document.draft.grid().width(), 7);
    assert!(!made.has_area());
    // All of the floor cannot go.
    let all = after(&floor(), [Action::Area(AreaAction::All)]);
    let is_removal = |offer: &LineOffer| offer.lines.more < 0;
    assert!(!offers(&all).iter().any(is_removal));
    let beyond = Lines {
        axis: Axis::Rows,
        at: 9,
        more: -1,
    };
    assert_eq!(
        act(&all, &[GrowAction::Lines(beyond)]).document,
        all.document
    );
}

/// Every cell keeps what is on it, wherever columns or rows come or go.
#[test]
fn lines_move_cells_as_a_list_of_lines_does() {
    let before = floor();
    let map = &before.document.draft.scene().map;
    for (axis, length) in [(Axis::Columns, 5_usize), (Axis::Rows, 4)] {
        for at in 0..=length {
            for more in [-3_i32, -1, 1, 2] {
                let lines = Lines {
                    axis,
                    at: u32::try_from(at).unwrap(),
                    more,
                };
                let made = act(&before, &[GrowAction::Lines(lines), GrowAction::Make]);
                // Line by line: columns as rows, so that they can be spliced.
                let turned = |map: &[String]| -> Vec<String> {
                    let column = |x: usize| map.iter().map(|row| &row[x..=x]).collect();
                    (0..map[0].len()).map(column).collect()
                };
                let mut rows = match axis {
                    Axis::Columns => turned(map),
                    Axis::Rows => map.clone(),
                };
                let gone = usize::try_from(-more).unwrap_or(0);
                if at + gone <= length && gone < length {
                    let free = ".".repeat(rows[0].len());
                    let come = usize::try_from(more).unwrap_or(0);
                    rows.splice(at..at + gone, vec![free; come]);
                }
                let expected = match axis {
                    Axis::Columns => turned(&rows),
                    Axis::Rows => rows,
                };
                assert_eq!(made.document.draft.scene().map, expected, "{lines:?}");
            }
        }
    }
}
