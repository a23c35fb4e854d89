//! Runs the cases of `plans/`: every valid plan is accepted with its costs and
//! battery rows, every broken one is rejected with its reasons.

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    clippy::print_stdout,
    reason = "a test stops at the first surprise"
)]

use std::collections::BTreeMap;
use std::path::PathBuf;

use giveway_model::check::{Report, Violation, check, levels};
use giveway_model::format::native;
use giveway_model::{Costs, Instance, Plan};
use serde::Deserialize;
use serde_json::Value;
use serde_json::value::RawValue;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Case<'a> {
    says: String,
    #[serde(borrow)]
    instance: &'a RawValue,
    #[serde(borrow)]
    plan: &'a RawValue,
    costs: Option<Costs>,
    #[serde(default)]
    levels: BTreeMap<String, Vec<i64>>,
    #[serde(default)]
    violations: Vec<Value>,
}

/// Runs all cases of a folder; there are at least a few.
fn run(folder: &str, judge: impl Fn(&Case<'_>, &Instance, &Plan, &Report)) {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR"))
        .join("tests/plans")
        .join(folder);
    let mut files: Vec<PathBuf> = std::fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .collect();
    files.sort();
    assert!(files.len() > 5);
    for file in files {
        println!("{}", file.display());
        let text = std::fs::read_to_string(&file).unwrap();
        let case: Case<'_> = serde_json::from_str(&text).unwrap();
        let instance = native::read_instance(case.instance.get()).unwrap();
        let plan = native::read_plan(case.plan.get()).unwrap();
        println!("{}", case.says);
        judge(&case, &instance, &plan, &check(&instance, &plan));
    }
}

#[test]
fn valid_plans_are_accepted() {
    run("valid", |case, instance, plan, report| {
        assert_eq!(report.violations, []);
        assert_eq!(report.costs, case.costs);
        for (i, agent) in instance.agents().iter().enumerate() {
            let expected = case.levels.get(&agent.name).cloned().unwrap_or_default();
            assert_eq!(levels(instance, i, plan), expected);
        }
    });
}

#[test]
fn broken_plans_are_rejected_with_every_reason() {
    run("broken", |case, _, _, report| {
        let found: Vec<Value> = report.violations.iter().map(without_message).collect();
        assert!(!found.is_empty());
        assert_eq!(found, case.violations);
    });
}

fn without_message(violation: &Violation) -> Value {
    let mut value = serde_json::to_value(violation).unwrap();
    value.as_object_mut().unwrap().remove("message").unwrap();
    value
}
