//! What another plan would have to be like: the contrast of a question, without
//! the plan that it was asked about.

use borsh::{BorshDeserialize, BorshSerialize};
use giveway_model::words::name;
use giveway_model::{Cost, Instance, Plan, Question, check, question, tr};
use serde::{Deserialize, Serialize};

use crate::{Claim, escape};

/// A condition on a plan.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Condition {
    /// The contrast of a question about what an agent does or does not do.
    Contrast(Question),
    /// An agent arrives before a time.
    Arrival {
        /// The agent.
        agent: String,
        /// The time, in steps.
        before: u32,
    },
    /// An agent alone has at most so much of a cost.
    AtMost {
        /// The agent.
        agent: String,
        /// Charges, moves or waits.
        cost: Cost,
        /// So much.
        most: u32,
    },
}

impl Claim {
    /// The claim that there is no plan such as a question about `plan` contrasts
    /// it with. `None` where the question contrasts it with none, or nothing could
    /// be less than what is asked about.
    ///
    /// ```
    /// use giveway_model::{Question, format::native};
    /// use giveway_proof::Claim;
    /// let instance = native::read_instance(r#"{ "giveway": 1, "map": ["..."],
    ///     "agents": [{ "name": "a", "start": [0, 0], "goal": [2, 0] }] }"#).unwrap();
    /// let plan = native::read_plan(
    ///     r#"{ "giveway": 1, "paths": { "a": [[0, 0], [1, 0], [2, 0]] } }"#).unwrap();
    /// let claim = Claim::contrast(&Question::Makespan, &instance, &plan).unwrap();
    /// assert_eq!(claim.sentence(), "There is no plan with makespan at most 1.");
    /// let claim = Claim::contrast(
    ///     &Question::Arrival { agent: "a".into() }, &instance, &plan).unwrap();
    /// assert_eq!(claim.sentence(), "There is no plan in which a arrives before time 2.");
    /// ```
    pub fn contrast(question: &Question, instance: &Instance, plan: &Plan) -> Option<Self> {
        let costs = check::costs(instance, plan);
        let total = |cost| {
            let below = costs?.get(cost).checked_sub(1)?;
            Some(Self::at_most([(cost, below)]))
        };
        let condition = match question {
            Question::Unsolvable | Question::Plan => return None,
            Question::Makespan => return total(Cost::Makespan),
            Question::SumOfCosts => return total(Cost::SumOfCosts),
            Question::Charges { agent: None } => return total(Cost::Charges),
            Question::Moves { agent: None } => return total(Cost::Moves),
            Question::Waits { agent: None } => return total(Cost::Waits),
            Question::Arrival { agent } => Condition::Arrival {
                agent: agent.clone(),
                before: one(instance, plan, agent)?.makespan,
            },
            Question::Length { agent, fewer_than } => {
                let than = match fewer_than {
                    Some(than) => *than,
                    None => one(instance, plan, agent)?.moves,
                };
                fewer(agent, Cost::Moves, than)?
            }
            Question::Charges { agent: Some(agent) } => {
                fewer(agent, Cost::Charges, one(instance, plan, agent)?.charges)?
            }
            Question::Moves { agent: Some(agent) } => {
                fewer(agent, Cost::Moves, one(instance, plan, agent)?.moves)?
            }
            Question::Waits { agent: Some(agent) } => {
                fewer(agent, Cost::Waits, one(instance, plan, agent)?.waits)?
            }
            other => Condition::Contrast(other.clone()),
        };
        Some(Self {
            condition: Some(condition),
            ..Self::default()
        })
    }
}

fn fewer(agent: &str, cost: Cost, than: u32) -> Option<Condition> {
    Some(Condition::AtMost {
        agent: agent.to_owned(),
        cost,
        most: than.checked_sub(1)?,
    })
}

/// What a plan costs one agent.
fn one(instance: &Instance, plan: &Plan, agent: &str) -> Option<giveway_model::Costs> {
    let instance = instance.alone(agent)?;
    let mut plan = plan.clone();
    plan.paths.retain(|name, _| name == agent);
    plan.charges.retain(|name, _| name == agent);
    (!plan.paths.is_empty()).then_some(())?;
    check::costs(&instance, &plan)
}

impl Condition {
    /// Whether it is about what agents of an instance do.
    pub(crate) fn fits(&self, instance: &Instance) -> bool {
        let exists = |name: &str| instance.agents().iter().any(|agent| agent.name == name);
        match self {
            Self::Arrival { agent, .. } => exists(agent),
            Self::AtMost { agent, cost, .. } => {
                let counted = matches!(cost, Cost::Charges | Cost::Moves | Cost::Waits);
                counted && exists(agent)
            }
            Self::Contrast(asked) => {
                question::contrast(asked).is_some() && asked.agents().all(exists)
            }
        }
    }

    /// Whether a plan that keeps the rules meets it.
    pub(crate) fn is_met_by(&self, instance: &Instance, plan: &Plan) -> bool {
        match self {
            Self::Arrival { agent, before } => {
                one(instance, plan, agent).is_some_and(|own| own.makespan < *before)
            }
            Self::AtMost { agent, cost, most } => {
                one(instance, plan, agent).is_some_and(|own| own.get(*cost) <= *most)
            }
            // What an agent does in one plan needs no other to be judged.
            Self::Contrast(asked) => question::holds(asked, instance, plan, plan) == Some(true),
        }
    }

    /// The condition as the end of a sentence: `in which a arrives before time 2`.
    pub(crate) fn words(&self) -> String {
        match self {
            Self::Arrival { agent, before } => {
                tr!("a plan in which ..." => "{agent} arrives before time {time}", agent = escape::name(agent), time = before)
            }
            Self::AtMost { agent, cost, most } => {
                tr!("a plan in which ..." => "{agent} has at most {most} {cost}", agent = escape::name(agent), most, cost = name(*cost))
            }
            Self::Contrast(question) => contrast(question),
        }
    }
}

fn contrast(question: &Question) -> String {
    match question::contrast(question) {
        Some(contrast) => contrast.does,
        // The others are limits of costs, or contrast a plan with nothing.
        None => {
            tr!("a plan in which ..." => "the question \"{kind}\" has another answer", kind = question.kind())
        }
    }
}
