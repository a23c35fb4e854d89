//! `Go on` with a plan around which the world has changed: it is improved in that world.

use giveway_model::Question;
use giveway_solve::Request;

use super::adopted;
use crate::reduce::tests::after;
use crate::{Action, SolveAction};

#[test]
fn going_on_keeps_the_changes_of_the_world() {
    let before = adopted();
    assert!(before.document.changed_last().is_some());
    let state = after(&before, [Action::Solve(SolveAction::Solve)]);
    assert_eq!(state.document.answer, before.document.answer);
    let Some((_, Request::Explain(request))) = state.work.request() else {
        panic!("{:?}", state.work);
    };
    assert_eq!(request.question, Question::Plan);
    assert!(request.changes.is_some(), "in its world");
    assert_eq!(state.view.notice, None);
}
