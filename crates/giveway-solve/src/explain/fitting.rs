//! A question that fits the plan, and what is to be known of both.

use std::collections::BTreeMap;

use giveway_model::{
    Condition, Cost, Costs, Instance, Objective, Plan, Question,
    check::{cost_of, costs},
    sorting::map,
};

use super::{ask::Ask, verdict::StillOpen, whole::WholePlan};
use crate::{
    impose::{Unmeetable, ways},
    problem::Relaxed,
    search::{LatestArrivals, Proved},
};

/// A question that fits a valid plan, and what is to be known of both.
pub(crate) struct FittingQuestion<'a> {
    /// The instance, with the objective in which costs compare.
    pub(crate) instance: &'a Instance,
    pub(crate) question: &'a Question,
    /// The plan that is asked about.
    pub(crate) plan: &'a Plan,
    /// Its costs.
    pub(crate) costs: Costs,
    /// How far it is proved that no plan is better, where it is.
    pub(crate) optimal: Option<Proved>,
    /// The latest arrivals in plans that are as good, where the proof leaves such.
    pub(crate) latest: Option<LatestArrivals>,
    /// An other plan that is as asked for and was found before, with its costs.
    pub(crate) known: Option<(Plan, Costs)>,
    /// How far the verdict is proved, once it is.
    pub(crate) shown: Option<Proved>,
    /// Where the verdict stands, but not yet how much the best other plan costs.
    pub(crate) open: Option<StillOpen>,
    /// The alternatives of the contrast, one of which must hold in the other plan; an error where no agent
    /// could do it.
    pub(crate) conditions: Result<Vec<Condition>, Unmeetable>,
    /// The horizon, where a person set one.
    pub(crate) within: Option<u32>,
    /// The plan of which the instance is the rest.
    pub(crate) whole: WholePlan<'a>,
}

impl<'a> FittingQuestion<'a> {
    pub(crate) fn new(
        instance: &'a Instance,
        question: &'a Question,
        plan: &'a Plan,
        costs: Costs,
        within: Option<u32>,
        whole: WholePlan<'a>,
    ) -> Self {
        let before = |agent: Option<&str>, cost| cost_of(instance, plan, agent, cost);
        let condition = question.condition(before);
        Self {
            instance,
            question,
            plan,
            costs,
            optimal: None,
            latest: None,
            known: None,
            shown: None,
            open: None,
            conditions: condition.map_or(Ok(Vec::new()), |it| ways(it, instance)),
            whole,
            // The horizon always includes the plan at hand.
            within: within.map(|within| within.max(costs.makespan)),
        }
    }

    pub(crate) fn objective(&self) -> &Objective {
        self.instance.objective()
    }

    /// The alternatives of the contrast, one of which must hold in the other plan.
    pub(crate) fn conditions(&self) -> impl Iterator<Item = &Condition> {
        self.conditions.iter().flatten()
    }

    /// The agent, by its index, that is to charge in the other plan and has a battery.
    pub(crate) fn charging(&self) -> Option<usize> {
        let mut agents = self.conditions().filter_map(|condition| match condition {
            Condition::Charge { agent, .. } => Some(agent),
            Condition::Never { .. }
            | Condition::Visit { .. }
            | Condition::Move { .. }
            | Condition::Before { .. }
            | Condition::Below { .. }
            | Condition::Keeps(_) => None,
        });
        let agent = agents.next()?;
        let mut all = self.instance.agents().iter();
        all.position(|it| it.name == *agent && it.battery.is_some())
    }

    /// The costs of another plan, where the judge passes it and it is as asked for.
    pub(crate) fn accepts(&self, plan: &Plan) -> Option<Costs> {
        let costs = costs(self.instance, plan)?;
        let in_time = self.within.is_none_or(|within| costs.makespan <= within);
        let mut conditions = self.conditions();
        let is_other = in_time
            && conditions.any(|condition| condition.holds(self.instance, plan) == Some(true))
            && self.whole.check(self.instance, plan).is_empty();
        is_other.then_some(costs)
    }

    /// Takes in a plan that was found before, where it is as asked for.
    pub(crate) fn hand_on(&mut self, plan: &Plan) {
        self.known = self.accepts(plan).map(|costs| (plan.clone(), costs));
    }

    /// The cheaper one of a plan and the one that was found before.
    pub(crate) fn cheapest_known(&self, other: Option<(Plan, Costs)>) -> Option<(Plan, Costs)> {
        let vector = |(_, costs): &(Plan, Costs)| costs.vector(self.objective());
        other
            .into_iter()
            .chain(self.known.clone())
            .min_by_key(vector)
    }

    /// The difference of a plan with these costs, for each cost of the objective.
    pub(crate) fn deltas(&self, costs: &Costs) -> BTreeMap<Cost, i64> {
        let more = |cost: Cost| i64::from(costs.get(cost)) - i64::from(self.costs.get(cost));
        let objective = self.objective().costs().iter();
        map(objective.map(|&cost| (cost, more(cost))))
    }

    /// Calls the search for the best in an objective with each of the conditions in turn.
    pub(super) fn each(&self, objective: &Objective, mut with: impl FnMut(&Ask)) {
        for condition in self.conditions() {
            with(&Ask {
                instance: self.instance,
                relaxed: &Relaxed::default(),
                conditions: std::slice::from_ref(condition),
                objective,
                caps: &BTreeMap::new(),
                within: self.within,
                at_least_within: self.costs.makespan,
            });
        }
    }
}
