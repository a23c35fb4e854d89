//! Honest certificates of all kinds, of random small instances.

use std::collections::BTreeMap;

use giveway_model::{Cost, Instance, Objective};
use giveway_proof::bundle::{Entry, Manifest};
use giveway_proof::{Budget, Bundle, Certified, export, verify};
use giveway_solve::{CertifyRequest, Status, Thresholds};

use crate::{answers, ask, questions, random};

/// What a certificate shows, and by what.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Shows {
    /// The best plan by the default objective.
    Optimal,
    /// The best plan, charges before all else.
    ChargesFirst,
    /// The best plan within a makespan.
    OptimalWithin,
    /// No plan at all, by search.
    Impossible,
    /// No plan within a makespan, by a proof.
    ImpossibleWithin,
    /// No plan of a kind that a question asks for.
    Necessary,
    /// The best plan of a kind that a question asks for.
    Costly,
    /// The best plan by the default objective, by lemmas.
    Lemmas,
}

const ALL: [Shows; 8] = [
    Shows::Optimal,
    Shows::ChargesFirst,
    Shows::OptimalWithin,
    Shows::Impossible,
    Shows::ImpossibleWithin,
    Shows::Necessary,
    Shows::Costly,
    Shows::Lemmas,
];

/// Two certificates of each kind.
pub fn certificates(seed: u64) -> BTreeMap<Shows, Vec<Bundle>> {
    let mut found: BTreeMap<Shows, Vec<Bundle>> = BTreeMap::new();
    for shows in ALL {
        let bundles = (0..1000).filter_map(|number| certificate(shows, seed, number));
        let bundles: Vec<Bundle> = bundles.take(2).collect();
        found.insert(shows, bundles);
    }
    found
}

/// The certificate of a number, if it is of the kind.
fn certificate(shows: Shows, seed: u64, number: u64) -> Option<Bundle> {
    let instance = random::small(seed, number);
    if instance.agents().len() != 2 {
        return None;
    }
    let (instance, request) = match shows {
        Shows::Necessary | Shows::Costly => explained(shows, seed, number)?,
        _ => solved(shows, instance)?,
    };
    let bundle = export(&request.claims(&instance), &trying(shows));
    let manifest: Manifest = serde_json::from_slice(&bundle["manifest.json"]).unwrap();
    let claims = &manifest.claims;
    let search = |entry: &Entry| matches!(entry, Entry::Search { .. });
    let suits = match shows {
        Shows::Impossible => claims.iter().any(search),
        Shows::ImpossibleWithin => !claims.iter().any(search),
        Shows::Necessary => claims
            .iter()
            .any(|entry| matches!(entry, Entry::Proof { .. })),
        Shows::Lemmas => {
            let lemmas = claims.iter().map(|entry| match entry {
                Entry::Lemmas { lemmas, .. } => lemmas.len(),
                Entry::Proof { .. } | Entry::Search { .. } | Entry::None { .. } => 0,
            });
            lemmas.max() >= Some(1)
        }
        _ => claims.len() >= 2,
    };
    let small = bundle.values().map(Vec::len).sum::<usize>() < 2_000_000;
    let report = verify(&bundle, &Budget::default());
    assert!(report.accepted, "{:?}", report.reason);
    // That a condition is never met is shown up to a makespan only.
    let shown = shows == Shows::Necessary || report.certified != Certified::NotCertified;
    (suits && small && shown).then_some(bundle)
}

/// The budget of a certificate; lemmas are tried only where they are what is to be shown.
fn trying(shows: Shows) -> Budget<'static> {
    let whole = Budget::default();
    Budget {
        small_formula: if shows == Shows::Lemmas {
            0
        } else {
            whole.small_formula
        },
        ..whole
    }
}

fn solved(shows: Shows, instance: Instance) -> Option<(Instance, CertifyRequest)> {
    let objective = match shows {
        Shows::Optimal => Objective::default(),
        Shows::ChargesFirst => Objective::new(vec![Cost::Charges, Cost::Makespan]).unwrap(),
        _ => instance.objective().clone(),
    };
    let instance = instance.with_objective(objective);
    let within = matches!(shows, Shows::OptimalWithin | Shows::ImpossibleWithin).then_some(7);
    let answer = match shows {
        Shows::Lemmas => ask::best_at_pace(&instance, None, Thresholds::default(), None),
        _ => ask::best(&instance, within),
    };
    let suits = match shows {
        Shows::Impossible => answer.status == Status::Impossible && answer.reach.is_complete(),
        Shows::ImpossibleWithin => {
            answer.status == Status::Impossible && answer.reach.within().is_some()
        }
        Shows::OptimalWithin => answer.status == Status::Optimal && answer.reach.within().is_some(),
        Shows::ChargesFirst => answer.costs.is_some_and(|costs| costs.charges > 0),
        _ => answer.status == Status::Optimal,
    };
    let request = CertifyRequest::of_solved(instance.to_scene(), None, &answer)
        .with_hints(answer.trace.as_ref());
    suits.then_some((instance, request))
}

fn explained(shows: Shows, seed: u64, number: u64) -> Option<(Instance, CertifyRequest)> {
    use giveway_solve::explain::Verdict;
    let case = questions::random(seed, number)?;
    let answer = answers::explained(&case, None);
    let verdict = match shows {
        Shows::Necessary => Verdict::Necessary,
        _ => Verdict::Costly,
    };
    let request = CertifyRequest::of_explained(&case.instance, Some(&case.plan), &answer);
    let suits = answer.verdict == verdict && request.about.condition.is_some();
    suits.then_some((case.instance, request))
}
