//! Audits against the oracle: its best plan is found to be the best, and the same
//! plan with one step spoiled, anywhere, never is unless it costs the same.
//!
//! `GIVEWAY_RANDOM_AUDITS` sets how many instances (60 by default), and
//! `GIVEWAY_RANDOM_SEED` the seed.
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "a test that cannot go on ends with a panic"
)]

use giveway_model::{Cell, Instance, Plan};
use giveway_solve::audit::{AuditAnswer, AuditRequest, AuditStatus};
use giveway_solve::{Limits, Request, Response, SilentHost, Status, serve};
use giveway_tests::oracle::{Point, Question, Verdict};
use giveway_tests::{environment, random, recount};

/// The largest number of labels that the oracle may make.
const CAP: usize = 100_000;

fn audit(instance: &Instance, plan: &Plan) -> AuditAnswer {
    let request = Request::Audit(AuditRequest {
        scene: instance.to_scene(),
        plan: plan.clone(),
        limits: Limits {
            conflicts: Some(20_000),
            ..Limits::default()
        },
        ..AuditRequest::default()
    });
    match serve(&request, &SilentHost) {
        Response::Audited(answer) => *answer,
        other => panic!("expected an audit, got {other:?}"),
    }
}

/// The plan with one step otherwise: each step of each agent, each in three ways.
fn spoiled(plan: &Plan) -> Vec<Plan> {
    let mut all = Vec::new();
    for (name, path) in &plan.paths {
        for at in 0..path.len() {
            let mut with = |change: &dyn Fn(&mut Vec<Option<Cell>>)| {
                let mut plan = plan.clone();
                change(plan.paths.get_mut(name).unwrap());
                all.push(plan);
            };
            with(&|path| path.insert(at, path[at]));
            with(&|path| {
                let cell = path[at].unwrap_or(Cell::new(0, 0));
                path[at] = Some(Cell::new(cell.x ^ 1, cell.y));
            });
            if path.len() > 1 {
                with(&|path| {
                    path.remove(at);
                });
            }
        }
    }
    all
}

/// What an audit may say where the oracle knows the best plan.
fn judge(instance: &Instance, best: &Point, plan: &Plan, answer: &AuditAnswer) {
    let objective = instance.objective();
    let scene = || serde_json::to_string(&(instance.to_scene(), plan)).unwrap();
    if answer.reach.is_complete() {
        let first = objective.costs()[0];
        let bound = answer.bounds.get(&first).copied().unwrap_or_default();
        assert!(bound <= best.vector[0], "{}", scene());
    }
    if let Some(better) = &answer.better {
        let vector = recount::costs(better).vector(objective);
        assert!(vector >= best.vector, "{}", scene());
        if answer.search == Status::Optimal && answer.reach.is_complete() {
            assert_eq!(vector, best.vector, "{}", scene());
        }
    }
    let own = answer.costs.map(|costs| costs.vector(objective));
    match answer.status {
        AuditStatus::Optimal => assert_eq!(own, Some(best.vector.clone()), "{}", scene()),
        AuditStatus::Feasible => assert!(own > Some(best.vector.clone()), "{}", scene()),
        AuditStatus::Illegal => assert!(!answer.violations.is_empty(), "{}", scene()),
        AuditStatus::Unknown => panic!("nothing known of {}", scene()),
    }
}

#[test]
fn a_spoiled_plan_is_illegal_or_not_the_best() {
    let seed = environment::number("GIVEWAY_RANDOM_SEED", 1);
    let count = environment::number("GIVEWAY_RANDOM_AUDITS", 60);
    let mut counts = [0_u32; 4];
    let mut audited = 0;
    for number in 0..5 * count {
        if audited == count {
            break;
        }
        let instance = random::small(seed, number);
        let question = Question {
            instance: &instance,
            within: None,
            cap: CAP,
        };
        let Verdict::Best(best) = question.best() else {
            continue;
        };
        audited += 1;
        let answer = audit(&instance, &best.plan);
        let scene = serde_json::to_string(&instance.to_scene()).unwrap();
        assert_eq!(answer.status, AuditStatus::Optimal, "{scene}");
        judge(&instance, &best, &best.plan, &answer);
        for plan in spoiled(&best.plan) {
            let answer = audit(&instance, &plan);
            judge(&instance, &best, &plan, &answer);
            counts[answer.status as usize] += 1;
        }
    }
    assert_eq!(audited, count);
    let [_, feasible, illegal, _] = counts;
    assert!(illegal > 20 && feasible > 5, "{counts:?}");
}
