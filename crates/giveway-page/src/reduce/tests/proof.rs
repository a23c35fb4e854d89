//! The check of a proof: offered, on its way, done, and of one answer only.

use giveway_model::{Cost, Version};
use giveway_proof::bundle::Method;
use giveway_proof::{Checked, Claim, Report};
use giveway_solve::{Progress, Request, Response};

use super::{after, stroke};
use crate::proof::{Outcome, Proof, proof};
use crate::sample::solved;
use crate::{Action, BoardAction, Phase, Selection, SolveAction, State, Tool, WorkerAction, words};

fn checking() -> State {
    after(&solved(), [Action::Solve(SolveAction::CheckProof)])
}

fn claims() -> Vec<Checked> {
    let claim = |cost, most| Claim::at_most([(cost, most)]);
    let proved = claim(Cost::Makespan, 17);
    let searched = claim(Cost::SumOfCosts, 34);
    let missing = claim(Cost::Charges, 2);
    vec![
        Checked::Proof {
            text: proved.sentence(),
            claim: proved,
            variables: 900,
            clauses: 23_456,
            steps: 3214,
        },
        Checked::Search {
            text: searched.sentence(),
            claim: searched,
            method: Method::Alone,
        },
        Checked::None {
            text: missing.sentence(),
            claim: missing,
            why: "Its formula would be too large.".to_owned(),
        },
    ]
}

fn report(claims: Vec<Checked>) -> Report {
    Report {
        giveway: Version,
        accepted: true,
        certified: giveway_proof::Certified::Proved,
        conclusion: None,
        concluded: None,
        reason: None,
        stopped: false,
        claims,
    }
}

fn respond(state: &State, report: Report) -> State {
    let run = state.work.id().unwrap();
    let response = Box::new(Response::Certified(Box::new(report)));
    after(
        state,
        [Action::Worker(WorkerAction::Respond { job: run, response })],
    )
}

#[track_caller]
fn outcome(state: &State) -> Outcome {
    match proof(state) {
        Some(Proof::Done(outcome)) => outcome,
        other => panic!("{other:?}"),
    }
}

#[test]
fn what_was_proved_is_asked_for_in_a_request() {
    assert_eq!(proof(&solved()), Some(Proof::Offered));
    let state = checking();
    assert_eq!(state.phase(), Phase::Checking);
    let Some((_, Request::Certify(request))) = state.work.request() else {
        panic!("{:?}", state.work);
    };
    assert_eq!(request.bounds[&Cost::Makespan], 18);
    assert!(request.plan.is_some() && request.limits.seconds.is_some());
    assert_eq!(words::standing(&state).sentence, "Checking the proof.");
}

#[test]
fn each_claim_is_told_as_it_is_come_to() {
    let state = checking();
    let run = state.work.id().unwrap();
    let tell = |checking| {
        Action::Worker(WorkerAction::Progress {
            job: run,
            event: Progress::Certifying {
                claim: "There is no plan.".to_owned(),
                checking,
            },
        })
    };
    let proving = after(&state, [tell(false)]);
    let said = "Proving again: There is no plan.";
    assert_eq!(words::standing(&proving).sentence, said);
    assert_eq!(proof(&proving), Some(Proof::Running(said.to_owned())));
    let later = after(&proving, [tell(true)]);
    let said = "Checking the proof: There is no plan.";
    assert_eq!(words::standing(&later).sentence, said);
}

#[test]
fn what_each_claim_rests_on_is_told() {
    let state = respond(&checking(), report(claims()));
    assert!(state.work.is_idle());
    let outcome = outcome(&state);
    assert_eq!(outcome.badge.word, "Partly checked");
    assert_eq!(
        outcome.sentence,
        "The proof was checked: 3214 steps. 1 claim rests on a search, which was repeated. \
         1 claim could not be checked."
    );
    let lines: Vec<&str> = outcome.claims.iter().map(|l| l.rests_on.as_str()).collect();
    assert_eq!(
        lines,
        [
            "A checked proof: 900 variables, 23\u{202f}456 clauses, 3214 steps.",
            "A search of each robot alone, repeated.",
            "Not checked. Its formula would be too large.",
        ]
    );
    let whole = respond(&checking(), report(claims()[..2].to_vec()));
    assert_eq!(self::outcome(&whole).badge.word, "Checked");
    let nothing = respond(&checking(), report(claims()[2..].to_vec()));
    assert_eq!(self::outcome(&nothing).badge.word, "Not checked");
}

#[test]
fn what_is_not_accepted_is_not_called_checked() {
    let refused = |stopped| Report {
        accepted: false,
        certified: giveway_proof::Certified::NotCertified,
        conclusion: None,
        concluded: None,
        reason: Some("It is wrong.".to_owned()),
        stopped,
        ..report(claims())
    };
    let rejected = outcome(&respond(&checking(), refused(false)));
    assert_eq!(rejected.badge.word, "Rejected");
    assert!(rejected.sentence.contains("It is wrong."), "{rejected:?}");
    let stopped = outcome(&respond(&checking(), refused(true)));
    assert_eq!(stopped.badge.word, "Not checked");
}

#[test]
fn a_report_is_of_one_answer_only() {
    let state = respond(&checking(), report(claims()));
    let edited = after(&state, stroke(Tool::Obstacle, &[(8, 2)]));
    assert_eq!(proof(&edited), None, "the plan is stale");
    let undone = after(&edited, [Action::Undo]);
    assert!(matches!(proof(&undone), Some(Proof::Done(_))));
    let solved_again = solved();
    let mut again = solved_again;
    again.document.checked = state.document.checked.clone();
    assert_eq!(proof(&again), Some(Proof::Offered));
}

#[test]
fn it_is_cancelled_at_once_and_what_comes_late_is_ignored() {
    let state = checking();
    let cancelled = after(&state, [Action::Solve(SolveAction::Cancel)]);
    assert!(cancelled.work.is_idle());
    assert_eq!(proof(&cancelled), Some(Proof::Offered));
    let run = state.work.id().unwrap();
    let response = Box::new(Response::Certified(Box::new(report(claims()))));
    let late = after(
        &cancelled,
        [Action::Worker(WorkerAction::Respond { job: run, response })],
    );
    assert_eq!(proof(&late), Some(Proof::Offered));
    let selected = after(
        &state,
        [Action::Board(BoardAction::Select(Selection::Agent(1)))],
    );
    assert_eq!(selected.work, state.work, "it goes on beside a selection");
}

#[test]
fn where_nothing_was_proved_nothing_is_offered() {
    let mut state = solved();
    let mut nothing = state.clone();
    nothing.document.answer = None;
    assert_eq!(proof(&nothing), None);
    let answer = std::rc::Rc::make_mut(state.document.answer.as_mut().unwrap());
    answer.solved.bounds.clear();
    assert_eq!(proof(&state), None);
    let refused = after(&state, [Action::Solve(SolveAction::CheckProof)]);
    assert!(refused.work.is_idle());
    assert!(refused.view.notice.is_some());
}
