//! The document of a lesson's board.

use std::collections::BTreeMap;
use std::rc::Rc;

use giveway_course::port::{Board, BoardPlan, Hand};
use giveway_model::change::Changes;
use giveway_model::check::check_changes;
use giveway_model::{Fault, Plan, Scene, Version};
use giveway_solve::{SolveAnswer, SolveRequest};

use crate::audit::{Audit, Dropped, unproved};
use crate::changing::Changing;
use crate::steering::Steering;
use crate::{Activity, Answer, Document, Draft};

/// The document of a board, with its plan where it comes with one.
///
/// # Errors
/// What is wrong with the scene.
pub(crate) fn document(board: &Board) -> Result<Document, Vec<Fault>> {
    let draft = Rc::new(Draft::new(board.scene.clone())?);
    let given = match &board.plan {
        BoardPlan::Given(plan) => Some(plan),
        BoardPlan::None | BoardPlan::Best | BoardPlan::Hidden => None,
    };
    if let Hand::Leads(names) = &board.hand {
        let plan = given.cloned();
        let plan = plan.unwrap_or_else(|| standing(&board.scene));
        if let Some(document) = led(&draft, &plan, names) {
            return Ok(document);
        }
    }
    let changes = board.changes.as_ref();
    let with = given.and_then(|plan| match changes {
        Some(changes) => changing(&draft, plan, changes),
        None => evidence(&draft, plan, None),
    });
    Ok(with.unwrap_or_else(|| Document::new(draft)))
}

/// A document that shows a plan, legal or not, through the changes that happen while it
/// runs. `None` where the scene is not valid, or the changes do not fit the plan.
pub(crate) fn evidence(
    draft: &Rc<Draft>,
    plan: &Plan,
    changes: Option<&Changes>,
) -> Option<Document> {
    if let Some(changes) = changes.filter(|changes| !changes.changes.is_empty()) {
        let answer = over_time(draft, plan, changes.clone())?;
        return Some(Document::answered(Rc::clone(draft), Some(answer)));
    }
    let dropped = Dropped::own(draft, plan)?;
    let mut document = if dropped.is_legal() {
        Document::answered(Rc::clone(draft), Some(dropped.answer))
    } else {
        Document::audited(Audit::new(
            vec![Rc::new(dropped)],
            Vec::new(),
            Rc::default(),
        )?)
    };
    document.draft = Rc::clone(draft);
    Some(document)
}

/// A document in which the world changes while a plan runs: what the plan does not know
/// yet is listed, as far as it happens at one time. A plan that breaks a rule before that
/// is shown as it is.
fn changing(draft: &Rc<Draft>, plan: &Plan, changes: &Changes) -> Option<Document> {
    let mut known = changes.clone();
    known
        .changes
        .retain(|change| plan.knows.is_some_and(|knows| change.at <= knows));
    let new = changes.changes.get(known.changes.len()..)?;
    let document = evidence(draft, plan, Some(&known))?;
    let next = new.iter().map(|change| change.at).min();
    let (Some(answer), Some(at)) = (document.answer.as_ref(), next) else {
        return Some(document);
    };
    let list = new.iter().filter(|change| change.at == at);
    let list = list.map(|change| change.what.clone()).collect();
    let changing = Changing::begin(answer, at)?.with(list).ok()?;
    Some(Document {
        mode: Activity::Changing(Rc::new(changing)).into(),
        ..document
    })
}

/// A plan that goes on across changes, as the page shows plans; `None` where the changes
/// do not fit it, or where it breaks a rule.
fn over_time(draft: &Rc<Draft>, plan: &Plan, changes: Changes) -> Option<Rc<Answer>> {
    let report = check_changes(draft.instance().ok()?, &changes, plan).ok()?;
    if !report.is_valid() {
        return None;
    }
    let solved = SolveAnswer {
        costs: report.costs,
        plan: Some(plan.clone()),
        ..unproved()
    };
    let request = SolveRequest {
        scene: draft.scene().clone(),
        ..SolveRequest::default()
    };
    let (draft, request) = (Rc::clone(draft), Rc::new(request));
    let answer = Answer::over_time(draft, request, solved, changes, Vec::new()).ok()?;
    Some(Rc::new(Answer {
        is_shared: true,
        ..answer
    }))
}

/// Robots are led from time 0 on, the first of them first.
fn led(draft: &Rc<Draft>, plan: &Plan, names: &[String]) -> Option<Document> {
    let about = Dropped::own(draft, plan)?.answer;
    let index = |name: &String| draft.agents().iter().position(|agent| agent.name == *name);
    let led: Vec<usize> = names.iter().filter_map(index).collect();
    let first = *led.first()?;
    let mut own = Steering::begin(&about, first, 0)?;
    for &agent in led.get(1..).unwrap_or_default() {
        own = own.lead(agent, 0)?;
    }
    if led.len() > 1 {
        own = own.lead(first, 0)?;
    }
    let mut document = Document::new(Rc::clone(draft));
    document.mode = Activity::Steering(Rc::new(own)).into();
    Some(document)
}

/// A plan in which nobody moves.
fn standing(scene: &Scene) -> Plan {
    let agents = scene.agents.iter();
    Plan {
        giveway: Version,
        paths: agents
            .map(|agent| (agent.name.clone(), vec![Some(agent.start)]))
            .collect(),
        charges: BTreeMap::new(),
        ..Plan::default()
    }
}
