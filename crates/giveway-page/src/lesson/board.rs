//! The document of a lesson's board.

use std::collections::BTreeMap;
use std::rc::Rc;

use giveway_course::port::{Board, BoardPlan, Hand};
use giveway_model::{Fault, Plan, Scene, Version};

use crate::audit::{Audit, Dropped};
use crate::steering::Steering;
use crate::{Document, Draft, Mode};

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
    let with = given.and_then(|plan| evidence(&draft, plan));
    Ok(with.unwrap_or_else(|| Document::new(draft)))
}

/// A document that shows a plan, legal or not; `None` where the scene is not valid.
pub(crate) fn evidence(draft: &Rc<Draft>, plan: &Plan) -> Option<Document> {
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
    document.mode = Mode::Steering(Rc::new(own));
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
