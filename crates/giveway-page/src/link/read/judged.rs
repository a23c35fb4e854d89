//! A plan becomes an answer only after the judge passed it.

use std::collections::BTreeMap;
use std::rc::Rc;

use giveway_model::change::Changes;
use giveway_model::{Costs, Fault, Instance, Plan, Version, check, tr};
use giveway_solve::{Reach, SolveAnswer, SolveRequest, Stats, Status};

use super::parts::Parts;
use crate::changing::Changing;
use crate::link::{Linked, Source, change, claim};
use crate::{Activity, Answer, Document, Draft};

/// A plan with the changes around it, as files tell it, judged.
///
/// # Errors
/// What is wrong with it, as a sentence.
pub(crate) fn judged(draft: Draft, plan: Plan, changes: Option<Changes>) -> Result<Linked, String> {
    let draft = Rc::new(draft);
    let changes = changes.filter(|changes| !changes.changes.is_empty());
    if let Some(changes) = &changes {
        // By way of a link's text, which is bounded.
        let text = change::write(&changes.changes);
        change::read(&text, draft.agents().len())
            .ok_or(tr!("It has more changes than the page takes."))?;
    }
    let answer = answer(&draft, Some(plan), changes, &Parts::default())?;
    Ok(Linked {
        document: Document::answered(draft, answer.map(Rc::new)),
        time: 0,
        question: None,
        source: Source::File,
        was_impossible: false,
        is_checked: true,
    })
}

/// A plan that does not know of changes, judged without them; they are listed at the first
/// of their times, so that new plans can be found.
///
/// # Errors
/// What is wrong with the plan or the changes, as a sentence.
pub(crate) fn changing(draft: Draft, plan: Plan, changes: &Changes) -> Result<Linked, String> {
    let mut linked = judged(draft, plan, None)?;
    let misfit = |faults: &[Fault]| tr!("Its changes do not fit: {first}.", first = first(faults));
    let answer = linked.document.answer.as_ref();
    let changing = answer.map(|answer| Changing::of_file(answer, changes));
    let changing = changing.transpose().map_err(|faults| misfit(&faults))?;
    if let Some(changing) = changing.flatten() {
        linked.time = changing.at;
        linked.document.mode = Activity::Changing(Rc::new(changing)).into();
    }
    Ok(linked)
}

/// The plan as an answer, after the judge passed it.
pub(super) fn answer(
    draft: &Rc<Draft>,
    plan: Option<Plan>,
    changes: Option<Changes>,
    parts: &Parts<'_>,
) -> Result<Option<Answer>, String> {
    let instance = match (draft.instance(), &plan) {
        (Ok(instance), _) => instance,
        (Err(_), None) => return Ok(None),
        (Err(faults), Some(_)) => {
            let fault = first(faults);
            return Err(tr!(
                "The file has a plan, but its scene is not valid: {fault}.",
                fault
            ));
        }
    };
    let costs = match &plan {
        None => None,
        Some(plan) => costs(instance, plan, changes.as_ref())?,
    };
    let mut solved = SolveAnswer {
        giveway: Version,
        status: Status::Feasible,
        costs,
        bounds: BTreeMap::new(),
        reach: Reach::default(),
        ended: None,
        reason: None,
        plan,
        stats: Stats::default(),
        trace: None,
    };
    let claim = parts.get("claim");
    let has_claim = claim.is_some_and(|claim| claim::read(&mut solved, claim).is_some());
    if solved.plan.is_none() && !has_claim {
        return Ok(None);
    }
    let within = parts.read("asked-within", |text| text.parse().ok())?;
    let request = SolveRequest {
        scene: draft.scene().clone(),
        within,
        ..SolveRequest::default()
    };
    let (draft, request) = (Rc::clone(draft), Rc::new(request));
    let mut answer = match changes {
        None => Answer::new(draft, request, solved),
        Some(changes) => {
            let steps = parts.get("steps").unwrap_or_default();
            let steps = change::read_steps(steps, &changes);
            Answer::over_time(draft, request, solved, changes, steps)
                .map_err(|_| tr!("Its changes do not fit its plan."))?
        }
    };
    answer.is_shared = !has_claim;
    if has_claim {
        answer.by = parts.read("planner", |text| text.parse().ok())?;
    }
    Ok(Some(answer))
}

/// What a plan costs by the judge; `None` where there are no costs to tell.
///
/// # Errors
/// Which rule it breaks, as a sentence.
fn costs(
    instance: &Instance,
    plan: &Plan,
    changes: Option<&Changes>,
) -> Result<Option<Costs>, String> {
    let report = match changes {
        None => check::check(instance, plan),
        Some(changes) => check::check_changes(instance, changes, plan)
            .map_err(|faults| tr!("Its changes do not fit: {first}.", first = first(&faults)))?,
    };
    match report.violations.first() {
        Some(violation) => Err(tr!(
            "Its plan breaks a rule: {message}",
            message = violation.message
        )),
        None => Ok(report.costs),
    }
}

/// The first of some faults, as a sentence.
pub(super) fn first<T: ToString>(faults: &[T]) -> String {
    faults.first().map(ToString::to_string).unwrap_or_default()
}
