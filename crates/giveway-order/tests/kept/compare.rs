//! What the graph says, beside what the simulation does.

use std::collections::BTreeMap;

use giveway_model::change::Changes;
use giveway_model::check::Rule;
use giveway_model::{Instance, Plan};
use giveway_order::{Lateness, Order, OrderGraph, Outcome, Visit, vda5050};
use rand::RngExt as _;
use rand::seq::IteratorRandom as _;
use rand_chacha::ChaCha8Rng;
use serde_json::{Value, json};

use crate::dress::Case;
use crate::simulate::World;

/// What the plans had.
#[derive(Debug, Default)]
pub(crate) struct Tally {
    pub(crate) plans: u32,
    pub(crate) none: u32,
    links: u32,
    without_slack: u32,
    rotations: u32,
    slow_rotations: u32,
    shifted: u32,
    vanish: u32,
    changed: u32,
    added: u32,
    removed: u32,
    batteries: u32,
    ruled: u32,
    pushed: u32,
    flat: u32,
    refused: u32,
}

impl Tally {
    pub(crate) fn count(&mut self, case: &Case, order: &Order) {
        self.links += order.links.len() as u32;
        self.without_slack += order.without_slack() as u32;
        self.rotations += order.rotations.len() as u32;
        let slow = order.rotations.iter().filter(|it| {
            let first = &it.moves[0];
            let agent = order.agent(&first.agent).unwrap();
            agent
                .visits
                .get(first.visit as usize)
                .is_some_and(Visit::is_slow)
        });
        self.slow_rotations += slow.count() as u32;
        self.shifted += u32::from(!order.later.is_empty());
        self.vanish += u32::from(case.scene.rules.at_goal == giveway_model::AtGoal::Vanish);
        self.changed += u32::from(!case.changes.changes.is_empty());
        self.added += case.plan.from.len() as u32;
        self.removed += case.plan.until.len() as u32;
        self.batteries += case
            .scene
            .agents
            .iter()
            .filter(|it| it.battery.is_some())
            .count() as u32;
        self.ruled += u32::from(!case.scene.constraints.is_empty());
    }

    /// Every kind is among many plans.
    pub(crate) fn has_all(&self) {
        if self.plans < 300 {
            return;
        }
        for (name, count) in [
            ("links", self.links),
            ("rotations", self.rotations),
            ("slow rotations", self.slow_rotations),
            ("plans that would wait for themselves", self.none),
            ("shifted", self.shifted),
            ("vanish", self.vanish),
            ("changed", self.changed),
            ("added", self.added),
            ("removed", self.removed),
            ("batteries", self.batteries),
            ("ruled", self.ruled),
            ("pushed", self.pushed),
            ("flat", self.flat),
        ] {
            assert!(count > 0, "no {name}");
        }
    }
}

/// When each event begins in the order, by robot.
fn times(order: &Order, world: &World<'_>) -> Vec<Vec<i64>> {
    let robots = world.robots.iter().map(|robot| {
        let agent = order.agent(&robot.name).unwrap();
        assert_eq!(agent.visits.len(), robot.visits.len());
        let mut times: Vec<i64> = agent
            .visits
            .iter()
            .map(|it| it.comes.map_or(i64::from(it.arrives) - 1, i64::from))
            .collect();
        if robot.leaves {
            times.push(i64::from(agent.visits.last().unwrap().leaves.unwrap()));
        }
        times
    });
    robots.collect()
}

/// Trailing rests are cut and empty lists left out.
fn tidy(plan: &Plan) -> Plan {
    let mut plan = plan.clone();
    for path in plan.paths.values_mut() {
        while matches!(path.as_slice(), [.., a, b] if a == b && a.is_some()) {
            path.pop();
        }
    }
    plan.charges.retain(|_, it| !it.is_empty());
    plan
}

pub(crate) fn without_lateness(
    seed: u64,
    case: &Case,
    world: &World<'_>,
    (graph, order): (&OrderGraph<'_>, &Order),
    instance: &Instance,
) {
    // The links are those of the plan: from one robot to the next in a cell, and where a rule
    // `gap` says more.
    let number = |name: &str| world.robots.iter().position(|it| it.name == name).unwrap();
    let mut direct = 0;
    for link in &order.links {
        let second = (number(&link.second.agent), link.second.visit as usize);
        let first = (
            number(&link.first.agent),
            link.first.visit as usize,
            i64::from(link.gap),
        );
        let all = &world.links[&second];
        assert!(all.contains(&first), "seed {seed}");
        assert!(all[0] == first || link.gap > 0, "seed {seed}");
        direct += usize::from(all[0] == first);
        assert_eq!(
            link.second.time - link.first.time,
            link.slack + link.gap,
            "seed {seed}"
        );
    }
    // Not where it comes again after itself.
    let mut expected = 0;
    for (&(robot, visit), all) in &world.links {
        let (other, left, _) = all[0];
        let own = &world.robots[robot].visits;
        let between = world.robots[other].visits[left].1;
        let mut before = own[..visit].iter();
        expected += usize::from(!before.any(|it| it.0 == own[visit].0 && it.1 > between));
    }
    assert_eq!(direct, expected, "seed {seed}");
    let of_plan: Vec<Vec<i64>> = world
        .robots
        .iter()
        .map(|robot| {
            let first = [robot.visits[0].1 - 1].into_iter();
            let mut times: Vec<i64> = first.chain(robot.visits.iter().map(|it| it.2)).collect();
            times.truncate(robot.events());
            times
        })
        .collect();
    let run = world.run(2000, &mut |robot, event, time| {
        time >= of_plan[robot][event]
    });
    assert_eq!(run.collision, None, "seed {seed}");
    assert!(run.done, "seed {seed}");
    let order_times = times(order, world);
    for (robot, begins) in run.begins.iter().enumerate() {
        for (event, begin) in begins.iter().enumerate() {
            if let Some(begin) = begin {
                assert_eq!(
                    *begin, order_times[robot][event],
                    "seed {seed}: {robot} {event}"
                );
            }
        }
    }
    // Only a slow move that begins before its end is left begins later.
    let early = world.links.iter().any(|(&(robot, visit), all)| {
        all.iter()
            .any(|&(other, left, _)| of_plan[robot][visit] < of_plan[other][left + 1])
    });
    assert_eq!(early, !order.later.is_empty(), "seed {seed}");
    if !early {
        assert_eq!(order_times, of_plan, "seed {seed}");
        let outcome = graph.late(instance, &[]).unwrap();
        assert_eq!(tidy(&outcome.plan), tidy(&case.plan), "seed {seed}");
        assert_eq!(
            (outcome.violations, outcome.refused),
            (vec![], vec![]),
            "seed {seed}"
        );
        assert!(outcome.visits.is_empty());
    }
}

/// Robots without clocks that stop now and then: no collision, no deadlock.
pub(crate) fn stalled(seed: u64, world: &World<'_>, rng: &mut ChaCha8Rng) {
    let lazy: Vec<f64> = world
        .robots
        .iter()
        .map(|_| rng.random_range(0.0..0.9))
        .collect();
    let run = world.run(20_000, &mut |robot, _, _| !rng.random_bool(lazy[robot]));
    assert_eq!(run.collision, None, "seed {seed}");
    assert!(run.done, "seed {seed}: they wait for ever");
}

/// Random latenesses: of a few visits, or of all.
pub(crate) fn latenesses(order: &Order, rng: &mut ChaCha8Rng) -> Vec<Lateness> {
    let mut all = Vec::new();
    for agent in &order.agents {
        for (number, it) in agent.visits.iter().enumerate() {
            let before = agent
                .visits
                .iter()
                .take(number + 1)
                .filter(|one| one.cell == it.cell);
            all.push(Lateness {
                agent: agent.agent.clone(),
                cell: it.cell,
                visit: before.count() as u32,
                steps: rng.random_range(0..6),
            });
        }
    }
    if rng.random_bool(0.3) {
        return all;
    }
    let few = rng.random_range(1..=3);
    all.into_iter().sample(rng, few)
}

pub(crate) fn late(
    seed: u64,
    case: &Case,
    world: &World<'_>,
    (order, outcome): (&Order, &Outcome),
    tally: &mut Tally,
) {
    let mut release = times(order, world);
    for late in &outcome.late {
        let robot = world
            .robots
            .iter()
            .position(|it| it.name == late.agent)
            .unwrap();
        let visits = world.robots[robot].visits.iter().enumerate();
        let mut visits = visits.filter(|it| it.1.0 == late.cell);
        let (visit, _) = visits.nth(late.visit as usize - 1).unwrap();
        release[robot][visit] += i64::from(late.steps);
    }
    let run = world.run(5000, &mut |robot, event, time| {
        // One that is late at its start stands there, and goes on later.
        let ready = event != 1 || world.robots[robot].from > 0 || time > release[robot][0];
        let ready = ready && turned(order, world, robot, event, time, &release);
        ready && time >= release[robot][event]
    });
    assert_eq!(run.collision, None, "seed {seed}");
    assert!(run.done, "seed {seed}");
    let mut pushed = Vec::new();
    for (number, robot) in world.robots.iter().enumerate() {
        let arrival = &outcome.arrivals[number];
        assert_eq!(arrival.agent, robot.name);
        let agent = order.agent(&robot.name).unwrap();
        let first = (robot.from == 0).then_some(release[number][0] + 1);
        let mut most = 0;
        for (visit, it) in run.arrives[number].iter().enumerate() {
            let now = if visit == 0 { first.or(*it) } else { *it };
            let now = now.filter(|now| robot.until.is_none_or(|until| *now < until));
            if let Some(now) = now {
                most = most.max(now - i64::from(agent.visits[visit].arrives));
            }
            let said = outcome
                .visits
                .iter()
                .find(|one| one.agent == robot.name && one.visit as usize == visit);
            let said = said.map(|one| i64::from(one.now));
            let later = now.filter(|now| *now > i64::from(agent.visits[visit].arrives));
            assert_eq!(said, later, "seed {seed}: {} {visit}", robot.name);
        }
        assert_eq!(i64::from(arrival.most), most, "seed {seed}: {}", robot.name);
        if most > 0 && !outcome.late.iter().any(|it| it.agent == robot.name) {
            pushed.push(robot.name.as_str());
        }
        for (time, cell) in (outcome.plan.from.get(&robot.name).copied().unwrap_or(0)..)
            .zip(&outcome.plan.paths[&robot.name])
        {
            let there = run.cells[number].get(time as usize).copied().flatten();
            let ended = time as usize >= run.cells[number].len();
            assert!(
                ended || there == *cell,
                "seed {seed}: {} at {time}",
                robot.name
            );
        }
    }
    let said: Vec<&str> = outcome.pushed().map(|it| it.agent.as_str()).collect();
    assert_eq!(said, pushed, "seed {seed}");
    tally.pushed += u32::from(!pushed.is_empty());
    tally.refused += u32::from(!outcome.refused.is_empty());
    let changed = case.changes != Changes::default();
    for violation in &outcome.violations {
        let may = match violation.rule {
            Rule::Battery => true,
            Rule::Obstacle | Rule::Charge | Rule::Constraint => changed,
            Rule::Shape => world.robots.iter().any(|it| it.until.is_some()),
            _ => false,
        };
        assert!(may, "seed {seed}: {violation:?}");
    }
    if !changed {
        let flat = outcome.violations.iter().any(|it| it.rule == Rule::Battery);
        assert_eq!(flat, runs_flat(case, &outcome.plan), "seed {seed}");
        tally.flat += u32::from(flat);
    }
}

/// Whether a robot has turned since it was ready at its start.
fn turned(
    order: &Order,
    world: &World<'_>,
    robot: usize,
    event: usize,
    time: i64,
    release: &[Vec<i64>],
) -> bool {
    let robot_order = order.agent(&world.robots[robot].name).unwrap();
    event != 1 || time >= release[robot][0] + 1 + i64::from(robot_order.visits[0].stands)
}

/// Whether a battery falls below the floor, counted anew.
fn runs_flat(case: &Case, plan: &Plan) -> bool {
    case.scene.agents.iter().any(|agent| {
        let Some(battery) = agent.battery else {
            return false;
        };
        let path = &tidy(plan).paths[&agent.name];
        let charges = plan.charges(&agent.name);
        let mut level = i64::from(battery.initial);
        let mut flat = level < i64::from(case.scene.rules.battery_floor);
        for time in 0..path.len() as u32 - 1 {
            level = if charges.contains(&time) {
                i64::from(battery.capacity)
            } else {
                level - 1
            };
            flat |= level < i64::from(case.scene.rules.battery_floor);
        }
        flat
    })
}

/// The updates of VDA 5050 orders can be sent one after the other, and release all nodes.
pub(crate) fn released(seed: u64, order: &Order) {
    let messages = vda5050(order, "floor", 9, None);
    let last = |message: &Value| {
        let nodes = message["nodes"].as_array().unwrap().iter();
        let released = nodes.filter(|it| it["released"] == true);
        released.map(|it| it["sequenceId"].as_u64().unwrap()).max()
    };
    let name = |message: &Value| message["serialNumber"].as_str().unwrap().to_owned();
    let mut base: BTreeMap<String, (u64, Value)> = BTreeMap::new();
    for message in &messages.orders {
        let nodes = message["nodes"].as_array().unwrap().len() as u64;
        let edges = message["edges"].as_array().unwrap().len() as u64;
        assert_eq!(nodes, edges + 1);
        base.insert(
            name(message),
            (last(message).unwrap(), json!(2 * nodes - 2)),
        );
    }
    for update in &messages.updates {
        for reached in &update.after {
            assert!(
                u64::from(reached.sequence_id) <= base[&reached.serial_number].0,
                "seed {seed}"
            );
        }
        let it = base.get_mut(&name(&update.order)).unwrap();
        assert_eq!(update.order["nodes"][0]["sequenceId"], it.0, "seed {seed}");
        it.0 = last(&update.order).unwrap();
    }
    for (released, all) in base.values() {
        assert_eq!(all, released, "seed {seed}");
    }
}
