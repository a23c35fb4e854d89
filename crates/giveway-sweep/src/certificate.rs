//! Certificates of rows: made and checked, not kept. Whoever makes one again gets the
//! same files, so that its fingerprint is enough.

use giveway_model::Instance;
use giveway_proof::bundle::fingerprint;
use giveway_proof::{Certified, Checked};
use giveway_solve::{
    Certificate, CertifyRequest, ExportRequest, Host, Limits, Request, Response, SolveAnswer, serve,
};
use serde::{Deserialize, Serialize};

use crate::Task;

/// That answers of the search are to have certificates, and what one of them may take.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default, rename_all = "kebab-case")]
pub struct Certificates {
    /// Seconds to make one and to check it, by the clock of the sweep.
    pub time_limit: Option<f64>,
    /// Bytes to hold its formulas and proofs.
    pub memory_limit: Option<u64>,
}

impl From<Certificates> for Limits {
    fn from(certificates: Certificates) -> Self {
        Self {
            seconds: certificates.time_limit,
            memory_bytes: certificates.memory_limit,
            ..Self::default()
        }
    }
}

/// What came of making a certificate and of checking it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct RowCertificate {
    /// What its claims were shown by.
    pub certified: Certified,
    /// The bytes of all its files.
    pub bytes: usize,
    /// The SHA-256 fingerprint of its `manifest.json`, which has those of all other files.
    /// Only where every claim has a proof: there the same row has the same certificate.
    /// Whether a search stands in for a proof depends on the time that there was.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub manifest: Option<String>,
    /// Why there is none, as a sentence.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub reason: Option<String>,
}

/// Makes the certificate of an answer, and checks it.
pub(crate) fn certify(
    instance: &Instance,
    task: &Task,
    limits: Limits,
    answer: &SolveAnswer,
    host: &dyn Host,
) -> RowCertificate {
    let objective = task.objective.clone();
    let request = CertifyRequest::of_solved(instance.to_scene(), objective, answer);
    let request = request.with_hints(answer.trace.as_ref());
    let name = NAME.to_owned();
    let request = Request::Export(ExportRequest {
        certificates: vec![Certificate { name, request }],
        limits,
    });
    let exported = match serve(&request, host) {
        Response::Exported(mut answer) => answer.certificates.remove(NAME),
        _ => None,
    };
    let Some(exported) = exported else {
        return RowCertificate {
            certified: Certified::NotCertified,
            bytes: 0,
            manifest: None,
            reason: Some("There was no time for it.".to_owned()),
        };
    };
    let report = exported.report;
    let proved = report.certified == Certified::Proved;
    let manifest = exported.files.get("manifest.json").filter(|_| proved);
    let missing = report.claims.iter().find_map(|claim| match claim {
        Checked::None { why, .. } => Some(why.clone()),
        _ => None,
    });
    RowCertificate {
        certified: report.certified,
        bytes: exported.files.values().map(String::len).sum(),
        manifest: manifest.map(|text| fingerprint(text.as_bytes())),
        reason: report.reason.or(missing),
    }
}

const NAME: &str = "row";

#[cfg(test)]
mod tests {
    use giveway_model::format::native::read_instance;
    use giveway_solve::SilentHost;

    use super::*;
    use crate::{Loaded, Row, RowStatus, Spec, run};

    /// Two agents that must pass each other at a side pocket.
    const SCENE: &str = r##"{ "giveway": 1, "map": ["....", "#.##"],
        "agents": [{ "name": "a", "start": [0, 0], "goal": [3, 0] },
                   { "name": "b", "start": [3, 0], "goal": [0, 0] }] }"##;

    fn row(certificates: &str, objective: &str) -> Row {
        row_of(SCENE, certificates, objective)
    }

    fn row_of(scene: &str, certificates: &str, objective: &str) -> Row {
        let spec = format!(
            "objectives = [\"{objective}\"]\n{certificates}\n[[instances]]\nfiles = [\"a.json\"]"
        );
        let spec = Spec::read(&spec).unwrap();
        let files = |file: &str| Ok(vec![file.to_owned()]);
        let tasks = spec.tasks(&files, &|_| Ok(2)).unwrap();
        let loaded = Loaded::of(read_instance(scene).unwrap());
        run(&tasks[0], &loaded, &SilentHost)
    }

    #[test]
    fn what_is_proved_has_a_certificate_that_is_the_same_again() {
        assert_eq!(row("", "makespan").certificate, None);
        let first = row("[certificates]", "sum-of-costs");
        let certificate = first.certificate.clone().unwrap();
        assert_eq!(first.status, RowStatus::Optimal);
        assert_eq!(certificate.certified, Certified::Proved, "{certificate:?}");
        assert_eq!(certificate.manifest.as_ref().map(String::len), Some(64));
        assert!(certificate.bytes > 1000, "{certificate:?}");
        assert_eq!(row("[certificates]", "sum-of-costs"), first);
        let other = row("[certificates]", "makespan").certificate.unwrap();
        assert_ne!(other.manifest, certificate.manifest);
    }

    #[test]
    fn a_scene_with_rules_of_its_own_has_one_about_these() {
        let rules = r#""zones": [{ "name": "pocket", "cells": [[1, 1]] }],
            "constraints": [{ "kind": "avoid", "zone": "pocket", "weight": 7 }], "agents""#;
        let scene = SCENE.replacen("\"agents\"", rules, 1);
        let row = row_of(&scene, "[certificates]", "sum-of-costs");
        assert_eq!(row.costs.unwrap().penalty, 7);
        let certificate = row.certificate.unwrap();
        assert_eq!(certificate.certified, Certified::Proved, "{certificate:?}");
        let free = self::row("[certificates]", "sum-of-costs")
            .certificate
            .unwrap();
        assert_ne!(certificate.manifest, free.manifest);
    }

    #[test]
    fn one_that_is_too_large_says_so_and_has_no_fingerprint() {
        let row = row("[certificates]\nmemory-limit = 1000", "sum-of-costs");
        assert_eq!(row.status, RowStatus::Optimal);
        let certificate = row.certificate.unwrap();
        assert_eq!(certificate.certified, Certified::NotCertified);
        assert_eq!(certificate.manifest, None);
        let reason = certificate.reason.unwrap();
        assert!(reason.contains("too large"), "{reason}");
    }
}
