//! Bounds by counting against the exhaustive oracle of rules: none is above the optimum, and
//! many meet it.
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "a test that cannot go on ends with a panic"
)]

use giveway_model::format::native;
use giveway_model::{Cost, Objective};
use giveway_planners::bottleneck::{Bottlenecks, Gate};
use giveway_planners::budget::Unlimited;
use giveway_planners::problem::Problem;
use giveway_proof::queue::counted_at_least;
use giveway_solve::trace::SearchEvent;
use giveway_solve::{Limits, Reason, Request, Response, SilentHost, SolveRequest, Status, serve};
use giveway_tests::bottleneck_random::scene_with_gate;
use giveway_tests::environment;
use giveway_tests::rules_oracle::{Answer, RuleScene, best};
use serde_json::json;

/// Joint states that the oracle looks at.
const MOST_STATES: usize = 12_000;

/// What was compared.
#[derive(Default, Debug)]
struct Tally {
    /// Bounds above what agents need alone.
    bounds: [u32; 2],
    /// Bounds that the optimum meets.
    met: [u32; 2],
    /// Scenes without a plan.
    impossible: u32,
    /// Bounds by zones.
    zones: u32,
    /// Bounds that the checker of certificates shows, too.
    again: u32,
}

#[test]
fn no_bound_is_above_the_optimum() {
    let scenes = environment::number("GIVEWAY_GATE_SCENES", 150);
    let mut tally = Tally::default();
    for number in 0..scenes {
        let mut scene = scene_with_gate(41, number);
        let instance = native::read_instance(&scene.to_string()).unwrap();
        let budget = Unlimited::default();
        let Ok(problem) = Problem::new(&instance, &budget) else {
            continue;
        };
        let bottlenecks = Bottlenecks::of(&problem, 2, &budget).unwrap();
        for (i, cost) in [Cost::Makespan, Cost::SumOfCosts].into_iter().enumerate() {
            let Some(counted) = bottlenecks.bound(&problem, cost, None) else {
                continue;
            };
            scene["objective"] = json!([cost.name()]);
            let text = scene.to_string();
            match best(&RuleScene::read(&text, &[]), None, MOST_STATES) {
                Answer::Capped => {}
                Answer::Impossible => tally.impossible += 1,
                Answer::Best(costs) => {
                    // The checker of certificates counts by itself.
                    let optimum = u32::try_from(costs[0]).unwrap();
                    let budget = giveway_proof::Budget::default();
                    let shows = |bound| {
                        counted_at_least(&instance, (cost, bound), None, 2, &budget).unwrap()
                    };
                    assert!(!shows(optimum + 1), "scene {number}, {cost:?}\n{text}");
                    tally.again += u32::from(shows(counted.at_least));
                    let bound = i64::from(counted.at_least);
                    assert!(
                        bound <= costs[0],
                        "scene {number}, {cost:?}: {bound} above {}, {:?}\n{text}",
                        costs[0],
                        counted.bottleneck
                    );
                    tally.bounds[i] += 1;
                    tally.met[i] += u32::from(bound == costs[0]);
                    let is_zone = matches!(counted.bottleneck.gate(), Gate::Zone { .. });
                    tally.zones += u32::from(is_zone);
                }
            }
        }
    }
    println!("{tally:?}");
    // The number that a person set may be small.
    if scenes >= 150 {
        let all = tally.bounds.iter().all(|&bounds| bounds > 25);
        let tight = tally.met.iter().all(|&met| met > 10);
        assert!(all && tight && tally.zones > 8, "{tally:?}");
    }
}

/// Robots that change sides through one gap in a wall, in two columns of starts on each side.
fn change_sides(most: Option<u32>) -> giveway_model::Instance {
    let row = |y: usize| if y == 2 { "........." } else { "....#...." };
    let map: Vec<&str> = (0..5).map(row).collect();
    let mut agents = Vec::new();
    for number in 0..10 {
        let (column, y) = (number / 5, number % 5);
        let [start, goal] = if y % 2 == 0 {
            [[column, y], [7 + column, y]]
        } else {
            [[8 - column, y], [1 - column, y]]
        };
        agents.push(json!({ "name": format!("R{number}"), "start": start, "goal": goal }));
    }
    let mut scene = json!({ "giveway": 1, "map": map, "agents": agents });
    if let Some(most) = most {
        scene["zones"] = json!([{ "name": "gate", "rect": [3, 2, 5, 2] }]);
        scene["constraints"] = json!([{ "kind": "capacity", "zone": "gate", "most": most }]);
    }
    native::read_instance(&scene.to_string()).unwrap()
}

#[test]
fn many_that_change_sides_are_closed_by_counting_and_certified_so() {
    for most in [None, Some(1)] {
        let instance = change_sides(most);
        for cost in [Cost::Makespan, Cost::SumOfCosts] {
            let request = Request::Solve(SolveRequest {
                scene: instance.to_scene(),
                objective: Some(Objective::new(vec![cost]).unwrap()),
                trace: true,
                limits: Limits {
                    work: Some(30_000_000),
                    ..Limits::default()
                },
                ..SolveRequest::default()
            });
            let Response::Solved(answer) = serve(&request, &SilentHost) else {
                unreachable!("a solve request is solved")
            };
            assert_eq!(answer.status, Status::Optimal, "{most:?}, {cost:?}");
            assert!(answer.reach.is_complete());
            let trace = answer.trace.unwrap();
            let counted = trace.events.iter().find_map(|event| match &event.event {
                SearchEvent::Counted {
                    at_least, agents, ..
                } => Some((*at_least, agents.len())),
                _ => None,
            });
            let least = answer.costs.unwrap().get(cost);
            assert_eq!(counted, Some((least, 10)), "{most:?}, {cost:?}");
            let budget = giveway_proof::Budget::default();
            let shows = |bound| counted_at_least(&instance, (cost, bound), None, 7, &budget);
            assert_eq!((shows(least), shows(least + 1)), (Some(true), Some(false)));
        }
    }
}

/// Where more robots come to rest in a zone than may be there, no horizon helps; with a last
/// time, or where robots vanish, one does.
#[test]
fn too_many_robots_at_rest_in_a_zone_leave_no_plan() {
    let scene = |to: Option<u32>, at_goal: &str, most: u32| {
        let agents: Vec<_> = (0..16)
            .map(|i| {
                let goal = if i < 3 { [9 + i, 9] } else { [i, 19] };
                json!({ "name": format!("A{i}"), "start": [i, 0], "goal": goal })
            })
            .collect();
        let mut rule = json!({ "kind": "capacity", "zone": "z", "most": most });
        if let Some(to) = to {
            rule["to"] = json!(to);
        }
        json!({
            "giveway": 1, "map": vec![".".repeat(20); 20], "agents": agents,
            "rules": { "at_goal": at_goal },
            "zones": [{ "name": "z", "rect": [9, 9, 11, 9] }], "constraints": [rule],
        })
    };
    let solve = |scene: serde_json::Value| {
        let request = Request::Solve(SolveRequest {
            scene: native::read_scene(&scene.to_string()).unwrap(),
            limits: Limits {
                work: Some(3_000_000),
                ..Limits::default()
            },
            ..SolveRequest::default()
        });
        match serve(&request, &SilentHost) {
            Response::Solved(answer) => answer,
            other => panic!("{other:?}"),
        }
    };
    let answer = solve(scene(None, "stay", 2));
    assert_eq!(answer.status, Status::Impossible);
    assert!(answer.reach.is_complete());
    let agents = ["A0", "A1", "A2"].map(str::to_owned).to_vec();
    assert_eq!(answer.reason, Some(Reason::Clash { agents }));
    for possible in [
        scene(Some(12), "stay", 2),
        scene(None, "vanish", 2),
        scene(None, "stay", 3),
    ] {
        assert_ne!(solve(possible).status, Status::Impossible);
    }
}
