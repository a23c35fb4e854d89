//! What a search of this page proved is handed on to a question; what a link or the browser's store
//! claims is not.

use giveway_model::Question;
use giveway_solve::{Reach, Status};

use super::answered;
use crate::link::{self, From, kept};
use crate::reduce::tests::after;
use crate::{Action, AskAction, FileAction, SolveAction, State, sample};

/// What a question about the plan takes as proved.
fn proved(state: &State) -> Option<Reach> {
    let asked = after(state, [Action::Ask(AskAction::Ask(Question::Makespan))]);
    let asking = asked.document.mode.asking().unwrap();
    asking.request.proved.as_ref().map(|proved| proved.reach)
}

fn status(state: &State) -> Status {
    state.document.fresh_answer().unwrap().solved.status
}

fn solved_here() -> State {
    let state = State::new(sample::draft());
    answered(&after(&state, [Action::Solve(SolveAction::Solve)]))
}

#[test]
fn the_proof_of_this_page_is_used_again() {
    let state = solved_here();
    assert_eq!(status(&state), Status::Optimal);
    let reach = state.document.fresh_answer().unwrap().solved.reach;
    assert_eq!(proved(&state), Some(reach));
}

#[test]
fn the_claim_of_what_the_browser_keeps_is_no_proof() {
    let again = kept(&link::keep(&solved_here())).unwrap();
    // It is shown as it was left, but a question proves it anew.
    assert_eq!(status(&again), Status::Optimal);
    assert_eq!(proved(&again), None);
}

#[test]
fn the_claim_of_a_link_is_no_proof() {
    let linked = link::read(&link::write(&solved_here()), From::Anywhere).unwrap();
    let open = Action::File(FileAction::OpenLink(Box::new(linked)));
    let opened = after(&State::new(crate::Draft::default()), [open]);
    assert!(opened.document.fresh_answer().is_some());
    assert_eq!(proved(&opened), None);
}
