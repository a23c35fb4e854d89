//! Edits tried, each in the whole instance.

use giveway_model::{
    Costs, Instance, Plan, check::own_costs, constraint::ConstraintKind, sorting::sort_by_key,
};

use super::{
    super::{
        answer::{Edit, Repair},
        edits::edited,
        group::{Group, Variant},
        group_mus::Tried,
        words,
    },
    EditedPlan, Solver, TriedEdits, Unsolved,
    candidate::{Candidate, candidates},
    order::rank,
    unproved,
};

pub(super) struct RepairSearch<'a> {
    pub(super) broken: &'a Unsolved<'a>,
    pub(super) solver: &'a mut dyn Solver,
    /// Whether all that was to be tried was tried to its end.
    pub(super) exhaustive: bool,
    pub(super) tried: TriedEdits,
    effort: Effort,
}

/// How long a plan of an edited instance is looked for.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Effort {
    /// Edits are guessed: briefly.
    Brief,
    /// As long as for any of many questions.
    Usual,
    /// With all of the budget where that does not tell.
    Long,
}

impl<'a> RepairSearch<'a> {
    pub(super) fn new(
        broken: &'a Unsolved<'a>,
        tried: TriedEdits,
        solver: &'a mut dyn Solver,
    ) -> Self {
        Self {
            broken,
            solver,
            exhaustive: true,
            tried,
            effort: Effort::Brief,
        }
    }

    pub(super) fn candidates(&mut self, instance: &Instance, facts: &[Group]) -> Vec<Candidate> {
        let (candidates, are_all) = candidates(instance, facts, self.broken.asked);
        self.exhaustive &= are_all;
        candidates
    }

    /// Tries single edits, where they were not tried before.
    pub(super) fn try_each(&mut self, effort: Effort, candidates: &[Candidate]) {
        self.effort = effort;
        for candidate in candidates {
            self.try_alone(candidate);
        }
        self.leave_out_who_helps();
    }

    /// Whether a single edit helps; where it does, it is kept.
    pub(super) fn try_alone(&mut self, candidate: &Candidate) -> Option<bool> {
        if let Some(&outcome) = self.tried.outcomes.get(candidate) {
            return outcome;
        }
        let outcome = self.attempt(&[candidate]);
        self.tried.outcomes.insert(candidate.clone(), outcome);
        outcome
    }

    /// Tries edits together, each as far-reaching as it can be; keeps the least that
    /// help. `None` where it is not known whether they help.
    pub(super) fn attempt(&mut self, candidates: &[&Candidate]) -> Option<bool> {
        let instance = self.broken.instance;
        let strongest = |candidate: &&Candidate| candidate.strongest(instance);
        let mut edits: Vec<Option<Edit>> = candidates.iter().map(strongest).collect();
        let has_deadline = candidates.iter().any(|c| matches!(c, Candidate::Deadline));
        let within = self.broken.within.filter(|_| !has_deadline);
        let outcome = self.helps(&flat(&edits), within);
        if outcome != Some(true) {
            return outcome;
        }
        let mut is_least = true;
        for (index, candidate) in candidates.iter().enumerate() {
            is_least &= self.lessen(candidate, index, &mut edits, within);
        }
        let mut edits = flat(&edits);
        if edits.iter().any(|edit| is_as_good_as_off(edit, instance)) {
            return outcome; // its rule is also switched off
        }
        let whole = self.broken.whole;
        let Some(mut best) = self.best(&edited(instance, &edits, within, whole)) else {
            self.exhaustive = false;
            return outcome;
        };
        if has_deadline && let Some(within) = self.broken.within {
            let (least, shown) = self.least_deadline(&edits, within, best.costs.makespan);
            is_least &= shown;
            edits.push(Edit::Deadline { within: least });
            let sooner = edited(instance, &edits, Some(within), whole);
            let Some(sooner) = self.solver.best(&sooner) else {
                self.exhaustive = false;
                return outcome;
            };
            // The least deadline is told; with a later one it may cost less.
            let [now, later] = [&sooner, &best].map(|best| self.vector(&best.costs));
            self.exhaustive &= now <= later;
            best = sooner;
        }
        self.exhaustive &= best.proved && is_least;
        sort_by_key(&mut edits, rank);
        let repair = self.repair(edits, is_least, best);
        self.tried.found.push(repair);
        outcome
    }

    pub(super) fn repair(&self, edits: Vec<Edit>, is_least: bool, best: EditedPlan) -> Repair {
        let arriving = self.broken.arriving;
        let arrival = arriving.and_then(|name| own_costs(self.broken.instance, name, &best.plan));
        let mut repair = Repair {
            edits,
            least: is_least,
            costs: best.costs,
            arrival: arrival.map(|costs| self.broken.whole.time(costs.makespan)),
            proved: best.proved,
            plan: best.plan,
            text: String::new(),
        };
        repair.text = words::repair(&repair, arriving);
        repair
    }

    pub(super) fn vector(&self, costs: &Costs) -> Vec<u32> {
        costs.vector(self.broken.objective)
    }

    /// The best plan; of a large floor without a known set any plan that costs little enough,
    /// where the best is not found in time. Where it is not proved, what is left of the plan that
    /// is asked about may be better.
    fn best(&mut self, variant: &Variant) -> Option<EditedPlan> {
        let mut best = self.solver.best(variant);
        if best.is_none()
            && self.effort != Effort::Long
            && let Tried::Plan(plan) = self.solver.search_briefly(variant)
        {
            best = unproved(variant, plan);
        }
        let is_proved = best.as_ref().is_some_and(|best| best.proved);
        let rest = self.rest(variant).filter(|_| !is_proved);
        best.into_iter()
            .chain(rest)
            .min_by_key(|it| self.vector(&it.costs))
    }

    /// The plan that is asked about without the agents that are left out, where it is as asked for.
    fn rest(&self, variant: &Variant) -> Option<EditedPlan> {
        self.rest_of(self.broken.plan?, variant)
    }

    /// A plan without the agents that are left out, where it is as asked for.
    pub(super) fn rest_of(&self, plan: &Plan, variant: &Variant) -> Option<EditedPlan> {
        let mut plan = plan.clone();
        let agents = variant.instance.agents();
        let is_there = |name: &String| agents.iter().any(|agent| agent.name == *name);
        plan.paths.retain(|name, _| is_there(name));
        plan.charges.retain(|name, _| is_there(name));
        let is_as_asked = self.solver.accepts(variant, &plan);
        unproved(variant, plan).filter(|_| is_as_asked)
    }

    /// Whether there is a plan after some edits; `None` where that is not known.
    pub(super) fn helps(&mut self, edits: &[Edit], within: Option<u32>) -> Option<bool> {
        if self.solver.is_over() {
            self.exhaustive = false;
            return None;
        }
        let variant = edited(self.broken.instance, edits, within, self.broken.whole);
        // With few agents a search decides as soon, and there are many pairs to try.
        let plan = self.broken.plan.filter(|_| self.broken.is_large);
        let near = plan.and_then(|plan| self.solver.near_to(plan, &variant));
        let tried = near.map_or_else(|| self.search(&variant), Tried::Plan);
        match tried.reaching(&variant, self.broken.reach) {
            Tried::Plan(_) => Some(true),
            Tried::None { .. } => Some(false),
            Tried::Unknown => {
                self.exhaustive = false;
                None
            }
        }
    }

    fn search(&mut self, variant: &Variant) -> Tried {
        if self.effort == Effort::Brief {
            return self.solver.search_briefly(variant);
        }
        let tried = self.solver.search(variant);
        let is_unknown = matches!(tried, Tried::Unknown) && !self.solver.is_over();
        if is_unknown && self.effort == Effort::Long {
            return self.solver.search_longer(variant);
        }
        tried
    }
}

/// Whether a limit is raised to the number of agents that it counts.
fn is_as_good_as_off(edit: &Edit, instance: &Instance) -> bool {
    let Edit::AllowMore { index, most, .. } = edit else {
        return false;
    };
    let mut rules = instance.constraints_in_force();
    let rule = rules.find(|rule| rule.index == *index as usize);
    rule.is_some_and(|rule| {
        let is_capacity = matches!(rule.constraint.kind, ConstraintKind::Capacity { .. });
        is_capacity && *most as usize >= rule.agents.len()
    })
}

/// The edits that are there: a deadline that is given up is none.
pub(super) fn flat(edits: &[Option<Edit>]) -> Vec<Edit> {
    edits.iter().flatten().cloned().collect()
}
