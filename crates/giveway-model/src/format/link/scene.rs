//! The scene in a link.

// Writing to a string cannot fail.
use std::fmt::Write as _;

use crate::{
    Agent, Assumption, AtGoal, Battery, Cell, Cost, Ground, LeftOutRule, Measure, Objective, Scene,
    Units,
};

use super::MAX_SIDE;
use super::message;
use super::text::{escape, letters, numbers, runs, unescape};
use crate::constraint::Heading;

/// The letters of the map: those of files have a meaning in a link.
const GROUNDS: [(char, Ground); 5] = [
    ('f', Ground::Free),
    ('o', Ground::Obstacle),
    ('s', Ground::Slow),
    ('c', Ground::Charger),
    ('b', Ground::SlowCharger),
];

/// The names of the parts that [`write()`] writes behind the version, and [`read()`] reads.
pub const PARTS: [&str; 8] = [
    "map",
    "name",
    "rules",
    "costs",
    "agents",
    "assumes",
    "constraints",
    "units",
];

/// Stands for the goal of an agent that has none.
const NO_GOAL: &str = ".-";

/// The parts of a scene, the first of a text.
pub fn write(scene: &Scene) -> String {
    let width = scene.map.first().map_or(0, |row| row.chars().count());
    let cells = scene.map.iter().flat_map(|row| row.chars());
    let cells = cells.map(|c| {
        let ground = Ground::from_char(c);
        let letter = GROUNDS.iter().find(|(_, g)| Some(*g) == ground);
        letter.map_or('f', |(letter, _)| *letter)
    });
    let mut text = format!("giveway=1&map={width}.{}", runs(cells));
    if !scene.name.is_empty() {
        let _ = write!(text, "&name={}", escape(&scene.name));
    }
    let leaves = u32::from(scene.rules.at_goal == AtGoal::Vanish);
    let _ = write!(text, "&rules={leaves}.{}&costs=", scene.rules.battery_floor);
    for cost in scene.objective.costs() {
        let place = Cost::ALL.iter().position(|other| other == cost);
        text += &place.unwrap_or(0).to_string();
    }
    let agents: Vec<String> = scene.agents.iter().map(write_agent).collect();
    text = text + "&agents=" + &agents.join(";");
    if !scene.assumptions.is_empty() {
        let assumptions: Vec<String> = scene.assumptions.iter().map(write_assumption).collect();
        text = text + "&assumes=" + &assumptions.join(";");
    }
    if !(scene.zones.is_empty() && scene.constraints.is_empty()) {
        let own = (&scene.zones, &scene.constraints);
        text = text + "&constraints=" + &message::write(&own);
    }
    if let Some(Units { cell, step }) = scene.units {
        let _ = write!(text, "&units={}.{}", cell.thousandths(), step.thousandths());
    }
    text
}

/// `g` for goals that were chosen, `k` with a key, `m` with a name and cells, `c` likewise
/// where rules close these cells, `r` with the number of a rule.
fn write_assumption(assumption: &Assumption) -> String {
    match assumption {
        Assumption::GoalsChosen => "g".to_owned(),
        Assumption::UnknownKey { key } => format!("k{}", escape(key)),
        Assumption::RuleLeftOut { rule } => {
            let number = LeftOutRule::ALL.iter().position(|one| one == rule);
            format!("r{}", number.unwrap_or_default())
        }
        Assumption::MovingObstacle { name, path, closed } => {
            let kind = if *closed { 'c' } else { 'm' };
            let mut text = format!("{kind}{}", escape(name));
            for cell in path {
                let _ = write!(text, ".{}.{}", cell.x, cell.y);
            }
            text
        }
    }
}

fn read_assumption(text: &str) -> Option<Assumption> {
    let rest = text.get(1..)?;
    match text.get(..1)? {
        "g" if rest.is_empty() => Some(Assumption::GoalsChosen),
        "k" => Some(Assumption::UnknownKey {
            key: unescape(rest)?,
        }),
        "r" => {
            let rule = *LeftOutRule::ALL.get(rest.parse::<usize>().ok()?)?;
            Some(Assumption::RuleLeftOut { rule })
        }
        kind @ ("m" | "c") => {
            let (name, cells) = rest.split_once('.')?;
            let numbers = numbers(cells)?;
            let (pairs, []) = numbers.as_chunks::<2>() else {
                return None;
            };
            Some(Assumption::MovingObstacle {
                name: unescape(name)?,
                path: pairs.iter().map(|&[x, y]| Cell::new(x, y)).collect(),
                closed: kind == "c",
            })
        }
        _ => None,
    }
}

/// An agent: its name, its cells, its battery.
pub fn write_agent(agent: &Agent) -> String {
    let mut text = escape(&agent.name);
    let mut add = |cell: Cell| {
        let _ = write!(text, ".{}.{}", cell.x, cell.y);
    };
    add(agent.start);
    match agent.goal {
        Some(goal) => add(goal),
        None => text += NO_GOAL,
    }
    for waypoint in &agent.waypoints {
        let _ = write!(text, ".{}.{}", waypoint.x, waypoint.y);
    }
    if let Some(battery) = agent.battery {
        let _ = write!(text, "!{}.{}", battery.capacity, battery.initial);
    }
    if let Some(heading) = agent.heading {
        let _ = write!(text, "*{}", heading as u8);
    }
    text
}

/// Reads a part of a scene; `None` where it is broken or unknown.
pub fn read(scene: &mut Scene, key: &str, value: &str) -> Option<()> {
    match key {
        "map" => {
            let (width, cells) = value.split_once('.')?;
            let width = width.parse::<usize>().ok().filter(|&width| width > 0)?;
            let most = (MAX_SIDE * MAX_SIDE) as usize;
            let cells = letters(cells, most)?;
            let cells = cells.iter().map(|letter| {
                let ground = GROUNDS.iter().find(|(own, _)| own == letter)?;
                Some(ground.1.to_char())
            });
            let cells: Vec<char> = cells.collect::<Option<_>>()?;
            scene.map = cells
                .chunks(width)
                .map(|row| row.iter().collect())
                .collect();
        }
        "name" => scene.name = unescape(value)?,
        "rules" => {
            let [leaves @ 0..=1, floor] = numbers(value)?[..] else {
                return None;
            };
            scene.rules.at_goal = if leaves == 1 {
                AtGoal::Vanish
            } else {
                AtGoal::Stay
            };
            scene.rules.battery_floor = floor;
        }
        "costs" => {
            let cost = |c: char| Cost::ALL.get(c.to_digit(10)? as usize).copied();
            let costs: Option<Vec<Cost>> = value.chars().map(cost).collect();
            scene.objective = Objective::new(costs?).ok()?;
        }
        "assumes" => {
            let assumptions = value.split(';').map(read_assumption);
            scene.assumptions = assumptions.collect::<Option<_>>()?;
        }
        "constraints" => (scene.zones, scene.constraints) = message::read(value)?,
        "units" => {
            let [cell, step] = numbers(value)?[..] else {
                return None;
            };
            scene.units = Some(Units {
                cell: Measure::from_thousandths(cell)?,
                step: Measure::from_thousandths(step)?,
            });
        }
        "agents" if value.is_empty() => {}
        "agents" => {
            let agents: Option<Vec<Agent>> = value.split(';').map(read_agent).collect();
            scene.agents = agents?;
        }
        _ => return None,
    }
    Some(())
}

/// Cells as pairs of numbers, all joined by points.
fn read_cells(text: &str) -> Option<Vec<Cell>> {
    let numbers = numbers(text)?;
    let (pairs, []) = numbers.as_chunks::<2>() else {
        return None;
    };
    Some(pairs.iter().map(|&[x, y]| Cell::new(x, y)).collect())
}

/// The agent that a text tells; `None` where it is none.
pub fn read_agent(text: &str) -> Option<Agent> {
    let (text, heading) = match text.split_once('*') {
        None => (text, None),
        Some((text, number)) => {
            let number: usize = number.parse().ok()?;
            (text, Some(*Heading::ALL.get(number)?))
        }
    };
    let (task, battery) = match text.split_once('!') {
        None => (text, None),
        Some((task, battery)) => {
            let [capacity, initial] = numbers(battery)?[..] else {
                return None;
            };
            (task, Some(Battery { capacity, initial }))
        }
    };
    let (name, cells) = task.split_once('.')?;
    let (start, goal, waypoints) = match cells.split_once(NO_GOAL) {
        Some((start, waypoints)) => {
            let [start] = read_cells(start)?[..] else {
                return None;
            };
            let waypoints = match waypoints.strip_prefix('.') {
                Some(waypoints) => read_cells(waypoints)?,
                None if waypoints.is_empty() => Vec::new(),
                None => return None,
            };
            (start, None, waypoints)
        }
        None => match read_cells(cells)?[..] {
            [start, goal, ref waypoints @ ..] => (start, Some(goal), waypoints.to_vec()),
            _ => return None,
        },
    };
    Some(Agent {
        name: unescape(name)?,
        start,
        goal,
        waypoints,
        battery,
        heading,
    })
}
