//! The check of a proof as the inspector shows it: offered, on its way, done.

use std::rc::Rc;

use giveway_model::tr;
use giveway_proof::{Checked, Report};
use giveway_solve::CertifyRequest;
use giveway_solve::explain::Verdict;

use crate::ask::Badge;
use crate::words::grouped;
use crate::{Certifies, State, Task, certificate};

/// The check of a proof.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Proof {
    /// It can be asked for.
    Offered,
    /// It is on its way: what is being done.
    Running(String),
    /// It is done.
    Done(Outcome),
}

/// What came of it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Outcome {
    /// In a word.
    pub badge: Badge,
    /// In a sentence.
    pub sentence: String,
    /// What each claim rests on.
    pub claims: Vec<Line>,
}

/// A claim.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Line {
    /// The icon's name.
    pub icon: &'static str,
    /// The claim.
    pub text: String,
    /// What it rests on.
    pub rests_on: String,
}

/// What there is to show; nothing where nothing was proved.
pub fn proof(state: &State) -> Option<Proof> {
    if let Some(Task::Certify(run)) = state.work.task() {
        return Some(Proof::Running(doing(run.at.as_ref())));
    }
    if let Some(Task::Export(run)) = state.work.task() {
        return Some(Proof::Running(certificate::doing(run)));
    }
    match report(state) {
        Some(report) => Some(Proof::Done(outcome(report))),
        None => request(state).map(|_| Proof::Offered),
    }
}

/// What came of the check of what the inspector shows.
fn report(state: &State) -> Option<&Report> {
    match state.document.mode.asking() {
        Some(asking) => asking.report.as_deref(),
        None => state
            .document
            .report()
            .filter(|_| !state.document.is_stale()),
    }
}

/// Whether it was checked, and holds.
pub(crate) fn is_accepted(state: &State) -> bool {
    report(state).is_some_and(|report| report.accepted)
}

/// What is to be certified: the answer to the question, where one was asked,
/// else the plan, or that there is none.
pub(crate) fn request(state: &State) -> Option<(Certifies, CertifyRequest)> {
    if !state.work.is_idle() {
        return None;
    }
    let Some(asking) = state.document.mode.asking() else {
        // Certificates are of plans in one world.
        let answer = state.document.fresh_answer();
        let answer = answer.filter(|answer| answer.course.is_none())?;
        if state.document.mode.changing().is_some() {
            return None;
        }
        let (scene, objective) = (&answer.request.scene, &answer.request.objective);
        let request = CertifyRequest::of_solved(scene.clone(), objective.clone(), &answer.solved);
        let about = Certifies::Answer(Rc::clone(answer));
        return claims_something(&request).then_some((about, request));
    };
    // Certificates are of plans in one world.
    if asking.request.changes.is_some() {
        return None;
    }
    let told = asking.told.as_deref()?;
    if told.verdict == Verdict::Unknown || told.valid == Some(false) {
        return None;
    }
    let mut instance = asking.about.draft.instance().ok()?.clone();
    if let Some(objective) = &asking.request.objective {
        instance = instance.with_objective(objective.clone());
    }
    let request = CertifyRequest::of_explained(&instance, asking.request.plan.as_ref(), told);
    let about = Certifies::Question(Rc::clone(&asking.request));
    claims_something(&request).then_some((about, request))
}

/// A request that is to be carried out, with guesses for lemmas.
pub(crate) fn hinted(about: &Certifies, request: CertifyRequest) -> CertifyRequest {
    match about {
        Certifies::Answer(answer) => request.with_hints(answer.solved.trace.as_ref()),
        Certifies::Question(_) | Certifies::Freedom(_) => request,
    }
}

/// Whether anything is claimed not to be: a bound of 0 says nothing.
fn claims_something(request: &CertifyRequest) -> bool {
    request.impossible || request.bounds.values().any(|&bound| bound > 0)
}

/// What a check is at, for the status and the inspector.
pub(crate) fn doing(at: Option<&(String, bool)>) -> String {
    match at {
        None => tr!("Checking the proof.").to_owned(),
        Some((claim, false)) => tr!("Proving again: {claim}", claim),
        Some((claim, true)) => tr!("Checking the proof: {claim}", claim),
    }
}

fn outcome(report: &Report) -> Outcome {
    let claims = &report.claims;
    let number = |is: fn(&Checked) -> bool| claims.iter().filter(|claim| is(claim)).count();
    let shown = number(|claim| !matches!(claim, Checked::None { .. }));
    let (word, icon, class) = match (report.accepted, report.stopped) {
        (true, _) if shown == claims.len() => (tr!("Checked"), "proved", "checked"),
        (true, _) if shown == 0 => (tr!("Not checked"), "clock", "unknown"),
        (true, _) => (tr!("Partly checked"), "clock", "unknown"),
        (false, true) => (tr!("Not checked"), "clock", "unknown"),
        (false, false) => (tr!("Rejected"), "cancel", "broken"),
    };
    let reason = report.reason.as_deref().unwrap_or_default();
    let sentence = match (report.accepted, report.stopped) {
        (true, _) => report.summary(),
        (false, true) => tr!("The check ended too early. {reason}", reason),
        (false, false) => {
            tr!(
                "The certificate does not hold, which is a fault of this program. {reason}",
                reason
            )
        }
    };
    Outcome {
        badge: Badge { word, icon, class },
        sentence,
        claims: claims.iter().map(line).collect(),
    }
}

/// So many lemmas are told.
const SHOWN_LEMMAS: usize = 3;

fn line(claim: &Checked) -> Line {
    let (icon, text, rests_on) = match claim {
        Checked::Proof {
            text,
            variables,
            clauses,
            steps,
            ..
        } => {
            let [variables, clauses, steps] = [*variables, *clauses, *steps].map(|n| n as u64);
            let size = tr!(
                "A checked proof: {variables} variables, {clauses} clauses, {steps} steps.",
                variables = grouped(variables),
                clauses = grouped(clauses),
                steps = grouped(steps)
            );
            ("proved", text, size)
        }
        Checked::Lemmas { text, lemmas, .. } => {
            let number = u32::try_from(lemmas.len()).unwrap_or(u32::MAX);
            let sentences = lemmas.iter().map(|lemma| lemma.text.as_str());
            let first: Vec<&str> = sentences.take(SHOWN_LEMMAS).collect();
            let what = tr!(
                "{n} checked lemma: {first}" | "{n} checked lemmas, the first: {first}" % number,
                first = first.join(" ")
            );
            ("proved", text, what)
        }
        Checked::Search { text, method, .. } => {
            let what = tr!("A search of {method}, repeated.", method = method.words());
            ("search", text, what)
        }
        Checked::None { text, why, .. } => ("clock", text, tr!("Not checked. {why}", why)),
    };
    Line {
        icon,
        text: text.clone(),
        rests_on,
    }
}
