//! Constraints as sentences, and sentences as constraints: [`Constraint::sentence`] and
//! [`Constraint::from_words`] are inverse.

mod among;
mod grammar;
mod read;
mod tokens;

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
    /// assert_eq!(constraint.sentence(), "At most 1 robot in 'aisle 3'");
    /// ```
    pub fn sentence(&self) -> String {
        match &self.kind {
            ConstraintKind::Capacity { zone, most, times } => self.limit(zone, *most, *times),
            ConstraintKind::Closed { zone, times } => self.closure(zone, *times),
            ConstraintKind::OneWay { lane } => self.lane(lane),
            ConstraintKind::Gap { steps } => match &self.agents {
                None => tr!("Each cell stays free for {n} step behind any robot"
                    | "Each cell stays free for {n} steps behind any robot" % *steps),
                Some(names) => tr!(
                    "Each cell stays free for {n} step behind any of {robots}"
                        | "Each cell stays free for {n} steps behind any of {robots}" % *steps,
                    robots = list(names)
                ),
            },
            ConstraintKind::Apart { distance, times } => {
                let robots = match &self.agents {
                    None => tr!("All robots").to_owned(),
                    Some(names) => list(names),
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
                tr!("{agent} goes to {cells}", agent = quoted_name(agent), cells)
            }
            ConstraintKind::Visit { cell, stay, times } => self.stop(*cell, *stay, *times),
            ConstraintKind::Arrive { times } => self.arrival(*times),
            ConstraintKind::Late { by, weight } => tr!(
                "Each step after {by} until {robots} arrives costs {weight}",
                by,
                robots = self.each_of_them(),
                weight
            ),
            ConstraintKind::Depart { from } => {
                tr!("{robots} starts from {from} on", robots = self.each(), from)
            }
            ConstraintKind::Before { first, second } => tr!(
                "{first} is at {cell} before {second} is at {later}",
                first = quoted_name(&first.agent),
                cell = first.cell,
                second = quoted_name(&second.agent),
                later = second.cell
            ),
            ConstraintKind::NoWaiting { zone, most } => self.waiting(zone, *most),
            ConstraintKind::Turns { quarter } => tr!(
                "{robots} needs {n} step for each quarter turn"
                    | "{robots} needs {n} steps for each quarter turn" % *quarter,
                robots = self.each()
            ),
            ConstraintKind::Avoid { zone, weight } => self.toll(zone, *weight),
        }
    }

    /// The constraint by its name, or else by its sentence.
    pub fn called(&self) -> String {
        match &self.name {
            Some(name) => tr!("the rule '{name}'", name),
            None => tr!("the rule \"{sentence}\"", sentence = self.sentence()),
        }
    }

    /// The constraint as a fact: by its sentence, and its name where it has one.
    pub fn fact(&self) -> String {
        let sentence = self.sentence();
        match &self.name {
            Some(name) => tr!("the rule '{name}': \"{sentence}\"", name, sentence),
            None => tr!("the rule \"{sentence}\"", sentence),
        }
    }

    /// The robots that it binds, as a subject: `Each robot`, `A1`, `Each of A1 and A2`.
    fn each(&self) -> String {
        match self.agents.as_deref() {
            None => tr!("Each robot").to_owned(),
            Some([one]) => quoted_name(one),
            Some(names) => tr!("Each of {robots}", robots = list(names)),
        }
    }

    /// The same in the middle of a sentence.
    fn each_of_them(&self) -> String {
        match self.agents.as_deref() {
            None => tr!("each robot").to_owned(),
            Some([one]) => quoted_name(one),
            Some(names) => tr!("each of {robots}", robots = list(names)),
        }
    }

    fn limit(&self, zone: &str, most: u32, times: Times) -> String {
        let (zone, times) = (escaped(zone), span(times));
        match &self.agents {
            None => tr!(
                "At most {n} robot in '{zone}'{times}"
                    | "At most {n} robots in '{zone}'{times}" % most,
                zone,
                times
            ),
            Some(names) => tr!(
                "At most {most} of {robots} in '{zone}'{times}",
                most,
                robots = list(names),
                zone,
                times
            ),
        }
    }

    fn closure(&self, zone: &str, times: Times) -> String {
        let (zone, times) = (escaped(zone), span(times));
        match self.agents.as_deref() {
            None => tr!("No robot in '{zone}'{times}", zone, times),
            Some([one]) => tr!(
                "{robot} never in '{zone}'{times}",
                robot = quoted_name(one),
                zone,
                times
            ),
            Some(names) => tr!(
                "None of {robots} in '{zone}'{times}",
                robots = list(names),
                zone,
                times
            ),
        }
    }

    fn lane(&self, lane: &[Cell]) -> String {
        let robots = match &self.agents {
            None => String::new(),
            Some(names) => tr!("a one-way lane" => " for {robots}", robots = list(names)),
        };
        match lane {
            [first, .., last] if is_straight(lane) => tr!(
                "One way from {first} to {last}{robots}",
                first,
                last,
                robots
            ),
            _ => {
                let cells: Vec<String> = lane.iter().map(Cell::to_string).collect();
                let cells = cells.join(", ");
                tr!("One way along {cells}{robots}", cells, robots)
            }
        }
    }

    fn stop(&self, cell: Cell, stay: u32, times: Times) -> String {
        let (robots, times) = (self.each(), span(times));
        if stay == 0 {
            return tr!("{robots} is at {cell} once{times}", robots, cell, times);
        }
        tr!(
            "{robots} stays {n} step at {cell}{times}"
                | "{robots} stays {n} steps at {cell}{times}" % stay,
            robots,
            cell,
            times
        )
    }

    fn waiting(&self, zone: &str, most: u32) -> String {
        let zone = escaped(zone);
        let robots = match self.agents.as_deref() {
            None => tr!("No robot").to_owned(),
            Some([one]) => {
                let robot = quoted_name(one);
                return if most == 0 {
                    tr!("{robot} never waits in '{zone}'", robot, zone)
                } else {
                    tr!(
                        "{robot} waits at most {n} step on end in '{zone}'"
                            | "{robot} waits at most {n} steps on end in '{zone}'" % most,
                        robot,
                        zone
                    )
                };
            }
            Some(names) => tr!("None of {robots}", robots = list(names)),
        };
        if most == 0 {
            return tr!("{robots} waits in '{zone}'", robots, zone);
        }
        tr!(
            "{robots} waits more than {n} step on end in '{zone}'"
                | "{robots} waits more than {n} steps on end in '{zone}'" % most,
            robots,
            zone
        )
    }

    fn arrival(&self, times: Times) -> String {
        let robots = self.each();
        match (times.from, meant(times).to) {
            (Some(from), Some(by)) => tr!(
                "{robots} arrives by {by}, not before {from}",
                robots,
                by,
                from
            ),
            (Some(from), None) => tr!("{robots} arrives not before {from}", robots, from),
            (None, Some(by)) => tr!("{robots} arrives by {by}", robots, by),
            (None, None) => tr!("{robots} arrives", robots),
        }
    }

    fn toll(&self, zone: &str, weight: u32) -> String {
        let zone = escaped(zone);
        match &self.agents {
            None => tr!("Each step in '{zone}' costs {weight}", zone, weight),
            Some(names) => tr!(
                "Each step of {robots} in '{zone}' costs {weight}",
                robots = list(names),
                zone,
                weight
            ),
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

/// Whether cells stand in a row or a column.
fn is_straight(cells: &[Cell]) -> bool {
    cells
        .iter()
        .all(|cell| Some(cell.y) == cells.first().map(|first| first.y))
        || cells
            .iter()
            .all(|cell| Some(cell.x) == cells.first().map(|first| first.x))
}

/// Names of robots as a list.
fn list(names: &[String]) -> String {
    let names: Vec<String> = names.iter().map(|name| quoted_name(name)).collect();
    and(&names)
}

/// The name of a robot; in quotes where it could be taken for other words of a rule.
fn quoted_name(name: &str) -> String {
    if tokens::is_plain_name(name) {
        name.to_owned()
    } else {
        format!("'{}'", escaped(name))
    }
}

/// A name as it stands within quotes: a quote of its own is doubled.
fn escaped(name: &str) -> String {
    name.replace('\'', "''")
}

fn span(times: Times) -> String {
    match (times.first(), meant(times).to) {
        (0, None) => String::new(),
        (from, None) => tr!("when a rule holds" => " from {from} on", from),
        (0, Some(to)) => tr!("when a rule holds" => " up to {to}", to),
        (from, Some(to)) => tr!("when a rule holds" => " from {from} to {to}", from, to),
    }
}
