//! A proof that is handed on with a question, and a plan near by: they spare work and change no
//! verdict.

use std::cell::RefCell;
use std::collections::BTreeMap;

use giveway_model::{Plan, Question};

use super::layers::questions;
use crate::{
    Host, Limits, Progress, ProvedBest, Request, Response, SilentHost, SolveRequest, Status,
    Thresholds,
    explain::{ExplainAnswer, ExplainRequest, Layer, Part, Verdict},
    serve,
    tests::random,
};

/// Takes each scene for a large floor, and keeps the answers that are told on the way.
#[derive(Default)]
pub(super) struct Eager(RefCell<Vec<ExplainAnswer>>);

impl Host for Eager {
    fn wall_seconds(&self) -> f64 {
        0.0
    }

    fn progress(&self, event: &Progress) {
        if let Progress::Explained { answer } = event {
            self.0.borrow_mut().push((**answer).clone());
        }
    }

    fn thresholds(&self) -> Thresholds {
        Thresholds {
            few_agents: 0,
            ..Thresholds::default()
        }
    }
}

/// A proof that is handed on spares the search, and changes no verdict.
#[test]
fn a_proof_that_is_handed_on_changes_no_verdict() {
    let (mut seen, mut spared, mut on_floors, mut late) = (BTreeMap::new(), 0, 0, 0);
    for seed in 0..60 {
        let instance = random(seed, 2 + (seed % 3) as usize);
        let request = Request::Solve(SolveRequest {
            scene: instance.to_scene(),
            trace: true,
            ..SolveRequest::default()
        });
        let Response::Solved(solved) = serve(&request, &Eager::default()) else {
            panic!("{seed}");
        };
        let proved = ProvedBest::by_search(&solved);
        late += (0..instance.agents().len())
            .filter(|&a| proved.latest_arrival(a).is_some())
            .count();
        let Some(plan) = solved.plan.filter(|_| solved.status == Status::Optimal) else {
            continue;
        };
        for question in questions(&instance, &plan).into_iter().take(8) {
            let layers = [Layer::Near, Layer::Whole];
            let ask = |proved: Option<&ProvedBest>, host: &dyn Host| {
                let request = Request::Explain(ExplainRequest {
                    scene: instance.to_scene(),
                    plan: Some(plan.clone()),
                    question: question.clone(),
                    changes: None,
                    at: None,
                    objective: None,
                    within: None,
                    proved: proved.cloned(),
                    known: None,
                    layers: layers.to_vec(),
                    limits: Limits::default(),
                });
                match serve(&request, host) {
                    Response::Explained(answer) => *answer,
                    other => panic!("{other:?}"),
                }
            };
            let without = ask(None, &SilentHost);
            let with = ask(Some(&proved), &SilentHost);
            // As on a large floor: from a plan near by, and with the optima that are proved.
            let on_floor = ask(Some(&proved), &Eager::default());
            assert_eq!(on_floor.verdict, without.verdict, "{seed} {question:?}");
            assert_eq!(on_floor.deltas, without.deltas, "{seed} {question:?}");
            let is_complete = on_floor.reach.is_complete();
            assert!(
                is_complete || !without.reach.is_complete(),
                "{seed} {question:?}"
            );
            *seen.entry(with.verdict).or_insert(0) += 1;
            on_floors += u32::from(on_floor.stats.solver_calls < without.stats.solver_calls);
            spared += u32::from(with.stats.solver_calls < without.stats.solver_calls);
        }
    }
    assert!(
        seen.len() >= 3 && spared > 0 && on_floors > 0 && late >= 8,
        "{seen:?} {spared} {on_floors} {late}"
    );
}

/// On a large floor the verdict is told before the best other plan is known. It stays as it is,
/// with and without a proof of the plan; what the other plan costs only falls.
#[test]
fn a_verdict_that_is_told_early_stays() {
    let (mut early, mut fallen) = (0, 0);
    for seed in 0..40 {
        let instance = random(seed, 3);
        let request = Request::Solve(SolveRequest {
            scene: instance.to_scene(),
            ..SolveRequest::default()
        });
        let Response::Solved(solved) = serve(&request, &SilentHost) else {
            panic!("{seed}");
        };
        let Some(plan) = solved.plan.filter(|_| solved.status == Status::Optimal) else {
            continue;
        };
        for question in questions(&instance, &plan).into_iter().take(8) {
            let proved = (seed % 3 > 0).then_some(solved.reach.into());
            let host = Eager::default();
            let request = Request::Explain(ExplainRequest {
                scene: instance.to_scene(),
                plan: Some(plan.clone()),
                question: question.clone(),
                changes: None,
                at: None,
                objective: None,
                within: None,
                proved,
                known: None,
                layers: vec![Layer::Reason],
                limits: Limits::default(),
            });
            let Response::Explained(last) = serve(&request, &host) else {
                panic!("{seed} {question:?}");
            };
            let vector = |answer: &ExplainAnswer| {
                let costs = answer.costs?;
                Some(costs.vector(instance.objective()))
            };
            let mut before: Option<Vec<u32>> = None;
            for told in host.0.into_inner() {
                if told.verdict == Verdict::Unknown {
                    continue;
                }
                assert_eq!(told.verdict, last.verdict, "{seed} {question:?}");
                let (now, end) = (vector(&told), vector(&last));
                assert!(now >= end && before.is_none_or(|it| Some(it) >= now));
                if told.words.contains("none costs as little") {
                    early += 1;
                    assert!(told.pending.contains(&Part::Closest), "{:?}", told.pending);
                    let first = |it: &Option<Vec<u32>>| it.as_ref()?.first().copied();
                    assert_eq!(first(&now), first(&end), "{seed} {question:?}");
                    fallen += u32::from(now > end);
                }
                before = now;
            }
            assert!(!last.words.contains("costs as little"), "{}", last.words);
        }
    }
    assert!(early > 0 && fallen > 0, "{early} {fallen}");
}

/// Where the plan is not proved best, a plan near by that costs the same or less is enough for a
/// verdict on a large floor, and one that costs less is made as cheap as can be.
#[test]
fn a_known_plan_is_enough_where_the_plan_is_not_proved_best() {
    let (mut needless, mut improvable) = (0, 0);
    for seed in 0..40 {
        let instance = random(seed, 3);
        let solve = Request::Solve(SolveRequest {
            scene: instance.to_scene(),
            ..SolveRequest::default()
        });
        let Response::Solved(solved) = serve(&solve, &SilentHost) else {
            panic!("{seed}");
        };
        let Some(best) = solved.plan else { continue };
        let ask = |plan: &Plan, question: &Question, host: &dyn Host| {
            let request = Request::Explain(ExplainRequest {
                scene: instance.to_scene(),
                plan: Some(plan.clone()),
                question: question.clone(),
                changes: None,
                at: None,
                objective: None,
                within: None,
                proved: None,
                known: None,
                layers: vec![Layer::Near, Layer::Whole],
                limits: Limits::default(),
            });
            match serve(&request, host) {
                Response::Explained(answer) => *answer,
                other => panic!("{other:?}"),
            }
        };
        // A plan that costs more: the best with what a question asks for.
        let mut worse = questions(&instance, &best)
            .into_iter()
            .filter_map(|question| {
                let answer = ask(&best, &question, &SilentHost);
                let is_costly = answer.verdict == Verdict::Costly;
                answer.alternative.filter(|_| is_costly)
            });
        let Some(plan) = worse.next() else { continue };
        for question in questions(&instance, &plan).into_iter().take(6) {
            let settled = ask(&plan, &question, &SilentHost);
            let on_floor = ask(&plan, &question, &Eager::default());
            let both = (settled.verdict, on_floor.verdict);
            let same = settled.deltas == on_floor.deltas;
            match both {
                (Verdict::Improvable, Verdict::Needless) => {
                    assert!(!on_floor.reach.is_complete(), "{seed} {question:?}");
                    assert!(on_floor.deltas.values().all(|&more| more == 0));
                    needless += 1;
                }
                (one, other) => assert!(one == other && same, "{seed} {question:?} {both:?}"),
            }
            improvable += u32::from(on_floor.verdict == Verdict::Improvable);
        }
    }
    assert!(improvable > 0, "{needless} {improvable}");
}

/// A plan that was found before bounds the other plan where the search has no work left; one that
/// is not as asked for, or breaks a rule, changes nothing.
#[test]
fn a_plan_that_was_found_before_is_known() {
    let (mut bounded, mut refused) = (0, 0);
    for seed in 0..30 {
        let instance = random(seed, 2 + (seed % 3) as usize);
        let solve = Request::Solve(SolveRequest {
            scene: instance.to_scene(),
            ..SolveRequest::default()
        });
        let Response::Solved(solved) = serve(&solve, &SilentHost) else {
            panic!("{seed}");
        };
        let Some(plan) = solved.plan else {
            continue;
        };
        for question in questions(&instance, &plan).into_iter().take(8) {
            let ask = |known: Option<&Plan>, work| {
                let request = Request::Explain(ExplainRequest {
                    scene: instance.to_scene(),
                    plan: Some(plan.clone()),
                    question: question.clone(),
                    changes: None,
                    at: None,
                    objective: None,
                    within: None,
                    proved: None,
                    known: known.cloned(),
                    layers: vec![Layer::Whole],
                    limits: Limits {
                        work,
                        ..Limits::default()
                    },
                });
                match serve(&request, &SilentHost) {
                    Response::Explained(answer) => *answer,
                    other => panic!("{other:?}"),
                }
            };
            let best = ask(None, None);
            let unknown = ask(None, Some(1));
            if unknown.verdict != Verdict::Unknown {
                continue;
            }
            if let Some(other) = &best.alternative {
                let told = ask(Some(other), Some(1));
                let name = format!("{seed} {question:?}");
                assert_eq!(told.costs, best.costs, "{name}");
                assert_eq!(told.deltas, best.deltas, "{name}");
                bounded += u32::from(unknown.costs != best.costs);
            }
            let empty = Plan::default();
            for wrong in [&plan, &empty] {
                let told = ask(Some(wrong), Some(1));
                assert_eq!(told.costs, unknown.costs, "{seed} {question:?}");
                refused += 1;
            }
        }
    }
    assert!(bounded > 5 && refused > 20, "{bounded} {refused}");
}
