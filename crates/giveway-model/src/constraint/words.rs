//! Constraints as sentences.

use super::{Constraint, ConstraintKind, meant};
use crate::condition::Times;
use crate::words::and;
use crate::{Cell, tr};

impl Constraint {
    /// The constraint as a sentence without a full stop; names of zones stand in quotes.
    ///
    /// ```
    /// use giveway_model::Constraint;
    /// let text = r#"{ "kind": "capacity", "zone": "aisle 3", "most": 1 }"#;
    /// let constraint: Constraint = serde_json::from_str(text).unwrap();
    /// assert_eq!(constraint.sentence(), "At most 1 of all robots in 'aisle 3' always");
    /// ```
    pub fn sentence(&self) -> String {
        let all = || self.all();
        match &self.kind {
            ConstraintKind::Capacity { zone, most, times } => tr!(
                "At most {most} of {robots} in '{zone}'{times}",
                most,
                robots = all(),
                zone,
                times = span(*times)
            ),
            ConstraintKind::Closed { zone, times } => match &self.agents {
                None => tr!("No robot in '{zone}'{times}", zone, times = span(*times)),
                Some(_) => tr!(
                    "None of {robots} in '{zone}'{times}",
                    robots = all(),
                    zone,
                    times = span(*times)
                ),
            },
            ConstraintKind::OneWay { lane } => tr!(
                "One way along {cells} for {robots}",
                cells = cells(lane),
                robots = all()
            ),
            ConstraintKind::Gap { steps } => tr!(
                "Each cell stays free for {n} step behind any of {robots}"
                    | "Each cell stays free for {n} steps behind any of {robots}" % *steps,
                robots = all()
            ),
            ConstraintKind::Apart { distance, times } => {
                let robots = match &self.agents {
                    None => tr!("All robots").to_owned(),
                    Some(names) => and(names),
                };
                tr!(
                    "{robots} keep {distance} apart{times}",
                    robots,
                    distance,
                    times = span(*times)
                )
            }
            ConstraintKind::Sequence { agent, cells } => {
                let stops: Vec<String> = cells.iter().map(Cell::to_string).collect();
                let cells = stops.join(tr!("between the stops of a robot" => ", then to "));
                tr!("{agent} goes to {cells}", agent, cells)
            }
            ConstraintKind::Visit {
                cell,
                stay: 0,
                times,
            } => tr!(
                "Each of {robots} is at {cell} once{times}",
                robots = all(),
                cell,
                times = span(*times)
            ),
            ConstraintKind::Visit { cell, stay, times } => tr!(
                "Each of {robots} stays {n} step at {cell}{times}"
                    | "Each of {robots} stays {n} steps at {cell}{times}" % *stay,
                robots = all(),
                cell,
                times = span(*times)
            ),
            ConstraintKind::Arrive { times } => self.arrival(*times),
            ConstraintKind::Late { by, weight } => tr!(
                "Each step after {by} until each of {robots} arrives costs {weight}",
                by,
                robots = all(),
                weight
            ),
            ConstraintKind::Depart { from } => tr!(
                "Each of {robots} starts from {from} on",
                robots = all(),
                from
            ),
            ConstraintKind::Before { first, second } => tr!(
                "{first} is at {cell} before {second} is at {later}",
                first = first.agent,
                cell = first.cell,
                second = second.agent,
                later = second.cell
            ),
            ConstraintKind::NoWaiting { zone, most } => self.waiting(zone, *most),
            ConstraintKind::Turns { quarter } => tr!(
                "Each of {robots} needs {n} step for each quarter turn"
                    | "Each of {robots} needs {n} steps for each quarter turn" % *quarter,
                robots = all()
            ),
            ConstraintKind::Avoid { zone, weight } => tr!(
                "Each step of {robots} in '{zone}' costs {weight}",
                robots = all(),
                zone,
                weight
            ),
        }
    }

    /// The constraint by its name, or else by its sentence.
    pub fn called(&self) -> String {
        match &self.name {
            Some(name) => tr!("the rule '{name}'", name),
            None => tr!("the rule \"{sentence}\"", sentence = self.sentence()),
        }
    }

    fn all(&self) -> String {
        match &self.agents {
            None => tr!("all robots").to_owned(),
            Some(names) => and(names),
        }
    }

    fn waiting(&self, zone: &str, most: u32) -> String {
        let robots = self.all();
        if most == 0 {
            return tr!("None of {robots} waits in '{zone}'", robots, zone);
        }
        tr!(
            "None of {robots} waits more than {n} step on end in '{zone}'"
                | "None of {robots} waits more than {n} steps on end in '{zone}'" % most,
            robots,
            zone
        )
    }

    fn arrival(&self, times: Times) -> String {
        let robots = self.all();
        match (times.from, meant(times).to) {
            (Some(from), Some(by)) => tr!(
                "Each of {robots} arrives by {by}, not before {from}",
                robots,
                by,
                from
            ),
            (Some(from), None) => tr!("Each of {robots} arrives not before {from}", robots, from),
            (None, Some(by)) => tr!("Each of {robots} arrives by {by}", robots, by),
            (None, None) => tr!("Each of {robots} arrives", robots),
        }
    }
}

/// A sentence about the rules of a scene that are in force; none where there are none.
pub fn sentences(constraints: &[Constraint]) -> Option<String> {
    let in_force = constraints.iter().filter(|rule| !rule.off);
    let rules: Vec<String> = in_force.map(Constraint::sentence).collect();
    let list = rules.join("; ");
    (!rules.is_empty()).then(|| {
        tr!(
            "{n} rule of the scene's own: {list}."
                | "{n} rules of the scene's own: {list}." % rules.len(),
            list
        )
    })
}

fn cells(cells: &[Cell]) -> String {
    let cells: Vec<String> = cells.iter().map(Cell::to_string).collect();
    cells.join(", ")
}

fn span(times: Times) -> String {
    match (times.first(), meant(times).to) {
        (0, None) => tr!("when a rule holds" => " always").to_owned(),
        (from, None) => tr!("when a rule holds" => " from {from} on", from),
        (0, Some(to)) => tr!("when a rule holds" => " up to {to}", to),
        (from, Some(to)) => tr!("when a rule holds" => " from {from} to {to}", from, to),
    }
}
