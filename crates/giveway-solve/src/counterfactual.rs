//! What a question contrasts the plan with, as the search sees it.
//!
//! Most of it is a demand on one agent
//! ([`TaskConstraint`](crate::single::TaskConstraint)) or a limit on a cost; who
//! comes first at a cell is the one thing between two agents. Names and cells
//! are looked up anew in each instance, since explanations ask about edited
//! ones, too, with other agents and other obstacles.

mod impose;

use std::collections::BTreeMap;

use giveway_model::{
    Cost, Instance, Plan, Question,
    check::{arrivals, costs},
    question::holds,
};

use crate::{explain::past::Past, single::Place, terrain::Vertex, walk::Walk};

/// A constraint on the other plan.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Counterfactual {
    /// The question; where it is about whichever agent, about one of them.
    question: Question,
    /// The plan that is asked about.
    plan: Plan,
    /// What a number must be below, where the question is about one.
    below: u32,
    /// What is past already, which costs count.
    past: Past,
}

/// One agent is at a vertex before another has been there.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Precedence {
    /// Who has to be there first; the vertex is one of its waypoints.
    pub(crate) first: usize,
    /// Who may be there later.
    pub(crate) second: usize,
    pub(crate) at: Vertex,
}

impl Precedence {
    /// Whether walks, in which the first does visit the vertex, keep to it.
    pub(crate) fn is_kept(self, walks: &[Walk]) -> bool {
        let visit = |agent: usize| {
            let walk = walks.get(agent)?;
            walk.iter().position(|&place| place == Place::At(self.at))
        };
        match (visit(self.first), visit(self.second)) {
            (Some(first), Some(second)) => first < second,
            (first, _) => first.is_some(),
        }
    }
}

/// What must hold in the other plan, one way or another.
#[derive(Clone, Debug)]
pub(crate) struct Counterfactuals {
    ways: Vec<Counterfactual>,
    nobody_could: Option<Unmeetable>,
}

/// The proof that no plan, of whatever makespan, is as asked for: it would have
/// to be where nobody can be, or cost less than nothing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Unmeetable(());

impl Counterfactuals {
    /// What a question asks for: there are several ways where it is about
    /// whichever agent, and none where it has no contrast. The question fits the
    /// plan.
    pub(crate) fn of(question: &Question, instance: &Instance, plan: &Plan, past: &Past) -> Self {
        let whole = |agent: &Option<String>| agent.is_none();
        let costs = past.costs(instance, plan).unwrap_or_default();
        let total = |cost: Cost| costs.get(cost);
        let below = match question {
            Question::Makespan => total(Cost::Makespan),
            Question::SumOfCosts => total(Cost::SumOfCosts),
            Question::Charges { agent } if whole(agent) => total(Cost::Charges),
            Question::Moves { agent } if whole(agent) => total(Cost::Moves),
            Question::Waits { agent } if whole(agent) => total(Cost::Waits),
            Question::Charges { agent: Some(agent) } => own(instance, plan, agent, Cost::Charges),
            Question::Waits { agent: Some(agent) } => own(instance, plan, agent, Cost::Waits),
            Question::Arrival { agent } => own(instance, plan, agent, Cost::Makespan),
            Question::Length {
                fewer_than: Some(fewer_than),
                ..
            } => *fewer_than,
            Question::Moves { agent: Some(agent) } | Question::Length { agent, .. } => {
                own(instance, plan, agent, Cost::Moves)
            }
            _ => 0,
        };
        let about = |question: Question| Counterfactual {
            question,
            plan: plan.clone(),
            below,
            past: past.clone(),
        };
        let mut nobody_could = None;
        let ways = match question {
            Question::Unsolvable | Question::Plan => Vec::new(),
            Question::NoVisit { agent: None, at } => {
                let agents = instance.agents().iter();
                nobody_could = instance.agents().is_empty().then_some(Unmeetable(()));
                agents
                    .map(|agent| {
                        about(Question::NoVisit {
                            agent: Some(agent.name.clone()),
                            at: *at,
                        })
                    })
                    .collect()
            }
            question => vec![about(question.clone())],
        };
        Self { ways, nobody_could }
    }

    /// The ways, in order.
    pub(crate) fn iter(&self) -> impl Iterator<Item = &Counterfactual> {
        self.ways.iter()
    }

    /// Where there is no way: that there is nobody who could be as asked for.
    pub(crate) const fn nobody_could(&self) -> Option<Unmeetable> {
        self.nobody_could
    }
}

impl Counterfactual {
    /// The agent that is asked about, if there is one.
    pub(crate) fn agent(&self) -> Option<&str> {
        self.question.agent()
    }

    /// The limit on a cost of the whole plan, if that is what is asked for.
    pub(crate) fn limit(&self) -> Option<(Cost, u32)> {
        let cost = match self.question {
            Question::Makespan => Cost::Makespan,
            Question::SumOfCosts => Cost::SumOfCosts,
            Question::Charges { agent: None } => Cost::Charges,
            Question::Moves { agent: None } => Cost::Moves,
            Question::Waits { agent: None } => Cost::Waits,
            _ => return None,
        };
        Some((cost, self.below))
    }

    /// Adds the limit on a cost to others.
    ///
    /// # Errors
    /// Where no plan can keep it: nothing costs less than nothing.
    pub(crate) fn limit_costs(&self, limits: &mut BTreeMap<Cost, u32>) -> Result<(), Unmeetable> {
        let Some((cost, below)) = self.limit() else {
            return Ok(());
        };
        let most = below.checked_sub(1).ok_or(Unmeetable(()))?;
        let limit = limits.entry(cost).or_insert(most);
        *limit = most.min(*limit);
        Ok(())
    }

    /// Whether a plan of an instance, edited maybe, is what is asked for. The
    /// judge of questions says so, which knows nothing of the search.
    pub(crate) fn is_met_by(&self, instance: &Instance, other: &Plan) -> bool {
        if let Some((cost, below)) = self.limit() {
            let costs = self.past.costs(instance, other);
            return costs.is_some_and(|costs| costs.get(cost) < below);
        }
        let question = match &self.question {
            // Whoever is not there has not been there before.
            Question::Yield { agent, to, at } if index(instance, to).is_none() => {
                Question::NoVisit {
                    agent: Some(agent.clone()),
                    at: *at,
                }
            }
            question => question.clone(),
        };
        holds(&question, instance, &self.plan, other) == Some(true)
    }
}

fn index(instance: &Instance, name: &str) -> Option<usize> {
    instance
        .agents()
        .iter()
        .position(|agent| agent.name == name)
}

/// A cost of one agent in a plan; its makespan is its arrival.
fn own(instance: &Instance, plan: &Plan, name: &str, cost: Cost) -> u32 {
    let Some(agent) = index(instance, name) else {
        return 0;
    };
    let arrival = arrivals(instance, plan).get(agent).copied().flatten();
    match cost {
        Cost::Makespan => arrival.unwrap_or(0),
        _ => instance
            .alone(name)
            .and_then(|alone| costs(&alone, plan))
            .map_or(0, |costs| costs.get(cost)),
    }
}
