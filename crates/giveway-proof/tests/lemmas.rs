//! Certificates of lemmas: made of guesses, verified, and refused once anything in them is changed.
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "a test that cannot go on ends with a panic"
)]

use std::collections::BTreeMap;

use giveway_model::format::native;
use giveway_model::{Cost, Instance};
use giveway_proof::bundle::{Entry, Manifest, fingerprint};
use giveway_proof::{
    Budget, Bundle, Certified, Checked, Claim, Hint, Least, Lemma, Solved, confirm, export, verify,
};

/// Twice two agents that cross in a corridor with a bay, where b makes room for a: of each two, one has to
/// be two steps late, or both one.
const CROSSINGS: &str = r####"{ "giveway": 1, "name": "crossings", "objective": ["sum-of-costs"],
    "map": ["#.#",
            "...",
            "###",
            "#.#",
            "..."],
    "agents": [
        { "name": "a", "start": [0, 1], "goal": [2, 1] },
        { "name": "b", "start": [1, 1], "goal": [0, 1] },
        { "name": "c", "start": [0, 4], "goal": [2, 4] },
        { "name": "d", "start": [1, 4], "goal": [0, 4] }] }"####;

/// The least sum of costs: 2 and 1 steps alone, and 2 more, twice.
const LEAST: u32 = 10;

/// The formula of all agents is too large.
fn budget() -> Budget<'static> {
    Budget {
        small_formula: 0,
        clauses: 450,
        ..Budget::default()
    }
}

/// A guess that these agents lose so much together.
fn hint(agents: &[&str], more: u32) -> Hint {
    Hint {
        cost: Cost::SumOfCosts,
        limits: BTreeMap::new(),
        agents: agents.iter().map(|&name| name.to_owned()).collect(),
        more,
        is_clause: false,
    }
}

fn certificate(instance: &Instance, bound: u32, hints: &[Hint]) -> Bundle {
    export(
        &solved(
            instance,
            &BTreeMap::from([(Cost::SumOfCosts, bound)]),
            hints,
        ),
        &budget(),
    )
}

fn solved<'a>(
    instance: &'a Instance,
    bounds: &'a BTreeMap<Cost, u32>,
    hints: &'a [Hint],
) -> Solved<'a> {
    Solved {
        instance,
        bounds,
        impossible: false,
        about: Claim::default(),
        complete: true,
        within: None,
        plan: None,
        hints,
    }
}

fn crossings() -> Instance {
    native::read_instance(CROSSINGS).unwrap()
}

fn manifest(bundle: &Bundle) -> Manifest {
    serde_json::from_slice(&bundle["manifest.json"]).unwrap()
}

/// The bundle with another manifest, and all that follows from it but formulas and proofs.
fn sealed(mut bundle: Bundle, mut manifest: Manifest, instance: &Instance) -> Bundle {
    bundle.insert(
        "README.md".to_owned(),
        manifest.readme(instance).into_bytes(),
    );
    bundle.remove("manifest.json");
    let files = bundle.iter();
    manifest.files = files
        .map(|(name, bytes)| (name.clone(), fingerprint(bytes)))
        .collect();
    bundle.insert("manifest.json".to_owned(), manifest.text().into_bytes());
    bundle
}

#[track_caller]
fn lemmas(bundle: &Bundle) -> Vec<Lemma> {
    let [Entry::Lemmas { lemmas, least, .. }] = &manifest(bundle).claims[..] else {
        panic!("{:?}", manifest(bundle).claims);
    };
    // These goals are as many steps away as an agent alone needs.
    assert_eq!(*least, Least::Distance);
    lemmas.iter().map(|proved| proved.lemma.clone()).collect()
}

#[test]
fn two_lemmas_of_two_agents_show_the_sum_of_four() {
    let instance = crossings();
    let bundle = certificate(
        &instance,
        LEAST,
        &[hint(&["a", "b"], 2), hint(&["c", "d"], 2)],
    );
    let of = |agents: [(&str, u32); 2]| Lemma {
        by: agents.map(|(name, by)| (name.to_owned(), by)).into(),
        most: BTreeMap::from([(Cost::SumOfCosts, 4)]),
    };
    assert_eq!(
        lemmas(&bundle),
        [of([("a", 3), ("b", 2)]), of([("c", 3), ("d", 2)])]
    );
    let report = verify(&bundle, &Budget::default());
    assert!(report.accepted, "{:?}", report.reason);
    assert_eq!(report.certified, Certified::Proved);
    let [Checked::Lemmas { lemmas, .. }] = &report.claims[..] else {
        panic!("{:?}", report.claims);
    };
    assert_eq!(
        lemmas[0].text,
        "Even without the other robots there is no plan with sum of costs at most 4 in which a arrives \
         by 3 and b arrives by 2."
    );
    assert!(
        report
            .summary()
            .starts_with("1 claim rests on 2 lemmas, the largest about 2 robots: ")
    );
    // What is confirmed at once is the same.
    let bounds = BTreeMap::from([(Cost::SumOfCosts, LEAST)]);
    let hints = [hint(&["a", "b"], 2), hint(&["c", "d"], 2)];
    let at_once = confirm(
        &solved(&instance, &bounds, &hints),
        &budget(),
        &Budget::default(),
    );
    assert_eq!(at_once, report);
}

#[test]
fn what_is_missing_is_found_and_what_is_wrong_is_left_out() {
    let instance = crossings();
    // Of one pair nothing is guessed, of the other too much, and of all four too little.
    let hints = [hint(&["a", "b"], 3), hint(&["a", "b", "c", "d"], 1)];
    let bundle = certificate(&instance, LEAST, &hints);
    let found = lemmas(&bundle);
    assert!(
        found.iter().any(|lemma| lemma.by.keys().eq(["c", "d"])),
        "{found:?}"
    );
    assert!(verify(&bundle, &Budget::default()).accepted);
}

#[test]
fn a_bound_that_is_too_high_has_no_lemmas() {
    let instance = crossings();
    let hints = [hint(&["a", "b"], 2), hint(&["c", "d"], 3)];
    let bundle = certificate(&instance, LEAST + 1, &hints);
    let is_lemmas = |entry: &Entry| matches!(entry, Entry::Lemmas { .. });
    assert!(!manifest(&bundle).claims.iter().any(is_lemmas));
    let report = verify(&bundle, &Budget::default());
    assert_eq!(report.certified, Certified::NotCertified);
}

#[test]
fn a_changed_byte_is_refused() {
    let bundle = certificate(
        &crossings(),
        LEAST,
        &[hint(&["a", "b"], 2), hint(&["c", "d"], 2)],
    );
    for (file, bytes) in &bundle {
        for place in (0..bytes.len()).step_by(1 + bytes.len() / 20) {
            let mut changed = bundle.clone();
            changed.get_mut(file).unwrap()[place] ^= 1;
            let report = verify(&changed, &Budget::default());
            assert!(!report.accepted, "{file} at {place}");
        }
        let mut without = bundle.clone();
        without.remove(file);
        assert!(!verify(&without, &Budget::default()).accepted, "{file}");
    }
}

/// Whoever knows the format and writes everything anew but a proof that does not exist.
#[test]
fn lemmas_that_are_not_so_or_not_enough_are_refused() {
    type Change = fn(&mut Vec<giveway_proof::ProvedLemma>);
    let changes: [(&str, Change); 7] = [
        ("more than is so", |lemmas| {
            lemmas[0]
                .lemma
                .most
                .values_mut()
                .for_each(|most| *most += 1);
        }),
        ("later than is so", |lemmas| {
            lemmas[0].lemma.most.clear();
        }),
        ("less than is proved", |lemmas| {
            lemmas[0].lemma.by.values_mut().for_each(|by| *by -= 1);
        }),
        ("one is missing", |lemmas| drop(lemmas.pop())),
        ("an agent that does not exist", |lemmas| {
            let by = lemmas[0].lemma.by.remove("a").unwrap();
            lemmas[0].lemma.by.insert("nobody".to_owned(), by);
        }),
        ("about nobody", |lemmas| lemmas[0].lemma.by.clear()),
        ("two of one name", |lemmas| {
            lemmas[1].name = lemmas[0].name.clone();
        }),
    ];
    let instance = crossings();
    let bundle = certificate(
        &instance,
        LEAST,
        &[hint(&["a", "b"], 2), hint(&["c", "d"], 2)],
    );
    for (what, change) in changes {
        let mut manifest = manifest(&bundle);
        let Entry::Lemmas { lemmas, .. } = &mut manifest.claims[0] else {
            panic!("no lemmas");
        };
        change(lemmas);
        let report = verify(
            &sealed(bundle.clone(), manifest, &instance),
            &Budget::default(),
        );
        assert!(!report.accepted, "{what}");
        assert!(!report.stopped, "{what}");
    }
}

#[test]
fn lemmas_show_nothing_of_some_plans_only() {
    let instance = crossings();
    let bundle = certificate(
        &instance,
        LEAST,
        &[hint(&["a", "b"], 2), hint(&["c", "d"], 2)],
    );
    let mut manifest = manifest(&bundle);
    let Entry::Lemmas { claim, .. } = &mut manifest.claims[0] else {
        panic!("no lemmas");
    };
    claim.within = Some(4);
    let report = verify(&sealed(bundle, manifest, &instance), &Budget::default());
    assert!(!report.accepted);
}
