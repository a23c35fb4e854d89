//! Its steps, worked out by hand, and the same on every machine.

use super::{OPTIONS, search};
use crate::{
    lacam::{Ended, Event, Made, Options},
    pibt::Inheritance,
    tests::{instance, plain},
};

fn told(picture: &str, told: usize) -> Vec<Event> {
    let options = Options {
        guided: false,
        told,
        ..OPTIONS
    };
    search(&instance(picture), options).unwrap().trace.events
}

#[test]
fn a_push_by_hand() {
    // a goes from 0 to 1, b from 1 to 2. The longer way chooses first: equal, so
    // a does. It wants 1, where b stands: b inherits, and goes on to 2. That is
    // the goal, and nothing better is possible.
    let events = told("a bA B", 9);
    let inherited = vec![Inheritance {
        from: 0,
        to: 1,
        at: 1,
    }];
    let step = Event {
        from: 0,
        constrained: Vec::new(),
        constraints: Vec::new(),
        inherited,
        made: Made::New(1),
        cells: vec![1, 2],
    };
    assert_eq!(events, [step]);
}

#[test]
fn exhaustion_by_hand() {
    // Two that want to change places on two cells: the only configuration is
    // the first one. Its tree has the root, two cells for the first agent, and
    // for each of these two for the second: seven steps, of which only those
    // lead anywhere that let both stay.
    let events = told("aB bA", 100);
    assert!(events.iter().all(|event| event.from == 0));
    let lengths: Vec<usize> = events.iter().map(|event| event.constraints.len()).collect();
    assert_eq!(lengths, [0, 1, 1, 2, 2, 2, 2]);
    // The longer way chooses first: equal, so a does, then b.
    let second = |event: &&Event| event.constrained.len() == 2;
    assert!(
        events
            .iter()
            .filter(second)
            .all(|event| event.constrained == [0, 1])
    );
    let again = |event: &&Event| event.made == Made::Again(0);
    for event in events.iter().filter(again) {
        let at = [0, 1];
        assert_eq!(event.constraints, at[..event.constraints.len()]);
    }
    assert_eq!(events.iter().filter(again).count(), 3);
    assert!(
        events
            .iter()
            .all(|event| !matches!(event.made, Made::New(_)))
    );
}

#[test]
fn a_trace_is_no_longer_than_was_asked_for() {
    assert_eq!(told("aB bA", 3).len(), 3);
    assert_eq!(told("aB bA", 0), []);
}

#[test]
fn the_search_is_the_same_on_every_machine() {
    let instance = plain(3, 30, [10, 10], 10);
    for (guided, expected) in [(true, (298, 20)), (false, (367, 125))] {
        let options = Options {
            step_limit: 2_000,
            guided,
            ..OPTIONS
        };
        let report = search(&instance, options).unwrap();
        let best = report.best.unwrap();
        assert_eq!(report.ended, Ended::StepLimit);
        assert_eq!((best.loss, best.steps), expected);
    }
}
