//! Requests for certificates of scenes with rules.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use giveway_model::format::native;
use giveway_model::{Cost, Instance};
use giveway_proof::{Budget, Certified, Conclusion, export, verify};
use giveway_solve::{CertifyRequest, Request, Response, SilentHost, SolveRequest, serve};
use serde_json::Value;

/// The certificate of what is answered about a scene.
fn certified(instance: &Instance) -> (giveway_proof::Bundle, giveway_proof::Report) {
    let request = Request::Solve(SolveRequest {
        scene: instance.to_scene(),
        ..SolveRequest::default()
    });
    let Response::Solved(answer) = serve(&request, &SilentHost) else {
        unreachable!("a solve request is solved")
    };
    let request = CertifyRequest::of_solved(instance.to_scene(), None, &answer);
    let bundle = export(&request.claims(instance), &Budget::default());
    let report = verify(&bundle, &Budget::default());
    (bundle, report)
}

#[test]
fn a_request_for_a_certificate_heeds_rules() {
    let scene = r#"{ "giveway": 1, "map": ["...."], "objective": ["makespan"],
        "zones": [{ "name": "end", "cells": [[3, 0]] }],
        "constraints": [{ "kind": "closed", "zone": "end", "to": 5, "name": "shut" }],
        "agents": [{ "name": "a", "start": [0, 0], "goal": [3, 0] }] }"#;
    let report = |scene: &str| {
        let instance = native::read_instance(scene).unwrap();
        let request = CertifyRequest {
            scene: instance.to_scene(),
            bounds: BTreeMap::from([(Cost::Makespan, 6)]),
            complete: true,
            ..CertifyRequest::default()
        };
        match serve(&Request::Certify(request), &SilentHost) {
            Response::Certified(report) => report,
            other => panic!("{other:?}"),
        }
    };
    assert_eq!(report(scene).certified, Certified::Proved);
    let off = scene.replace("\"to\": 5", "\"to\": 5, \"off\": true");
    assert_eq!(report(&off).certified, Certified::NotCertified);
    let shorter = scene.replace("\"to\": 5", "\"to\": 4");
    assert_eq!(report(&shorter).certified, Certified::NotCertified);
}

#[test]
fn the_known_answers_have_certificates() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("data/rules");
    let mut by: BTreeMap<&str, u32> = BTreeMap::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let known: Value = serde_json::from_str(&fs::read_to_string(&path).unwrap()).unwrap();
        if known["status"] == "broken" {
            continue;
        }
        let what = path.display().to_string();
        let instance = native::read_instance(&known["instance"].to_string()).unwrap();
        let (bundle, report) = certified(&instance);
        assert!(report.accepted, "{what}: {:?}", report.reason);
        assert_ne!(
            report.certified,
            Certified::NotCertified,
            "{what}: {report:?}"
        );
        *by.entry(report.certified.words()).or_default() += 1;
        match (&known["status"], report.concluded) {
            (Value::String(status), Some(Conclusion::Best { within: None, .. }))
                if status == "optimal" =>
            {
                let manifest: Value = serde_json::from_slice(&bundle["manifest.json"]).unwrap();
                let objective = instance.in_force(instance.objective().clone());
                for cost in objective.costs() {
                    let told = &manifest["costs"][cost.name()];
                    let told = if told.is_null() {
                        &Value::from(0)
                    } else {
                        told
                    };
                    assert_eq!(known["costs"][cost.name()], *told, "{what}: {cost}");
                }
            }
            (Value::String(status), Some(Conclusion::NoPlan { .. })) if status == "impossible" => {}
            (status, concluded) => panic!("{what}: {status}, {concluded:?}"),
        }
        let readme = String::from_utf8(bundle["README.md"].clone()).unwrap();
        for rule in instance.constraints_in_force() {
            let line = format!("- Rule {}: ", rule.index);
            assert!(readme.contains(&line), "{what}: {readme}");
        }
    }
    println!("{by:?}");
    assert_eq!(by.values().sum::<u32>(), 57, "{by:?}");
}
