//! An answer of the solver, with the draft that it answers.

use std::rc::Rc;

use giveway_model::{Agent, Plan, check};
use giveway_solve::{SolveAnswer, SolveRequest};

use crate::Draft;

/// An answer, and what the page derives from it once.
#[derive(Clone, Debug, PartialEq)]
pub struct Answer {
    /// The draft that was solved.
    pub draft: Rc<Draft>,
    /// The request.
    pub request: Rc<SolveRequest>,
    /// What the solver said.
    pub solved: SolveAnswer,
    /// The battery level of each agent at each time up to its arrival; empty
    /// for agents without a battery, and without a plan.
    pub levels: Vec<Vec<i64>>,
    /// When each agent arrives; `None` without a plan.
    pub arrivals: Vec<Option<u32>>,
}

impl Answer {
    /// Takes an answer in.
    pub(crate) fn new(draft: Rc<Draft>, request: Rc<SolveRequest>, solved: SolveAnswer) -> Self {
        let count = draft.agents().len();
        let (mut levels, mut arrivals) = (vec![Vec::new(); count], vec![None; count]);
        if let (Ok(instance), Some(plan)) = (draft.instance(), &solved.plan) {
            arrivals = check::arrivals(instance, plan);
            for (agent, levels) in levels.iter_mut().enumerate() {
                if instance.agents()[agent].battery.is_some() {
                    *levels = check::levels(instance, agent, plan);
                }
            }
        }
        Self {
            draft,
            request,
            solved,
            levels,
            arrivals,
        }
    }

    /// The plan, where there is one.
    pub const fn plan(&self) -> Option<&Plan> {
        self.solved.plan.as_ref()
    }

    /// The index, in the draft that was solved, of an agent of another draft:
    /// of the same name and from the same start. Else the plan is not of it.
    pub fn agent(&self, draft: &Draft, agent: usize) -> Option<usize> {
        let who = draft.agents().get(agent)?;
        let is = |other: &Agent| other.name == who.name && other.start == who.start;
        let mine = self.draft.agents();
        // Nearly always it has kept its place.
        match mine.get(agent) {
            Some(other) if is(other) => Some(agent),
            _ => mine.iter().position(is),
        }
    }

    /// The last time of the plan, in steps; 0 without one.
    pub fn makespan(&self) -> u32 {
        self.solved.costs.map_or(0, |costs| costs.makespan)
    }
}
