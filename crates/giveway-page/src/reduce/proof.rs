//! The check of a proof: started, on its way, done.

use std::rc::Rc;

use giveway_proof::Report;
use giveway_solve::{CertifyRequest, Limits};

use super::{ask, stroke};
use crate::{Certifying, State, Work, proof};

/// Starts it where there is something to be checked.
pub(super) fn start(state: &mut State) {
    stroke::release(state);
    let Some(request) = proof::request(state) else {
        ask::refuse(state, "There is nothing proved to be checked.");
        return;
    };
    state.notice = None;
    state.runs += 1;
    state.work = Work::Certifying(Certifying {
        id: state.runs,
        request: Rc::new(CertifyRequest {
            limits: Limits {
                seconds: Some(f64::from(state.settings.seconds)),
                ..Limits::default()
            },
            ..request
        }),
        of_question: state.asking.is_some(),
        at: None,
    });
}

pub(super) fn is_current(state: &State, id: u64) -> bool {
    matches!(&state.work, Work::Certifying(run) if run.id == id)
}

/// It came to a claim.
pub(super) fn learn(state: &mut State, id: u64, claim: String, checking: bool) {
    if let Work::Certifying(run) = &mut state.work
        && run.id == id
    {
        run.at = Some((claim, checking));
    }
}

/// It is done.
pub(super) fn checked(state: &mut State, id: u64, report: Report) {
    let Work::Certifying(run) = &state.work else {
        return;
    };
    if run.id != id {
        return;
    }
    let of_question = run.of_question;
    state.work = Work::Idle;
    let report = Rc::new(report);
    if of_question {
        ask::change(state, |asking| asking.report = Some(report));
    } else if let Some(answer) = &state.answer {
        state.checked = Some((Rc::clone(answer), report));
    }
}
