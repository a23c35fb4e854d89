//! Safe intervals under rules of a scene's own, against space-time A*: the same arrivals among
//! the same others, and plans that the judge passes.
//!
//! `GIVEWAY_CROWDS` sets how many random scenes are compared.
#![allow(
    clippy::unwrap_used,
    reason = "a test that cannot go on ends with a panic"
)]

use giveway_model::Instance;
use giveway_model::check::check;
use giveway_model::format::native;
use giveway_planners::budget::Unlimited;
use giveway_planners::local::{OtherAgents, Query, Reservations, Timetable, plan_one};
use giveway_planners::problem::Problem;
use giveway_planners::walk::{Walk, arrival, to_plan};
use giveway_solve::plan::{PlanRequest, Planner};
use giveway_solve::{Request, Response, SilentHost, serve};
use giveway_tests::rules_random::{KINDS, crowd_with_rules, scene_with_rules};
use giveway_tests::{environment, known};
use serde_json::{Value, json};

/// What was seen in all scenes.
#[derive(Debug, Default)]
struct Seen {
    on_time: u32,
    delayed: u32,
    stuck: u32,
    plans: u32,
}

/// A crowd, planned by both one agent after the other.
struct Both<'p> {
    problem: &'p Problem,
    table: Timetable<'p>,
    reserved: Reservations<'p>,
    walks: Vec<Walk>,
    what: String,
}

impl Both<'_> {
    /// Plans an agent around those that were added, and adds it; whether it has a way.
    fn plan(&mut self, agent: usize, latest: u32, seen: &mut Seen) -> bool {
        let query = Query {
            agent,
            latest,
            conflict_penalty: None,
            expansion_limit: u32::MAX,
        };
        let budget = Unlimited::default();
        let by_intervals = self.table.plan(query, &budget).unwrap();
        let by_a_star = plan_one(self.problem, &self.reserved, query, &budget).unwrap();
        let [a, b] =
            [&by_intervals, &by_a_star].map(|found| found.as_ref().map(|(walk, _)| arrival(walk)));
        let what = format!("agent {agent} by {latest}, {}", self.what);
        assert_eq!(a, b, "{what}: {by_intervals:?} {by_a_star:?}");
        let Some((walk, _)) = by_intervals else {
            seen.stuck += 1;
            return false;
        };
        let met = self.reserved.met_by(agent, &walk);
        assert!(met.is_empty(), "{what}: {walk:?} meets {met:?}");
        let is_delayed = arrival(&walk) > self.problem.optima[agent];
        *(if is_delayed {
            &mut seen.delayed
        } else {
            &mut seen.on_time
        }) += 1;
        self.table.add(agent, &walk);
        self.reserved.add(agent, &walk);
        self.walks[agent] = walk;
        true
    }

    fn remove(&mut self, agent: usize) {
        self.table.remove(agent, &self.walks[agent]);
        self.reserved.remove(agent, &self.walks[agent]);
    }
}

/// Plans the agents of a scene in an order that begins with a number, then each of them anew.
fn compare(scene: &Value, first: usize, seen: &mut Seen) {
    let text = scene.to_string();
    let instance: Instance = native::read_instance(&text).unwrap();
    let Ok(problem) = Problem::new(&instance, &Unlimited::default()) else {
        return;
    };
    let agents = problem.agents();
    let mut both = Both {
        table: Timetable::new(&problem).unwrap(),
        reserved: Reservations::new(&problem),
        walks: vec![Walk::new(); agents],
        problem: &problem,
        what: text,
    };
    let latest = |agent: usize| problem.optima[agent] + 6 + (first % 10) as u32;
    let order = (0..agents).map(|agent| (agent + first) % agents);
    for agent in order.clone() {
        if !both.plan(agent, latest(agent), seen) {
            return;
        }
    }
    for agent in order {
        both.remove(agent);
        let again = both.plan(agent, latest(agent), seen);
        assert!(
            again,
            "agent {agent} has no way again: {:?} {}",
            both.walks, both.what
        );
    }
    let names: Vec<String> = instance
        .agents()
        .iter()
        .map(|agent| agent.name.clone())
        .collect();
    let plan = to_plan(&problem, &names, &both.walks);
    let report = check(&instance, &plan);
    assert!(report.is_valid(), "{:?} {}", report.violations, both.what);
    seen.plans += 1;
}

/// 100 agents in a warehouse of which every second aisle is one-way, by turns in both
/// directions, with six zones in which two may be at once.
fn warehouse() -> Instance {
    let mut scene = known::scenario("warehouse-10-20-10-2-1", 100).to_scene();
    let zones = [(42, 2), (53, 22), (64, 42), (75, 2), (86, 22), (97, 42)];
    let rows = (4..62).step_by(6);
    let lanes = rows.enumerate().map(|(number, y)| {
        let mut lane: Vec<[u32; 2]> = (26..135).map(|x| [x, y]).collect();
        if number % 2 == 1 {
            lane.reverse();
        }
        json!({ "kind": "one-way", "lane": lane })
    });
    let limits =
        zones.map(|(x, _)| json!({ "kind": "capacity", "zone": format!("zone {x}"), "most": 2 }));
    let rules = lanes.chain(limits).map(serde_json::from_value);
    scene.constraints = rules.collect::<Result<_, _>>().unwrap();
    let zones = zones.map(|(x, y)| {
        let zone = json!({ "name": format!("zone {x}"), "rect": [x, y, x + 10, y + 12] });
        serde_json::from_value(zone)
    });
    scene.zones = zones.into_iter().collect::<Result<_, _>>().unwrap();
    Instance::new(scene).unwrap()
}

#[test]
fn a_crowd_with_lanes_and_zones_has_a_good_plan_soon() {
    let instance = warehouse();
    let problem = Problem::new(&instance, &Unlimited::default()).ok().unwrap();
    let least: u32 = (0..problem.agents())
        .map(|agent| problem.least_cost(agent))
        .sum();
    let sum = |planner: Planner, work: u64| {
        let mut request = PlanRequest::new(instance.to_scene(), planner);
        request.objective = Some("sum-of-costs".parse().unwrap());
        request.limits.work = Some(work);
        let Response::Planned(answer) = serve(&Request::Plan(request), &SilentHost) else {
            unreachable!("a plan request is planned")
        };
        assert!(answer.plan.is_some(), "{planner}: {:?}", answer.ended);
        let plan = answer.plan.unwrap();
        assert!(check(&instance, &plan).is_valid());
        answer.costs.unwrap().sum_of_costs
    };
    let first = sum(Planner::Prioritised, 3_000_000);
    assert!(first >= least, "{first}, {least}");
    let better = sum(Planner::Lns, 5_000_000);
    assert!(better <= least + least / 20, "{better}, {least}");
}

fn scenes(usual: u64) -> u64 {
    environment::number("GIVEWAY_CROWDS", usual)
}

#[test]
fn a_rule_of_each_kind_gives_the_same_arrivals() {
    let mut seen = Seen::default();
    for number in 0..scenes(2_000) {
        let kind = KINDS[number as usize % KINDS.len()];
        let scene = crowd_with_rules(41, number, &[kind]);
        compare(&scene, number as usize, &mut seen);
        let scene = scene_with_rules(42, number, &[kind]);
        compare(&scene, number as usize, &mut seen);
    }
    assert_seen(&seen);
}

#[test]
fn two_or_three_rules_together_give_the_same_arrivals() {
    let mut seen = Seen::default();
    for number in 0..scenes(2_000) {
        let kind = |step: usize| KINDS[(number as usize * 5 + step) / step % KINDS.len()];
        let kinds = [kind(1), kind(14), kind(3)];
        let kinds = &kinds[..2 + (number % 2) as usize];
        compare(
            &crowd_with_rules(43, number, kinds),
            number as usize,
            &mut seen,
        );
        compare(
            &scene_with_rules(44, number, kinds),
            number as usize,
            &mut seen,
        );
    }
    assert_seen(&seen);
}

fn assert_seen(seen: &Seen) {
    let Seen {
        on_time,
        delayed,
        stuck,
        plans,
    } = *seen;
    let least = scenes(2_000) as u32 / 10;
    let all = [on_time, delayed, stuck, plans];
    assert!(all.iter().all(|&count| count > least), "{seen:?}");
}
