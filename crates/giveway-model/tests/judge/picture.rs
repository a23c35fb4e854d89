//! Instances and plans drawn in a few lines.
//!
//! The map is drawn as in files. Each further line is an agent and its path:
//!
//! ```text
//! A 00 10 20+ .. 30 | to 40, via 10 20, battery 8/10
//! rules vanish, floor 1
//! ```
//!
//! `20` is the cell (2, 0), `..` is in transit, `+` after a cell is a charge at
//! that time. The start is the first cell and the goal the last, unless `from`
//! and `to` say otherwise; a battery is its initial level and its capacity.
//!
//! A violation is written as `3 vertex A B 20`: time, rule, agents, and the
//! cell or the edge (`10-20`), where there is one.

use giveway_model::change::Changes;
use giveway_model::check::{Violation, check as judge, check_changes};
use giveway_model::{Agent, AtGoal, Battery, Cell, Costs, Instance, Plan, Rules, Scene};

/// Judges a drawn plan and compares the violations, one a line.
#[track_caller]
pub(crate) fn check(map: &str, plan: &str, expected: &str) {
    let (instance, plan) = read(map, plan);
    let report = judge(&instance, &plan);
    if plan.from.is_empty() && plan.until.is_empty() {
        // Where nothing changes, the judge of changes is of the same mind.
        let other = check_changes(&instance, &Changes::default(), &plan);
        assert_eq!(other.as_ref(), Ok(&report));
    }
    let found: Vec<String> = report.violations.iter().map(line).collect();
    let expected: Vec<&str> = rows(expected).collect();
    assert_eq!(found, expected);
    for violation in &report.violations {
        assert!(violation.message.ends_with('.'), "{}", violation.message);
        for agent in &violation.agents {
            assert!(violation.message.contains(agent), "{}", violation.message);
        }
    }
}

/// The costs of a drawn plan that must be valid: makespan, sum of costs,
/// charges, moves, waits.
#[track_caller]
pub(crate) fn check_costs(map: &str, plan: &str, expected: [u32; 5]) {
    let (instance, plan) = read(map, plan);
    let report = judge(&instance, &plan);
    assert_eq!(report.violations, []);
    let other = check_changes(&instance, &Changes::default(), &plan);
    assert_eq!(other.as_ref(), Ok(&report));
    let [makespan, sum_of_costs, charges, moves, waits] = expected;
    let expected = Costs {
        makespan,
        sum_of_costs,
        charges,
        moves,
        waits,
        penalty: 0,
    };
    assert_eq!(report.costs, Some(expected));
}

/// The instance and the plan of a drawing.
pub(crate) fn read(map: &str, plan: &str) -> (Instance, Plan) {
    let mut scene = Scene {
        map: rows(map).map(str::to_owned).collect(),
        ..Scene::default()
    };
    let mut paths = Plan::default();
    for row in rows(plan) {
        match row.strip_prefix("rules ") {
            Some(rules) => scene.rules = read_rules(rules),
            None => scene.agents.push(read_agent(row, &mut paths)),
        }
    }
    (Instance::new(scene).unwrap(), paths)
}

fn read_rules(text: &str) -> Rules {
    let mut rules = Rules::default();
    for word in text.split(", ") {
        match word.split_once(' ') {
            None if word == "vanish" => rules.at_goal = AtGoal::Vanish,
            Some(("floor", level)) => rules.battery_floor = level.parse().unwrap(),
            _ => panic!("no rule: {word}"),
        }
    }
    rules
}

fn read_agent(row: &str, plan: &mut Plan) -> Agent {
    let (path, options) = row.split_once('|').unwrap_or((row, ""));
    let mut words = path.split_whitespace();
    let name = words.next().unwrap().to_owned();
    let mut cells = Vec::new();
    let mut charges = Vec::new();
    for (time, word) in words.enumerate() {
        if word.ends_with('+') {
            charges.push(u32::try_from(time).unwrap());
        }
        cells.push(cell(word.trim_end_matches('+')));
    }
    let mut agent = Agent {
        name: name.clone(),
        start: cells.first().copied().flatten().unwrap_or(Cell::new(0, 0)),
        goal: Some(cells.last().copied().flatten().unwrap_or(Cell::new(0, 0))),
        waypoints: Vec::new(),
        battery: None,
        heading: None,
    };
    for option in options.split(',').map(str::trim).filter(|o| !o.is_empty()) {
        let (key, value) = option.split_once(' ').unwrap();
        match key {
            "from" => agent.start = cell(value).unwrap(),
            "to" => agent.goal = cell(value),
            "via" => agent.waypoints = value.split(' ').map(|w| cell(w).unwrap()).collect(),
            "battery" => {
                let (initial, capacity) = value.split_once('/').unwrap();
                agent.battery = Some(Battery {
                    capacity: capacity.parse().unwrap(),
                    initial: initial.parse().unwrap(),
                });
            }
            _ => panic!("no option: {option}"),
        }
    }
    plan.paths.insert(name.clone(), cells);
    if !charges.is_empty() {
        plan.charges.insert(name, charges);
    }
    agent
}

fn cell(word: &str) -> Option<Cell> {
    if word == ".." {
        return None;
    }
    let mut digits = word.chars().map(|c| c.to_digit(10).unwrap());
    Some(Cell::new(digits.next().unwrap(), digits.next().unwrap()))
}

fn rows(text: &str) -> impl Iterator<Item = &str> {
    text.lines().map(str::trim).filter(|row| !row.is_empty())
}

/// A violation on one line.
pub(crate) fn line(violation: &Violation) -> String {
    let digits = |cell: Cell| format!("{}{}", cell.x, cell.y);
    let mut words = vec![
        violation.time.to_string(),
        violation.rule.name().to_owned(),
        violation.agents.join(" "),
    ];
    words.extend(violation.cell.map(digits));
    words.extend(
        violation
            .edge
            .map(|[u, v]| format!("{}-{}", digits(u), digits(v))),
    );
    words.join(" ")
}
