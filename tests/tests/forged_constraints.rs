//! Forged certificates of scenes with rules of their own: a rule that is dropped, switched off
//! or changed, its clauses left out, a plan that breaks it. What is accepted although it was
//! changed must be so, by the oracle of these rules.
//!
//! `GIVEWAY_RULE_FORGERIES` sets how many scenes of each kind are forged (2 by default). The long run:
//!
//! ```text
//! GIVEWAY_RULE_FORGERIES=300 \
//!     cargo test --release -p giveway-tests --test forged_constraints -- --nocapture
//! ```
#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    clippy::panic,
    reason = "a test that cannot go on ends with a panic"
)]

use std::collections::{BTreeMap, BTreeSet};

use giveway_model::check;
use giveway_model::format::native;
use giveway_model::{Cost, Instance, Plan};
use giveway_proof::bundle::Entry;
use giveway_proof::{
    Budget, Bundle, Certified, Checked, Claim, Conclusion, Report, export, plain, verify,
};
use giveway_solve::{
    CertifyRequest, Request, Response, SilentHost, SolveAnswer, SolveRequest, serve,
};
use giveway_tests::environment;
use giveway_tests::forge::{Folder, Seal};
use giveway_tests::rules_oracle::{Answer, RuleScene, best};
use giveway_tests::rules_random::{KINDS, scene_with_rules};
use serde_json::{Value, json};

/// Joint states that the oracle looks at.
const MOST_STATES: usize = 15_000;

fn budget() -> Budget<'static> {
    Budget {
        clauses: 100_000,
        proof_bytes: 2 << 20,
        states: 15_000,
        ..Budget::default()
    }
}

fn solve(instance: &Instance) -> SolveAnswer {
    let request = Request::Solve(SolveRequest {
        scene: instance.to_scene(),
        ..SolveRequest::default()
    });
    let Response::Solved(answer) = serve(&request, &SilentHost) else {
        unreachable!("a solve request is solved")
    };
    answer
}

/// The certificate of a scene, where all of it is certified.
fn honest(scene: &str) -> Option<Bundle> {
    let instance = native::read_instance(scene).unwrap();
    let answer = solve(&instance);
    let request = CertifyRequest::of_solved(instance.to_scene(), None, &answer);
    let bundle = export(&request.claims(&instance), &budget());
    let report = verify(&bundle, &budget());
    assert!(report.accepted, "{:?} {scene}", report.reason);
    let is_settled = matches!(
        report.concluded,
        Some(Conclusion::Best { .. } | Conclusion::NoPlan { .. })
    );
    (report.certified != Certified::NotCertified && is_settled).then_some(bundle)
}

/// What the oracle says of a scene; `None` where it is too large.
fn truth(scene: &str, within: Option<u32>) -> Option<Answer> {
    let scene = RuleScene::read(scene, &[]);
    let answer = best(&scene, within.map(i64::from), MOST_STATES);
    (answer != Answer::Capped).then_some(answer)
}

/// Whether a claim holds, as far as the best costs tell.
fn holds(instance: &Instance, claim: &Claim, scene: &str) -> Option<bool> {
    let Answer::Best(vector) = truth(scene, claim.within)? else {
        return Some(true);
    };
    let objective = instance.in_force(instance.objective().clone());
    let mut left = claim.most.clone();
    for (cost, least) in objective.costs().iter().zip(vector) {
        let Some(most) = left.remove(cost) else {
            break;
        };
        match least.cmp(&i64::from(most)) {
            std::cmp::Ordering::Greater => return Some(true),
            std::cmp::Ordering::Equal => {}
            std::cmp::Ordering::Less => return left.is_empty().then_some(false),
        }
    }
    left.is_empty().then_some(false)
}

/// What of an accepted certificate is not so.
fn lies(folder: &Folder, report: &Report) -> Vec<String> {
    let instance = folder.instance().unwrap();
    let scene = String::from_utf8(folder.files["instance.json"].clone()).unwrap();
    let mut lies = Vec::new();
    for checked in &report.claims {
        if let Checked::Proof { text, claim, .. } | Checked::Search { text, claim, .. } = checked
            && holds(&instance, claim, &scene) == Some(false)
        {
            lies.push(text.clone());
        }
    }
    match &report.concluded {
        Some(Conclusion::Best {
            objective, within, ..
        }) => {
            let costs = check::check(&instance, &folder.plan().unwrap())
                .costs
                .unwrap();
            let own: Vec<i64> = costs.vector(objective).into_iter().map(i64::from).collect();
            if truth(&scene, *within).is_some_and(|best| best != Answer::Best(own)) {
                lies.push("the plan is best".to_owned());
            }
        }
        Some(Conclusion::NoPlan { claim }) => {
            if truth(&scene, claim.within).is_some_and(|best| best != Answer::Impossible) {
                lies.push("there is no plan".to_owned());
            }
        }
        Some(Conclusion::Believed | Conclusion::Bounds) | None => {}
    }
    lies
}

/// The scene of a folder as JSON, and a change of it.
fn edit(folder: &mut Folder, change: impl FnOnce(&mut Value)) -> bool {
    let mut scene: Value = serde_json::from_slice(&folder.files["instance.json"]).unwrap();
    change(&mut scene);
    let Ok(new) = native::read_instance(&scene.to_string()) else {
        return false;
    };
    let text = native::write_scene(&new.to_scene()).into_bytes();
    folder.files.insert("instance.json".to_owned(), text);
    true
}

/// What is changed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Change {
    Dropped,
    Off,
    /// A number of the rule, one more or one less.
    Number(i64),
    /// All agents but one are left out.
    Agents,
    /// A cell of the zone.
    Zone,
    /// All headings.
    Headings,
    /// All clauses that are there because of the rule.
    Clauses,
    /// The plan is the best one without the rule.
    Plan,
    /// All bounds, one more.
    Bound,
}

const CHANGES: [Change; 10] = [
    Change::Dropped,
    Change::Off,
    Change::Number(1),
    Change::Number(-1),
    Change::Agents,
    Change::Zone,
    Change::Headings,
    Change::Clauses,
    Change::Plan,
    Change::Bound,
];

impl Change {
    /// Makes the change about a rule; whether there was something to change.
    fn make(self, folder: &mut Folder, rule: usize) -> bool {
        let before = folder.clone();
        let is_made = match self {
            Self::Dropped => edit(folder, |scene| {
                scene["constraints"].as_array_mut().unwrap().remove(rule);
            }),
            Self::Off => edit(folder, |scene| {
                scene["constraints"][rule]["off"] = json!(true);
            }),
            Self::Number(more) => edit(folder, |scene| {
                let fields = scene["constraints"][rule].as_object_mut().unwrap();
                for value in fields.values_mut() {
                    if let Some(old) = value.as_i64() {
                        *value = json!(old + more);
                    }
                }
            }),
            Self::Agents => edit(folder, |scene| {
                if scene["constraints"][rule]["kind"] != "before"
                    && scene["constraints"][rule]["kind"] != "sequence"
                {
                    let first = scene["agents"][0]["name"].clone();
                    scene["constraints"][rule]["agents"] = json!([first]);
                }
            }),
            Self::Zone => edit(folder, |scene| {
                for zone in scene["zones"].as_array_mut().into_iter().flatten() {
                    zone["cells"].as_array_mut().unwrap().pop();
                }
            }),
            Self::Headings => edit(folder, |scene| {
                for agent in scene["agents"].as_array_mut().unwrap() {
                    agent.as_object_mut().unwrap().remove("heading");
                }
            }),
            Self::Clauses => drop_clauses(folder, rule),
            Self::Plan => other_plan(folder, rule),
            Self::Bound => {
                let mut manifest = folder.read().unwrap();
                for entry in &mut manifest.claims {
                    let (Entry::Proof { claim, .. } | Entry::Search { claim, .. }) = entry else {
                        continue;
                    };
                    for most in claim.most.values_mut() {
                        *most += 1;
                    }
                }
                folder.write(&manifest);
                true
            }
        };
        is_made && (folder.files != before.files || folder.manifest != before.manifest)
    }
}

/// The instance with a rule switched off.
fn without(instance: &Instance, rule: usize) -> Instance {
    let mut scene = instance.to_scene();
    scene.constraints[rule].off = true;
    Instance::new(scene).unwrap()
}

/// Leaves out of each formula what is not in that of the scene without the rule.
fn drop_clauses(folder: &mut Folder, rule: usize) -> bool {
    let instance = folder.instance().unwrap();
    let free = without(&instance, rule);
    let mut manifest = folder.read().unwrap();
    let mut is_dropped = false;
    for entry in &mut manifest.claims {
        let Entry::Proof {
            claim,
            name,
            clauses,
            ..
        } = entry
        else {
            continue;
        };
        let plain = plain::formula(&free, claim, &Budget::default())
            .unwrap()
            .text();
        let kept: BTreeSet<&str> = plain.lines().collect();
        let file = folder.files.get_mut(&format!("{name}.cnf")).unwrap();
        let text = String::from_utf8(file.clone()).unwrap();
        let lines = text.lines().skip(1).filter(|line| kept.contains(line));
        let lines: Vec<&str> = lines.collect();
        is_dropped |= lines.len() < *clauses;
        *clauses = lines.len();
        let variables = text.split_whitespace().nth(2).unwrap();
        let whole = format!("p cnf {variables} {}\n{}\n", lines.len(), lines.join("\n"));
        *file = whole.into_bytes();
    }
    folder.write(&manifest);
    is_dropped
}

/// The best plan without the rule, with its costs.
fn other_plan(folder: &mut Folder, rule: usize) -> bool {
    let instance = folder.instance().unwrap();
    let Some(plan): Option<Plan> = solve(&without(&instance, rule)).plan else {
        return false;
    };
    let text = native::write_plan(&plan).into_bytes();
    folder.files.insert("plan.json".to_owned(), text);
    folder.manifest["costs"] = json!(check::costs(&instance, &plan));
    true
}

#[derive(Debug, Default)]
struct Count {
    rejected: u32,
    so: u32,
    /// Of the rejected ones, those in which the best costs are others.
    false_ones: u32,
}

/// Certificates of scenes with a rule of a kind, without which the best plan would be
/// another; each with the scene and its best costs.
fn tight(kind: &str, wanted: u64) -> Vec<(String, Answer, Bundle)> {
    let mut found = Vec::new();
    for number in 0..wanted * 1000 {
        if found.len() as u64 == wanted {
            break;
        }
        let scene = scene_with_rules(64, number, &[kind]).to_string();
        if kind == "turns" && !scene.contains("heading") {
            continue;
        }
        let free = best(&RuleScene::read(&scene, &[0]), None, MOST_STATES);
        let Some(known) = truth(&scene, None) else {
            continue;
        };
        let is_free = free == known || free == Answer::Capped;
        if !is_free && let Some(bundle) = honest(&scene) {
            found.push((scene, known, bundle));
        }
    }
    found
}

#[test]
fn what_is_accepted_of_a_scene_with_rules_is_so() {
    let wanted = environment::number("GIVEWAY_RULE_FORGERIES", 2);
    let mut counts: BTreeMap<Change, Count> = BTreeMap::new();
    for (number, kind) in (0..).zip(KINDS) {
        let scenes = tight(kind, wanted);
        assert_eq!(scenes.len() as u64, wanted, "{kind}");
        let mut is_caught = false;
        for (scene, known, bundle) in scenes {
            for (i, change) in (0u64..).zip(CHANGES) {
                let mut folder = Folder::open(&bundle);
                if !change.make(&mut folder, 0) {
                    continue;
                }
                let is_other = folder.files["instance.json"] != bundle["instance.json"] && {
                    let text = String::from_utf8(folder.files["instance.json"].clone()).unwrap();
                    truth(&text, None).is_some_and(|other| other != known)
                };
                let early = [Seal::Fingerprints, Seal::Readme];
                let early = early[usize::from((i + number).is_multiple_of(2))];
                let everything = (change != Change::Clauses).then_some(Seal::Everything);
                for seal in [early].into_iter().chain(everything) {
                    let forged = folder.clone().seal(seal);
                    let report = verify(&forged, &budget());
                    let count = counts.entry(change).or_default();
                    if !report.accepted {
                        count.rejected += 1;
                        count.false_ones += u32::from(is_other);
                        is_caught |= is_other && change == Change::Dropped;
                        continue;
                    }
                    let what = format!("{change:?} of {kind}, {seal:?}: {scene}");
                    assert_ne!(change, Change::Clauses, "{what}");
                    count.so += 1;
                    let lies = lies(&Folder::open(&forged), &report);
                    assert_eq!(lies, Vec::<String>::new(), "{what}");
                }
            }
        }
        assert!(is_caught, "{kind}");
    }
    println!("{counts:#?}");
    assert_eq!(counts.len(), CHANGES.len(), "{counts:?}");
    // Without its rule none of these scenes has the same answer.
    let without = counts[&Change::Dropped].so + counts[&Change::Off].so;
    assert_eq!(without, 0, "{counts:?}");
    let mut all = counts.values();
    assert!(all.all(|count| count.rejected > 0), "{counts:?}");
}

/// A claim about the penalty has a proof of its own name, and no other.
#[test]
fn a_proof_about_the_penalty_is_named_so() {
    let scene = r#"{ "giveway": 1, "map": ["..."], "objective": ["moves"],
        "zones": [{ "name": "middle", "cells": [[1, 0]] }],
        "constraints": [{ "kind": "avoid", "zone": "middle", "weight": 3 },
                        { "kind": "arrive", "by": 1, "weight": 2 }],
        "agents": [{ "name": "a", "start": [0, 0], "goal": [2, 0] }] }"#;
    let bundle = honest(scene).unwrap();
    let manifest = Folder::open(&bundle).read().unwrap();
    let last = manifest.objective.costs().last();
    assert_eq!(last, Some(&Cost::Penalty));
    // Once through the zone, and a step too late.
    assert_eq!(manifest.costs.unwrap().penalty, 5);
    let readme = String::from_utf8(bundle["README.md"].clone()).unwrap();
    assert!(
        readme.contains("penalty 5") || readme.contains("penalty of 5"),
        "{readme}"
    );
}
