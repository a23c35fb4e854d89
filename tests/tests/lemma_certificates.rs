//! Certificates of lemmas: each lemma that is accepted is so, and so is what they show together,
//! by an exhaustive search of the agents of the lemma and of all agents.
//!
//! `GIVEWAY_RANDOM_LEMMAS` sets how many scenes are solved (250 by default), `GIVEWAY_RANDOM_SEED` the
//! seed. The long run:
//!
//! ```text
//! GIVEWAY_RANDOM_LEMMAS=20000 GIVEWAY_RANDOM_SEED=7 \
//!     cargo test --release -p giveway-tests --test lemma_certificates -- --nocapture
//! ```
#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "a test that cannot go on ends with a panic"
)]

use std::collections::BTreeMap;

use giveway_model::{Cost, Instance};
use giveway_proof::bundle::{Entry, Manifest};
use giveway_proof::{Budget, Bundle, Checked, Hint, export, verify};
use giveway_solve::{CertifyRequest, Status, Thresholds};
use giveway_tests::{ask, environment, random, truth};

/// Lemmas are tried before any formula of all agents, which is too large in every other scene.
fn budget(number: u64) -> Budget<'static> {
    Budget {
        small_formula: 0,
        clauses: if number.is_multiple_of(2) {
            20_000
        } else {
            3_000
        },
        proof_bytes: 1 << 18,
        ..Budget::default()
    }
}

/// The claims of the best plan, where it is found.
fn request(instance: &Instance) -> Option<CertifyRequest> {
    let answer = ask::best_at_pace(instance, None, Thresholds::default(), None);
    let is_best = answer.status == Status::Optimal && answer.reach.is_complete();
    is_best.then(|| {
        CertifyRequest::of_solved(instance.to_scene(), None, &answer)
            .with_hints(answer.trace.as_ref())
    })
}

fn certificate(number: u64, instance: &Instance, request: &CertifyRequest) -> Bundle {
    export(&request.claims(instance), &budget(number))
}

/// How many claims about each cost rest on lemmas, and on how many.
fn lemmas(bundle: &Bundle) -> BTreeMap<Cost, usize> {
    let manifest: Manifest = serde_json::from_slice(&bundle["manifest.json"]).unwrap();
    let mut found = BTreeMap::new();
    for entry in manifest.claims {
        if let Entry::Lemmas { claim, lemmas, .. } = entry {
            let cost = claim.most.keys().copied().max().unwrap();
            found.insert(cost, lemmas.len());
        }
    }
    found
}

#[test]
fn lemmas_and_what_they_show_are_so() {
    let seed = environment::number("GIVEWAY_RANDOM_SEED", 1);
    let count = environment::number("GIVEWAY_RANDOM_LEMMAS", 250);
    let (mut solved, mut too_large) = (0, 0);
    let mut shown: BTreeMap<Cost, (u64, usize)> = BTreeMap::new();
    for number in 0..count {
        let instance = random::small(seed, number);
        let Some(request) = request(&instance) else {
            continue;
        };
        solved += 1;
        let bundle = certificate(number, &instance, &request);
        let report = verify(&bundle, &Budget::default());
        assert!(report.accepted, "{number}: {:?}", report.reason);
        for (cost, lemmas) in lemmas(&bundle) {
            let entry = shown.entry(cost).or_default();
            entry.0 += 1;
            entry.1 += lemmas;
        }
        match truth::lies(&instance, request.plan.as_ref(), &report) {
            Some(lies) => assert!(lies.is_empty(), "{number}: {lies:?}"),
            None => too_large += 1,
        }
    }
    println!("{solved} solved, by lemmas: {shown:?}; {too_large} too large for the oracle");
    assert!(too_large * 20 <= solved);
    assert!(
        count < 250 || shown.contains_key(&Cost::SumOfCosts),
        "no sum is shown by lemmas"
    );
}

/// Guesses that are wrong prove nothing: whatever they are, what is accepted is so.
#[test]
fn wrong_guesses_show_nothing_that_is_not_so() {
    let seed = environment::number("GIVEWAY_RANDOM_SEED", 1);
    let count = environment::number("GIVEWAY_RANDOM_LEMMAS", 250) / 5;
    let mut by_lemmas = 0;
    for number in 0..count {
        let instance = random::small(seed ^ 0x1e, number);
        let Some(mut request) = request(&instance) else {
            continue;
        };
        for bound in request.bounds.values_mut() {
            *bound += 1; // claims that are wrong
        }
        request.plan = None;
        let everyone: Vec<String> = instance.agents().iter().map(|it| it.name.clone()).collect();
        for (cost, more) in [
            (Cost::SumOfCosts, 9),
            (Cost::Charges, 3),
            (Cost::Makespan, 0),
        ] {
            request.hints.push(Hint {
                cost,
                limits: everyone.iter().map(|name| (name.clone(), 40)).collect(),
                agents: everyone.clone(),
                more,
                is_clause: more == 0,
            });
        }
        let report = verify(
            &certificate(number, &instance, &request),
            &Budget::default(),
        );
        let is_lemmas = |claim: &&Checked| matches!(claim, Checked::Lemmas { .. });
        by_lemmas += report.claims.iter().filter(is_lemmas).count();
        if let Some(lies) = truth::lies(&instance, None, &report) {
            assert!(lies.is_empty(), "{number}: {lies:?}");
        }
    }
    println!("{by_lemmas} claims by lemmas");
}
