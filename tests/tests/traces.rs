//! Traces of the search: they replay, they change nothing, and what each of their steps
//! claims is true by itself, as the oracle says.
//!
//! `GIVEWAY_LONG=1` replays 2,000 traces, 200 otherwise; `GIVEWAY_RANDOM_TRACES` sets of
//! how many instances the claims are looked at (50 by default), `GIVEWAY_RANDOM_SEED`
//! the seed.
#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    clippy::panic,
    reason = "a test that cannot go on ends with a panic"
)]

use giveway_model::{Cost, Instance, Objective};
use giveway_solve::trace::{Core, SearchEvent};
use giveway_solve::{
    Limits, Request, Response, SilentHost, SolveAnswer, SolveRequest, Stats, serve,
};
use giveway_tests::oracle::{AtMost, least_alone, some_plan_keeps};
use giveway_tests::{environment, random, traced};

/// States that the oracle may look at for one claim.
const CAP: usize = 60_000;

fn seed() -> u64 {
    environment::number("GIVEWAY_RANDOM_SEED", 1)
}

/// A random instance: of all kinds, with makespan or sum of costs first in two of three.
fn instance(number: u64) -> Instance {
    let made = match number % 2 {
        0 => random::crowded(seed(), number),
        _ => random::small(seed(), number),
    };
    let costs = match number % 3 {
        0 => vec![Cost::SumOfCosts, Cost::Charges],
        1 => vec![Cost::Makespan, Cost::SumOfCosts, Cost::Moves],
        _ => return made,
    };
    made.with_objective(Objective::new(costs).unwrap())
}

fn solve(instance: &Instance, trace: bool, conflicts: Option<u64>) -> SolveAnswer {
    let request = Request::Solve(SolveRequest {
        scene: instance.to_scene(),
        trace,
        limits: Limits {
            conflicts,
            ..Limits::default()
        },
        ..SolveRequest::default()
    });
    match serve(&request, &SilentHost) {
        Response::Solved(answer) => answer,
        other => panic!("{other:?}"),
    }
}

/// What was said of a scene, for whoever looks into it.
fn show(instance: &Instance, number: u64) -> String {
    let scene = serde_json::to_string(&instance.to_scene()).unwrap();
    format!("instance {number} of seed {}: {scene}", seed())
}

#[test]
fn a_trace_replays_and_changes_nothing() {
    let count = match environment::number("GIVEWAY_LONG", 0) {
        0 => 200,
        _ => 2_000,
    };
    let mut cores = 0;
    for number in 0..count {
        let instance = match number % 4 {
            3 => random::medium(seed(), number),
            _ => instance(number),
        };
        // Some are cut off.
        let conflicts = Some(if number % 5 == 4 { 20 } else { 20_000 });
        let told = solve(&instance, true, conflicts);
        let faults = traced::replay(&told);
        assert!(
            faults.is_empty(),
            "{}: {faults:#?}",
            show(&instance, number)
        );
        let again = solve(&instance, true, conflicts);
        assert_eq!(told.trace, again.trace, "{}", show(&instance, number));
        let events = told.trace.iter().flat_map(|trace| &trace.events);
        let is_core = |event: &SearchEvent| matches!(event, SearchEvent::Core(_));
        cores += events.filter(|event| is_core(&event.event)).count();
        let clock = |answer: SolveAnswer| SolveAnswer {
            trace: None,
            stats: Stats {
                cpu_seconds: 0.0,
                ..answer.stats
            },
            ..answer
        };
        let untold = solve(&instance, false, conflicts);
        assert!(untold.trace.is_none());
        assert_eq!(clock(told), clock(untold), "{}", show(&instance, number));
    }
    println!("{cores} cores");
    assert!(2 * cores >= count as usize, "too few cores: {cores}");
}

/// What was seen of claims.
#[derive(Debug, Default)]
struct Seen {
    claims: u32,
    /// Of these about makespan, sum of costs, and others.
    makespan: u32,
    sum: u32,
    counted: u32,
    /// Under a condition; of several agents with limits of their own; alone.
    conditional: u32,
    sums: u32,
    by_themselves: u32,
    /// That are no longer true with one more of the cost for everybody.
    tight: u32,
    too_large: u32,
}

impl Seen {
    fn look(&mut self, instance: &Instance, core: &Core) -> Vec<String> {
        let mut faults = Vec::new();
        for limits in traced::claims(core) {
            self.claims += 1;
            match some_plan_keeps(instance, &limits, CAP) {
                None => self.too_large += 1,
                Some(true) => faults.push(format!("a plan keeps {limits:?}")),
                Some(false) => {}
            }
            let more: Vec<AtMost> = limits
                .iter()
                .map(|limit| AtMost {
                    most: limit.most + 1,
                    ..limit.clone()
                })
                .collect();
            self.tight += u32::from(some_plan_keeps(instance, &more, CAP) == Some(true));
        }
        match core.cost {
            Cost::Makespan => self.makespan += 1,
            Cost::SumOfCosts => self.sum += 1,
            _ => self.counted += 1,
        }
        let scope = &core.scope;
        self.conditional += u32::from(scope.at_most.is_some() || !scope.given.is_empty());
        self.sums += u32::from(!core.sums.is_empty());
        if !scope.others {
            self.by_themselves += 1;
            let alone = traced::alone(instance, core);
            for limits in traced::claims(core) {
                let named = |limit: &AtMost| {
                    limit
                        .agents
                        .iter()
                        .flatten()
                        .all(|name| alone.agents().iter().any(|agent| agent.name == *name))
                };
                // (What they need together may be about more of them.)
                if limits.iter().all(named) && some_plan_keeps(&alone, &limits, CAP) == Some(true) {
                    faults.push(format!("alone a plan keeps {limits:?}"));
                }
            }
        }
        faults
    }
}

#[test]
fn each_step_is_true_by_itself() {
    let count = environment::number("GIVEWAY_RANDOM_TRACES", 50);
    let mut seen = Seen::default();
    let mut instances = 0;
    for number in 0.. {
        if instances >= count {
            break;
        }
        let instance = instance(number);
        let answer = solve(&instance, true, Some(20_000));
        let trace = answer.trace.unwrap();
        let mut has_core = false;
        for event in &trace.events {
            let faults = match &event.event {
                SearchEvent::Core(core) => {
                    has_core = true;
                    seen.look(&instance, core)
                }
                SearchEvent::Alone { cost, agents, .. } => {
                    let least = least_alone(&instance, *cost);
                    let told: Vec<u32> = agents.iter().map(|agent| agent.least).collect();
                    let fault = format!("{cost:?} alone is {least:?}");
                    let differs = least.is_some_and(|least| least != told);
                    differs.then_some(fault).into_iter().collect()
                }
                SearchEvent::Closed {
                    cost, scope, to, ..
                } => {
                    let mut limits = traced::limits(scope, *cost);
                    limits.push(AtMost {
                        cost: *cost,
                        agents: None,
                        most: to - 1,
                    });
                    let kept = some_plan_keeps(&instance, &limits, CAP) == Some(true);
                    kept.then(|| format!("a plan keeps {limits:?}"))
                        .into_iter()
                        .collect()
                }
                _ => Vec::new(),
            };
            assert!(
                faults.is_empty(),
                "{}\n{}: {}\n{faults:#?}",
                show(&instance, number),
                event.number,
                event.text
            );
        }
        instances += u64::from(has_core);
    }
    println!("{seen:?}");
    assert!(
        seen.too_large * 10 <= seen.claims,
        "too many are too large: {seen:?}"
    );
    assert!(
        seen.tight * 4 >= seen.claims,
        "too many are far from tight: {seen:?}"
    );
    assert!(
        seen.makespan > 0 && seen.sum > 0 && seen.counted > 0,
        "{seen:?}"
    );
    assert!(
        seen.sums > 0 && seen.by_themselves > 0 && seen.conditional > 0,
        "{seen:?}"
    );
}
