//! Forged certificates: what is accepted although it was changed must be so.
//!
//! `GIVEWAY_RANDOM_FORGERIES` sets how many (200 by default),
//! `GIVEWAY_RANDOM_SEED` the seed. The long run:
//!
//! ```text
//! GIVEWAY_RANDOM_FORGERIES=20000 GIVEWAY_RANDOM_SEED=7 \
//!     cargo test --release -p giveway-tests --test forged_certificates -- --nocapture
//! ```
#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    clippy::panic,
    reason = "a test that cannot go on ends with a panic"
)]

use std::collections::BTreeMap;

use giveway_proof::{Budget, Bundle, Checked, verify};
use giveway_tests::forge::change::{self, Change};
use giveway_tests::forge::honest::{self, Shows};
use giveway_tests::forge::{Folder, Seal};
use giveway_tests::{compare, environment, truth};
use rand::seq::IndexedRandom;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// What became of the forgeries of a kind.
#[derive(Clone, Copy, Debug, Default)]
struct Count {
    rejected: u64,
    so: u64,
    too_large: u64,
    lies: u64,
}

/// What a certificate may take that is far smaller than what is allowed.
fn budget() -> Budget<'static> {
    Budget {
        clauses: 200_000,
        states: 40_000,
        ..Budget::default()
    }
}

/// What of a certificate is not so; nothing where it is rejected.
enum Judged {
    Rejected,
    TooLarge,
    Accepted { lies: Vec<String> },
}

fn judge(bundle: &Bundle) -> Judged {
    let report = verify(bundle, &budget());
    if !report.accepted {
        assert_eq!((report.conclusion, report.concluded), (None, None));
        return Judged::Rejected;
    }
    let folder = Folder::open(bundle);
    let instance = folder.instance().unwrap();
    // What is written behind its arrivals is no part of a plan.
    let plan = folder.plan().map(|mut plan| {
        plan.cut_trailing_goals(&instance);
        plan
    });
    let Some(mut lies) = truth::lies(&instance, plan.as_ref(), &report) else {
        return Judged::TooLarge;
    };
    if let Some(plan) = &plan {
        let costs = folder.read().unwrap().costs.unwrap();
        lies.extend(compare::judge(&instance, plan, &costs));
    }
    Judged::Accepted { lies }
}

/// The forgery of a number.
fn forge(
    honest: &[(Shows, &Bundle)],
    change: Change,
    random: &mut ChaCha8Rng,
) -> (Shows, Seal, Bundle) {
    loop {
        let (shows, bundle) = *honest.choose(random).unwrap();
        let (_, lender) = *honest.choose(random).unwrap();
        let mut folder = Folder::open(bundle);
        if change
            .make(&mut folder, &Folder::open(lender), random)
            .is_none()
        {
            continue;
        }
        let seal = if change.outlives_a_seal() {
            let hard = [Seal::Fingerprints, Seal::Readme, Seal::Broken];
            let most = random.random_bool(0.8);
            if most {
                Seal::Everything
            } else {
                *hard.choose(random).unwrap()
            }
        } else if change == Change::Fingerprint {
            Seal::Broken
        } else {
            Seal::Fingerprints
        };
        let forged = folder.seal(seal);
        if forged != *bundle {
            return (shows, seal, forged);
        }
    }
}

#[test]
fn what_is_accepted_is_so() {
    let seed = environment::number("GIVEWAY_RANDOM_SEED", 1);
    let count = environment::number("GIVEWAY_RANDOM_FORGERIES", 200);
    let certificates = honest::certificates(seed);
    let honest: Vec<(Shows, &Bundle)> = certificates
        .iter()
        .flat_map(|(shows, bundles)| bundles.iter().map(|bundle| (*shows, bundle)))
        .collect();
    assert!(honest.len() >= 12, "{}", honest.len());
    let mut counts: BTreeMap<Change, Count> = BTreeMap::new();
    let mut of: BTreeMap<Shows, u64> = BTreeMap::new();
    for number in 0..count {
        let mut random = ChaCha8Rng::seed_from_u64(seed ^ 0xf0);
        random.set_stream(number);
        let change = change::ALL[number as usize % change::ALL.len()];
        let (shows, seal, forged) = forge(&honest, change, &mut random);
        *of.entry(shows).or_default() += 1;
        let entry = counts.entry(change).or_default();
        match judge(&forged) {
            Judged::Rejected => entry.rejected += 1,
            Judged::TooLarge => entry.too_large += 1,
            Judged::Accepted { lies } if lies.is_empty() => entry.so += 1,
            Judged::Accepted { lies } => {
                entry.lies += 1;
                println!("forgery {number} of seed {seed}: {change:?}, {seal:?}, {shows:?}");
                println!("  accepted, and not so: {lies:?}");
                for name in ["instance.json", "plan.json", "manifest.json"] {
                    let file = forged.get(name).cloned().unwrap_or_default();
                    println!("{name}: {}", String::from_utf8_lossy(&file));
                }
            }
        }
    }
    for (change, count) in &counts {
        println!("{change:?}: {count:?}");
    }
    println!("{of:?}");
    let sum = |field: fn(&Count) -> u64| counts.values().map(field).sum::<u64>();
    assert_eq!(sum(|c| c.lies), 0, "they are printed above");
    assert!(
        sum(|c| c.too_large) * 20 <= count,
        "too many for the oracle"
    );
    assert_eq!(counts.len(), change::ALL.len(), "{counts:?}");
    assert!(of.len() == certificates.len(), "{of:?}");
    assert!(sum(|c| c.rejected) * 2 > count && sum(|c| c.so) * 20 > count);
}

/// The judge of this test finds lies: with a limit more, a claim is none that
/// holds, or there is no plan that costs so little.
#[test]
fn a_claim_with_a_limit_more_is_not_so() {
    let (mut lies, mut so) = (0, 0);
    for (shows, bundles) in honest::certificates(1) {
        for bundle in bundles {
            let instance = Folder::open(&bundle).instance().unwrap();
            let report = verify(&bundle, &budget());
            for checked in &report.claims {
                let (Checked::Proof { claim, .. } | Checked::Search { claim, .. }) = checked else {
                    continue;
                };
                assert_eq!(
                    truth::holds(&instance, claim),
                    Some(true),
                    "{shows:?} {claim:?}"
                );
                so += 1;
                let mut more = claim.clone();
                for most in more.most.values_mut() {
                    *most += 40;
                }
                lies += u64::from(truth::holds(&instance, &more) == Some(false));
            }
        }
    }
    println!("{so} claims that hold, {lies} that do not");
    assert!(so >= 15 && lies >= 10, "{so} {lies}");
}
