//! Who costs whom: each number of the ledger, found a second and slow way.
//!
//! `GIVEWAY_DELAY_SCENES` sets how many random scenes each test compares, `GIVEWAY_RANDOM_SEED`
//! the seed. The long run:
//!
//! ```text
//! GIVEWAY_DELAY_SCENES=5000 cargo test --release -p giveway-tests --test delays
//! ```
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    clippy::print_stdout,
    reason = "a test that cannot go on ends with a panic"
)]

mod by_hand;
mod changed;
mod lost;
mod proof;
mod rows;

use std::collections::BTreeSet;

use giveway_model::check::{Violation, check};
use giveway_model::{Cost, Instance, Objective, Plan};
use giveway_solve::delays::{AgentDelay, DelayCause, DelaysAnswer, DelaysRequest};
use giveway_solve::plan::{PlanRequest, Planner};
use giveway_solve::{Request, Response, SilentHost, serve};
use giveway_tests::environment;
use giveway_tests::going_on::plan_of;
use giveway_tests::rules_oracle::{Answer, RuleScene, best};

/// Joint states that the oracle looks at.
const MOST_STATES: usize = 30_000;
/// Walks of more steps are not listed one by one.
const MOST_STEPS: u32 = 7;

fn ask(request: DelaysRequest) -> DelaysAnswer {
    match serve(&Request::Delays(request), &SilentHost) {
        Response::Delays(answer) => *answer,
        other => panic!("{other:?}"),
    }
}

fn ledger(instance: &Instance, plan: &Plan) -> DelaysAnswer {
    ask(DelaysRequest {
        scene: instance.to_scene(),
        plan: Some(plan.clone()),
        ledger_only: true,
        ..DelaysRequest::default()
    })
}

/// Plans of a scene: a best one, and what a planner without proofs finds.
fn plans(instance: &Instance) -> Vec<Plan> {
    let mut request = PlanRequest::new(instance.to_scene(), Planner::Prioritised);
    request.limits.work = Some(200_000);
    let quick = match serve(&Request::Plan(request), &SilentHost) {
        Response::Planned(answer) => answer.plan,
        other => panic!("{other:?}"),
    };
    let best = plan_of(instance);
    let slow = best.as_ref().map(one_later);
    let mut plans: Vec<Plan> = best.into_iter().chain(quick).chain(slow).collect();
    for plan in &mut plans {
        plan.cut_trailing_goals(instance);
    }
    plans.retain(|plan| check(instance, plan).is_valid());
    plans.dedup();
    plans
}

/// The same plan one step later: each robot waits at first.
fn one_later(plan: &Plan) -> Plan {
    let mut plan = plan.clone();
    for path in plan.paths.values_mut() {
        let first = path.first().copied();
        path.splice(0..0, first);
    }
    for time in plan.charges.values_mut().flatten() {
        *time += 1;
    }
    plan
}

/// The costs by the oracle of rules, as it reads the scene; `None` where it is too large.
fn least(instance: &Instance, objective: &[Cost], within: Option<u32>) -> Option<Vec<u32>> {
    let objective = Objective::new(objective.to_vec()).unwrap();
    let mut scene = instance.clone().with_objective(objective).to_scene();
    // A rule about others alone says nothing.
    scene.settle_rules(instance.grid());
    let scene = RuleScene::read(&serde_json::to_string(&scene).unwrap(), &[]);
    match best(&scene, within.map(i64::from), MOST_STATES) {
        Answer::Best(costs) => Some(
            costs
                .into_iter()
                .map(|it| u32::try_from(it).unwrap())
                .collect(),
        ),
        Answer::Impossible => panic!("there is a plan"),
        Answer::Capped => None,
    }
}

/// Whom a plan with another way of one agent offends: by name, rules by number.
fn offended(agent: &str, violations: &[Violation], until: u32) -> BTreeSet<String> {
    let named = |violations: &mut dyn Iterator<Item = &Violation>| {
        let mut all = BTreeSet::new();
        for violation in violations {
            if let Some(broken) = &violation.broken {
                all.insert(format!("#{}", broken.index));
            } else {
                let others = violation.agents.iter().filter(|it| *it != agent);
                all.extend(others.cloned());
            }
        }
        all
    };
    let early = named(&mut violations.iter().filter(|it| it.time <= until));
    if early.is_empty() {
        named(&mut violations.iter())
    } else {
        early
    }
}

/// The causes of a row: by name, rules by number.
fn causes(row: &AgentDelay) -> BTreeSet<String> {
    let name = |cause: &DelayCause| match cause {
        DelayCause::Agent { agent } => Some(agent.clone()),
        DelayCause::Rule { index, .. } => Some(format!("#{index}")),
        DelayCause::Nobody => None,
    };
    row.because
        .iter()
        .filter_map(|share| name(&share.cause))
        .collect()
}

fn scenes(default: u64) -> (u64, u64) {
    let count = environment::number("GIVEWAY_DELAY_SCENES", default);
    (environment::number("GIVEWAY_RANDOM_SEED", 0), count)
}
