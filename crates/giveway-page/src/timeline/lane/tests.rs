//! Lanes of the warehouse, and lanes that differ.

use super::*;
use crate::sample::warehouse;

#[test]
fn the_lanes_of_the_warehouse() {
    let answer = warehouse();
    let lane = Lane::of(&answer, 0).unwrap();
    assert_eq!(
        (lane.arrival, lane.moves(), lane.count(Way::Slow)),
        (17, 15, 2)
    );
    assert_eq!(lane.charges, [9]);
    assert_eq!(lane.levels.len(), 18);
    assert_eq!(lane.level_at(9), Some(1));
    assert_eq!(lane.level_at(10), Some(10));
    assert_eq!(lane.level_at(99), lane.level_at(17));
    assert_eq!(
        lane.sentence(),
        "A1: 15 moves, 2 of them slow, charges at 9, arrives at 17"
    );
    assert_eq!(Lane::of(&answer, 2), None);
}

#[test]
fn steps_have_no_gaps() {
    let answer = warehouse();
    for agent in 0..2 {
        let lane = Lane::of(&answer, agent).unwrap();
        let mut at = (lane.begins, lane.entry);
        for step in &lane.steps {
            assert_eq!((step.begins, step.from), at);
            at = (step.ends, step.to);
            for time in step.begins..step.ends {
                assert_eq!(lane.step_at(time), Some(step));
            }
        }
        assert_eq!(at, (lane.arrival, lane.end()));
        assert_eq!(lane.step_at(lane.arrival), None);
    }
}

/// A lane of moves and waits along a row of cells.
fn along(cells: &[u32]) -> Lane {
    let steps = cells.windows(2).zip(0..).map(|(pair, begins)| Step {
        way: if pair[0] == pair[1] {
            Way::Wait
        } else {
            Way::Move
        },
        begins,
        ends: begins + 1,
        from: Cell::new(pair[0], 0),
        to: Cell::new(pair[1], 0),
    });
    let steps: Vec<Step> = steps.collect();
    Lane {
        arrival: steps.len() as u32,
        steps,
        ..Lane::of(&warehouse(), 0).unwrap()
    }
}

#[test]
fn what_is_done_otherwise_differs_and_what_is_done_later_does_not() {
    let differing = |one: &Lane, other: &Lane| {
        let steps = one.steps.iter().filter(|step| other.differs_from(step));
        steps.map(|step| step.begins).collect::<Vec<_>>()
    };
    let (at_once, late) = (along(&[0, 1, 2]), along(&[0, 0, 1, 2]));
    assert_eq!(differing(&late, &at_once), [0]);
    assert_eq!(differing(&at_once, &late), [0]);
    assert_eq!(differing(&late, &late), [0; 0]);
    let elsewhere = along(&[0, 1, 7]);
    assert_eq!(differing(&elsewhere, &at_once), [1]);
}

#[test]
fn each_stop_begins_once() {
    assert_eq!(along(&[0, 0, 0, 1, 1, 2]).stops(), [0, 3]);
    assert!(along(&[0, 1, 2]).stops().is_empty());
}
