//! Certificates to be saved, of what the inspector tells: the best plan, the answer to a
//! question, what must be so in every best plan.

use std::rc::Rc;

use giveway_model::{Instance, tr};
use giveway_proof::Certified;
use giveway_solve::{Certificate, ExportAnswer, ExportRequest};

use crate::freedom::Freedom;
use crate::{Certifies, Notice, Selection, State, proof};

/// Certificates on their way to files.
#[derive(Clone, Debug, PartialEq)]
pub struct Exporting {
    /// The request.
    pub request: Rc<ExportRequest>,
    /// What is certified.
    pub about: Certifies,
    /// How many are made, and of how many.
    pub made: (u32, u32),
    /// The claim that it has come to, and whether its proof is being checked.
    pub at: Option<(String, bool)>,
}

/// What saves the certificates of what the inspector tells, in words; `None` where
/// there is nothing to save.
pub fn offer(state: &State) -> Option<&'static str> {
    if !state.work.is_idle() || state.intake.job().is_some() {
        return None;
    }
    let Some(freedom) = state.freedom() else {
        // They are made where it was seen before that they hold.
        return proof::is_accepted(state).then_some(tr!("Save the certificate"));
    };
    let instance = instance(freedom)?;
    let mut certificates = of_freedom(freedom, &instance, state.view.selection);
    certificates.next()?;
    Some(match state.view.selection {
        Selection::Nothing => tr!("Save all certificates"),
        Selection::Agent(_) | Selection::Cell(_) => tr!("Save its certificates"),
    })
}

/// The certificates of what the inspector tells.
pub(crate) fn certificates(state: &State) -> Option<(Certifies, Vec<Certificate>)> {
    offer(state)?;
    let Some(freedom) = state.freedom() else {
        let (about, request) = proof::request(state)?;
        let name = match about {
            Certifies::Question(_) => "answer",
            Certifies::Answer(_) | Certifies::Freedom(_) => "best",
        };
        let name = name.to_owned();
        let request = proof::hinted(&about, request);
        return Some((about, vec![Certificate { name, request }]));
    };
    let instance = instance(freedom)?;
    let certificates = of_freedom(freedom, &instance, state.view.selection).collect();
    let about = Certifies::Freedom(Rc::clone(&freedom.request));
    Some((about, certificates))
}

fn instance(freedom: &Freedom) -> Option<Instance> {
    let request = &freedom.request;
    let instance = Instance::new(request.scene.clone()).ok()?;
    Some(match &request.objective {
        Some(objective) => instance.with_objective(objective.clone()),
        None => instance,
    })
}

fn of_freedom<'a>(
    freedom: &'a Freedom,
    instance: &'a Instance,
    selection: Selection,
) -> Box<dyn Iterator<Item = Certificate> + 'a> {
    let Some(told) = freedom.told.as_deref() else {
        return Box::new(std::iter::empty());
    };
    match selection {
        Selection::Nothing => Box::new(told.certificates(instance).into_iter()),
        Selection::Agent(agent) => {
            let agent = instance.agents().get(agent).into_iter();
            let all = agent.flat_map(|agent| told.certificates_of_agent(instance, &agent.name));
            Box::new(all)
        }
        Selection::Cell(cell) => Box::new(told.certificates_of_cell(instance, cell)),
    }
}

/// What is being done, for status and inspector.
pub(crate) fn doing(run: &Exporting) -> String {
    let (made, of) = run.made;
    let which = if of > 1 {
        tr!("Certificate {made} of {of}: ", made = made + 1, of)
    } else {
        String::new()
    };
    let what = proof::doing(run.at.as_ref());
    format!("{which}{what}")
}

/// What was saved, in sentences: how many certificates, and how many of them hold.
pub(crate) fn saved(name: &str, answer: &ExportAnswer) -> Notice {
    let reports = || answer.certificates.values().map(|it| &it.report);
    let rejected = reports().filter(|it| !it.accepted && !it.stopped).count();
    let whole = reports().filter(|it| it.certified != Certified::NotCertified);
    let (all, whole) = (answer.certificates.len(), whole.count());
    let mut details = vec![if whole == all {
        tr!("It holds {n} certificate, all checked."
            | "It holds {n} certificates, all checked." % all)
    } else {
        tr!(
            "It holds {n} certificate; {whole} are proved."
                | "It holds {n} certificates; {whole} are proved." % all,
            whole
        )
    }];
    if rejected > 0 {
        details.push(tr!(
            "{n} certificate did not hold, which is a fault of this program."
                | "{n} certificates did not hold, which is a fault of this program." % rejected
        ));
    }
    if let open @ 1.. = all - whole - rejected {
        details.push(tr!(
            "{n} certificate not proved: there was too little time or memory."
                | "{n} certificates not proved: there was too little time or memory." % open
        ));
    }
    if answer.missing > 0 {
        details.push(tr!("{n} certificate not made: time ran out."
            | "{n} certificates not made: time ran out." % answer.missing));
    }
    details.push(tr!(
        "Anyone can check it again without this page: giveway verify {name}",
        name
    ));
    let sentence = tr!("{name} is saved.", name);
    if rejected > 0 {
        Notice::refusal(sentence).with(details)
    } else {
        Notice::information(sentence).with(details)
    }
}
