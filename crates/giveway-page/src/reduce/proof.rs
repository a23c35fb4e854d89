//! The check of a proof: started, done, its certificates saved.

use std::rc::Rc;

use giveway_model::tr_data;
use giveway_proof::Report;
use giveway_solve::{CertifyRequest, ExportAnswer, ExportRequest, Limits};

use super::{ask, intake, stroke};
use crate::certificate::{self, Exporting};
use crate::{Certifies, Certifying, State, Task, files, intake::protocol, proof};

/// Starts it where there is something to be checked.
pub(super) fn start(state: &mut State) {
    stroke::release(state);
    let Some((about, request)) = proof::request(state) else {
        return ask::refuse(state, tr_data!("There is nothing proved to be checked."));
    };
    state.view.notice = None;
    state.work.start(Task::Certify(Certifying {
        request: Rc::new(CertifyRequest {
            limits: limits(state),
            ..proof::hinted(&about, request)
        }),
        about,
        at: None,
    }));
}

/// Starts what makes certificates of what the inspector tells.
pub(super) fn export(state: &mut State) {
    stroke::release(state);
    let Some((about, certificates)) = certificate::certificates(state) else {
        return ask::refuse(state, tr_data!("There is nothing proved to be saved."));
    };
    state.view.notice = None;
    let made = (0, u32::try_from(certificates.len()).unwrap_or(u32::MAX));
    let limits = limits(state);
    state.work.start(Task::Export(Exporting {
        request: Rc::new(ExportRequest {
            certificates,
            limits,
        }),
        about,
        made,
        at: None,
    }));
}

/// They are made: they become one file.
pub(super) fn exported(state: &mut State, answer: ExportAnswer) {
    if answer.certificates.is_empty() {
        return ask::refuse(
            state,
            tr_data!("Time ran out before the first certificate was made."),
        );
    }
    let name = files::certificate_name(state);
    intake::begin(state, protocol::Task::Pack { name, answer });
}

fn limits(state: &State) -> Limits {
    Limits {
        seconds: Some(f64::from(state.settings.seconds)),
        ..Limits::default()
    }
}

/// It is done.
pub(super) fn checked(state: &mut State, run: &Certifying, report: Report) {
    let report = Rc::new(report);
    match &run.about {
        Certifies::Answer(answer) => {
            state.document.checked = Some((Rc::clone(answer), report));
        }
        Certifies::Freedom(_) => {}
        Certifies::Question(_) => {
            if let Some(asking) = state.document.mode.asking_mut() {
                asking.report = Some(report);
            }
        }
    }
}
