//! Certificates of answers, made as `--proof` makes them and checked as `verify`
//! checks them.

use std::collections::BTreeMap;

use giveway_model::Instance;
use giveway_proof::{Budget, Certified, Checked, export, verify};
use giveway_solve::CertifyRequest;

use crate::truth;

/// What came of the certificates of many answers.
#[derive(Debug, Default)]
pub struct Tally {
    /// How many there were, by the last line of `verify`.
    pub last_lines: BTreeMap<&'static str, u64>,
    /// What is not certified, or not so by the oracle, as sentences.
    pub faults: Vec<String>,
}

impl Tally {
    /// Certifies an answer, which has a name in sentences.
    pub fn add(&mut self, name: &str, instance: &Instance, request: &CertifyRequest) {
        let bundle = export(&request.claims(instance), &Budget::default());
        let report = verify(&bundle, &Budget::default());
        *self.last_lines.entry(report.certified.words()).or_default() += 1;
        let mut faults: Vec<String> = report.reason.iter().cloned().collect();
        for claim in &report.claims {
            if let Checked::None { text, why, .. } = claim {
                faults.push(format!("{text} {why}"));
            }
        }
        let lies = truth::lies(instance, request.plan.as_ref(), &report);
        faults.extend(lies.unwrap_or_default());
        if !faults.is_empty() || report.certified == Certified::NotCertified {
            let scene = serde_json::to_string(&instance.to_scene()).unwrap();
            self.faults.push(format!("{name}: {faults:?} {scene}"));
        }
    }

    /// Fails where there are faults.
    pub fn end(&self) {
        assert!(self.faults.is_empty(), "{}", self.faults.join("\n"));
    }
}
