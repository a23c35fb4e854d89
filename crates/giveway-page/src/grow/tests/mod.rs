//! The size of the floor.

mod lines;

use giveway_model::constraint::ConstraintKind;
use giveway_model::{Agent, Cell, Constraint, Scene, Zone};

use super::{GrowAction, Room, Side, card};
use crate::edit::{Lost, Sides};
use crate::reduce::tests::after;
use crate::{Action, Draft, Point, SolveAction, State, words};

/// A floor of 5 × 4 cells whose last column has a goal, a start and the end of a lane.
fn floor() -> State {
    let agent = |name: &str, start: (u32, u32), goal: (u32, u32)| Agent {
        name: name.to_owned(),
        start: Cell::new(start.0, start.1),
        goal: Some(Cell::new(goal.0, goal.1)),
        waypoints: vec![Cell::new(4, 3), Cell::new(1, 1)],
        battery: None,
        heading: None,
    };
    let lane = |cells: &[(u32, u32)]| Constraint {
        kind: ConstraintKind::OneWay {
            lane: cells.iter().map(|&(x, y)| Cell::new(x, y)).collect(),
        },
        agents: None,
        name: None,
        off: false,
    };
    let scene = Scene {
        map: [".....", "..#..", "...~+", "....."]
            .map(str::to_owned)
            .to_vec(),
        agents: vec![agent("A1", (0, 0), (4, 0)), agent("A2", (4, 1), (0, 3))],
        zones: vec![Zone {
            name: "dock".to_owned(),
            rect: Some([3, 0, 4, 1]),
            listed: None,
        }],
        constraints: vec![lane(&[(2, 0), (3, 0), (4, 0)]), lane(&[(4, 2), (4, 3)])],
        ..Scene::default()
    };
    State::new(Draft::new(scene).unwrap())
}

fn act(state: &State, actions: &[GrowAction]) -> State {
    after(state, actions.iter().map(|&action| Action::Grow(action)))
}

#[test]
fn rows_above_and_columns_at_the_left_move_everything() {
    let before = floor();
    let open = act(
        &before,
        &[
            GrowAction::Open,
            GrowAction::Side(Side::Top, 2),
            GrowAction::Side(Side::Left, 1),
        ],
    );
    assert_eq!(open.document, before.document);
    let told = card(&open).unwrap();
    assert_eq!(
        (told.before.as_str(), told.after.as_str()),
        ("5 \u{d7} 4", "6 \u{d7} 6")
    );
    assert!(told.losses.is_empty() && told.lost.is_none());
    assert_eq!(told.moved.unwrap(), "(1, 2) becomes (2, 4), and so on.");
    let made = act(&open, &[GrowAction::Make]);
    let scene = made.document.draft.scene();
    assert_eq!(
        scene.map,
        ["......", "......", "......", "...#..", "....~+", "......"]
    );
    assert_eq!(scene.agents[0].start, Cell::new(1, 2));
    assert_eq!(
        scene.agents[0].waypoints,
        [Cell::new(5, 5), Cell::new(2, 3)]
    );
    assert_eq!(scene.zones[0].rect, Some([4, 2, 5, 3]));
    let lane = vec![Cell::new(5, 4), Cell::new(5, 5)];
    assert_eq!(scene.constraints[1].kind, ConstraintKind::OneWay { lane });
    assert_eq!(
        after(&made, [Action::Undo]).document.draft,
        before.document.draft
    );
    // The same cells go again, and nothing is lost with them.
    let back = act(
        &made,
        &[
            GrowAction::Open,
            GrowAction::Side(Side::Top, -2),
            GrowAction::Side(Side::Left, -1),
        ],
    );
    assert!(card(&back).unwrap().losses.is_empty());
    assert_eq!(
        act(&back, &[GrowAction::Make]).document.draft,
        before.document.draft
    );
}

#[test]
fn what_would_be_lost_is_said_before() {
    let open = act(&floor(), &[GrowAction::To(4, 4)]);
    assert_eq!(open.document, floor().document, "it asks first");
    let told = card(&open).unwrap();
    let losses = [
        "1 robot starts there: A2",
        "1 has its goal there: A1",
        "2 waypoints",
        "1 charger",
        "1 rule whose place goes",
    ];
    assert_eq!(told.losses, losses);
    assert_eq!(told.lost, Some(Lost::Move));
    let status = words::standing(&open).sentence;
    assert_eq!(
        status,
        "A smaller floor: 2 robots would lose their start or goal."
    );
    let made = act(&open, &[GrowAction::Make]);
    let agents = made.document.draft.agents();
    assert_eq!(agents[1].start, Cell::new(3, 1));
    assert_eq!(agents[0].goal, Some(Cell::new(3, 0)));
    assert_eq!(agents[0].waypoints, [Cell::new(3, 3), Cell::new(1, 1)]);
    let rules = &made.document.draft.scene().constraints;
    assert_eq!(rules.len(), 1);
    assert_eq!(
        rules[0].kind,
        ConstraintKind::OneWay {
            lane: vec![Cell::new(2, 0), Cell::new(3, 0)]
        }
    );
    assert_eq!(
        made.document.draft.scene().zones[0].rect,
        Some([3, 0, 3, 1])
    );
    let removed = act(&open, &[GrowAction::Lost(Lost::Remove), GrowAction::Make]);
    assert!(removed.document.draft.agents().is_empty());
    assert_eq!(act(&open, &[GrowAction::Cancel]).document, floor().document);
}

#[test]
fn where_nothing_is_lost_nothing_is_asked() {
    let made = act(&floor(), &[GrowAction::To(9, 5)]);
    assert!(card(&made).is_none());
    assert_eq!(made.document.draft.grid().width(), 9);
    assert_eq!(
        made.document.draft.agents(),
        floor().document.draft.agents()
    );
}

#[test]
fn a_floor_keeps_a_row_and_a_column() {
    let open = act(
        &floor(),
        &[
            GrowAction::Open,
            GrowAction::Side(Side::Left, -4),
            GrowAction::Side(Side::Right, -1),
        ],
    );
    assert_eq!(card(&open).unwrap().after, "1 \u{d7} 4");
    let far = act(&open, &[GrowAction::Side(Side::Bottom, 100_000)]);
    assert_eq!(card(&far).unwrap().after, "1 \u{d7} 4");
}

#[test]
fn steps_add_up_as_far_as_possible() {
    let open = act(&floor(), &[GrowAction::Open]);
    let step = |by| GrowAction::Step(Side::Right, by);
    let stepped = act(&open, &[step(1), step(5), step(-1)]);
    let set = act(&open, &[GrowAction::Side(Side::Right, 5)]);
    assert_eq!(stepped.view.growing, set.view.growing);
    assert_eq!(card(&act(&open, &[step(-99)])).unwrap().after, "1 \u{d7} 4");
    assert_eq!(
        card(&act(&open, &[step(i32::MAX)])).unwrap().after,
        "2048 \u{d7} 4"
    );
}

#[test]
fn solving_keeps_it() {
    let open = act(
        &floor(),
        &[GrowAction::Open, GrowAction::Side(Side::Bottom, 1)],
    );
    let solved = after(&open, [Action::Solve(SolveAction::Solve)]);
    assert_eq!(solved.document.draft.grid().height(), 5);
}

#[test]
fn a_side_that_is_held_goes_with_the_hand_as_far_as_possible() {
    let open = act(&floor(), &[GrowAction::Open]);
    let idle = act(&open, &[GrowAction::Drag(Side::Right, 3)]);
    assert_eq!(idle.view.growing, open.view.growing, "nothing is held");
    let held = act(
        &open,
        &[GrowAction::Hold, GrowAction::Drag(Side::Right, -99)],
    );
    assert_eq!(card(&held).unwrap().after, "1 \u{d7} 4");
    let far = act(&held, &[GrowAction::Drag(Side::Right, i32::MAX)]);
    assert_eq!(card(&far).unwrap().after, "2048 \u{d7} 4");
    assert_eq!(far.room(), open.room(), "the floor stays under the hand");
    let let_go = act(
        &far,
        &[GrowAction::Drag(Side::Right, 2), GrowAction::Release],
    );
    assert_eq!(card(&let_go).unwrap().after, "7 \u{d7} 4");
    assert_eq!(
        let_go.room(),
        Room {
            before: (2, 2),
            size: (2 + 5 + 4, 8)
        }
    );
    let back = act(&far, &[GrowAction::Abandon]);
    assert_eq!(back.view.growing, open.view.growing);
}

#[test]
fn a_drag_counts_the_lines_between_cells() {
    let open = act(&floor(), &[GrowAction::Open]);
    // The middle of the first cell is (0, 0): its left edge is at -0.5.
    let at = |side: Side, x: f64, y: f64| open.side_dragged(side, Point { x, y });
    for (side, here) in [
        (Side::Left, (-0.5, 9.0)),
        (Side::Top, (9.0, -0.5)),
        (Side::Right, (4.5, 9.0)),
        (Side::Bottom, (9.0, 3.5)),
    ] {
        assert_eq!(at(side, here.0, here.1), 0, "{side:?}");
        assert_eq!(at(side, here.0 + 0.4, here.1 - 0.4), 0, "{side:?}");
    }
    assert_eq!(at(Side::Left, -2.4, 0.0), 2);
    assert_eq!(at(Side::Left, 1.4, 0.0), -2);
    assert_eq!(at(Side::Top, 0.0, -1.6), 1);
    assert_eq!(at(Side::Right, 6.6, 0.0), 2);
    assert_eq!(at(Side::Bottom, 0.0, 0.6), -3);
}

/// Every cell that comes or goes is in one strip of that kind, and no other cell is in one.
#[test]
fn strips_are_what_comes_and_goes_cell_by_cell() {
    let open = act(&floor(), &[GrowAction::Open]);
    let numbers = [-1, 0, 2];
    for (left, top) in numbers.into_iter().flat_map(|n| numbers.map(|m| (n, m))) {
        for (right, bottom) in numbers.into_iter().flat_map(|n| numbers.map(|m| (n, m))) {
            let sides = Sides {
                left,
                top,
                right,
                bottom,
            };
            let all = Side::ALL.map(|side| GrowAction::Side(side, side.of(sides)));
            let strips = act(&open, &all).size_strips();
            for (x, y) in (-4..10).flat_map(|x| (-4..10).map(move |y| (x, y))) {
                let is_old = (0..5).contains(&x) && (0..4).contains(&y);
                let is_new = (-left..5 + right).contains(&x) && (-top..4 + bottom).contains(&y);
                let mut found = strips.iter().filter(|strip| {
                    let [x0, y0, x1, y1] = strip.area;
                    (x0..x1).contains(&x) && (y0..y1).contains(&y)
                });
                let more = found.next().map(|strip| strip.more > 0);
                let expected = (is_old != is_new).then_some(is_new);
                assert_eq!(more, expected, "({x}, {y}) with {sides:?}");
                assert!(found.next().is_none(), "({x}, {y}) twice with {sides:?}");
            }
        }
    }
}
