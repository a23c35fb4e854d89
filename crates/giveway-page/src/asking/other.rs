//! The other plan of a question: the best that is known, or a variation that a person chose.

use std::collections::BTreeMap;
use std::rc::Rc;

use giveway_model::{Cost, Costs, Plan};
use giveway_solve::explain::{AgentDifference, ExplainAnswer, Variation};
use giveway_solve::{Reach, Reason, SolveAnswer, Stats, Status};

use super::Asking;
use crate::Answer;

impl Asking {
    /// Whether the other plan costs less than the one asked about.
    pub(crate) fn is_bettered(&self) -> bool {
        let other = self.other.as_deref();
        other.is_some_and(|other| self.costs_less(other, &self.about))
    }

    /// Whether a plan costs less than another one, or has costs where that one has none.
    pub(super) fn costs_less(&self, one: &Answer, other: &Answer) -> bool {
        let value = |answer: &Answer| Some(answer.solved.costs?.vector(self.objective()));
        value(one).is_some_and(|one| value(other).is_none_or(|other| one < other))
    }

    /// The variation that is looked at.
    pub(crate) fn variation(&self) -> Option<&Variation> {
        let near = self.told.as_deref()?.near.as_ref()?;
        near.variations.get(self.chosen?)
    }

    /// The plan of a variation: robots that it does not move do as before.
    pub(crate) fn varied(&self, it: &Variation) -> Option<Plan> {
        let mut plan = self.about.plan()?.clone();
        for (name, path) in &it.plan.paths {
            plan.paths.insert(name.clone(), path.clone());
            plan.charges.remove(name);
        }
        for (name, charges) in &it.plan.charges {
            plan.charges.insert(name.clone(), charges.clone());
        }
        Some(plan)
    }

    /// The robots that the other plan moves differently.
    pub(crate) fn pays(&self) -> &[AgentDifference] {
        match (self.variation(), self.told.as_deref()) {
            (Some(it), _) => &it.pays,
            (None, Some(told)) => &told.pays,
            (None, None) => &[],
        }
    }

    /// Looks at a variation as the other plan, or at the best that is known.
    pub(crate) fn choose(&mut self, variation: Option<usize>) {
        let Some(told) = self.told.clone() else {
            return;
        };
        self.chosen = variation;
        let varied = self.variation();
        let varied = varied.and_then(|it| self.answer_of(self.varied(it)?, it.costs));
        if varied.is_none() {
            self.chosen = None;
        }
        self.other = varied.or_else(|| self.best_other(&told));
        self.shows_other &= self.other.is_some();
    }

    /// The best other plan that is known.
    pub(super) fn best_other(&self, told: &ExplainAnswer) -> Option<Rc<Answer>> {
        self.answer_of(told.alternative.clone()?, told.costs?)
    }

    /// Another plan, with what is known of it: it is as good as proved where it costs what a proved
    /// plan costs, or as little as is proved of all plans.
    fn answer_of(&self, plan: Plan, costs: Costs) -> Option<Rc<Answer>> {
        let solved = &self.about.solved;
        let objective = self.objective().costs();
        let before = solved.costs?;
        let is_equal = objective
            .iter()
            .all(|&cost| before.get(cost) == costs.get(cost));
        let is_least = |cost: &Cost| solved.bounds.get(cost) == Some(&costs.get(*cost));
        let is_least = objective.iter().all(is_least);
        let status = match solved.status {
            Status::Optimal if is_equal => Status::Optimal,
            _ if is_least => Status::Optimal,
            _ => Status::Feasible,
        };
        // A plan that is no worse is the best so far of a search that was stopped.
        let by_costs = |costs: &Costs| objective.iter().map(|&cost| costs.get(cost)).collect();
        let (mine, other): (Vec<u32>, Vec<u32>) = (by_costs(&before), by_costs(&costs));
        // A claim that this plan refutes is none: it came with a link or a file.
        let is_refuted = solved.status == Status::Optimal && other < mine;
        let ended = solved
            .ended
            .filter(|_| status == Status::Feasible && other <= mine);
        let answer = SolveAnswer {
            status,
            costs: Some(costs),
            plan: Some(plan),
            ended,
            // It was asked for, not searched for: where the best plan is known, this is not it.
            reason: (solved.status == Status::Optimal && other > mine)
                .then_some(Reason::Beaten)
                .filter(|_| status == Status::Feasible),
            stats: Stats::default(),
            ..solved.clone()
        };
        let answer = if is_refuted {
            SolveAnswer {
                status: Status::Feasible,
                bounds: BTreeMap::new(),
                reach: Reach::default(),
                trace: None,
                ..answer
            }
        } else {
            answer
        };
        let (draft, request) = (Rc::clone(&self.about.draft), Rc::clone(&self.about.request));
        let is_searched = solved.trace.is_some() && self.about.is_searched();
        let proved_by_bounds = (is_searched && is_least).then_some(answer.reach);
        let answer = match self.about.course.as_deref() {
            None => Answer {
                proved_by_bounds,
                ..Answer::new(draft, request, answer)
            },
            Some(course) => {
                let (changes, steps) = (course.changes.clone(), course.steps.clone());
                Answer::over_time(draft, request, answer, changes, steps).ok()?
            }
        };
        Some(Rc::new(answer))
    }
}
