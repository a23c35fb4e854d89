//! The check of a proof: started, done.

use std::rc::Rc;

use giveway_proof::Report;
use giveway_solve::{CertifyRequest, Limits};

use super::{ask, stroke};
use crate::{Certified, Certifying, State, Task, proof};

/// Starts it where there is something to be checked.
pub(super) fn start(state: &mut State) {
    stroke::release(state);
    let Some((about, request)) = proof::request(state) else {
        return ask::refuse(state, "There is nothing proved to be checked.");
    };
    state.view.notice = None;
    state.work.start(Task::Certify(Certifying {
        request: Rc::new(CertifyRequest {
            limits: Limits {
                seconds: Some(f64::from(state.settings.seconds)),
                ..Limits::default()
            },
            ..request
        }),
        about,
        at: None,
    }));
}

/// It is done.
pub(super) fn checked(state: &mut State, run: &Certifying, report: Report) {
    let report = Rc::new(report);
    match &run.about {
        Certified::Answer(answer) => {
            state.document.checked = Some((Rc::clone(answer), report));
        }
        Certified::Question(_) => {
            if let Some(asking) = state.document.mode.asking_mut() {
                asking.report = Some(report);
            }
        }
    }
}
