//! Forged certificates: honest ones, changed by somebody who knows the format.
//!
//! [`honest`] makes folders of many kinds, [`change`] changes one thing in one of
//! them, and a [`Folder`] is then sealed: as far as the forger cares, all that
//! follows from the change is written anew.

pub mod change;
mod files;
pub mod honest;

use std::collections::BTreeSet;

use giveway_model::{Cost, Instance, Plan, format::native};
use giveway_proof::bundle::{Entry, Manifest, fingerprint};
use giveway_proof::plain::{self, Cnf};
use giveway_proof::{Budget, Bundle, Lemma, Outcome, prove};
use serde_json::Value;

/// A certificate under the hands of a forger.
#[derive(Clone, Debug)]
pub struct Folder {
    /// All files but the manifest.
    pub files: Bundle,
    /// The manifest, as the JSON that it is.
    pub manifest: Value,
}

/// How much of what follows from a change a forger writes anew.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Seal {
    /// Nothing.
    Broken,
    /// The fingerprints.
    Fingerprints,
    /// The README, too.
    Readme,
    /// Formulas, their names and sizes, and proofs where there are any, too.
    Everything,
}

impl Folder {
    /// The files of a certificate, to be changed.
    pub fn open(bundle: &Bundle) -> Self {
        let mut files = bundle.clone();
        let manifest = files.remove("manifest.json").unwrap();
        let manifest = serde_json::from_slice(&manifest).unwrap();
        Self { files, manifest }
    }

    /// The instance, if it still is one.
    pub fn instance(&self) -> Option<Instance> {
        let text = std::str::from_utf8(self.files.get("instance.json")?).ok()?;
        native::read_instance(text).ok()
    }

    /// The plan, if there is one.
    pub fn plan(&self) -> Option<Plan> {
        let text = std::str::from_utf8(self.files.get("plan.json")?).ok()?;
        native::read_plan(text).ok()
    }

    /// The manifest, if it still is one.
    pub fn read(&self) -> Option<Manifest> {
        serde_json::from_value(self.manifest.clone()).ok()
    }

    /// Another manifest.
    pub fn write(&mut self, manifest: &Manifest) {
        self.manifest = serde_json::to_value(manifest).unwrap();
    }

    /// The certificate, as far as a seal goes.
    pub fn seal(mut self, seal: Seal) -> Bundle {
        if let Some((mut manifest, instance)) = self.read().zip(self.instance()) {
            if seal == Seal::Everything {
                self.prove(&mut manifest, &instance);
            }
            if matches!(seal, Seal::Readme | Seal::Everything) {
                let readme = manifest.readme(&instance).into_bytes();
                self.files.insert("README.md".to_owned(), readme);
            }
            if seal != Seal::Broken {
                let each = self.files.iter();
                let prints = each.map(|(name, bytes)| (name.clone(), fingerprint(bytes)));
                manifest.files = prints.collect();
            }
            self.write(&manifest);
        }
        let text = match self.read() {
            Some(manifest) => manifest.text(),
            None => serde_json::to_string_pretty(&self.manifest).unwrap(),
        };
        let mut bundle = self.files;
        bundle.insert("manifest.json".to_owned(), text.into_bytes());
        bundle
    }

    /// Writes the formulas of all claims, and proofs of those that have one.
    fn prove(&mut self, manifest: &mut Manifest, instance: &Instance) {
        let endings = [".cnf", ".drat", ".names.txt"];
        let old = std::mem::take(&mut self.files);
        let of_proof = |name: &str| endings.iter().any(|ending| name.ends_with(ending));
        self.files = old
            .clone()
            .into_iter()
            .filter(|(name, _)| !of_proof(name))
            .collect();
        let budget = Budget {
            clauses: 60_000,
            proof_bytes: 1 << 20,
            ..Budget::default()
        };
        let mut free: BTreeSet<&str> = Cost::USUAL.iter().map(|cost| cost.name()).collect();
        free.insert("no-plan");
        for entry in &mut manifest.claims {
            let (name, size, formula) = match entry {
                Entry::Proof {
                    claim,
                    name,
                    variables,
                    clauses,
                } => {
                    let formula = plain::formula(instance, claim, &budget);
                    (name, (variables, clauses), formula)
                }
                Entry::Lemmas {
                    claim,
                    name,
                    variables,
                    clauses,
                    least,
                    lemmas,
                } => {
                    for proved in &mut *lemmas {
                        if let Some(scene) = proved.lemma.scene(instance)
                            && let Ok(formula) = plain::of_lemma(&scene, &proved.lemma, &budget)
                        {
                            (proved.variables, proved.clauses) =
                                (formula.variables(), formula.clauses());
                            self.put(&old, (&proved.name, &proved.name), &scene, &formula);
                        }
                    }
                    let said: Vec<&Lemma> = lemmas.iter().map(|it| &it.lemma).collect();
                    let formula = plain::of_lemmas(instance, claim, (*least, &said), &budget);
                    (name, (variables, clauses), formula)
                }
                Entry::Search { .. } | Entry::None { .. } => continue,
            };
            // Two proofs have two names.
            let before = name.clone();
            if !free.remove(name.as_str())
                && let Some(other) = free.pop_first()
            {
                other.clone_into(name);
            }
            let Ok(formula) = formula else {
                continue;
            };
            (*size.0, *size.1) = (formula.variables(), formula.clauses());
            self.put(&old, (&before, name), instance, &formula);
        }
    }

    /// Writes a formula under a new name, with a proof where there is one, else with the old one.
    fn put(
        &mut self,
        old: &Bundle,
        (before, name): (&str, &str),
        instance: &Instance,
        formula: &Cnf,
    ) {
        let budget = Budget {
            proof_bytes: 1 << 20,
            ..Budget::default()
        };
        let proof = match prove(formula, &budget) {
            Outcome::Proof(proof) => proof,
            Outcome::Satisfiable | Outcome::Stopped => {
                let kept = old.get(&format!("{before}.drat"));
                kept.cloned().unwrap_or_default()
            }
        };
        let names = formula.names_text(instance).into_bytes();
        self.files
            .insert(format!("{name}.cnf"), formula.text().into_bytes());
        self.files.insert(format!("{name}.drat"), proof);
        self.files.insert(format!("{name}.names.txt"), names);
    }
}
