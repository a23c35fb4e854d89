//! Marks on the board: two clicks make one.

use giveway_course::judge::Did;
use giveway_course::learner::{Effect, reduce};
use giveway_course::port::{Hand, Happened, Pick, ToPage};
use giveway_model::Cell;

use super::{board, opened, said};

#[test]
fn two_clicks_make_a_mark() {
    let (learner, effects) = opened("two-robots-one-cell", 2);
    let number = board(&effects);
    assert!(effects.iter().any(|effect| {
        matches!(effect, Effect::Page(ToPage::Open(board)) if board.hand == Hand::Points)
    }));
    let pick = |x, time, robots: &[&str]| {
        let robots = robots.iter().map(|name| (*name).to_owned()).collect();
        let cell = Cell::new(x, 0);
        Happened::Picked(Pick { cell, time, robots })
    };
    let (learner, _) = reduce(learner, said(number, pick(1, 1, &["A1"])));
    assert!(learner.open.as_ref().unwrap().pointed().is_some());
    let (learner, _) = reduce(learner, said(number, pick(2, 1, &["A2"])));
    assert!(matches!(learner.open.as_ref().unwrap().did(), Did::Marked(marks) if marks.len() == 1));
    // A wrong mark does not stay beside the next one.
    let (learner, _) = reduce(learner, said(number, pick(3, 3, &["A1", "A3"])));
    assert!(!learner.open.as_ref().unwrap().is_solved());
    let (learner, _) = reduce(learner, said(number, pick(2, 2, &["A1", "A3"])));
    assert!(
        learner.open.as_ref().unwrap().is_solved(),
        "{:?}",
        learner.open.unwrap().did()
    );
}

#[test]
fn of_two_robots_in_a_cell_the_one_that_swaps_is_meant() {
    let (learner, effects) = opened("trust-but-check", 0);
    let number = board(&effects);
    let pick = |x, robots: &[&str]| {
        let robots = robots.iter().map(|name| (*name).to_owned()).collect();
        let cell = Cell::new(x, 3);
        let pick = Pick {
            cell,
            time: 2,
            robots,
        };
        Happened::Picked(pick)
    };
    let (learner, _) = reduce(learner, said(number, pick(2, &["A1", "A3"])));
    let (learner, _) = reduce(learner, said(number, pick(3, &["A4"])));
    let (learner, _) = reduce(learner, said(number, pick(2, &["A1", "A3"])));
    let open = learner.open.unwrap();
    assert!(open.is_solved(), "{:?}", open.did());
    let Did::Marked(marks) = open.did() else {
        panic!("{:?}", open.did());
    };
    assert_eq!(marks[1].robots, ["A4", "A1"]);
}

/// What the page is to say.
fn says(effects: &[Effect]) -> Vec<&str> {
    let says = effects.iter().filter_map(|effect| match effect {
        Effect::Page(ToPage::Say(sentence)) => Some(sentence.as_str()),
        _ => None,
    });
    says.collect()
}

#[test]
fn a_conflict_is_marked_once_and_a_click_that_does_nothing_says_why() {
    let (mut learner, effects) = opened("two-robots-one-cell", 2);
    let number = board(&effects);
    let mut click = |time, x, robots: &[&str]| {
        let robots = robots.iter().map(|&name| name.to_owned()).collect();
        let cell = Cell::new(x, 0);
        let pick = Happened::Picked(Pick { cell, time, robots });
        let (next, effects) = reduce(std::mem::take(&mut learner), said(number, pick));
        learner = next;
        let open = learner.open.as_ref().unwrap();
        let marks = match open.did() {
            Did::Marked(marks) => marks.len(),
            _ => 0,
        };
        let says = says(&effects)
            .into_iter()
            .map(str::to_owned)
            .collect::<Vec<_>>();
        (marks, says)
    };
    assert_eq!(click(0, 2, &[]).1, ["No robot is at (2, 0) at time 0."]);
    assert_eq!(click(2, 1, &["A2"]), (0, Vec::new()));
    let again = "Now click the robot that A2 gets into conflict with.";
    assert_eq!(click(2, 1, &["A2"]), (0, vec![again.to_owned()]));
    assert_eq!(click(2, 2, &["A1", "A3"]), (1, Vec::new()));
    // The same swap, before its step and from the other robot.
    assert_eq!(click(1, 1, &["A1"]), (1, Vec::new()));
    let known = "You have marked this conflict already.";
    assert_eq!(click(1, 2, &["A2"]), (1, vec![known.to_owned()]));
    assert_eq!(click(2, 2, &["A1", "A3"]), (2, Vec::new()));
    assert!(learner.open.unwrap().is_solved());
}
