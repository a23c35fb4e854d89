//! Certificates of answers, made as `--proof` makes them and checked as `verify`
//! checks them.

use std::collections::BTreeMap;

use giveway_model::Instance;
use giveway_proof::bundle::{Entry, Manifest, Missing};
use giveway_proof::{Budget, Certified, export, verify};
use giveway_solve::CertifyRequest;

/// What came of the certificates of many answers.
#[derive(Debug, Default)]
pub struct Tally {
    /// How many there were, by the last line of `verify`.
    pub last_lines: BTreeMap<&'static str, u64>,
    /// Answers of which a claim is not certified: why, and how many claims.
    pub missing: BTreeMap<String, u64>,
    /// What must not be, as sentences.
    pub faults: Vec<String>,
}

impl Tally {
    /// Certifies an answer. `excused` tells whether a claim for which something is
    /// missing is a known limit.
    pub fn add(
        &mut self,
        name: &str,
        instance: &Instance,
        request: &CertifyRequest,
        excused: impl Fn(&Entry, Missing) -> Option<&'static str>,
    ) {
        let bundle = export(&request.claims(instance), &Budget::default());
        let report = verify(&bundle, &Budget::default());
        *self.last_lines.entry(report.certified.words()).or_default() += 1;
        let mut wrong = report.reason.iter().cloned().collect::<Vec<String>>();
        let manifest: Manifest = serde_json::from_slice(&bundle["manifest.json"]).unwrap();
        let mut excuses = 0;
        for entry in &manifest.claims {
            let Entry::None { claim, why } = entry else {
                continue;
            };
            if let Some(excuse) = excused(entry, *why) {
                excuses += 1;
                *self.missing.entry(excuse.to_owned()).or_default() += 1;
            } else {
                wrong.push(format!("{} {why:?}", claim.sentence()));
            }
        }
        let expected = excuses > 0;
        if wrong.is_empty() && (report.certified == Certified::NotCertified) != expected {
            wrong.push(format!(
                "{}, though nothing is missing",
                report.certified.words()
            ));
        }
        if !wrong.is_empty() {
            let scene = serde_json::to_string(&instance.to_scene()).unwrap();
            self.faults.push(format!("{name}: {wrong:?} {scene}"));
        }
    }
}
