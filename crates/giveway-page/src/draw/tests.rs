//! Shapes, drawn on the floor of a depot.

use giveway_model::{Cell, Ground};

use super::{Drawing, LONGEST, Measure, Shape, drawn, row};
use crate::reduce::tests::{after, stroke};
use crate::{Action, BoardAction, Draft, State, Tool};

const RACKS: [(Measure, u32); 2] = [(Measure::RackDepth, 2), (Measure::RackAisle, 2)];

/// An empty floor of 40 × 24 cells.
fn floor() -> State {
    let scene = giveway_model::Scene {
        map: vec![".".repeat(40); 24],
        ..giveway_model::Scene::default()
    };
    State::new(Draft::new(scene).unwrap())
}

fn with(shape: Shape, measures: &[(Measure, u32)]) -> Vec<Action> {
    let measures = measures
        .iter()
        .map(|&(measure, cells)| BoardAction::SetMeasure(measure, cells));
    let actions = [BoardAction::PickShape(shape)].into_iter().chain(measures);
    actions.map(Action::Board).collect()
}

fn count(state: &State, is: impl Fn(Ground) -> bool) -> usize {
    let cells = state.world().grid().cells();
    cells.filter(|&(_, ground)| is(ground)).count()
}

/// Draws a shape with a tool, from a cell to another one.
fn draw(
    state: &State,
    tool: Tool,
    shape: Shape,
    measures: &[(Measure, u32)],
    from: (u32, u32),
    to: (u32, u32),
) -> State {
    after(
        &after(state, with(shape, measures)),
        stroke(tool, &[from, to]),
    )
}

#[test]
fn a_depot_is_drawn_by_racks_aisles_and_rectangles() {
    let state = draw(
        &floor(),
        Tool::Obstacle,
        Shape::Racks,
        &[],
        (4, 3),
        (28, 10),
    );
    assert_eq!(count(&state, |ground| ground == Ground::Obstacle), 150);
    let state = draw(
        &state,
        Tool::Obstacle,
        Shape::Racks,
        &RACKS,
        (4, 14),
        (28, 19),
    );
    assert_eq!(count(&state, |ground| ground == Ground::Obstacle), 250);
    let state = draw(
        &state,
        Tool::Obstacle,
        Shape::Aisle,
        &[],
        (12, 14),
        (13, 19),
    );
    let state = draw(
        &state,
        Tool::Obstacle,
        Shape::Aisle,
        &[],
        (22, 19),
        (21, 14),
    );
    assert_eq!(count(&state, |ground| ground == Ground::Obstacle), 234);
    // A slow zone has no aisles: its shape is a rectangle.
    let state = after(&state, stroke(Tool::SlowZone, &[(31, 8), (33, 14)]));
    assert_eq!(count(&state, Ground::is_slow), 21);
    let every = [(Measure::Every, 2)];
    let state = draw(
        &state,
        Tool::Charger,
        Shape::Rectangle,
        &every,
        (0, 9),
        (0, 15),
    );
    assert_eq!(count(&state, Ground::is_charger), 4);
    // Each drag is one step of undo.
    let undone = after(&state, vec![Action::Undo; 6]);
    assert_eq!(count(&undone, |ground| ground != Ground::Free), 0);
}

#[test]
fn what_is_drawn_is_said_while_the_hand_is_down() {
    let state = after(&floor(), with(Shape::Racks, &RACKS));
    let mut actions = stroke(Tool::Obstacle, &[(4, 14), (20, 16), (28, 19)]);
    actions.pop();
    let state = after(&state, actions);
    assert_eq!(
        row(&state).unwrap().drawn.as_deref(),
        Some("25 \u{d7} 6: 2 racks, 100 cells")
    );
    let dropped = after(&state, [Action::Board(BoardAction::Abandon)]);
    assert_eq!(dropped.document, floor().document);
}

#[test]
fn a_line_takes_one_of_eight_directions_and_stays_on_the_map() {
    let grid = floor().world().grid().clone();
    for from in grid.cells().map(|(cell, _)| cell).step_by(7) {
        for to in grid.cells().map(|(cell, _)| cell).step_by(11) {
            let cells = drawn(Shape::Line, from, to, &Drawing::default(), &grid).cells;
            assert_eq!(cells[0], from);
            assert!(
                cells.iter().all(|&cell| grid.ground(cell).is_some()),
                "{from:?} {to:?}"
            );
            let steps = |pair: &[Cell]| {
                let [a, b] = pair else { unreachable!() };
                (b.x.wrapping_sub(a.x), b.y.wrapping_sub(a.y))
            };
            let mut steps: Vec<_> = cells.windows(2).map(steps).collect();
            steps.dedup();
            assert!(steps.len() <= 1, "{from:?} {to:?}: {steps:?}");
        }
    }
}

#[test]
fn fill_takes_the_connected_cells_of_the_same_ground() {
    let walled = draw(
        &floor(),
        Tool::Obstacle,
        Shape::Rectangle,
        &[],
        (10, 0),
        (10, 23),
    );
    let filled = after(
        &after(&walled, with(Shape::Fill, &[])),
        stroke(Tool::SlowZone, &[(3, 3)]),
    );
    assert_eq!(count(&filled, Ground::is_slow), 10 * 24);
    let away = after(&filled, stroke(Tool::Obstacle, &[(10, 5)]));
    assert_eq!(
        away.world().grid(),
        filled.world().grid(),
        "obstacles are there already"
    );
    let taken = [
        BoardAction::Mark {
            cell: Cell::new(10, 5),
            takes: true,
            is_rect: false,
        },
        BoardAction::Release,
    ];
    let taken = after(&away, taken.map(Action::Board));
    assert_eq!(count(&taken, |ground| ground == Ground::Obstacle), 0);
}

#[test]
fn blocks_stand_apart_as_many_as_fit() {
    let sizes = [
        (Measure::BlockWidth, 3),
        (Measure::BlockHeight, 2),
        (Measure::BlockGap, 2),
    ];
    let state = draw(
        &floor(),
        Tool::Obstacle,
        Shape::Blocks,
        &sizes,
        (1, 1),
        (12, 6),
    );
    // Columns at 1 to 3, 6 to 8; rows at 1 and 2, 5 and 6; a third column does not fit.
    assert_eq!(count(&state, |ground| ground == Ground::Obstacle), 4 * 6);
    assert_eq!(
        state.world().grid().ground(Cell::new(11, 1)),
        Some(Ground::Free)
    );
}

#[test]
fn racks_lie_along_the_longer_side_and_shrink_to_a_small_drag() {
    let state = draw(&floor(), Tool::Obstacle, Shape::Racks, &[], (1, 1), (5, 12));
    let ground = |x, y| state.world().grid().ground(Cell::new(x, y)).unwrap();
    let column = |x| (1..=12).all(|y| ground(x, y) == Ground::Obstacle);
    assert_eq!([1, 2, 3, 4, 5].map(column), [true, true, false, true, true]);
    let one = draw(
        &floor(),
        Tool::Obstacle,
        Shape::Racks,
        &[(Measure::RackDepth, 9)],
        (1, 1),
        (1, 1),
    );
    assert_eq!(count(&one, |ground| ground == Ground::Obstacle), 1);
}

#[test]
fn shift_draws_a_rectangle_and_alt_takes_away() {
    let state = after(
        &floor(),
        [Action::Board(BoardAction::PickTool(Tool::Obstacle))],
    );
    let drag = |takes, is_rect, to| {
        let mark = BoardAction::Mark {
            cell: Cell::new(2, 2),
            takes,
            is_rect,
        };
        [mark, BoardAction::Drag(vec![to]), BoardAction::Release].map(Action::Board)
    };
    let drawn = after(&state, drag(false, true, Cell::new(5, 4)));
    assert_eq!(count(&drawn, |ground| ground == Ground::Obstacle), 12);
    let taken = after(&drawn, drag(true, false, Cell::new(5, 2)));
    assert_eq!(count(&taken, |ground| ground == Ground::Obstacle), 8);
}

#[test]
fn keys_stretch_a_shape_until_the_tool_is_used_again() {
    let mut actions = with(Shape::Rectangle, &[]);
    let step = |by| BoardAction::StepCursor { by, carries: false };
    let keys = [
        BoardAction::PickTool(Tool::SlowZone),
        BoardAction::UseTool,
        step((2, 0)),
        step((0, 1)),
        BoardAction::UseTool,
    ];
    actions.extend(keys.map(Action::Board));
    assert_eq!(count(&after(&floor(), actions), Ground::is_slow), 6);
}

#[test]
fn measures_keep_to_what_is_possible() {
    let sizes = Drawing::default().with_measure(Measure::Every, 0);
    assert_eq!(sizes.measure(Measure::Every), 1);
    let sizes = sizes.with_measure(Measure::Every, u32::MAX);
    assert_eq!(sizes.measure(Measure::Every), LONGEST);
}
