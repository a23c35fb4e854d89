//! Whether a question can be asked of a plan: it names what exists, and what it
//! asks about is so.

use super::holds;
use super::least::already_least;
use super::not_so::not_so;
use super::{Misfit, Question, so};
use crate::check::Walk;
use crate::condition::{Times, first_visit, is_at};
use crate::{Cell, Constraint, Fault, Ground, Instance, Plan, tr, tr_later};

/// Agents that a fault lists by name.
const NAMED: usize = 8;

/// Checks that a question names agents and cells of the instance, whatever the
/// plan.
///
/// # Errors
/// The first thing that it names and that does not exist.
pub fn names_exist(question: &Question, instance: &Instance) -> Result<(), Misfit> {
    let about = Names { instance };
    if let Question::Rule { rule } = question {
        return about.rule(rule);
    }
    for name in question.agents() {
        about.agent(name)?;
    }
    let on_map = |key, cell| about.on_map(key, cell);
    match *question {
        Question::Wait {
            at,
            from,
            to,
            at_least,
            ..
        } => {
            at.map_or(Ok(()), |at| on_map("at", at))?;
            let from = from.unwrap_or(0);
            if let Some(to) = to.filter(|&to| to <= from) {
                let expected = tr!("a time after {from}, since a wait takes a step", from);
                return fault("to", tr!("time {time}", time = to), expected);
            }
            if at_least == Some(0) {
                return fault("at-least", "0", tr_later!("at least 1 step"));
            }
            Ok(())
        }
        Question::Charge { at, .. } => at.map_or(Ok(()), |at| about.charger(at)),
        Question::NoCharge { at, .. } => about.charger(at),
        Question::Visit { at, .. } => on_map("at", at),
        Question::NoVisit { at, .. } | Question::Yield { at, .. } => about.vertex("at", at),
        Question::Move {
            from_cell, to_cell, ..
        }
        | Question::NoMove {
            from_cell, to_cell, ..
        } => about.edge(from_cell, to_cell),
        Question::Slow {
            from_cell: Some(u),
            to_cell: Some(v),
            ..
        } => about.edge(u, v),
        Question::Order { first, second, .. } => {
            about.vertex("first", first)?;
            about.vertex("second", second)?;
            if first == second {
                return fault(
                    "second",
                    tr!("{cell} again", cell = second),
                    tr_later!("another cell"),
                );
            }
            Ok(())
        }
        Question::Slow { .. }
        | Question::Arrival { .. }
        | Question::Length { .. }
        | Question::Makespan
        | Question::SumOfCosts
        | Question::Charges { .. }
        | Question::Moves { .. }
        | Question::Waits { .. }
        | Question::Rule { .. }
        | Question::Unsolvable
        | Question::Plan => Ok(()),
    }
}

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

fn fault<T>(
    place: &str,
    found: impl Into<String>,
    expected: impl Into<String>,
) -> Result<T, Misfit> {
    let fault = Fault::at(place, found, expected);
    Err(Misfit::Fault { fault })
}

/// Looks names up.
struct Names<'a> {
    instance: &'a Instance,
}

impl Names<'_> {
    /// A rule that could be one of the scene's own, and that forbids something.
    fn rule(&self, rule: &Constraint) -> Result<(), Misfit> {
        if rule.is_penalty() {
            let found = tr!(
                "a rule that forbids nothing, but has a price: \"{sentence}\"",
                sentence = rule.sentence()
            );
            return fault("rule", found, tr_later!("a rule that a plan can break"));
        }
        let mut scene = self.instance.to_scene();
        scene.constraints = vec![Constraint {
            off: false,
            ..rule.clone()
        }];
        let Err(faults) = Instance::new(scene) else {
            return Ok(());
        };
        match faults.into_iter().next() {
            None => Ok(()),
            Some(mut fault) => {
                fault.place = fault.place.replacen("constraints[0]", "rule", 1);
                Err(Misfit::Fault { fault })
            }
        }
    }

    fn agent(&self, name: &str) -> Result<(), Misfit> {
        let agents = self.instance.agents();
        if agents.iter().any(|agent| agent.name == name) {
            return Ok(());
        }
        let names: Vec<&str> = agents.iter().map(|agent| agent.name.as_str()).collect();
        let expected = match names.as_slice() {
            [] => tr!("a robot, but there is none").to_owned(),
            [one] => one.to_string(),
            names if names.len() <= NAMED => tr!("one of {names}", names = names.join(", ")),
            [first, .., last] => tr!(
                "one of the {n} robots {first} to {last}",
                n = names.len(),
                first,
                last
            ),
        };
        fault("agent", format!("\"{name}\""), expected)
    }

    fn on_map(&self, key: &str, cell: Cell) -> Result<(), Misfit> {
        let grid = self.instance.grid();
        if grid.ground(cell).is_some() {
            return Ok(());
        }
        let expected = tr!(
            "a cell of the {width} x {height} map",
            width = grid.width(),
            height = grid.height()
        );
        fault(key, cell.to_string(), expected)
    }

    fn vertex(&self, key: &str, cell: Cell) -> Result<(), Misfit> {
        self.on_map(key, cell)?;
        if self.instance.grid().ground(cell) == Some(Ground::Obstacle) {
            return fault(
                key,
                tr!("the obstacle {cell}", cell),
                tr_later!("a free cell"),
            );
        }
        Ok(())
    }

    fn charger(&self, cell: Cell) -> Result<(), Misfit> {
        self.on_map("at", cell)?;
        let grid = self.instance.grid();
        if grid.is_charger(cell) {
            return Ok(());
        }
        let chargers: Vec<String> = grid
            .cells()
            .filter(|(_, ground)| ground.is_charger())
            .map(|(cell, _)| cell.to_string())
            .collect();
        let expected = if chargers.is_empty() {
            tr!("a charger, but the map has none").to_owned()
        } else {
            tr!(
                "one of the chargers: {chargers}",
                chargers = so::list(&chargers)
            )
        };
        fault("at", tr!("{cell}, which is not a charger", cell), expected)
    }

    fn edge(&self, from: Cell, to: Cell) -> Result<(), Misfit> {
        self.vertex("from-cell", from)?;
        self.vertex("to-cell", to)?;
        if from.touches(to) {
            return Ok(());
        }
        let expected = tr!("a neighbour of {from}", from);
        fault("to-cell", to.to_string(), expected)
    }
}
