//! The agents of the warehouse.

use super::*;
use crate::{Action, PlayAction, reduce, sample};

fn facts(agent: usize, time: u32) -> AgentFacts {
    let state = reduce(&sample::solved(), Action::Play(PlayAction::Seek(time)));
    super::agent(&state, agent).unwrap()
}

#[test]
fn a_charge() {
    let facts = facts(0, 9);
    assert_eq!(facts.doing, "Charging at (6, 2), then to (6, 1)");
    assert_eq!(facts.waypoints, (2, 3));
    let battery = facts.battery.unwrap();
    assert_eq!((battery.level, battery.charges), (1, true));
    assert_eq!(battery.cells(), (1, 10));
    assert_eq!(battery.reserve, Reserve::Critical);
}

#[test]
fn a_slow_move_and_half_of_it() {
    assert_eq!(facts(1, 9).doing, "Going slowly from (4, 0) to (3, 0)");
    assert_eq!(facts(1, 10).doing, "Half way from (4, 0) to (3, 0)");
}

#[test]
fn the_end() {
    let facts = facts(0, 18);
    assert_eq!(facts.doing, "Arrived at (9, 2)");
    assert_eq!(facts.waypoints, (3, 3));
    assert_eq!(facts.battery.unwrap().level, 3);
}

#[test]
fn without_a_plan() {
    let state = State::new(sample::draft());
    let facts = super::agent(&state, 1).unwrap();
    assert_eq!(facts.doing, "From (9, 2) to (0, 0)");
    assert_eq!(facts.waypoints.0, 0);
    assert_eq!(facts.battery.unwrap().level, 8);
    assert_eq!(super::agent(&state, 2), None);
}
