//! The counter of events, its rows and columns made in any order.

use super::{as_unary, can, each_list, solver};
use crate::{
    encode::count::EventCounter,
    sat::{Lit, Sat},
};

/// A counter under test.
struct Trial {
    sat: Sat<'static>,
    count: EventCounter,
    /// The literals of each time: "at least one", and maybe "at least two".
    events: Vec<Vec<Lit>>,
    /// What was asked for: j and the literal "more than j".
    asked: Vec<(usize, Lit)>,
}

impl Trial {
    /// Every column asked for so far, for all events that there may be.
    fn check(&mut self, told: &str) {
        self.count.extend(&mut self.sat);
        assert_eq!(self.count.times(), self.events.len());
        let maxima: Vec<usize> = self.events.iter().map(Vec::len).collect();
        for values in each_list(&maxima) {
            let sum: usize = values.iter().sum();
            let events = self.events.iter().zip(&values);
            let mut given: Vec<Lit> = events
                .flat_map(|(event, &value)| as_unary(event, value))
                .collect();
            for &(j, more) in &self.asked {
                given.push(!more);
                let at_most = can(&mut self.sat, &given);
                given.pop();
                assert_eq!(at_most, sum <= j, "{told}: {values:?} at most {j}");
            }
            let exact = self.asked.iter();
            given.extend(exact.map(|&(j, more)| super::literal(more, sum > j)));
            assert!(can(&mut self.sat, &given), "{told}: {values:?}");
        }
    }
}

/// Follows a line: `2` makes a time whose event weighs up to two, `1` one that
/// is given and weighs one, `>j` asks for "more than j".
fn check(line: &str) {
    let mut trial = Trial {
        sat: solver(),
        count: EventCounter::default(),
        events: Vec::new(),
        asked: Vec::new(),
    };
    for word in line.split(' ') {
        let sat = &mut trial.sat;
        match word {
            "1" => {
                let event = super::fresh(sat, 1);
                trial.count.append(event[0]);
                trial.events.push(event);
            }
            "2" => {
                let event = trial.count.event(trial.events.len() as u32, sat);
                trial.events.push(event.to_vec());
            }
            _ => {
                let j = word.trim_start_matches('>').parse().unwrap();
                let more = trial.count.more_than(j, sat);
                trial.asked.push((j, more));
            }
        }
        trial.check(line);
    }
}

#[test]
fn columns_first_then_rows() {
    check(">0 >1 >2 >3 1 1 1 1 1");
    check(">0 >1 >2 >3 >4 >5 2 2 2");
}

#[test]
fn rows_first_then_columns() {
    check("1 1 1 1 >0 >1 >2 >3 >4");
    check("2 2 2 >0 >1 >2 >3 >4 >5 >6");
}

#[test]
fn rows_and_columns_in_turn() {
    check("1 >0 1 1 >1 1 >3 1");
    check("2 >0 2 >2 2 >1 2");
}

#[test]
fn a_far_column_makes_those_before_it() {
    check("2 1 >4 2 1 >0");
    check(">5 2 1 1 2 >3");
}

#[test]
fn weights_may_differ_from_time_to_time() {
    check("1 2 1 >0 >1 >2 >3 2");
    check("2 1 >1 2 1 >2");
}

#[test]
fn asking_again_gives_the_same_literal() {
    let mut sat = solver();
    let mut count = EventCounter::default();
    let first = count.more_than(2, &mut sat);
    count.event(4, &mut sat);
    assert_eq!(count.times(), 5);
    assert_eq!(count.event(2, &mut sat), count.event(2, &mut sat));
    assert_eq!(count.more_than(2, &mut sat), first);
}

#[test]
fn columns_have_no_holes() {
    let mut sat = solver();
    let mut count = EventCounter::default();
    let columns: Vec<Lit> = (0..4).map(|j| count.more_than(j, &mut sat)).collect();
    for pair in columns.windows(2) {
        assert!(!can(&mut sat, &[!pair[0], pair[1]]));
    }
}

#[test]
fn two_at_once_are_also_one() {
    let mut sat = solver();
    let [one, two] = EventCounter::default().event(0, &mut sat);
    assert!(!can(&mut sat, &[!one, two]));
    assert!(can(&mut sat, &[one, !two]));
}
