//! Plans of problems with rules that scenes do not have.

use super::{audit, dropped, fresh};
use crate::audit::facts;
use crate::tests::answered;
use crate::{Action, reduce, words};

const MAP: &str = "type octile\nheight 2\nwidth 3\nmap\n...\n...\n";
/// A turn and a move, two ticks each.
const SLOW: &str = r#"{"actionModel": "MAPF_T", "version": "2026 LoRR", "agentMaxCounter": 2,
    "start": [[0, 0, "E"]], "actualPaths": ["[(0,0,0,0,0):(R 2,F 2)]"]}"#;

#[test]
fn a_plan_of_ours_whose_moves_take_a_step_is_no_better_one() {
    let state = answered(&dropped(&fresh(), &[("a.map", MAP), ("r.json", SLOW)]));
    assert!(audit(&state).better().is_none());
    let told = facts(&state).unwrap();
    assert_eq!(
        told.verdict.sentence,
        "At most 100.0 % above the best. Every plan costs at least 2, and this one costs 4."
    );
    assert!(told.take.is_none());
    let notes = audit(&state).notes.join(" ");
    assert!(notes.contains("a move takes several steps"), "{notes}");
    // The scene keeps it after the audit.
    let left = reduce(&state, Action::Audit(crate::audit::AuditAction::Leave));
    assert!(
        words::standing(&left)
            .sentence
            .contains("a move takes several steps"),
        "{}",
        words::standing(&left).sentence
    );
}
