//! The shapes of the warehouse's lanes.

use super::*;
use crate::sample::warehouse;

fn shapes(seen: &Range<u32>) -> Shapes {
    let lane = Lane::of(&warehouse(), 0).unwrap();
    let axis = Axis {
        times: 19,
        column: 40.0,
    };
    Shapes::of(&lane, axis, Row::WIDE, seen)
}

#[test]
fn a_bar_for_every_move() {
    let all = shapes(&(0..19));
    assert_eq!(all.moves.matches('M').count(), 13);
    assert_eq!(all.slow.matches('M').count(), 2);
    assert_eq!(all.waits, "");
    assert_eq!(all.charges, [380.0]);
    assert_eq!((all.flag, all.entry), (Some(700.0), None));
    assert_eq!(all.after, "M714 15H740");
    // Half a column after 0, full; then lower and lower.
    assert!(
        all.level.starts_with("M20 27L60 29L100 31"),
        "{}",
        all.level
    );
}

#[test]
fn steps_of_one_kind_are_joined_where_columns_are_narrow() {
    let lane = Lane::of(&warehouse(), 0).unwrap();
    let axis = Axis {
        times: 19,
        column: 8.0,
    };
    let shapes = Shapes::of(&lane, axis, Row::MANY, &(0..19));
    let kinds = lane.steps.chunk_by(|a, b| a.way == b.way);
    let moves = kinds.filter(|steps| steps[0].way == Way::Move).count();
    assert_eq!(shapes.moves.matches('M').count(), moves);
    assert!(moves < 13);
    let whole = |steps: &[Step]| {
        steps
            .iter()
            .map(|step| step.ends - step.begins)
            .sum::<u32>()
    };
    let joined = joined(lane.steps.iter(), axis);
    assert_eq!(whole(&joined), whole(&lane.steps));
    assert!(joined.windows(2).all(|pair| pair[0].ends == pair[1].begins));
}

#[test]
fn half_a_lane_has_frames_and_no_battery() {
    let lane = Lane::of(&warehouse(), 0).unwrap();
    let mut other = lane.clone();
    other.steps[1].to = giveway_model::Cell::new(1, 1);
    let axis = Axis {
        times: 19,
        column: 40.0,
    };
    let frames = |seen| Shapes::frames(&lane, &other, axis, Row::HALF, &seen);
    assert_eq!(frames(0..19).matches('M').count(), 1);
    assert!(frames(0..19).starts_with("M63.5 3h"), "{}", frames(0..19));
    assert_eq!(frames(8..19), "");
    assert_eq!(Shapes::of(&lane, axis, Row::HALF, &(0..19)).level, "");
}

#[test]
fn what_is_not_seen_is_not_drawn() {
    let some = shapes(&(0..3));
    assert_eq!(some.moves.matches('M').count(), 2);
    assert_eq!(some.slow.matches('M').count(), 1);
    assert_eq!((some.charges.len(), some.flag), (0, None));
    assert_eq!(some.level.matches(['M', 'L']).count(), 4);
}

#[test]
fn a_wait_has_a_pause() {
    let step = |way, begins, ends| Step {
        way,
        begins,
        ends,
        from: giveway_model::Cell::new(0, 0),
        to: giveway_model::Cell::new(0, 0),
    };
    let axis = Axis {
        times: 9,
        column: 14.0,
    };
    let mut shapes = Shapes::default();
    shapes.add(&step(Way::Wait, 0, 1), axis, Row::DENSE);
    let narrow = Axis {
        column: 9.0,
        ..axis
    };
    let mut one = Shapes::default();
    one.add(&step(Way::Wait, 0, 1), narrow, Row::MANY);
    assert_eq!(one.pauses.matches('M').count(), 1);
    let mut long = Shapes::default();
    long.add(&step(Way::Wait, 0, 3), narrow, Row::MANY);
    assert_eq!(long.pauses.matches('M').count(), 2);
    assert_eq!(shapes.pauses.matches('M').count(), 2);
    assert!(shapes.waits.starts_with("M12 6.75h4"), "{}", shapes.waits);
}
