//! The best plan so far.

use std::collections::BTreeMap;

use giveway_model::{Cost, Costs, Objective};

use crate::{
    first::First,
    local::{OtherAgents, Reservations},
    problem::Problem,
    trace::FoundBy,
    walk::{Walk, arrival, costs},
};

/// Is told of each better plan, and who found it.
pub(crate) type OnBetter<'a> = dyn Fn(&[Walk], FoundBy) + 'a;

/// The best plan so far of those that keep within the limits.
pub(crate) struct Incumbent<'a> {
    objective: Objective,
    horizon: u32,
    limits: BTreeMap<Cost, u32>,
    best: Option<(Vec<Walk>, Costs)>,
    on_better: &'a OnBetter<'a>,
}

impl<'a> Incumbent<'a> {
    pub(crate) fn new(
        objective: Objective,
        horizon: u32,
        limits: BTreeMap<Cost, u32>,
        on_better: &'a OnBetter<'a>,
    ) -> Self {
        Self {
            objective,
            horizon,
            limits,
            best: None,
            on_better,
        }
    }

    /// Keeps a plan if it is better than the best; true if it was. Walks of which one is empty
    /// are none.
    pub(crate) fn offer(&mut self, problem: &Problem, walks: &[Walk], by: FoundBy) -> bool {
        if walks.iter().any(Vec::is_empty) {
            return false;
        }
        let costs = costs(problem, walks);
        let kept = self
            .limits
            .iter()
            .all(|(&cost, &most)| costs.get(cost) <= most);
        let better = self
            .best
            .as_ref()
            .is_none_or(|(_, best)| costs.vector(&self.objective) < best.vector(&self.objective));
        let within = walks.iter().all(|walk| arrival(walk) <= self.horizon);
        if !(kept && better && within && problem.keeps(walks)) {
            return false;
        }
        self.best = Some((walks.to_vec(), costs));
        (self.on_better)(walks, by);
        true
    }

    /// The costs of the best plan.
    pub(crate) fn costs(&self) -> Option<Costs> {
        self.best.as_ref().map(|(_, costs)| *costs)
    }

    /// The walks of the best plan.
    pub(crate) fn walks(&self) -> Option<&[Walk]> {
        self.best.as_ref().map(|(walks, _)| walks.as_slice())
    }

    /// The best plan, given away.
    pub(crate) fn into_best(self) -> Option<(Vec<Walk>, Costs)> {
        self.best
    }

    pub(crate) fn objective(&self) -> &Objective {
        &self.objective
    }
}

impl From<First> for FoundBy {
    fn from(first: First) -> Self {
        match first {
            First::Prioritised => Self::Prioritised,
            First::Lacam => Self::Lacam,
            First::Repair => Self::Repair,
        }
    }
}

/// Whether no two walks collide.
pub(crate) fn free_of_collisions(problem: &Problem, walks: &[Walk]) -> bool {
    let all = Reservations::of(problem, walks);
    let mut agents = walks.iter().enumerate();
    agents.all(|(agent, walk)| all.met_by(agent, walk).is_empty())
}
