//! A scene with its rules, read from JSON.

use std::collections::{BTreeMap, BTreeSet};

use serde_json::Value;

/// A cell as a pair of numbers.
pub(super) type Spot = (i64, i64);

/// The largest number of a rule: for ever.
const FOREVER: i64 = 1_000_000;

/// An agent.
pub(super) struct RuleAgent {
    pub(super) start: Spot,
    pub(super) goal: Spot,
    pub(super) waypoints: BTreeSet<Spot>,
    /// Capacity and level at first.
    pub(super) battery: Option<(i64, i64)>,
    /// Clockwise from the north.
    pub(super) heading: Option<i64>,
    /// The only cells that it may go along, where it is held to some.
    pub(super) path: Option<Vec<Spot>>,
}

/// What a rule demands.
#[derive(Clone, Debug)]
pub(super) enum Kind {
    /// At most so many in the zone.
    Capacity(BTreeSet<Spot>, usize),
    /// Nobody in the zone.
    Closed(BTreeSet<Spot>),
    /// No move from one to the next of these.
    OneWay(Vec<(Spot, Spot)>),
    /// So many steps between agents at a cell.
    Gap(usize),
    /// So far from each other.
    Apart(i64),
    /// Cells in order.
    Sequence(Vec<Spot>),
    /// A stay.
    Visit(Spot, i64),
    /// Arrival within the times.
    Arrive,
    /// Late steps cost.
    Late(i64),
    /// No move before the first time.
    Depart,
    /// The first agent at its cell before the second at its own.
    Before((usize, Spot), (usize, Spot)),
    /// Wait steps on end in the zone.
    NoWaiting(BTreeSet<Spot>, i64),
    /// Steps for a quarter turn.
    Turns(i64),
    /// Times in the zone cost.
    Avoid(BTreeSet<Spot>, i64),
}

/// A rule in force.
#[derive(Clone, Debug)]
pub(super) struct OracleRule {
    pub(super) kind: Kind,
    /// The agents that it binds.
    pub(super) agents: Vec<usize>,
    pub(super) from: i64,
    pub(super) to: i64,
}

impl OracleRule {
    pub(super) fn is_about(&self, time: i64) -> bool {
        self.from <= time && time <= self.to
    }
}

/// A scene as the oracle sees it.
pub struct RuleScene {
    pub(super) free: BTreeSet<Spot>,
    pub(super) slow: BTreeSet<Spot>,
    pub(super) chargers: BTreeSet<Spot>,
    pub(super) vanish: bool,
    pub(super) floor: i64,
    pub(super) agents: Vec<RuleAgent>,
    pub(super) rules: Vec<OracleRule>,
    /// The objective, the penalty last where it is in force and not named.
    pub objective: Vec<String>,
    /// The last time that a rule names.
    pub(super) last: i64,
}

pub(super) fn spot(value: &Value) -> Spot {
    (value[0].as_i64().unwrap(), value[1].as_i64().unwrap())
}

fn spots(value: &Value) -> Vec<Spot> {
    value.as_array().into_iter().flatten().map(spot).collect()
}

fn zone(value: &Value) -> BTreeSet<Spot> {
    let Some(rect) = value["rect"].as_array() else {
        return spots(&value["cells"]).into_iter().collect();
    };
    let corner: Vec<i64> = rect.iter().map(|n| n.as_i64().unwrap()).collect();
    let rows = corner[1]..=corner[3];
    rows.flat_map(|y| (corner[0]..=corner[2]).map(move |x| (x, y)))
        .collect()
}

impl RuleScene {
    /// Reads a scene; the rules of these numbers are left out.
    ///
    /// # Panics
    /// When the text is no scene.
    pub fn read(text: &str, off: &[usize]) -> Self {
        let json: Value = serde_json::from_str(text).unwrap();
        let mut cells: BTreeMap<Spot, char> = BTreeMap::new();
        for (y, row) in (0..).zip(json["map"].as_array().unwrap()) {
            for (x, c) in (0..).zip(row.as_str().unwrap().chars()) {
                cells.insert((x, y), c);
            }
        }
        let of = |kinds: &str| -> BTreeSet<Spot> {
            let those = cells.iter().filter(|(_, c)| kinds.contains(**c));
            those.map(|(&spot, _)| spot).collect()
        };
        let directions = ["north", "east", "south", "west"];
        let agent = |agent: &Value| RuleAgent {
            start: spot(&agent["start"]),
            goal: spot(&agent["goal"]),
            waypoints: spots(&agent["waypoints"]).into_iter().collect(),
            battery: agent["battery"]["capacity"]
                .as_i64()
                .map(|capacity| (capacity, agent["battery"]["initial"].as_i64().unwrap())),
            heading: (0..)
                .zip(directions)
                .find(|(_, name)| agent["heading"] == *name)
                .map(|(number, _)| number),
            path: None,
        };
        let agents = json["agents"].as_array().unwrap();
        let names: Vec<&str> = agents.iter().map(|a| a["name"].as_str().unwrap()).collect();
        let zones = json["zones"].as_array().into_iter().flatten();
        let zones: BTreeMap<&str, BTreeSet<Spot>> = zones
            .map(|it| (it["name"].as_str().unwrap(), zone(it)))
            .collect();
        let constraints = json["constraints"].as_array().into_iter().flatten();
        let in_force = constraints
            .enumerate()
            .filter(|(i, it)| it["off"] != true && !off.contains(i));
        let rules: Vec<OracleRule> = in_force.map(|(_, it)| rule(it, &names, &zones)).collect();
        let mut objective: Vec<String> = match json["objective"].as_array() {
            Some(costs) => costs.iter().map(|c| c.as_str().unwrap().into()).collect(),
            None => ["makespan", "sum-of-costs", "charges"]
                .map(String::from)
                .into(),
        };
        let is_penalty = |rule: &OracleRule| matches!(rule.kind, Kind::Late(_) | Kind::Avoid(..));
        if rules.iter().any(is_penalty) && !objective.iter().any(|cost| cost == "penalty") {
            objective.push("penalty".into());
        }
        let named = rules.iter().flat_map(|rule| [rule.from, rule.to]);
        Self {
            free: of(".~+*"),
            slow: of("~*"),
            chargers: of("+*"),
            vanish: json["rules"]["at_goal"] == "vanish",
            floor: json["rules"]["battery_floor"].as_i64().unwrap_or(0),
            agents: agents.iter().map(agent).collect(),
            objective,
            last: named.filter(|&time| time < FOREVER).max().unwrap_or(0),
            rules,
        }
    }
}

fn rule(json: &Value, names: &[&str], zones: &BTreeMap<&str, BTreeSet<Spot>>) -> OracleRule {
    let number = |name: &Value| names.iter().position(|other| *name == **other).unwrap();
    let int = |key: &str| json[key].as_i64();
    let count = |key: &str| usize::try_from(json[key].as_u64().unwrap()).unwrap();
    let zone = || zones[json["zone"].as_str().unwrap()].clone();
    let visit = |key: &str| (number(&json[key]["agent"]), spot(&json[key]["cell"]));
    let mut agents: Vec<usize> = match json["agents"].as_array() {
        Some(list) => list.iter().map(number).collect(),
        None => (0..names.len()).collect(),
    };
    let (mut from, mut to) = (int("from").unwrap_or(0), int("to").unwrap_or(FOREVER));
    let kind = match json["kind"].as_str().unwrap() {
        "capacity" => Kind::Capacity(zone(), count("most")),
        "closed" => Kind::Closed(zone()),
        "one-way" => {
            let lane = spots(&json["lane"]);
            Kind::OneWay(lane.windows(2).map(|pair| (pair[1], pair[0])).collect())
        }
        "gap" => Kind::Gap(count("steps")),
        "apart" => Kind::Apart(int("distance").unwrap()),
        "sequence" => {
            agents = vec![number(&json["agent"])];
            Kind::Sequence(spots(&json["cells"]))
        }
        "visit" => Kind::Visit(spot(&json["cell"]), int("stay").unwrap_or(0)),
        "arrive" if int("weight").is_some() => {
            (from, to) = (int("by").unwrap(), int("by").unwrap());
            Kind::Late(int("weight").unwrap())
        }
        "arrive" => {
            to = int("by").unwrap_or(FOREVER);
            Kind::Arrive
        }
        "depart" => Kind::Depart,
        "before" => {
            let (first, second) = (visit("first"), visit("second"));
            agents = vec![first.0, second.0];
            Kind::Before(first, second)
        }
        "no-waiting" => Kind::NoWaiting(zone(), int("most").unwrap_or(0)),
        "turns" => Kind::Turns(int("quarter").unwrap()),
        "avoid" => Kind::Avoid(zone(), int("weight").unwrap()),
        other => panic!("no rule is called {other}"),
    };
    from = from.max(0);
    OracleRule {
        kind,
        agents,
        from,
        to,
    }
}
