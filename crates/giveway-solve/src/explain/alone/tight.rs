//! The sets of agents whose own needs explain a cost: for the makespan a smallest set that needs
//! as much, and what is left of it with fewer agents; for sums sets that share no agent.

mod meetings;

use std::cmp::Reverse;
use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;

use giveway_model::{
    Cost, Plan, Question,
    check::own_costs,
    sorting::{set, sort_by_key},
};

use super::{SubsetBound, needs::Needs};
use crate::{
    budget::Budget,
    explain::{ExplainAnswer, Verdict, causes::Refuted, fitting::FittingQuestion},
};

/// Sets that are told.
const MOST_TOLD: usize = 7;
/// Agents of a set.
const MOST_AGENTS: usize = 5;

/// What sets of agents alone need, where the answer is about a cost of all; `forcing` are agents
/// that alone force it.
pub(crate) fn subset_bounds(
    case: &FittingQuestion,
    refuted: Refuted,
    answer: &ExplainAnswer,
    forcing: Option<&BTreeSet<usize>>,
    budget: &Rc<Budget>,
) -> Vec<SubsetBound> {
    let Some(mut tightness) = Tightness::new(case, refuted, answer, budget) else {
        return Vec::new();
    };
    let sets = match (tightness.needs.cost(), forcing) {
        (Cost::Makespan, Some(agents)) => tightness.downwards(agents),
        (Cost::Makespan, None) => tightness.largest(),
        (Cost::SumOfCosts | Cost::Charges | Cost::Moves | Cost::Waits | Cost::Penalty, _) => {
            tightness.disjoint()
        }
    };
    sets.iter().filter_map(|it| tightness.bound(it)).collect()
}

/// The same of agents alone of which the answer says what they need.
pub(crate) fn forcing_bound(
    case: &FittingQuestion,
    refuted: Refuted,
    answer: &ExplainAnswer,
    forcing: &BTreeSet<usize>,
    budget: &Rc<Budget>,
) -> Option<SubsetBound> {
    let mut tightness = Tightness::new(case, refuted, answer, budget)?;
    tightness.know(forcing);
    tightness.bound(forcing)
}

/// The cost that decides: that of the question, or the first that grows.
fn deciding_cost(case: &FittingQuestion, answer: &ExplainAnswer) -> Option<Cost> {
    match case.question {
        Question::Makespan => Some(Cost::Makespan),
        Question::SumOfCosts => Some(Cost::SumOfCosts),
        Question::Charges { agent: None } => Some(Cost::Charges),
        Question::Moves { agent: None } => Some(Cost::Moves),
        Question::Waits { agent: None } => Some(Cost::Waits),
        _ if answer.verdict == Verdict::Costly => {
            let costs = case.objective().costs().iter().copied();
            let more = |cost: &Cost| answer.deltas.get(cost).is_some_and(|&more| more > 0);
            costs.into_iter().find(more)
        }
        _ => None,
    }
}

struct Tightness<'a, 'h> {
    case: &'a FittingQuestion<'a>,
    needs: Needs<'a, 'h>,
    /// The plan that is told beside.
    here: &'a Plan,
    budget: &'a Rc<Budget<'h>>,
}

impl<'a, 'h> Tightness<'a, 'h> {
    /// `None` where no cost of all decides.
    fn new(
        case: &'a FittingQuestion<'a>,
        refuted: Refuted<'a>,
        answer: &'a ExplainAnswer,
        budget: &'a Rc<Budget<'h>>,
    ) -> Option<Self> {
        let cost = deciding_cost(case, answer)?;
        let other = answer.alternative.as_ref();
        // What the agents need is about plans in which no cost that matters more grows.
        let before = case.objective().costs().iter();
        let mut before = before.take_while(|&&earlier| earlier != cost);
        let keeps = before.all(|cost| answer.deltas.get(cost).is_none_or(|&more| more <= 0));
        let here = other.filter(|_| answer.verdict == Verdict::Costly && keeps);
        Some(Self {
            case,
            needs: Needs::new(case, refuted, cost, budget)?,
            here: here.unwrap_or(case.plan),
            budget,
        })
    }

    /// Of agents that force the answer to a question about the makespan it is known what they need.
    fn know(&mut self, forcing: &BTreeSet<usize>) {
        if *self.case.question == Question::Makespan {
            // They cannot be done sooner, and are done by then in the plan.
            self.needs.know(forcing, self.case.costs.makespan);
        }
    }

    fn bound(&mut self, agents: &BTreeSet<usize>) -> Option<SubsetBound> {
        let instance = self.needs.instance();
        let (own, least) = (self.needs.own(agents)?, self.needs.least(agents)?);
        let names: Vec<String> = agents
            .iter()
            .filter_map(|&agent| Some(instance.agents().get(agent)?.name.clone()))
            .collect();
        let cost = self.needs.cost();
        let own_cost = |name: &String| own_costs(instance, name, self.here).map(|it| it.get(cost));
        let here = names.iter().filter_map(own_cost);
        let whole = self.case.whole;
        Some(match cost {
            Cost::Makespan => SubsetBound {
                own: whole.time(own),
                least: whole.time(least),
                here: whole.time(here.max().unwrap_or_default()),
                agents: names,
                cost,
            },
            Cost::SumOfCosts | Cost::Charges | Cost::Moves | Cost::Waits | Cost::Penalty => {
                // After a change with what they had paid before it.
                let before = whole.paid(&names, self.here).get(cost);
                SubsetBound {
                    own: own.saturating_add(before),
                    least: least.saturating_add(before),
                    here: here.fold(before, u32::saturating_add),
                    agents: names,
                    cost,
                }
            }
        })
    }

    /// A set, then with one agent less each time the set that needs most, down to the agent that
    /// needs most of all.
    fn downwards(&mut self, agents: &BTreeSet<usize>) -> Vec<BTreeSet<usize>> {
        self.know(agents);
        self.downwards_of(agents)
    }

    /// The same, where nothing is known of the set.
    fn downwards_of(&mut self, agents: &BTreeSet<usize>) -> Vec<BTreeSet<usize>> {
        let mut sets = vec![agents.clone()];
        let mut now = agents.clone();
        while now.len() > 2 {
            let smaller: Vec<BTreeSet<usize>> = now
                .iter()
                .map(|agent| now.iter().copied().filter(|it| it != agent).collect())
                .collect();
            let mut best: Option<(u32, BTreeSet<usize>)> = None;
            for set in smaller {
                if let Some(least) = self.needs.least(&set)
                    && best.as_ref().is_none_or(|(most, _)| least > *most)
                {
                    best = Some((least, set));
                }
            }
            let Some((_, set)) = best else { break };
            sets.push(set.clone());
            now = set;
        }
        let slowest = self.slowest().filter(|_| agents.len() > 1);
        sets.extend(slowest.map(|agent| BTreeSet::from([agent])));
        sets
    }

    /// The agent that needs most alone.
    fn slowest(&mut self) -> Option<usize> {
        let all = 0..self.needs.instance().agents().len();
        let least = |it: &usize| self.needs.least(&BTreeSet::from([*it])).unwrap_or(0);
        all.rev().max_by_key(least)
    }

    /// The agent that needs most alone, grown by those that make it need more.
    fn largest(&mut self) -> Vec<BTreeSet<usize>> {
        let first = self.slowest();
        let Some(first) = first else {
            return Vec::new();
        };
        let meetings = self.meetings();
        let grown = self.grown(BTreeSet::from([first]), &meetings, &BTreeSet::new());
        self.downwards_of(&grown)
    }

    /// Sets that share no agent, each grown along the meetings while it loses more; the set that
    /// loses most first.
    fn disjoint(&mut self) -> Vec<BTreeSet<usize>> {
        let meetings = self.meetings();
        let mut pairs: Vec<(u32, BTreeSet<usize>)> = Vec::new();
        for pair in meetings.keys() {
            let lost = self.lost(pair);
            pairs.extend((lost > 0).then(|| (lost, pair.clone())));
        }
        sort_by_key(&mut pairs, |(lost, pair)| (Reverse(*lost), pair.clone()));
        let (mut sets, mut used) = (Vec::new(), BTreeSet::new());
        for (_, pair) in pairs {
            if sets.len() < MOST_TOLD && pair.is_disjoint(&used) {
                let grown = self.grown(pair, &meetings, &used);
                used.extend(grown.iter().copied());
                sets.push(grown);
            }
        }
        let mut sets: Vec<(u32, BTreeSet<usize>)> =
            sets.into_iter().map(|it| (self.lost(&it), it)).collect();
        sort_by_key(&mut sets, |(lost, set)| (Reverse(*lost), set.clone()));
        sets.into_iter().map(|(_, set)| set).collect()
    }

    /// A set with further agents that make it lose more.
    fn grown(
        &mut self,
        mut agents: BTreeSet<usize>,
        meetings: &BTreeMap<BTreeSet<usize>, u32>,
        used: &BTreeSet<usize>,
    ) -> BTreeSet<usize> {
        while agents.len() < MOST_AGENTS {
            let near = meetings.keys().filter(|pair| !pair.is_disjoint(&agents));
            let near = set(near.flatten().copied());
            let now = self.value(&agents);
            let mut best: Option<(u32, usize)> = None;
            for agent in near {
                if agents.contains(&agent) || used.contains(&agent) {
                    continue;
                }
                let mut larger = agents.clone();
                larger.insert(agent);
                let value = self.value(&larger);
                if value > now && best.is_none_or(|(most, _)| value > most) {
                    best = Some((value, agent));
                }
            }
            let Some((_, agent)) = best else { break };
            agents.insert(agent);
        }
        agents
    }

    /// What a set is grown for.
    fn value(&mut self, agents: &BTreeSet<usize>) -> u32 {
        match self.needs.cost() {
            Cost::Makespan => self.needs.least(agents).unwrap_or(0),
            Cost::SumOfCosts | Cost::Charges | Cost::Moves | Cost::Waits | Cost::Penalty => {
                self.lost(agents)
            }
        }
    }

    /// What a set loses beyond what each needs alone; 0 where that is not known.
    fn lost(&mut self, agents: &BTreeSet<usize>) -> u32 {
        let own = self.needs.own(agents);
        let lost = self.needs.least(agents).zip(own);
        lost.map_or(0, |(least, own)| least.saturating_sub(own))
    }
}
