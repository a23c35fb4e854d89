//! One change of a certificate, drawn.

use giveway_model::{Cost, Instance};
use giveway_proof::Claim;
use giveway_proof::bundle::{Entry, Manifest, Method};
use rand::RngExt;
use rand::seq::IndexedRandom;
use rand_chacha::ChaCha8Rng;
use serde_json::{Value, json};

use super::{Folder, files};

/// What is changed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Change {
    /// A number of the manifest.
    Number,
    /// A text of the manifest: a cost, a kind, a name.
    Word,
    /// A horizon, dropped or added.
    Within,
    /// The condition of all claims, dropped or another's.
    Condition,
    /// Claims, dropped, doubled, another's, or without anything to show them.
    Claims,
    /// What a claim says, and all that is to show it.
    Claim,
    /// A clause more or less.
    Formula,
    /// A proof, emptied, cut or another's.
    Proof,
    /// The plan, by a step or a charge, or a worse one.
    Plan,
    /// The instance.
    Instance,
    /// The objective, with or without that of the instance.
    Objective,
    /// A file's name, or a file more or less.
    Name,
    /// The README.
    Readme,
    /// A fingerprint.
    Fingerprint,
}

/// All of them.
pub const ALL: [Change; 14] = [
    Change::Number,
    Change::Word,
    Change::Within,
    Change::Condition,
    Change::Claims,
    Change::Claim,
    Change::Formula,
    Change::Proof,
    Change::Plan,
    Change::Instance,
    Change::Objective,
    Change::Name,
    Change::Readme,
    Change::Fingerprint,
];

impl Change {
    /// Whether what follows from it may be written anew without undoing it.
    pub fn outlives_a_seal(self) -> bool {
        !matches!(
            self,
            Self::Formula | Self::Proof | Self::Name | Self::Readme | Self::Fingerprint
        )
    }

    /// Makes the change in a folder; another one lends what is exchanged. `None`
    /// where there is nothing to change.
    pub fn make(self, folder: &mut Folder, other: &Folder, random: &mut ChaCha8Rng) -> Option<()> {
        match self {
            Self::Number => number(&mut folder.manifest, random),
            Self::Word => word(&mut folder.manifest, random),
            Self::Within => edit(folder, |manifest, instance| {
                within(manifest, instance, random);
            }),
            Self::Condition => edit(folder, |manifest, _| {
                let others = other.read().unwrap().claims;
                let condition = others.first().and_then(|e| e.claim().condition.clone());
                for entry in &mut manifest.claims {
                    claim(entry).condition.clone_from(&condition);
                }
            }),
            Self::Claims => edit(folder, |manifest, _| {
                claims(manifest, &other.read().unwrap(), random);
            }),
            Self::Claim => edit(folder, |manifest, _| another_claim(manifest, random)),
            Self::Formula => files::lines(folder, ".cnf", random),
            Self::Proof => files::proof(folder, other, random),
            Self::Plan => files::plan(folder, random),
            Self::Instance => files::instance(folder, random),
            Self::Objective => files::objective(folder, random),
            Self::Name => files::name(folder, random),
            Self::Readme => files::lines(folder, "README.md", random),
            Self::Fingerprint => {
                let files = folder.manifest["files"].as_object_mut()?;
                let all: Vec<String> = files.keys().cloned().collect();
                let one = all.choose(random)?.clone();
                match random.random_range(0..3) {
                    0 => files.remove(&one),
                    1 => files.insert(one, json!("00")),
                    _ => files.insert("more".to_owned(), json!("00")),
                };
                Some(())
            }
        }
    }
}

/// Another number in the place of one, of any field.
fn number(manifest: &mut Value, random: &mut ChaCha8Rng) -> Option<()> {
    let mut places = Vec::new();
    leaves(manifest, "", &mut |at, value| {
        if value.is_u64() {
            places.push(at.to_owned());
        }
    });
    let value = manifest.pointer_mut(places.choose(random)?)?;
    let old = value.as_i64()?;
    let all = [old + 1, old - 1, 0, i64::from(u32::MAX), i64::MAX];
    *value = json!(all.choose(random)?);
    Some(())
}

/// Another word in the place of one, or a key.
fn word(manifest: &mut Value, random: &mut ChaCha8Rng) -> Option<()> {
    const WORDS: [&str; 15] = [
        "makespan",
        "sum-of-costs",
        "charges",
        "moves",
        "waits",
        "no-plan",
        "proof",
        "search",
        "none",
        "alone",
        "joint",
        "counting",
        "A1",
        "A2",
        "no-horizon",
    ];
    let new = *WORDS.choose(random)?;
    let mut places = Vec::new();
    leaves(manifest, "", &mut |at, value| {
        if value.is_string() && !at.starts_with("/files") {
            places.push(at.to_owned());
        }
        // Limits are by costs, which are keys.
        if at.contains("/most/") {
            places.push(at.to_owned());
        }
    });
    let place = places.choose(random)?;
    let (parent, key) = place.rsplit_once('/')?;
    if parent.ends_with("/most") {
        let most = manifest.pointer_mut(parent)?.as_object_mut()?;
        let value = most.remove(key)?;
        most.insert(new.to_owned(), value);
    } else {
        *manifest.pointer_mut(place)? = json!(new);
    }
    Some(())
}

/// Every value that holds no others, by its place.
fn leaves(value: &Value, at: &str, take: &mut impl FnMut(&str, &Value)) {
    match value {
        Value::Object(fields) => {
            for (key, value) in fields {
                leaves(value, &format!("{at}/{key}"), take);
            }
        }
        Value::Array(items) => {
            for (i, value) in items.iter().enumerate() {
                leaves(value, &format!("{at}/{i}"), take);
            }
        }
        leaf => take(at, leaf),
    }
}

/// Changes the manifest, as long as it is one.
fn edit(folder: &mut Folder, change: impl FnOnce(&mut Manifest, &Instance)) -> Option<()> {
    let (mut manifest, instance) = folder.read().zip(folder.instance())?;
    change(&mut manifest, &instance);
    folder.write(&manifest);
    Some(())
}

fn claim(entry: &mut Entry) -> &mut Claim {
    match entry {
        Entry::Proof { claim, .. }
        | Entry::Lemmas { claim, .. }
        | Entry::Search { claim, .. }
        | Entry::None { claim, .. } => claim,
    }
}

fn within(manifest: &mut Manifest, instance: &Instance, random: &mut ChaCha8Rng) {
    let makespan = manifest.costs.map_or(4, |costs| costs.makespan);
    let cells = instance.grid().width() + instance.grid().height();
    let all = [None, Some(makespan), Some(makespan + cells), Some(u32::MAX)];
    let last = *all.choose(random).unwrap();
    let one = random.random_bool(0.3);
    for entry in manifest.claims.iter_mut().skip(usize::from(one)) {
        claim(entry).within = last;
    }
}

fn claims(manifest: &mut Manifest, other: &Manifest, random: &mut ChaCha8Rng) {
    let some = random.random_range(0..manifest.claims.len().max(1));
    let entries = &mut manifest.claims;
    match random.random_range(0..5) {
        0 if some < entries.len() => drop(entries.remove(some)),
        1 => entries.extend(entries.get(some).cloned()),
        2 => entries.extend(other.claims.iter().cloned()),
        3 => entries.clone_from(&other.claims),
        _ => {
            let about = entries.get(some).map(|entry| entry.claim().clone());
            entries.push(Entry::Search {
                claim: Claim {
                    within: None,
                    ..about.unwrap_or_default()
                },
                method: *[Method::Alone, Method::Joint, Method::Counting]
                    .choose(random)
                    .unwrap(),
            });
        }
    }
}

/// A claim that goes further, or less far.
fn another_claim(manifest: &mut Manifest, random: &mut ChaCha8Rng) {
    let cost = *Cost::USUAL.choose(random).unwrap();
    let some = random.random_range(0..manifest.claims.len().max(1));
    let Some(entry) = manifest.claims.get_mut(some) else {
        return;
    };
    let claim = claim(entry);
    match random.random_range(0..4) {
        0 => drop(claim.most.pop_first()),
        1 => drop(claim.most.insert(cost, random.random_range(0..8))),
        _ => {
            let more = random.random_bool(0.7);
            for most in claim.most.values_mut() {
                *most = if more {
                    most.saturating_add(1)
                } else {
                    most.saturating_sub(1)
                };
            }
        }
    }
}
