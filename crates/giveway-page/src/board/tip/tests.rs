//! The tip of a cell: what it tells, and where it is.

use super::super::tests::planned;
use super::*;

fn told(time: u32, x: u32, y: u32) -> String {
    let mut state = planned();
    state.view.playback.time = time;
    let cast = Cast::of(&state);
    let tip = tip(&state, &cast, Cell::new(x, y)).unwrap();
    format!("{} {}", tip.cell, tip.sentence())
}

#[test]
fn who_is_there_comes_next_and_waits() {
    assert_eq!(told(0, 0, 0), "(0, 0) used 1 time, by 1 robot, A is here");
    assert_eq!(
        told(0, 1, 0),
        "(1, 0) used 1 time, by 1 robot, A is the next here, at 1, waypoint of A"
    );
    assert_eq!(
        told(1, 3, 1),
        "(3, 1) used 1 time, by 1 robot, B is here, B waits here for 1 step, at 0"
    );
    assert_eq!(told(4, 0, 1), "(0, 1) never used");
    assert_eq!(told(0, 1, 1), "(1, 1) obstacle");
}

#[test]
fn units_stand_beside_times_and_places() {
    let mut state = planned();
    let mut scene = state.document.draft.scene().clone();
    scene.units = serde_json::from_str(r#"{ "cell": 0.8, "step": 1.5 }"#).unwrap();
    state.document.draft = std::rc::Rc::new(crate::Draft::new(scene).unwrap());
    state.view.selection = crate::Selection::Agent(0);
    let tip = tip(&state, &Cast::of(&state), Cell::new(2, 0)).unwrap();
    assert_eq!(tip.cell, "(2, 0), 1.6 m");
    assert_eq!(tip.lines[0].text, "A is the next here, at 2 (3 s)");
}

#[test]
fn without_a_plan_whose_the_cell_is() {
    let mut state = planned();
    state.document.answer = None;
    let cast = Cast::of(&state);
    let of = |x, y| tip(&state, &cast, Cell::new(x, y)).map(|tip| tip.sentence());
    assert_eq!(of(1, 0).as_deref(), Some("waypoint of A"));
    assert_eq!(of(0, 1).as_deref(), Some(""));
    assert_eq!(of(99, 0), None);
}

#[test]
fn a_tip_is_in_sight_and_off_the_way() {
    let frame = Frame {
        x: 0.0,
        y: 0.0,
        width: 4000.0,
        height: 2400.0,
        cell_px: 20.0,
    };
    let corner = |x: u32, y: u32, way: &[(u32, u32)]| {
        let way = way.iter().map(|&(x, y)| Cell::new(x, y));
        tip_corner(Cell::new(x, y), &frame, (200.0, 60.0), way)
    };
    assert_eq!(corner(10, 10, &[]), (230.0, 130.0));
    assert_eq!(corner(10, 10, &[(13, 8)]), (230.0, 230.0));
    assert_eq!(corner(10, 0, &[]), (230.0, 30.0));
    assert_eq!(corner(39, 23, &[]), (570.0, 390.0));
    for x in 0..40 {
        for y in 0..24 {
            let (left, top) = corner(x, y, &[]);
            assert!((0.0..=600.0).contains(&left) && (0.0..=420.0).contains(&top));
        }
    }
}
