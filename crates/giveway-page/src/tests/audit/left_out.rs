//! Plans of problems with rules that scenes do not have.

use super::{audit, dropped, fresh};
use crate::audit::facts;
use crate::tests::answered;
use crate::{Action, reduce, words};

const MAP: &str = "type octile\nheight 2\nwidth 3\nmap\n...\n...\n";
const TURNING: &str =
    r#"{"actionModel": "MAPF_T", "start": [[0, 0, "E"]], "actualPaths": ["R,F"]}"#;

#[test]
fn a_plan_of_ours_that_does_not_turn_is_no_better_one() {
    let state = answered(&dropped(&fresh(), &[("a.map", MAP), ("r.json", TURNING)]));
    assert!(audit(&state).better().is_none());
    let told = facts(&state).unwrap();
    assert_eq!(
        told.verdict.sentence,
        "At most 100.0 % above the best. Every plan costs at least 1, and this one costs 2."
    );
    assert!(told.take.is_none());
    let notes = audit(&state).notes.join(" ");
    assert!(notes.contains("a turn takes a step"), "{notes}");
    // The scene keeps it after the audit.
    let left = reduce(&state, Action::Audit(crate::audit::AuditAction::Leave));
    assert!(
        words::standing(&left)
            .sentence
            .contains("a turn takes a step"),
        "{}",
        words::standing(&left).sentence
    );
}
