//! What is known of the order of a plan, and what is asked.

use std::rc::Rc;

use giveway_model::Plan;
use giveway_model::change::{Changes, History, What};
use giveway_model::check::costs_over_time;
use giveway_order::{Lateness, Outcome};
use giveway_solve::order::{OrderAnswer, OrderFormat, OrderRequest};
use giveway_solve::{SolveAnswer, Status};

use crate::audit::unproved;
use crate::{Answer, Document};

/// The order of a plan, as far as it is known.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct OrderKnown {
    /// The plan that it is about.
    pub(crate) about: Rc<Answer>,
    /// What the solver was asked last.
    pub(crate) request: Rc<OrderRequest>,
    /// The order.
    pub(crate) told: Option<Rc<OrderAnswer>>,
    /// What follows from the lateness that was asked about last.
    pub(crate) late: Option<Rc<LateOutcome>>,
}

/// What follows from a lateness, with the plan as the page shows plans.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct LateOutcome {
    pub(crate) outcome: Outcome,
    /// `None` where changes of the world contradict that plan.
    pub(crate) answer: Option<Rc<Answer>>,
}

impl OrderKnown {
    /// A request about a plan; `None` without one.
    pub(crate) fn about(answer: &Rc<Answer>) -> Option<Self> {
        let request = OrderRequest {
            scene: answer.draft.scene().clone(),
            plan: Some(answer.plan()?.clone()),
            changes: answer.course.as_ref().map(|course| course.changes.clone()),
            ..OrderRequest::default()
        };
        Some(Self {
            about: Rc::clone(answer),
            request: Rc::new(request),
            told: None,
            late: None,
        })
    }

    /// The same, asked about a lateness, and for files in some formats.
    pub(crate) fn asked(&self, late: Vec<Lateness>, to: Vec<OrderFormat>) -> Self {
        let request = OrderRequest {
            late,
            to,
            ..(*self.request).clone()
        };
        Self {
            request: Rc::new(request),
            ..self.clone()
        }
    }

    /// Takes in what became known.
    pub(crate) fn learn(&mut self, mut told: OrderAnswer) {
        told.files.clear();
        if let Some(outcome) = told.late.take() {
            let answer = carried_out(&self.about, &outcome.plan).map(Rc::new);
            self.late = Some(Rc::new(LateOutcome { outcome, answer }));
        }
        // The order is the same, however late a robot is.
        if self.told.is_none() {
            self.told = Some(Rc::new(told));
        }
    }
}

/// The late plan as the page shows plans.
fn carried_out(about: &Answer, plan: &Plan) -> Option<Answer> {
    let instance = about.draft.instance().ok()?;
    let changes = about.course.as_ref().map(|course| &course.changes);
    let changes = changes.map_or_else(Changes::default, |changes| put_off(changes, plan));
    let history = History::of(instance, &changes, plan).ok()?;
    let solved = SolveAnswer {
        status: Status::Feasible,
        costs: costs_over_time(&history, plan),
        plan: Some(plan.clone()),
        ..unproved()
    };
    let (draft, request) = (Rc::clone(&about.draft), Rc::clone(&about.request));
    match &about.course {
        None => Some(Answer::new(draft, request, solved)),
        Some(course) => {
            Answer::over_time(draft, request, solved, changes, course.steps.clone()).ok()
        }
    }
}

/// The changes, where a robot joins as late as the late plan has it.
fn put_off(changes: &Changes, plan: &Plan) -> Changes {
    let mut changes = changes.clone();
    for change in &mut changes.changes {
        if let What::AddAgent { agent } = &change.what
            && let Some(&from) = plan.from.get(&agent.name)
        {
            change.at = from;
        }
    }
    changes
}

impl Document {
    /// The order, where it is of the plan that there is.
    pub(crate) fn order(&self) -> Option<&Rc<OrderKnown>> {
        let found = self.found_order.as_ref()?;
        Rc::ptr_eq(&found.about, self.fresh_answer()?).then_some(found)
    }
}
