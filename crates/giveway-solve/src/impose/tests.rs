//! Any two conditions at once, against all plans, each judged.

use std::collections::BTreeMap;
use std::rc::Rc;

use giveway_model::condition::{Act, Condition, Times, Visit};
use giveway_model::{Cell, Cost, Instance, Objective, Path, Plan, check::check};

use crate::{
    Limits, SilentHost, Status,
    budget::Budget,
    explain::ask::{Ask, best},
    problem::Relaxed,
    tests::instance,
};

/// All paths of an agent that arrive by a horizon, most of them legal.
fn paths(instance: &Instance, agent: usize, horizon: usize) -> Vec<Path> {
    let (grid, agent) = (instance.grid(), &instance.agents()[agent]);
    let mut paths = Vec::new();
    let mut open: Vec<Path> = vec![vec![Some(agent.start)]];
    while let Some(path) = open.pop() {
        let here = path[path.len() - 1].unwrap();
        let arrives = Some(here) == agent.goal
            && path.len().checked_sub(2).map(|t| path[t]) != Some(Some(here));
        if arrives {
            paths.push(path.clone());
        }
        for (there, _) in grid.cells().filter(|&(cell, _)| grid.is_vertex(cell)) {
            let mut longer = path.clone();
            if here.touches(there) && grid.is_slow_edge(here, there) {
                longer.push(None);
            }
            if here == there || here.touches(there) {
                longer.push(Some(there));
                open.extend((longer.len() <= horizon + 1).then_some(longer));
            }
        }
    }
    paths
}

/// All ways to charge on a path.
fn charges(instance: &Instance, path: &Path) -> Vec<Vec<u32>> {
    let at_charger =
        |entry: &Option<Cell>| entry.is_some_and(|cell| instance.grid().is_charger(cell));
    let times = (0..path.len() - 1).filter(|&time| at_charger(&path[time]));
    times.fold(vec![Vec::new()], |mut all, time| {
        let with = |charges: &Vec<u32>| charges.iter().copied().chain([time as u32]).collect();
        let more: Vec<Vec<u32>> = all.iter().map(with).collect();
        all.extend(more);
        all
    })
}

/// All plans that arrive by a horizon.
fn plans(instance: &Instance, horizon: usize) -> Vec<Plan> {
    let mut plans = vec![Plan::default()];
    for (index, agent) in instance.agents().iter().enumerate() {
        let mut longer = Vec::new();
        for path in paths(instance, index, horizon) {
            let ways = match agent.battery {
                Some(_) => charges(instance, &path),
                None => vec![Vec::new()],
            };
            for (way, plan) in ways
                .iter()
                .flat_map(|way| plans.iter().map(move |it| (way, it)))
            {
                let mut plan = plan.clone();
                plan.paths.insert(agent.name.clone(), path.clone());
                if !way.is_empty() {
                    plan.charges.insert(agent.name.clone(), way.clone());
                }
                longer.push(plan);
            }
        }
        plans = longer;
    }
    plans.retain(|plan| check(instance, plan).is_valid());
    plans
}

/// Searches with any two of the conditions, with the joint states and without, and
/// compares each answer with the best of all plans that meet both. How many pairs no
/// plan meets.
fn compare(instance: &Instance, conditions: &[Condition], horizon: u32) -> [usize; 2] {
    let objective: Objective = "makespan,moves,charges,waits".parse().unwrap();
    let all = plans(instance, horizon as usize);
    let meets = |condition: &Condition| -> Vec<bool> {
        let holds = |plan| condition.holds(instance, plan).unwrap();
        all.iter().map(holds).collect()
    };
    let met: Vec<Vec<bool>> = conditions.iter().map(meets).collect();
    let costs = |plan: &Plan| check(instance, plan).costs.unwrap().vector(&objective);
    let costs: Vec<Vec<u32>> = all.iter().map(costs).collect();
    let mut seen = [0; 2];
    for one in 0..conditions.len() {
        for other in one..conditions.len() {
            let both = (0..all.len()).filter(|&plan| met[one][plan] && met[other][plan]);
            let expected = both.map(|plan| &costs[plan]).min();
            seen[usize::from(expected.is_none())] += 1;
            let asked = [conditions[one].clone(), conditions[other].clone()];
            for joint_steps in [0, u64::MAX] {
                let budget = Budget::new(&SilentHost, Limits::default());
                let budget = Rc::new(budget.with_work(u64::MAX, joint_steps));
                let found = best(
                    &Ask {
                        instance,
                        relaxed: &Relaxed::default(),
                        conditions: &asked,
                        objective: &objective,
                        caps: &BTreeMap::new(),
                        within: Some(horizon),
                        at_least_within: 0,
                    },
                    &budget,
                );
                // (Without a limit on the horizon there may be plans beyond it.)
                let within = found.costs.filter(|costs| costs.makespan <= horizon);
                let found = (found.status, within.map(|costs| costs.vector(&objective)));
                let status = match expected {
                    Some(_) => Status::Optimal,
                    None => Status::Impossible,
                };
                assert_eq!(
                    found,
                    (status, expected.cloned()),
                    "{joint_steps} {asked:?}"
                );
            }
        }
    }
    seen
}

fn between(from: u32, to: u32) -> Times {
    Times {
        from: Some(from),
        to: Some(to),
    }
}

fn never(act: Act, times: Times) -> Condition {
    Condition::Never {
        agent: "a".to_owned(),
        act,
        times,
    }
}

fn visit(agent: &str, cell: Cell) -> Visit {
    Visit {
        agent: agent.to_owned(),
        cell,
    }
}

fn below(agent: Option<&str>, cost: Cost, limit: u32) -> Condition {
    Condition::Below {
        agent: agent.map(str::to_owned),
        cost,
        limit,
    }
}

fn wait(cell: Option<Cell>, steps: u32) -> Act {
    Act::Wait { cell, steps }
}

#[test]
fn any_two_conditions_on_one_agent() {
    let instance = instance(
        "a . +
         ~ ~ A
         battery a 4/4",
    );
    let always = Times::default();
    let (start, middle, charger) = (Cell::new(0, 0), Cell::new(1, 0), Cell::new(2, 0));
    let (slow, goal) = (Cell::new(0, 1), Cell::new(2, 1));
    let a = || "a".to_owned();
    let go = |from, to, times| Condition::Move {
        agent: a(),
        from,
        to,
        times,
    };
    let conditions = [
        never(Act::Visit(middle), always),
        never(Act::Visit(middle), between(1, 2)),
        never(Act::Visit(goal), Times::at(Some(4))),
        never(Act::Move(start, middle), always),
        never(Act::Move(middle, charger), Times::at(Some(1))),
        never(Act::SlowMove(None), always),
        never(wait(None, 1), between(0, 3)),
        never(wait(None, 1), always),
        never(wait(Some(start), 2), always),
        never(wait(None, 2), between(1, 5)),
        never(Act::Charge(None), always),
        never(Act::Charge(Some(charger)), Times::at(Some(2))),
        go(middle, start, always),
        go(start, middle, Times::at(Some(2))),
        go(start, middle, between(1, 3)),
        Condition::Visit {
            agent: Some(a()),
            cell: slow,
        },
        Condition::Charge {
            agent: a(),
            cell: charger,
        },
        Condition::Before {
            first: visit("a", slow),
            second: visit("a", middle),
        },
        below(Some("a"), Cost::Makespan, 5),
        below(Some("a"), Cost::Moves, 5),
        below(Some("a"), Cost::Waits, 2),
        below(None, Cost::Charges, 1),
    ];
    let [met, unmet] = compare(&instance, &conditions, 7);
    assert!(met > 100 && unmet > 20, "{met} {unmet}");
}

#[test]
fn any_two_conditions_on_two_agents() {
    let instance = instance(
        "a . B
         b . A",
    );
    let cells = [Cell::new(1, 0), Cell::new(1, 1)];
    let first = |one: &str, other: &str, cell: Cell, later: Cell| Condition::Before {
        first: visit(one, cell),
        second: visit(other, later),
    };
    let conditions = [
        first("a", "b", cells[0], cells[0]),
        first("a", "b", cells[1], cells[1]),
        first("b", "a", cells[0], cells[0]),
        first("b", "a", cells[1], cells[0]),
        first("b", "b", cells[0], cells[1]),
        never(Act::Visit(cells[0]), Times::default()),
        never(wait(None, 1), Times::default()),
        never(wait(None, 2), Times::default()),
        below(Some("a"), Cost::Makespan, 4),
        below(Some("b"), Cost::Moves, 4),
        below(None, Cost::Waits, 1),
        below(None, Cost::SumOfCosts, 7),
    ];
    let [met, unmet] = compare(&instance, &conditions, 5);
    assert!(met > 30 && unmet > 5, "{met} {unmet}");
}
