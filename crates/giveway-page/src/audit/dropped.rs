//! A plan of a file on the scene that it is for, with what the judge says of it.

use std::collections::BTreeMap;
use std::rc::Rc;

use giveway_formats::ForeignPlan;
use giveway_model::check::{Rule, Violation, check};
use giveway_model::{Instance, Plan, Version};
use giveway_solve::{Reach, SolveAnswer, SolveRequest, Stats, Status};

use super::seen::bursts;
use crate::{Answer, Draft};

/// A plan of elsewhere, judged.
#[derive(Clone, Debug, PartialEq)]
pub struct Dropped {
    /// What its file tells, and how it was read.
    pub file: ForeignPlan,
    /// The plan as the page shows plans; it may break any rule.
    pub answer: Rc<Answer>,
    /// Every rule that it breaks, by time.
    pub violations: Vec<Violation>,
    /// The times at which something goes wrong with each agent, by its name.
    pub(super) bursts: BTreeMap<String, Vec<f64>>,
}

impl Dropped {
    /// Judges a plan; `None` where the draft is no valid scene.
    pub(crate) fn new(draft: &Rc<Draft>, file: ForeignPlan) -> Option<Self> {
        let instance = draft.instance().ok()?;
        let violations = check(instance, &file.plan).violations;
        let plan = shown(instance, &file.plan);
        let solved = SolveAnswer {
            costs: check(instance, &plan).costs,
            plan: Some(plan),
            ..unproved()
        };
        let request = SolveRequest {
            scene: draft.scene().clone(),
            ..SolveRequest::default()
        };
        let mut answer = Answer::new(Rc::clone(draft), Rc::new(request), solved);
        answer.is_shared = true;
        Some(Self {
            file,
            answer: Rc::new(answer),
            bursts: bursts(&violations),
            violations,
        })
    }

    /// Whether it breaks no rule.
    pub const fn is_legal(&self) -> bool {
        self.violations.is_empty()
    }

    /// The broken rules of a time, or of the step that begins then.
    pub(crate) fn now(&self, time: u32) -> impl Iterator<Item = &Violation> {
        let near = self.violations.get(self.since(time)..);
        let near = near.unwrap_or_default().iter();
        near.take_while(move |violation| violation.time == time)
    }

    /// The broken rules of about that time, so many before and after it.
    pub(crate) fn around(&self, time: u32, count: usize) -> &[Violation] {
        let at = self.since(time);
        let (from, to) = (at.saturating_sub(count), at.saturating_add(count));
        let to = to.min(self.violations.len());
        self.violations.get(from..to).unwrap_or_default()
    }

    /// The place of the first broken rule from a time on.
    fn since(&self, time: u32) -> usize {
        self.violations
            .partition_point(|violation| violation.time < time)
    }

    /// How many robots start elsewhere in it than in the scene.
    pub(crate) fn strangers(&self) -> impl Iterator<Item = &str> {
        let starts = self.violations.iter();
        let starts = starts.filter(|violation| violation.rule == Rule::Start);
        starts
            .flat_map(|violation| &violation.agents)
            .map(String::as_str)
    }
}

/// An answer in which nothing is proved of a plan.
pub(crate) fn unproved() -> SolveAnswer {
    SolveAnswer {
        giveway: Version,
        status: Status::Feasible,
        costs: None,
        bounds: BTreeMap::new(),
        reach: Reach::default(),
        ended: None,
        reason: None,
        plan: None,
        stats: Stats::default(),
        trace: None,
    }
}

/// The plan as it can be drawn: who has no path stays at the start.
fn shown(instance: &Instance, plan: &Plan) -> Plan {
    let mut shown = Plan {
        paths: plan.paths.clone(),
        charges: plan.charges.clone(),
        ..Plan::default()
    };
    for agent in instance.agents() {
        let path = shown.paths.entry(agent.name.clone()).or_default();
        if path.iter().all(Option::is_none) {
            *path = vec![Some(agent.start)];
        }
    }
    shown.cut_trailing_goals(instance);
    shown
}
