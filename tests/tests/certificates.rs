//! Certificates beside the oracle, on the graded instances, and before a checker
//! of somebody else.
#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    clippy::panic,
    reason = "a test that cannot go on ends with a panic"
)]

use std::collections::BTreeMap;
use std::fs;
use std::io::ErrorKind;
use std::path::Path;
use std::process::Command;

use giveway_model::{Cost, Instance, Objective};
use giveway_proof::bundle::{Entry, Manifest};
use giveway_proof::exhaust::{Exhausted, exhaust, exhaust_kind};
use giveway_proof::{
    Budget, Bundle, Certified, Claim, Conclusion, Outcome, Solved, drat, export, plain, prove,
    verify,
};
use giveway_solve::{CertifyRequest, Status, Thresholds};
use giveway_tests::oracle::{Question, Verdict};
use giveway_tests::{ask, known, questions, random, recount, truth};

/// Whether the plain formula of a claim can be satisfied; a proof that it
/// cannot is checked.
fn is_satisfiable(instance: &Instance, claim: &Claim) -> bool {
    let budget = Budget::default();
    let formula = plain::formula(instance, claim, &budget).unwrap();
    match prove(&formula, &budget) {
        Outcome::Satisfiable => true,
        Outcome::Proof(proof) => {
            let proof = String::from_utf8(proof).unwrap();
            if let Err(refused) = drat::check(&formula.text(), &proof, &|| true) {
                panic!("{refused}: {} {:?}", claim.sentence(), instance.to_scene());
            }
            false
        }
        Outcome::Stopped => panic!("too large: {}", claim.sentence()),
    }
}

/// The least that a plan costs of one cost, whatever the others, and within a
/// horizon: the formula must allow just that.
fn compare_formula(instance: &Instance, cost: Cost, within: u32) -> Option<bool> {
    let objective = Objective::new(vec![cost]).unwrap();
    let instance = instance.clone().with_objective(objective);
    let question = Question {
        instance: &instance,
        within: Some(within),
        cap: 300_000,
    };
    let claim =
        |most: Option<u32>| Claim::at_most(most.map(|most| (cost, most))).within(Some(within));
    let told = |claim: Claim| format!("{} {:?}", claim.sentence(), instance.to_scene());
    match question.best() {
        Verdict::Capped => None,
        Verdict::Impossible => {
            let none = claim(None);
            assert!(!is_satisfiable(&instance, &none), "{}", told(none));
            Some(false)
        }
        Verdict::Best(point) => {
            let least = point.vector[0];
            let enough = claim(Some(least));
            assert!(is_satisfiable(&instance, &enough), "{}", told(enough));
            if let Some(below) = least.checked_sub(1) {
                let less = claim(Some(below));
                assert!(!is_satisfiable(&instance, &less), "{}", told(less));
            }
            Some(true)
        }
    }
}

#[test]
fn formulas_agree_with_the_oracle() {
    let (mut plans, mut none) = (0, 0);
    for number in 0..120 {
        let instance = random::small(11, number);
        let cost = Cost::USUAL[number as usize % 5];
        match compare_formula(&instance, cost, (number % 13) as u32) {
            Some(true) => plans += 1,
            Some(false) => none += 1,
            None => {}
        }
    }
    println!("{plans} with plans, {none} without");
    assert!(plans >= 30 && none >= 20, "{plans} {none}");
}

/// Two costs at once, and the search that certificates rest on beside a proof.
#[test]
fn searches_agree_with_the_oracle() {
    let (mut plans, mut none, mut pairs) = (0, 0, 0);
    for number in 0..80 {
        let instance = random::small(12, number);
        let costs = vec![
            Cost::USUAL[number as usize % 5],
            Cost::USUAL[(number as usize + 1 + number as usize / 5 % 4) % 5],
        ];
        let objective = Objective::new(costs.clone()).unwrap();
        let instance = instance.with_objective(objective);
        let question = Question {
            instance: &instance,
            within: None,
            cap: 200_000,
        };
        let all: Vec<usize> = (0..instance.agents().len()).collect();
        let search = |most: &BTreeMap<Cost, u32>| {
            let budget = Budget::default();
            exhaust(&instance, &all, most, &budget)
        };
        let told = || format!("{costs:?} {:?}", instance.to_scene());
        match question.best() {
            Verdict::Capped => {}
            Verdict::Impossible => {
                none += 1;
                assert_eq!(search(&BTreeMap::new()), Exhausted::NoPlan, "{}", told());
            }
            Verdict::Best(point) => {
                plans += 1;
                let [first, second] = [point.vector[0], point.vector[1]];
                let most = BTreeMap::from([(costs[0], first), (costs[1], second)]);
                assert!(matches!(search(&most), Exhausted::Plan(_)), "{}", told());
                for (cost, least) in [(costs[0], first), (costs[1], second)] {
                    let Some(below) = least.checked_sub(1) else {
                        continue;
                    };
                    let mut less = most.clone();
                    less.insert(cost, below);
                    assert_eq!(search(&less), Exhausted::NoPlan, "{}", told());
                    let claim = Claim::at_most(less);
                    if claim.horizon(&instance).is_some() {
                        pairs += 1;
                        assert!(!is_satisfiable(&instance, &claim), "{}", told());
                    }
                }
            }
        }
    }
    println!("{plans} with plans, {none} without, {pairs} proofs of two limits");
    assert!(
        plans >= 30 && none >= 5 && pairs >= 20,
        "{plans} {none} {pairs}"
    );
}

/// The search with a condition, such as a question asks for, and with a limit.
#[test]
fn searches_of_a_kind_agree_with_the_oracle() {
    let (mut plans, mut none) = (0, 0);
    let mut kinds: BTreeMap<&str, u64> = BTreeMap::new();
    let budget = Budget {
        states: 30_000,
        ..Budget::default()
    };
    for number in 0..400 {
        let Some(case) = questions::random(21, number) else {
            continue;
        };
        let (instance, question) = (&case.instance, &case.question);
        let Some(mut claim) = Claim::contrast(question, instance, &case.plan) else {
            continue;
        };
        let cost = Cost::USUAL[number as usize % 5];
        if number % 2 == 0 {
            claim
                .most
                .insert(cost, recount::costs(&case.plan).get(cost));
        }
        let found = match exhaust_kind(instance, &claim, &budget) {
            Exhausted::Stopped => continue,
            Exhausted::Plan(_) => true,
            Exhausted::NoPlan => false,
        };
        let Some(holds) = truth::holds(instance, &claim) else {
            continue;
        };
        assert_ne!(found, holds, "{claim:?} {:?}", instance.to_scene());
        *kinds.entry(question.kind()).or_default() += 1;
        if found {
            plans += 1;
        } else {
            none += 1;
        }
    }
    println!("{plans} with plans, {none} without; {kinds:?}");
    assert!(plans >= 60 && none >= 40, "{plans} {none}");
    assert!(kinds.len() >= 15, "{kinds:?}");
}

/// The certificate that an instance has no smaller makespan.
fn makespan(instance: &Instance, makespan: u32) -> Bundle {
    let instance = instance.clone().with_objective("makespan".parse().unwrap());
    export(
        &Solved {
            instance: &instance,
            bounds: &BTreeMap::from([(Cost::Makespan, makespan)]),
            impossible: false,
            about: Claim::default(),
            complete: true,
            within: None,
            plan: None,
            hints: &[],
        },
        &Budget::default(),
    )
}

/// The certificates of the worked examples and of graded instances, by name.
fn bundles() -> Vec<(String, Bundle)> {
    let graded = [
        "A01", "A02", "A03", "A04", "B01", "B02", "B03", "B04", "B05",
    ];
    let rows = known::rows();
    let least = |name: &str| rows.iter().find(|row| row.name == name).unwrap().makespan;
    let mut bundles: Vec<(String, Bundle)> = graded
        .into_iter()
        .map(|name| (name.to_owned(), makespan(&known::mmapf(name), least(name))))
        .collect();
    // The makespans stand in the README of the examples.
    for (name, least) in [("warehouse", 18), ("scenario-1", 4), ("dynamic-3x3", 4)] {
        let instance = known::instance(&format!("seed/{name}.json"));
        bundles.push((name.to_owned(), makespan(&instance, least)));
    }
    let instance = known::instance("seed/scenario-6.json");
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
    bundles.push(("scenario-6".to_owned(), export(&solved, &Budget::default())));
    bundles
}

fn proofs(bundle: &Bundle) -> Vec<String> {
    let manifest: Manifest = serde_json::from_slice(&bundle["manifest.json"]).unwrap();
    let proofs = manifest.claims.into_iter().filter_map(|entry| match entry {
        Entry::Proof { name, .. } => Some(name),
        _ => None,
    });
    proofs.collect()
}

#[test]
fn makespans_are_certified_and_no_byte_may_change() {
    for (name, bundle) in bundles() {
        assert_eq!(proofs(&bundle).len(), 1, "{name}");
        let report = verify(&bundle, &Budget::default());
        assert!(report.accepted, "{name}: {:?}", report.reason);
        for (file, bytes) in &bundle {
            for place in [0, bytes.len() / 3, bytes.len() / 2, bytes.len() - 1] {
                let mut changed = bundle.clone();
                changed.get_mut(file).unwrap()[place] ^= 1;
                let report = verify(&changed, &Budget::default());
                assert!(!report.accepted, "{name}: {file} at {place}");
            }
        }
    }
}

/// What `rate` says of a proof: whether it accepts it. `None` where it is not
/// installed; `./x test` installs it.
fn rate(folder: &Path, name: &str) -> Option<bool> {
    let output = Command::new("rate")
        .arg("--skip-unit-deletions")
        .args([format!("{name}.cnf"), format!("{name}.drat")])
        .current_dir(folder)
        .output();
    match output {
        Ok(output) => {
            let said = String::from_utf8_lossy(&output.stdout).into_owned();
            let accepted = said.lines().any(|line| line.trim() == "s VERIFIED");
            assert_eq!(accepted, output.status.success(), "{said}");
            Some(accepted)
        }
        Err(error) if error.kind() == ErrorKind::NotFound => None,
        Err(error) => panic!("rate: {error}"),
    }
}

#[test]
fn a_checker_of_somebody_else_accepts_the_proofs() {
    for (name, bundle) in bundles() {
        let folder = tempfile::tempdir().unwrap();
        for (file, bytes) in &bundle {
            fs::write(folder.path().join(file), bytes).unwrap();
        }
        for proof in proofs(&bundle) {
            let Some(accepted) = rate(folder.path(), &proof) else {
                println!("rate is not installed: nothing was tested");
                return;
            };
            assert!(accepted, "{name}");
            // It must be able to refuse: half of a proof is none, unless propagation is enough.
            let drat = folder.path().join(format!("{proof}.drat"));
            let whole = fs::read_to_string(&drat).unwrap();
            let formula = fs::read_to_string(folder.path().join(format!("{proof}.cnf"))).unwrap();
            if drat::check(&formula, "", &|| true).is_err() {
                fs::write(&drat, "").unwrap();
                assert_eq!(rate(folder.path(), &proof), Some(false), "{name}");
                fs::write(&drat, whole).unwrap();
            }
        }
    }
}

/// The formula of forty robots would be too large: lemmas about few of them show the sum of costs.
#[test]
fn forty_robots_are_certified_by_lemmas_about_few() {
    let instance = known::mmapf("B10");
    let answer = ask::best_at_pace(&instance, None, Thresholds::default(), None);
    assert_eq!(answer.status, Status::Optimal);
    let request = CertifyRequest::of_solved(instance.to_scene(), None, &answer);
    let request = request.with_hints(answer.trace.as_ref());
    let bundle = export(&request.claims(&instance), &Budget::default());
    let manifest: Manifest = serde_json::from_slice(&bundle["manifest.json"]).unwrap();
    let lemmas = manifest.claims.iter().find_map(|entry| match entry {
        Entry::Lemmas { lemmas, .. } => Some(lemmas),
        Entry::Proof { .. } | Entry::Search { .. } | Entry::None { .. } => None,
    });
    let lemmas = lemmas.unwrap();
    let largest = lemmas.iter().map(|proved| proved.lemma.by.len()).max();
    assert!(largest <= Some(6), "{largest:?}");
    let report = verify(&bundle, &Budget::default());
    assert!(report.accepted, "{:?}", report.reason);
    assert_ne!(report.certified, Certified::NotCertified);
    assert!(matches!(report.concluded, Some(Conclusion::Best { .. })));
}
