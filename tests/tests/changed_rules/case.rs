//! A plan around which the world changes once, under rules, and ways to go on.

use giveway_model::change::Changes;
use giveway_model::check::{check, check_changes};
use giveway_model::format::native;
use giveway_model::{Costs, Instance, Plan, Question};
use giveway_solve::change::Method;
use giveway_solve::explain::{ExplainAnswer, ExplainRequest};
use giveway_solve::{Limits, Refusal, Request, Response, SilentHost, serve};
use giveway_tests::going_on::{go_on, plan_of};
use giveway_tests::rules_oracle::{Answer, ChangedRules};
use giveway_tests::rules_random::{changes_of_rules, scene_to_change};
use serde_json::{Value, json};

/// Joint states that the oracle looks at.
const MOST_STATES: usize = 20_000;

/// A plan and the changes of one time.
pub(super) struct Case {
    pub(super) told: String,
    pub(super) scene: Value,
    pub(super) instance: Instance,
    /// The plan before the change.
    pub(super) plan: Plan,
    pub(super) at: u32,
    pub(super) changes: Vec<Value>,
    pub(super) read: Changes,
    /// A rule of the scene's zones and agents that is in force nowhere.
    pub(super) other: Value,
    /// Plans that go on.
    pub(super) plans: Vec<Plan>,
    objective: Vec<String>,
}

impl Case {
    pub(super) fn random(seed: u64, number: u64, kinds: &[&str]) -> Option<Self> {
        let (mut scene, rule) = scene_to_change(seed, number, kinds);
        let rules = scene["constraints"].as_array_mut().unwrap();
        let other = if number.is_multiple_of(3) {
            rules.pop().unwrap_or_default()
        } else {
            rule.clone()
        };
        let instance = native::read_instance(&scene.to_string()).unwrap();
        let plan = plan_of(&instance)?;
        assert!(check(&instance, &plan).is_valid());
        let longest = plan.paths.values().map(Vec::len).max().unwrap_or(1);
        let changes = changes_of_rules(seed, number, (&scene, &rule), longest as u32 - 1);
        let file = json!({ "giveway": 1, "changes": changes }).to_string();
        let read = native::read_changes(&file).unwrap();
        let methods = [Method::Revise, Method::Replan];
        let answer = go_on(&instance, &plan, &read, &methods)?;
        let mut plans: Vec<Plan> = Vec::new();
        for (_, method) in &answer.methods.0 {
            plans.extend(method.result.plan.clone().filter(|it| !plans.contains(it)));
        }
        let at = answer.at?;
        let world = ChangedRules::new(&scene, &plan, at, &changes);
        let objective = world.objective().to_vec();
        let plan_text = serde_json::to_string(&plan).unwrap();
        Some(Self {
            told: format!("{number} {kinds:?}\n{scene}\n{plan_text}\n{file}"),
            scene,
            instance,
            plan,
            at,
            changes,
            read,
            other,
            plans,
            objective,
        })
    }

    /// The world with more rules, which begin with the change.
    pub(super) fn with_rules(&self, rules: &[Value]) -> ChangedRules {
        self.edited(rules, |_, _| {})
    }

    /// The same after an edit of the scene and its changes.
    pub(super) fn edited(
        &self,
        rules: &[Value],
        edit: impl Fn(&mut Value, &mut Vec<Value>),
    ) -> ChangedRules {
        let mut scene = self.scene.clone();
        let mut changes = self.changes.clone();
        edit(&mut scene, &mut changes);
        for rule in rules {
            // A zone of its own is told beside it.
            let mut rule = rule.clone();
            if let Some(cells) = rule.as_object_mut().unwrap().remove("cells of its zone") {
                let zone = json!({ "name": rule["zone"], "cells": cells });
                match scene["zones"].as_array_mut() {
                    Some(zones) => zones.push(zone),
                    None => scene["zones"] = json!([zone]),
                }
            }
            changes.push(json!({ "change": "add-constraint", "at": self.at, "constraint": rule }));
        }
        ChangedRules::new(&scene, &self.plan, self.at, &changes)
    }

    /// The costs of the best plan with more rules, in the order of the objective.
    pub(super) fn best(&self, rules: &[Value]) -> Answer {
        self.with_rules(rules).best(&[], MOST_STATES)
    }

    /// The same after an edit.
    pub(super) fn best_after(
        &self,
        rules: &[Value],
        edit: impl Fn(&mut Value, &mut Vec<Value>),
    ) -> Answer {
        self.edited(rules, edit).best(&[], MOST_STATES)
    }

    pub(super) fn ask(&self, plan: &Plan, question: &Question) -> Result<ExplainAnswer, Refusal> {
        let request = Request::Explain(ExplainRequest {
            scene: self.instance.to_scene(),
            plan: Some(plan.clone()),
            changes: Some(self.read.clone()),
            at: None,
            question: question.clone(),
            objective: None,
            within: None,
            proved: None,
            known: None,
            layers: Vec::new(),
            limits: Limits {
                conflicts: Some(20_000),
                ..Limits::default()
            },
        });
        match serve(&request, &SilentHost) {
            Response::Explained(answer) => Ok(*answer),
            Response::Refused(refusal) => Err(refusal),
            other => panic!("{other:?}"),
        }
    }

    /// Costs in the order of the objective.
    pub(super) fn costs_of(&self, costs: &Costs) -> Vec<i64> {
        let names = self.objective.iter();
        let costs = names.map(|name| costs.get(name.parse().unwrap()));
        costs.map(i64::from).collect()
    }

    /// The costs of a plan that breaks no rule.
    pub(super) fn vector(&self, plan: &Plan) -> Vec<i64> {
        let report = check_changes(&self.instance, &self.read, plan).unwrap();
        assert_eq!(report.violations, [], "{}", self.told);
        self.costs_of(&report.costs.unwrap())
    }
}
