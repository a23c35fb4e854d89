//! Whether a question can be asked of a plan: it names what exists, and what it
//! asks about is so.

use super::holds;
use super::least::already_least;
use super::names::{fault, names_exist};
use super::not_so::not_so;
use super::{Misfit, Question};
use crate::check::Walk;
use crate::condition::{Times, first_visit, is_at};
use crate::{Cell, Constraint, Instance, Plan, tr, tr_later};

/// Checks that a question can be asked of a valid plan: what it names exists,
/// and what it asks about is so.
///
/// # Errors
/// What is so instead, and what can be asked.
///
/// ```
/// use giveway_model::{Question, format::native, question::fits};
/// let instance = native::read_instance(r#"{ "giveway": 1, "map": ["..."],
///     "agents": [{ "name": "A1", "start": [0, 0], "goal": [2, 0] }] }"#).unwrap();
/// let plan = native::read_plan(
///     r#"{ "giveway": 1, "paths": { "A1": [[0, 0], [1, 0], [2, 0]] } }"#).unwrap();
/// let why = Question::Wait {
///     agent: "A1".into(), at: None, from: None, to: None, at_least: None,
/// };
/// let misfit = fits(&why, &instance, &plan).unwrap_err();
/// assert_eq!(
///     misfit.to_string(),
///     "A1 does not wait. It never waits before its arrival. You can ask: arrival A1",
/// );
/// assert_eq!(
///     misfit.in_sentences(),
///     "A1 does not wait. It never waits before its arrival. \
///      You can ask: Why does A1 not arrive sooner?",
/// );
/// ```
pub fn fits(question: &Question, instance: &Instance, plan: &Plan) -> Result<(), Misfit> {
    names_exist(question, instance)?;
    if let Question::Yield { agent, to, at } = question {
        return precedence(instance, plan, agent, to, *at);
    }
    if let Some(is_so) = already_least(question, instance, plan) {
        return Err(Misfit::NotSo { is_so, ask: None });
    }
    if let Question::Rule { rule } = question {
        return kept(rule, question, instance, plan);
    }
    // The question fits where the plan does not meet the contrast.
    let order = matches!(question, Question::Order { .. });
    if !order && holds(question, instance, plan, plan) != Some(true) {
        return Ok(());
    }
    let Some(walk) = question
        .agent()
        .and_then(|name| Walk::named(instance, name, plan))
        .or_else(|| visitor(question, instance, plan))
    else {
        return Ok(());
    };
    not_so(question, instance, &walk)
}

/// A rule that the plan breaks fits; one that it keeps, or that costs only, does not.
fn kept(
    rule: &Constraint,
    question: &Question,
    instance: &Instance,
    plan: &Plan,
) -> Result<(), Misfit> {
    let is_alike = |own: &Constraint| own.kind == rule.kind && own.agents == rule.agents;
    let mut in_force = instance.constraints_in_force();
    let sentence = rule.sentence();
    let is_so = if in_force.any(|own| is_alike(own.constraint)) {
        tr!(
            "It is so: the scene has this rule, \"{sentence}\".",
            sentence
        )
    } else if holds(question, instance, plan, plan) == Some(true) {
        tr!(
            "It is so: this plan keeps the rule \"{sentence}\".",
            sentence
        )
    } else {
        return Ok(());
    };
    Err(Misfit::NotSo { is_so, ask: None })
}

/// The first agent that passes where nobody is said to.
fn visitor<'a>(question: &Question, instance: &'a Instance, plan: &'a Plan) -> Option<Walk<'a>> {
    let Question::NoVisit { agent: None, at } = question else {
        return None;
    };
    Walk::all(instance, plan)
        .into_iter()
        .find(|walk| is_at(instance, walk, *at, Times::default()))
}

/// One agent gives way to another at a cell: both are there, the other first.
fn precedence(
    instance: &Instance,
    plan: &Plan,
    agent: &str,
    to: &str,
    at: Cell,
) -> Result<(), Misfit> {
    if agent == to {
        return fault(
            "agents",
            tr!("{what} twice", what = agent),
            tr_later!("two different robots"),
        );
    }
    let visit = |name: &str| first_visit(&Walk::named(instance, name, plan)?, at);
    let (is_so, ask) = match (visit(agent), visit(to)) {
        (Some(late), Some(early)) if early < late => return Ok(()),
        (Some(early), Some(late)) => (
            tr!(
                "{agent} is at {at} first, at time {early}, and {to} at time {late}.",
                agent,
                at,
                early,
                to,
                late
            ),
            Question::Yield {
                agent: to.to_owned(),
                to: agent.to_owned(),
                at,
            },
        ),
        (None, _) => (
            tr!(
                "{agent} is never at {at}, so it gives way to nobody there.",
                agent,
                at
            ),
            Question::NoVisit {
                agent: Some(agent.to_owned()),
                at,
            },
        ),
        (Some(_), None) => (
            tr!(
                "{to} is never at {at}, so {agent} does not give way to it there.",
                to,
                at,
                agent
            ),
            Question::NoVisit {
                agent: Some(to.to_owned()),
                at,
            },
        ),
    };
    let ask = Some(ask);
    Err(Misfit::NotSo { is_so, ask })
}
