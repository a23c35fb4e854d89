//! Obstacles of scenarios in YAML that move: the least makespan and the judge against a
//! search of all joint positions time by time, which knows nothing of rules.
//!
//! `GIVEWAY_RANDOM_MOVING` sets of how many random scenarios (150 by default).
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "a test that cannot go on ends with a panic"
)]

use std::collections::BTreeSet;
use std::fmt::Write as _;

use giveway_formats::{Options, Source, combine};
use giveway_model::change::Changes;
use giveway_model::check::{check, check_changes};
use giveway_model::format::native;
use giveway_model::{Assumption, Instance, Plan, Question};
use giveway_solve::change::Method;
use giveway_solve::explain::{ExplainAnswer, ExplainRequest, Verdict};
use giveway_solve::{
    Limits, Request, Response, SilentHost, SolveAnswer, SolveRequest, Status, serve,
};
use giveway_tests::environment;
use giveway_tests::going_on::go_on;
use rand::seq::IndexedRandom;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

type Spot = (i32, i32);

/// A scenario.
struct Scenario {
    width: i32,
    height: i32,
    walls: BTreeSet<Spot>,
    robots: Vec<(Spot, Spot)>,
    /// The times and cells of the obstacle.
    states: Vec<(usize, Spot)>,
}

impl Scenario {
    fn random(seed: u64) -> Option<Self> {
        let random = &mut ChaCha8Rng::seed_from_u64(seed);
        let (width, height) = *[(4, 1), (5, 1), (3, 2), (3, 3), (4, 2)].choose(random)?;
        let all: Vec<Spot> = (0..height)
            .flat_map(|y| (0..width).map(move |x| (x, y)))
            .collect();
        let (free, walls): (Vec<Spot>, Vec<Spot>) =
            all.iter().copied().partition(|_| random.random_bool(0.85));
        let mut robots: Vec<(Spot, Spot)> = Vec::new();
        for _ in 0..random.random_range(1..=2) {
            let (start, goal) = (*free.choose(random)?, *free.choose(random)?);
            if robots.iter().any(|&(s, g)| s == start || g == goal) {
                return None;
            }
            robots.push((start, goal));
        }
        let mut at = *all.choose(random)?;
        let mut time = random.random_range(0..=2);
        let mut states = vec![(time, at)];
        for _ in 0..random.random_range(1..=7) {
            time += if random.random_bool(0.8) { 1 } else { 2 };
            let next = [(1, 0), (-1, 0), (0, 1), (0, -1), (0, 0)];
            let (x, y) = *next.choose(random)?;
            at = (at.0 + x, at.1 + y);
            states.push((time, at));
        }
        let walls = walls.into_iter().collect();
        Some(Self {
            width,
            height,
            walls,
            robots,
            states,
        })
    }

    fn yaml(&self, with_obstacle: bool) -> String {
        let mut text = format!(
            "map:\n  dimensions: [{}, {}]\n  obstacles: [",
            self.width, self.height
        );
        let walls = self.walls.iter().map(|(x, y)| format!("[{x}, {y}]"));
        text += &walls.collect::<Vec<String>>().join(", ");
        text += "]\nagents:\n";
        for (i, ((sx, sy), (gx, gy))) in self.robots.iter().enumerate() {
            writeln!(
                text,
                "- {{name: r{i}, start: [{sx}, {sy}], goal: [{gx}, {gy}]}}"
            )
            .unwrap();
        }
        if with_obstacle {
            text += "dynamic_obstacles:\n  cart:\n";
            for (t, (x, y)) in &self.states {
                writeln!(text, "  - {{t: {t}, x: {x}, y: {y}}}").unwrap();
            }
        }
        text
    }

    /// Where the obstacle is.
    fn obstacle(&self, time: usize) -> Option<Spot> {
        let before = self.states.iter().rev();
        let mut before = before.filter(|&&(t, _)| t <= time);
        before.next().map(|&(_, spot)| spot)
    }

    fn is_free(&self, spot: Spot) -> bool {
        let (x, y) = spot;
        (0..self.width).contains(&x) && (0..self.height).contains(&y) && !self.walls.contains(&spot)
    }

    /// Whether robots may be somewhere at a time, and come there from where they were.
    fn may_step(&self, from: &[Spot], to: &[Spot], time: usize) -> bool {
        let (was, is) = (self.obstacle(time), self.obstacle(time + 1));
        let swaps = |a: (Spot, Spot), b: (Spot, Spot)| a.0 == b.1 && a.1 == b.0 && a.0 != a.1;
        let steps: Vec<(Spot, Spot)> = from.iter().copied().zip(to.iter().copied()).collect();
        let cart = was.zip(is);
        steps.iter().enumerate().all(|(i, &step)| {
            let mut others = steps.iter().take(i);
            self.is_free(step.1)
                && Some(step.1) != is
                && others.all(|&other| other.1 != step.1 && !swaps(step, other))
                && !cart.is_some_and(|cart| swaps(step, cart))
        })
    }

    /// Whether robots may rest somewhere from a time on.
    fn may_rest(&self, at: &[Spot], time: usize) -> bool {
        let last = self.states.last().map_or(0, |&(t, _)| t);
        (time..=time.max(last)).all(|time| at.iter().all(|&spot| Some(spot) != self.obstacle(time)))
    }

    /// The least makespan up to 40.
    fn makespan(&self) -> Option<usize> {
        let starts: Vec<Spot> = self.robots.iter().map(|robot| robot.0).collect();
        let goals: Vec<Spot> = self.robots.iter().map(|robot| robot.1).collect();
        let is_met = starts.iter().any(|&spot| Some(spot) == self.obstacle(0));
        let mut now = BTreeSet::from([starts]);
        if is_met {
            return None;
        }
        for time in 0..40 {
            if now.contains(&goals) && self.may_rest(&goals, time) {
                return Some(time);
            }
            let mut next = BTreeSet::new();
            for from in &now {
                let mut ways: Vec<Vec<Spot>> = vec![Vec::new()];
                for &(x, y) in from {
                    let steps = [(0, 0), (1, 0), (-1, 0), (0, 1), (0, -1)];
                    let longer = |way: &Vec<Spot>| {
                        let each = steps.map(|(dx, dy)| [&way[..], &[(x + dx, y + dy)]].concat());
                        each.to_vec()
                    };
                    ways = ways.iter().flat_map(longer).collect();
                }
                next.extend(ways.into_iter().filter(|to| self.may_step(from, to, time)));
            }
            now = next;
        }
        None
    }

    /// Whether a plan meets neither obstacle nor robots.
    fn is_legal(&self, plan: &Plan) -> bool {
        let end = plan.paths.values().map(Vec::len).max().unwrap_or(1) - 1;
        let at = |time: usize| -> Vec<Spot> {
            let paths = (0..self.robots.len()).map(|i| plan.path(&format!("r{i}")));
            let cells = paths.map(|path| path[time.min(path.len() - 1)].unwrap().signed());
            cells.collect()
        };
        let first = at(0).iter().all(|&spot| Some(spot) != self.obstacle(0));
        let steps = (0..end).all(|time| self.may_step(&at(time), &at(time + 1), time));
        // One that has arrived may be met as long as the obstacle moves.
        first && steps && self.may_rest(&at(end), end)
    }
}

fn instance(text: &str) -> Instance {
    let source = Source {
        name: "it.yaml",
        text,
    };
    combine(&[source], &Options::default()).unwrap().instance
}

fn solve(instance: &Instance) -> SolveAnswer {
    let request = Request::Solve(SolveRequest {
        scene: instance.to_scene(),
        ..SolveRequest::default()
    });
    match serve(&request, &SilentHost) {
        Response::Solved(answer) => answer,
        other => panic!("{other:?}"),
    }
}

fn ask(scene: &Instance, plan: Option<&Plan>, changes: Option<&Changes>) -> ExplainAnswer {
    let request = Request::Explain(ExplainRequest {
        scene: scene.to_scene(),
        plan: plan.cloned(),
        changes: changes.cloned(),
        at: None,
        question: match plan {
            Some(_) => Question::Plan,
            None => Question::Unsolvable,
        },
        objective: None,
        within: None,
        proved: None,
        known: None,
        layers: Vec::new(),
        limits: Limits::default(),
    });
    match serve(&request, &SilentHost) {
        Response::Explained(answer) => *answer,
        other => panic!("{other:?}"),
    }
}

/// Answers about plans, and plans that go on after a change, heed obstacles that move.
#[test]
fn explain_and_change_heed_obstacles_that_move() {
    let count = environment::number("GIVEWAY_RANDOM_MOVING", 150);
    let (mut legal, mut illegal, mut impossible, mut late) = (0, 0, 0, 0);
    for scenario in (0..).filter_map(Scenario::random).take(count as usize) {
        let text = scenario.yaml(true);
        let scene = instance(&text);
        let Some(makespan) = scenario.makespan() else {
            let answer = ask(&scene, None, None);
            assert_eq!(answer.verdict, Verdict::Necessary, "{text}{answer:?}");
            assert!(answer.reach.is_complete(), "{text}{answer:?}");
            impossible += 1;
            continue;
        };
        let plan = solve(&scene).plan.unwrap();
        let at = makespan as u32 / 2;
        // Nothing changes but the time from which on all is planned anew.
        let text_of_changes = format!(
            r#"{{ "giveway": 1, "changes": [{{ "at": {at}, "change": "set-normal", "cells": [] }}] }}"#
        );
        let changes = native::read_changes(&text_of_changes).unwrap();
        for method in [Method::Revise, Method::Replan] {
            let answer = go_on(&scene, &plan, &changes, &[method]).unwrap();
            let found = &answer.methods.get(method).unwrap().result;
            let told = found.costs.map(|costs| costs.makespan as usize);
            assert_eq!(told, Some(makespan), "{method} {text}{answer:?}");
            assert!(scenario.is_legal(found.plan.as_ref().unwrap()), "{text}");
            let answer = ask(&scene, found.plan.as_ref(), Some(&changes));
            assert_eq!(answer.optimal, Some(true), "{text}{answer:?}");
            late += u32::from(at > 0);
        }
        // Plans that know nothing of the obstacle are judged by it.
        if let Some(plan) = solve(&instance(&scenario.yaml(false))).plan {
            let is_legal = scenario.is_legal(&plan);
            let answer = ask(&scene, Some(&plan), None);
            assert_eq!(answer.valid, Some(is_legal), "{text}{answer:?}");
            let report = check_changes(&scene, &changes, &plan).unwrap();
            assert_eq!(report.is_valid(), is_legal, "{text}{:?}", report.violations);
            *(if is_legal { &mut legal } else { &mut illegal }) += 1;
        }
    }
    let counts = (legal, illegal, impossible, late);
    assert!(
        legal > 20 && illegal > 10 && impossible > 10 && late > 60,
        "{counts:?}"
    );
}

#[test]
fn the_least_makespan_and_the_judge_heed_obstacles_that_move() {
    let count = environment::number("GIVEWAY_RANDOM_MOVING", 150);
    let (mut solved, mut impossible, mut illegal, mut swaps) = (0, 0, 0, 0);
    for scenario in (0..).filter_map(Scenario::random).take(count as usize) {
        let text = scenario.yaml(true);
        let scene = instance(&text);
        let assumptions = scene.assumptions().iter();
        let moving = assumptions.filter(|one| matches!(one, Assumption::MovingObstacle { .. }));
        swaps += moving.count();
        let answer = solve(&scene);
        let makespan = scenario.makespan();
        let told = answer.costs.map(|costs| costs.makespan as usize);
        assert_eq!(told, makespan, "{text}{answer:?}");
        if makespan.is_some() {
            assert_eq!(answer.status, Status::Optimal, "{text}");
            assert!(scenario.is_legal(answer.plan.as_ref().unwrap()), "{text}");
            solved += 1;
        } else {
            assert_eq!(answer.status, Status::Impossible, "{text}");
            impossible += 1;
        }
        // Plans that know nothing of the obstacle are judged by it.
        if let Some(plan) = solve(&instance(&scenario.yaml(false))).plan {
            let report = check(&scene, &plan);
            let is_legal = scenario.is_legal(&plan);
            assert_eq!(report.is_valid(), is_legal, "{text}{:?}", report.violations);
            illegal += u32::from(!is_legal);
        }
    }
    let counts = (solved, impossible, illegal, swaps);
    assert!(
        solved > 60 && impossible > 10 && illegal > 20 && swaps > 60,
        "{counts:?}"
    );
}
