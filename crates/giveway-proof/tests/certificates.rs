//! Certificates as a whole: made, verified, and refused once anything is changed.
//!
//! The warehouse and the third scenario are examples of the literature: A.
//! Bogatarkan, "Flexible and Explainable Solutions for Multi-Agent Path Finding
//! Problems" (2021); shelf cells and waypoints are reconstructed.
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "a test that cannot go on ends with a panic"
)]

use std::collections::BTreeMap;

use giveway_model::format::native;
use giveway_model::{Cost, Instance, Objective, Plan};
use giveway_proof::bundle::{Entry, Manifest, Method};
use giveway_proof::{Budget, Bundle, Checked, Claim, Solved, confirm, drat, export, plain, verify};

/// Two agents that swap sides of a wall with a gap at the bottom: no plan.
const SCENARIO_6: &str = r#"{ "giveway": 1, "name": "scenario-6",
    "map": [".#.",
            ".#.",
            "..."],
    "agents": [
        { "name": "A1", "start": [0, 0], "goal": [2, 0], "waypoints": [[0, 0]] },
        { "name": "A2", "start": [2, 0], "goal": [0, 0], "waypoints": [[2, 0]] }] }"#;

const WAREHOUSE: &str = r#"{ "giveway": 1, "name": "warehouse",
    "map": ["..~~~~~~..",
            ".##.##.##.",
            "...+..+..."],
    "agents": [
        { "name": "A1", "start": [0, 0], "goal": [9, 2], "waypoints": [[2, 0], [4, 2], [7, 0]],
          "battery": { "capacity": 10, "initial": 10 } },
        { "name": "A2", "start": [9, 2], "goal": [0, 0], "waypoints": [[5, 0], [1, 2]],
          "battery": { "capacity": 10, "initial": 8 } }] }"#;

/// Two agents that cross in a corridor with a bay; b makes room.
const CROSSING: &str = r##"{ "giveway": 1, "name": "crossing",
    "map": ["#.#",
            "..."],
    "agents": [
        { "name": "a", "start": [0, 1], "goal": [2, 1] },
        { "name": "b", "start": [1, 1], "goal": [0, 1] }] }"##;
const CROSSING_PLAN: &str = r#"{ "giveway": 1, "paths": {
    "a": [[0, 1], [1, 1], [2, 1]],
    "b": [[1, 1], [1, 0], [1, 1], [0, 1]] } }"#;

fn instance(text: &str) -> Instance {
    native::read_instance(text).unwrap()
}

fn bounds(instance: &Instance, objective: &str, bounds: &[(Cost, u32)]) -> Bundle {
    let objective: Objective = objective.parse().unwrap();
    let instance = instance.clone().with_objective(objective);
    let solved = Solved {
        instance: &instance,
        bounds: &bounds.iter().copied().collect(),
        impossible: false,
        about: Claim::default(),
        complete: true,
        within: None,
        plan: None,
        hints: &[],
    };
    export(&solved, &Budget::default())
}

fn manifest(bundle: &Bundle) -> Manifest {
    serde_json::from_slice(&bundle["manifest.json"]).unwrap()
}

#[track_caller]
fn accept(bundle: &Bundle) -> Vec<Checked> {
    let report = verify(bundle, &Budget::default());
    assert!(report.accepted, "{:?}", report.reason);
    assert_eq!(report.claims.len(), manifest(bundle).claims.len());
    report.claims
}

/// Changes a byte of each file at several places, each of which must be noticed.
fn refuse_every_change(bundle: &Bundle) {
    for (file, bytes) in bundle {
        let last = bytes.len() - 1;
        let places = (0..24).map(|i| i * last / 23).chain([1, last / 2 + 1]);
        for place in places {
            let mut changed = bundle.clone();
            let byte = &mut changed.get_mut(file).unwrap()[place];
            *byte ^= 1;
            let report = verify(&changed, &Budget::default());
            assert!(!report.accepted, "{file} at {place}");
            assert!(!report.stopped, "{file} at {place}");
        }
        let mut without = bundle.clone();
        without.remove(file);
        assert!(!verify(&without, &Budget::default()).accepted, "{file}");
    }
    let mut with = bundle.clone();
    with.insert("more.txt".to_owned(), Vec::new());
    assert!(!verify(&with, &Budget::default()).accepted);
}

#[test]
fn the_warehouse_has_proofs_of_all_its_bounds() {
    let known = [
        (Cost::Makespan, 18),
        (Cost::SumOfCosts, 35),
        (Cost::Charges, 3),
    ];
    let warehouse = instance(WAREHOUSE);
    let bundle = bounds(&warehouse, "makespan,sum-of-costs,charges", &known);
    let claims = accept(&bundle);
    let proofs = claims
        .iter()
        .filter(|c| matches!(c, Checked::Proof { steps, .. } if *steps > 0));
    assert_eq!(proofs.count(), 3, "{claims:?}");
    refuse_every_change(&bundle);
}

#[test]
fn a_bound_that_is_too_high_has_no_proof() {
    let warehouse = instance(WAREHOUSE);
    let bundle = bounds(&warehouse, "makespan", &[(Cost::Makespan, 19)]);
    let claims = manifest(&bundle).claims;
    let [Entry::None { why, .. }] = claims.as_slice() else {
        panic!("there is a plan of makespan 18");
    };
    let why = why.sentence();
    assert!(why.contains("can be satisfied"), "{why}");
    accept(&bundle);
    let readme = String::from_utf8(bundle["README.md"].clone()).unwrap();
    assert!(readme.contains("*Not certified.*"), "{readme}");
}

#[test]
fn charges_first_rest_on_search_whatever_the_horizon() {
    let warehouse = instance(WAREHOUSE);
    let bundle = bounds(&warehouse, "charges", &[(Cost::Charges, 3)]);
    let claims = manifest(&bundle).claims;
    let searched = claims.iter().any(|entry| {
        matches!(entry, Entry::Search { claim, method: Method::Alone }
            if *claim == Claim::at_most([(Cost::Charges, 2)]))
    });
    assert!(searched, "{claims:?}");
    accept(&bundle);
}

#[test]
fn no_plan_is_a_search_and_up_to_a_makespan_a_proof() {
    let instance = instance(SCENARIO_6);
    let solved = Solved {
        instance: &instance,
        bounds: &BTreeMap::new(),
        impossible: true,
        about: Claim::default(),
        complete: true,
        within: None,
        plan: None,
        hints: &[],
    };
    let bundle = export(&solved, &Budget::default());
    let claims = manifest(&bundle).claims;
    let [
        Entry::Search {
            method: Method::Joint,
            ..
        },
        Entry::Proof { claim, .. },
    ] = claims.as_slice()
    else {
        panic!("{claims:?}");
    };
    // 6 steps alone, and 4 (3 + 3) + 10.
    assert_eq!(claim.within, Some(40));
    accept(&bundle);
    refuse_every_change(&bundle);
}

#[test]
fn a_plan_is_part_of_it_and_judged_again() {
    let instance = instance(CROSSING);
    let plan: Plan = native::read_plan(CROSSING_PLAN).unwrap();
    let bounds = BTreeMap::from([(Cost::Makespan, 3), (Cost::SumOfCosts, 5)]);
    let objective: Objective = "makespan,sum-of-costs".parse().unwrap();
    let instance = instance.with_objective(objective);
    let solved = Solved {
        instance: &instance,
        bounds: &bounds,
        impossible: false,
        about: Claim::default(),
        complete: true,
        within: None,
        plan: Some(&plan),
        hints: &[],
    };
    let bundle = export(&solved, &Budget::default());
    accept(&bundle);
    let readme = String::from_utf8(bundle["README.md"].clone()).unwrap();
    assert!(readme.contains("Together: the plan is optimal"), "{readme}");
    refuse_every_change(&bundle);
}

/// Someone who can write fingerprints and a README cannot write a proof.
#[test]
fn a_claim_that_is_not_the_formula_s_is_refused() {
    let warehouse = instance(WAREHOUSE);
    let bundle = bounds(&warehouse, "makespan", &[(Cost::Makespan, 18)]);
    let mut manifest = manifest(&bundle);
    let Entry::Proof { claim, .. } = &mut manifest.claims[0] else {
        panic!("no proof");
    };
    *claim = Claim::at_most([(Cost::Makespan, 16)]);
    let mut changed = bundle.clone();
    let readme = String::from_utf8(bundle["README.md"].clone()).unwrap();
    let readme = readme.replace("makespan at most 17", "makespan at most 16");
    changed.insert("README.md".to_owned(), readme.into_bytes());
    let honest = |changed: &mut Bundle, manifest: &Manifest| {
        let text = serde_json::to_string_pretty(manifest).unwrap() + "\n";
        changed.insert("manifest.json".to_owned(), text.into_bytes());
    };
    // The fingerprint of the new README, as the report of a wrong one would not tell it.
    manifest
        .files
        .insert("README.md".to_owned(), sha256(&changed["README.md"]));
    honest(&mut changed, &manifest);
    let report = verify(&changed, &Budget::default());
    assert!(!report.accepted);
    let reason = report.reason.unwrap();
    assert!(
        reason.contains("size") || reason.contains("formula"),
        "{reason}"
    );
}

fn sha256(bytes: &[u8]) -> String {
    use sha2::Digest as _;
    format!("{:x}", sha2::Sha256::digest(bytes))
}

#[test]
fn a_cut_proof_is_refused() {
    let warehouse = instance(WAREHOUSE);
    let claim = Claim::at_most([(Cost::Makespan, 17)]);
    let budget = Budget::default();
    let formula = plain::formula(&warehouse, &claim, &budget).unwrap();
    let giveway_proof::Outcome::Proof(proof) = giveway_proof::prove(&formula, &budget) else {
        panic!("no proof");
    };
    let proof = String::from_utf8(proof).unwrap();
    let steps = drat::check(&formula.text(), &proof, &|| true)
        .unwrap()
        .steps;
    let lines: Vec<&str> = proof.split_inclusive('\n').collect();
    let cut: String = lines[..steps - 1].concat();
    let refused = drat::check(&formula.text(), &cut, &|| true);
    assert_eq!(refused, Err(drat::Refused::Unfinished));
    // Without the lemmas in between, the later ones do not follow.
    let holes: String = lines.iter().step_by(2).copied().collect();
    assert!(drat::check(&formula.text(), &holes, &|| true).is_err());
}

#[test]
fn a_budget_that_runs_out_is_no_claim() {
    let warehouse = instance(WAREHOUSE);
    let warehouse = warehouse.with_objective("makespan".parse().unwrap());
    let solved = Solved {
        instance: &warehouse,
        bounds: &BTreeMap::from([(Cost::Makespan, 18)]),
        impossible: false,
        about: Claim::default(),
        complete: true,
        within: None,
        plan: None,
        hints: &[],
    };
    let small = Budget {
        proof_bytes: 100,
        states: 10,
        ..Budget::default()
    };
    let bundle = export(&solved, &small);
    assert!(matches!(
        manifest(&bundle).claims.as_slice(),
        [Entry::None { .. }]
    ));
    let bundle = bounds(&warehouse, "makespan", &[(Cost::Makespan, 18)]);
    let stopped = Budget {
        go_on: &|| false,
        ..Budget::default()
    };
    let report = verify(&bundle, &stopped);
    assert!(!report.accepted && report.stopped, "{report:?}");
}

/// A makespan below the grid distance: still a formula with something in it.
#[test]
fn a_goal_out_of_reach_is_no_empty_formula() {
    let instance = instance(
        r#"{ "giveway": 1, "map": ["....."],
        "agents": [{ "name": "a", "start": [0, 0], "goal": [4, 0] }] }"#,
    );
    let claim = Claim::at_most([(Cost::Makespan, 3)]);
    let formula = plain::formula(&instance, &claim, &Budget::default()).unwrap();
    assert!(formula.iter().all(|clause| !clause.is_empty()));
    let text = formula.text();
    assert!(drat::check(&text, "", &|| true).is_ok());
    let enough = Claim::at_most([(Cost::Makespan, 4)]);
    let formula = plain::formula(&instance, &enough, &Budget::default()).unwrap();
    let outcome = giveway_proof::prove(&formula, &Budget::default());
    assert_eq!(outcome, giveway_proof::Outcome::Satisfiable);
}

#[test]
fn what_is_confirmed_at_once_is_what_its_files_would_show() {
    let budget = Budget::default();
    let compare = |solved: &Solved<'_>| {
        let at_once = confirm(solved, &budget, &budget);
        assert_eq!(at_once, verify(&export(solved, &budget), &budget));
        at_once
    };
    let objective: Objective = "makespan,sum-of-costs".parse().unwrap();
    let crossing = instance(CROSSING).with_objective(objective);
    let plan = native::read_plan(CROSSING_PLAN).unwrap();
    let solved = Solved {
        instance: &crossing,
        about: Claim::default(),
        bounds: &BTreeMap::from([(Cost::Makespan, 3), (Cost::SumOfCosts, 5)]),
        impossible: false,
        complete: true,
        within: None,
        plan: Some(&plan),
        hints: &[],
    };
    assert!(compare(&solved).accepted);
    let wrong = BTreeMap::from([(Cost::Makespan, 4)]);
    let wrong = compare(&Solved {
        bounds: &wrong,
        ..solved.clone()
    });
    // The plan itself shows that it is wrong.
    assert!(!wrong.accepted && wrong.claims.is_empty());
    let impossible = instance(SCENARIO_6);
    let none = compare(&Solved {
        instance: &impossible,
        impossible: true,
        plan: None,
        hints: &[],
        ..solved.clone()
    });
    assert!(matches!(
        none.claims.as_slice(),
        [Checked::Search { .. }, Checked::Proof { .. }]
    ));
    // A plan that breaks a rule is no plan.
    let mut broken = plan.clone();
    broken.paths.remove("b");
    let broken = Solved {
        plan: Some(&broken),
        ..solved
    };
    assert!(!confirm(&broken, &budget, &budget).accepted);
}
