//! Claims about the plans that a question contrasts one with.

use std::borrow::Cow;

use giveway_model::words::name;
use giveway_model::{Condition, Constraint, Cost, Instance, Plan, Question, tr};

use crate::{Claim, escape};

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
        match question.contrast(instance, plan)? {
            Condition::Below { limit: 0, .. } => None,
            Condition::Below {
                agent: None,
                cost,
                limit,
            } => Some(Self::at_most([(cost, limit - 1)])),
            condition @ (Condition::Never { .. }
            | Condition::Visit { .. }
            | Condition::Move { .. }
            | Condition::Charge { .. }
            | Condition::Before { .. }
            | Condition::Keeps(_)
            | Condition::Below { agent: Some(_), .. }) => Some(Self {
                condition: Some(condition),
                ..Self::default()
            }),
        }
    }
}

/// A condition is a rule that an instance cannot have.
#[derive(Clone, Copy, Debug)]
pub(crate) struct NoRule;

/// The instance in which a condition that is a rule is one of its own.
///
/// # Errors
/// Where the rule does not fit the instance.
pub(crate) fn with_rule<'a>(
    instance: &'a Instance,
    condition: Option<&Condition>,
) -> Result<Cow<'a, Instance>, NoRule> {
    match condition {
        Some(Condition::Keeps(rule)) => {
            let mut scene = instance.to_scene();
            scene.constraints.push(Constraint {
                off: false,
                name: None,
                ..(**rule).clone()
            });
            Instance::new(scene).map(Cow::Owned).map_err(|_| NoRule)
        }
        Some(
            Condition::Never { .. }
            | Condition::Visit { .. }
            | Condition::Move { .. }
            | Condition::Charge { .. }
            | Condition::Before { .. }
            | Condition::Below { .. },
        )
        | None => Ok(Cow::Borrowed(instance)),
    }
}

/// Whether a condition is about agents of an instance.
pub(crate) fn fits(condition: &Condition, instance: &Instance) -> bool {
    let mut agents = condition.agents();
    agents.all(|name| instance.agents().iter().any(|agent| agent.name == name))
}

/// A condition as the end of a sentence: `in which a arrives before time 2`.
pub(crate) fn words(condition: &Condition) -> String {
    match condition {
        Condition::Below {
            agent: Some(agent),
            cost,
            limit,
        } => {
            let agent = escape::name(agent);
            match cost {
                Cost::Charges | Cost::Moves | Cost::Waits | Cost::Penalty => tr!(
                    "a plan in which ..." => "{agent} has at most {most} {cost}",
                    agent,
                    most = limit.saturating_sub(1),
                    cost = name(*cost)
                ),
                Cost::Makespan | Cost::SumOfCosts => tr!(
                    "a plan in which ..." => "{agent} arrives before time {time}",
                    agent,
                    time = limit
                ),
            }
        }
        Condition::Never { .. }
        | Condition::Visit { .. }
        | Condition::Move { .. }
        | Condition::Charge { .. }
        | Condition::Before { .. }
        | Condition::Keeps(_)
        | Condition::Below { agent: None, .. } => condition.clause().does,
    }
}
