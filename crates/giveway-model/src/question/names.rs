//! Whether what a question names exists in the instance.

use super::{Misfit, Question, so};
use crate::constraint::find;
use crate::{Cell, Constraint, Fault, Ground, Instance, tr, tr_later};

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
        | Question::Penalty
        | Question::Charges { .. }
        | Question::Moves { .. }
        | Question::Waits { .. }
        | Question::Rule { .. }
        | Question::Unsolvable
        | Question::Plan => Ok(()),
    }
}

/// A fault of a question: what it has at a key, and what it should have.
pub(super) fn fault<T>(
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
        let mut faults = Vec::new();
        find(&scene, self.instance.grid(), &mut faults);
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
