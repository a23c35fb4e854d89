//! Random walks made scenes with plans: goals, way-points, batteries, rules, changes.

use std::collections::BTreeMap;

use giveway_model::change::{Change, Changes, What};
use giveway_model::check::check_changes;
use giveway_model::{
    Agent, AtGoal, Battery, Cell, Constraint, Grid, Ground, Instance, Plan, Rules, Scene, Version,
};
use rand::RngExt as _;
use rand::seq::{IndexedRandom as _, SliceRandom as _};
use rand_chacha::ChaCha8Rng;

use crate::walks::{Walk, walk};

/// A scene with a plan, and what changes while it runs.
#[derive(Clone, Debug)]
pub(crate) struct Case {
    pub(crate) scene: Scene,
    pub(crate) changes: Changes,
    pub(crate) plan: Plan,
}

/// A random case, which may break a rule; `None` where the walks got stuck.
pub(crate) fn random(rng: &mut ChaCha8Rng) -> Option<Case> {
    let rows = map(rng);
    let grid = Grid::from_rows(&rows).ok()?;
    let mut cells: Vec<Cell> = grid.cells().map(|(cell, _)| cell).collect();
    cells.retain(|&cell| grid.is_vertex(cell));
    let most = (cells.len() * 3 / 4).min(9);
    let robots = rng.random_range(1..=most.max(1));
    let last = rng.random_range(3..=18);
    let vanish = rng.random_bool(0.4);
    let changing = rng.random_bool(0.5);
    let mut changes = Vec::new();
    if changing && rng.random_bool(0.5) {
        let at = rng.random_range(1..=last);
        let some: Vec<Cell> = cells
            .iter()
            .copied()
            .filter(|_| rng.random_bool(0.4))
            .collect();
        let what = if rng.random_bool(0.6) {
            What::SetSlow { cells: some }
        } else {
            let slow = some.into_iter().filter(|&cell| grid.is_slow(cell));
            What::SetNormal {
                cells: slow.collect(),
            }
        };
        changes.push(Change { at, what });
    }
    let first = grid.clone();
    let paved = changes.clone();
    let at = move |time: u32| {
        let mut grid = first.clone();
        for change in paved.iter().filter(|it| it.at <= time) {
            let (What::SetSlow { cells } | What::SetNormal { cells }) = &change.what else {
                continue;
            };
            let slow = matches!(change.what, What::SetSlow { .. });
            grid.change(|cell, ground| {
                if cells.contains(&cell) {
                    paved_as(ground, slow)
                } else {
                    ground
                }
            });
        }
        grid
    };
    let mut walks: Vec<Walk> = (0..robots)
        .map(|_| Walk {
            from: if changing && rng.random_bool(0.15) {
                rng.random_range(1..=last)
            } else {
                0
            },
            until: None,
            ends: vanish.then(|| rng.random_range(0..=last)),
            path: Vec::new(),
        })
        .collect();
    for walk in &mut walks {
        if let Some(ends) = &mut walk.ends {
            *ends = (*ends).max(walk.from);
        }
        if changing && rng.random_bool(0.15) {
            walk.until = Some(rng.random_range(walk.from + 1..=last + 2));
            walk.ends = None;
        }
    }
    walk(&mut walks, &at, last, rng)?;
    dressed(&rows, walks, changes, (vanish, changing), rng)
}

/// The ground in the slow zone or out of it.
fn paved_as(ground: Ground, slow: bool) -> Ground {
    let paved = match (ground.to_char(), slow) {
        ('.', true) => '~',
        ('+', true) => '*',
        ('~', false) => '.',
        ('*', false) => '+',
        (same, _) => same,
    };
    Ground::from_char(paved).unwrap()
}

fn map(rng: &mut ChaCha8Rng) -> Vec<String> {
    let (width, height) = (rng.random_range(2..=6), rng.random_range(2..=5));
    let slow = if rng.random_bool(0.4) {
        rng.random_range(0.2..1.0)
    } else {
        0.0
    };
    let charge = if rng.random_bool(0.5) { 0.2 } else { 0.0 };
    let blocked = rng.random_range(0.0..0.25);
    let row = |rng: &mut ChaCha8Rng| {
        let cell = |_| {
            let (slow, charge) = (rng.random_bool(slow), rng.random_bool(charge));
            match (rng.random_bool(blocked), slow, charge) {
                (true, ..) => '#',
                (false, false, false) => '.',
                (false, true, false) => '~',
                (false, false, true) => '+',
                (false, true, true) => '*',
            }
        };
        (0..width).map(cell).collect()
    };
    (0..height).map(|_| row(rng)).collect()
}

fn dressed(
    rows: &[String],
    walks: Vec<Walk>,
    mut changes: Vec<Change>,
    (vanish, changing): (bool, bool),
    rng: &mut ChaCha8Rng,
) -> Option<Case> {
    let grid = Grid::from_rows(rows).ok()?;
    let mut scene = Scene {
        map: rows.to_vec(),
        rules: Rules {
            at_goal: if vanish { AtGoal::Vanish } else { AtGoal::Stay },
            battery_floor: rng.random_range(0..3),
        },
        ..Scene::default()
    };
    let mut plan = Plan::default();
    let mut free_goals: Vec<Cell> = grid.cells().map(|it| it.0).collect();
    let ends: Vec<Cell> = walks
        .iter()
        .filter_map(|it| it.path.last().copied().flatten())
        .collect();
    free_goals.retain(|it| grid.is_vertex(*it) && !ends.contains(it));
    free_goals.shuffle(rng);
    for (number, walk) in walks.into_iter().enumerate() {
        let name = format!("A{}", number + 1);
        let mut path = walk.path;
        let end = path.iter().rev().find_map(|it| *it)?;
        if walk.until.is_none() {
            // It arrives when it comes to rest.
            while matches!(path.as_slice(), [.., Some(a), Some(b)] if a == b) {
                path.pop();
            }
        }
        let mut agent = Agent::new(&name, (*path.first()?)?, Some(end));
        if !vanish && rng.random_bool(0.1) {
            agent.goal = None;
        }
        let seen: Vec<Cell> = path.iter().flatten().copied().collect();
        let waypoint = seen.choose(rng).filter(|_| rng.random_bool(0.3));
        agent.waypoints = waypoint.copied().into_iter().collect();
        if rng.random_bool(0.5) {
            battery(
                &mut agent,
                &path,
                &grid,
                walk.from,
                scene.rules.battery_floor,
                &mut plan,
                rng,
            );
        }
        if changing && walk.until.is_none() && rng.random_bool(0.15) && agent.goal.is_some() {
            let at = walk.from + rng.random_range(1..=path.len() as u32);
            if let Some(goal) = free_goals.pop() {
                agent.goal = Some(goal);
                let what = What::SetGoal {
                    agent: name.clone(),
                    cell: end,
                };
                changes.push(Change { at, what });
            }
        }
        if changing && rng.random_bool(0.2) {
            breakdown(&name, &path, walk.from, &mut changes, rng);
        }
        if let Some(until) = walk.until {
            plan.until.insert(name.clone(), until);
            let what = What::RemoveAgent {
                agent: name.clone(),
            };
            changes.push(Change { at: until, what });
        }
        if walk.from > 0 {
            plan.from.insert(name.clone(), walk.from);
            changes.push(Change {
                at: walk.from,
                what: What::AddAgent { agent },
            });
        } else {
            scene.agents.push(agent);
        }
        plan.paths.insert(name, path);
    }
    plan.knows = changes.iter().map(|it| it.at).max();
    let case = Case {
        scene,
        changes: Changes {
            giveway: Version,
            changes,
        },
        plan,
    };
    Some(ruled(case, rng))
}

/// A battery that just bears the path, with charges where it passes chargers.
fn battery(
    agent: &mut Agent,
    path: &[Option<Cell>],
    grid: &Grid,
    from: u32,
    floor: u32,
    plan: &mut Plan,
    rng: &mut ChaCha8Rng,
) {
    let arrival = path.len() - 1;
    let mut charges = Vec::new();
    let (mut legs, mut leg) = (Vec::new(), 0);
    for (time, entry) in path.iter().enumerate().take(arrival) {
        if entry.is_some_and(|cell| grid.is_charger(cell)) && rng.random_bool(0.5) {
            charges.push(from + time as u32);
            legs.push(leg);
            leg = 0;
        } else {
            leg += 1;
        }
    }
    legs.push(leg);
    let capacity = floor + legs.iter().max().unwrap() + rng.random_range(0..5);
    let initial = floor + legs[0] + rng.random_range(0..4);
    agent.battery = Some(Battery {
        capacity,
        initial: initial.min(capacity),
    });
    if !charges.is_empty() {
        plan.charges.insert(agent.name.clone(), charges);
    }
}

/// A breakdown where the path waits anyway.
fn breakdown(
    name: &str,
    path: &[Option<Cell>],
    from: u32,
    changes: &mut Vec<Change>,
    rng: &mut ChaCha8Rng,
) {
    let waits = (0..path.len().saturating_sub(1))
        .filter(|&it| path[it].is_some() && path[it] == path[it + 1]);
    let waits: Vec<usize> = waits.collect();
    if let Some(&at) = waits.choose(rng) {
        let length = (at..path.len())
            .take_while(|&it| path[it] == path[at])
            .count() as u32;
        let steps = rng.random_range(1..=length.max(2) - 1);
        let what = What::DelayAgent {
            agent: name.to_owned(),
            steps,
        };
        changes.push(Change {
            at: from + at as u32,
            what,
        });
    }
}

/// With rules that the plan keeps anyway.
fn ruled(case: Case, rng: &mut ChaCha8Rng) -> Case {
    let names: Vec<String> = case.plan.paths.keys().cloned().collect();
    let mut tried = case.clone();
    let some = |rng: &mut ChaCha8Rng, n| {
        let chosen: Vec<&String> = names.sample(rng, n).collect();
        format!("{chosen:?}")
    };
    let rules: BTreeMap<u32, String> = [
        format!(
            r#"{{ "kind": "gap", "steps": {}, "agents": {} }}"#,
            rng.random_range(1..3),
            some(rng, 2)
        ),
        format!(
            r#"{{ "kind": "turns", "quarter": 1, "agents": {} }}"#,
            some(rng, 1)
        ),
        format!(
            r#"{{ "kind": "gap", "steps": 1, "agents": {} }}"#,
            some(rng, 3)
        ),
        r#"{ "kind": "turns", "quarter": 1 }"#.to_owned(),
    ]
    .into_iter()
    .zip(0..)
    .map(|(rule, number)| (number, rule))
    .collect();
    let Some(text) = rules.get(&rng.random_range(0..6)) else {
        return case;
    };
    let rule: Constraint = serde_json::from_str(text).unwrap();
    tried.scene.constraints.push(rule);
    let valid = Instance::new(tried.scene.clone()).is_ok_and(|instance| {
        check_changes(&instance, &tried.changes, &tried.plan).is_ok_and(|it| it.is_valid())
    });
    if valid { tried } else { case }
}
