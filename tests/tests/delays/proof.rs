//! How many steps every plan loses, by the oracle.

use giveway_model::format::native;
use giveway_model::{Cost, Objective};
use giveway_solve::delays::DelaysRequest;
use giveway_solve::{Limits, Request, Response, SilentHost, serve};
use giveway_tests::random::small;
use giveway_tests::rules_random::{KINDS, scene_with_rules};

use crate::{ask, least, ledger, plans, scenes};

/// What is proved of the sum of all delays is what no plan is better than, by the oracle.
#[test]
fn no_plan_loses_less_than_is_proved() {
    let (seed, count) = scenes(100);
    let (mut proved, mut improvable) = (0, 0);
    for number in 0..count {
        let scene = scene_with_rules(seed ^ 0xde1a, number, &KINDS[..3]);
        let instance = native::read_instance(&scene.to_string()).unwrap();
        let sum_first = [Cost::SumOfCosts];
        let makespan_first = [Cost::Makespan, Cost::SumOfCosts];
        for plan in plans(&instance) {
            for objective in [&sum_first[..], &makespan_first[..]] {
                let objective = Objective::new(objective.to_vec()).unwrap();
                let answer = ask(DelaysRequest {
                    scene: instance.to_scene(),
                    plan: Some(plan.clone()),
                    objective: Some(objective.clone()),
                    limits: Limits {
                        work: Some(5_000_000),
                        ..Limits::default()
                    },
                    ..DelaysRequest::default()
                });
                let Some(proof) = answer.proof else {
                    assert_eq!(answer.delay, 0);
                    continue;
                };
                let given = proof.given.get(&Cost::Makespan).copied();
                assert_eq!(given.is_some(), objective.costs().len() == 2);
                let Some(sum) = least(&instance, &sum_first, given) else {
                    continue;
                };
                let what = format!("{seed}-{number}");
                let least = sum[0] - answer.alone;
                assert_eq!((proof.at_least, proof.at_most), (least, least), "{what}");
                proved += u32::from(least == answer.delay);
                improvable += u32::from(least < answer.delay);
                let sentence = if least < answer.delay {
                    " fewer."
                } else {
                    " loses less."
                };
                assert!(answer.words.contains(sentence), "{what}: {}", answer.words);
            }
        }
    }
    println!("{proved} proved, {improvable} improvable");
    assert!(proved > 0 && improvable > 0);
}

#[test]
fn a_solved_scene_has_its_proof_from_its_search() {
    let (seed, count) = scenes(60);
    let mut proved = 0;
    for number in 0..count {
        let instance = small(seed, number);
        let request = DelaysRequest {
            scene: instance.to_scene(),
            ..DelaysRequest::default()
        };
        let Response::Delays(found) = serve(&Request::Delays(request), &SilentHost) else {
            continue; // there is no plan
        };
        let Some(plan) = &found.plan else { continue };
        let again = ledger(&instance, plan);
        assert_eq!(again.agents, found.agents, "{number}");
        if let Some(proof) = &found.proof {
            assert!(proof.at_least <= proof.at_most, "{number}");
            assert_eq!(proof.at_most, found.delay, "{number}");
            proved += u32::from(proof.at_least == found.delay);
        } else {
            assert_eq!(found.delay, 0, "{number}");
        }
    }
    assert!(proved > 0);
}
