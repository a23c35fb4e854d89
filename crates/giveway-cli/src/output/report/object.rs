//! An audit for programs: one object.

use std::collections::BTreeMap;

use giveway_formats::Format;
use giveway_model::check::Violation;
use giveway_model::compare::Claimed;
use giveway_model::compare::{ClaimedBound, ClaimedCost};
use giveway_model::{Assumption, Cost, Costs, Objective, Plan, Version};
use giveway_solve::audit::AuditStatus;
use giveway_solve::{Reach, Reason, Stats, Status};
use serde::Serialize;

use super::Audited;

/// The object, in the order in which it is read best.
#[derive(Serialize)]
pub(crate) struct AuditObject<'a> {
    giveway: Version,
    file: &'a str,
    format: Format,
    conventions: BTreeMap<&'a str, &'a str>,
    why: &'a str,
    name: &'a str,
    agents: usize,
    #[serde(skip_serializing_if = "<[_]>::is_empty")]
    assumptions: &'a [Assumption],
    notes: Vec<&'a str>,
    legal: bool,
    violations: &'a [Violation],
    objective: &'a Objective,
    costs: Option<Costs>,
    claimed: Option<Claimed>,
    claims: &'a [ClaimedCost],
    #[serde(skip_serializing_if = "<[_]>::is_empty")]
    claimed_bounds: &'a [ClaimedBound],
    bounds: &'a BTreeMap<Cost, u32>,
    #[serde(flatten)]
    reach: Reach,
    status: AuditStatus,
    gap: Option<f64>,
    better: Option<&'a Plan>,
    better_costs: Option<Costs>,
    search: Status,
    #[serde(skip_serializing_if = "Option::is_none")]
    reason: Option<&'a Reason>,
    stats: Stats,
    /// In a report: what opens the plan on the page.
    #[serde(skip_serializing_if = "Option::is_none")]
    link: Option<&'a str>,
}

impl<'a> AuditObject<'a> {
    /// The object of a report, with what opens the plan on the page.
    pub(super) fn with_link(self, link: Option<&'a str>) -> Self {
        Self { link, ..self }
    }
}

impl Audited {
    /// The object for programs.
    pub(crate) fn object(&self) -> AuditObject<'_> {
        let (plan, answer) = (&self.plan, &self.answer);
        let words = plan.words.iter();
        AuditObject {
            giveway: Version,
            file: &plan.file,
            format: plan.format,
            conventions: words.map(|(about, how)| (&**about, &**how)).collect(),
            why: &plan.why,
            name: self.instance.name(),
            agents: self.instance.agents().len(),
            assumptions: self.instance.assumptions(),
            notes: self
                .notes
                .iter()
                .chain(&plan.notes)
                .chain(&self.otherwise)
                .map(String::as_str)
                .collect(),
            legal: answer.legal,
            violations: &answer.violations,
            objective: &answer.objective,
            costs: answer.costs,
            claimed: Some(plan.claimed).filter(|claimed| *claimed != Claimed::default()),
            claims: &self.claims,
            claimed_bounds: &self.claimed_bounds,
            bounds: &answer.bounds,
            reach: answer.reach,
            status: answer.status,
            gap: answer.gap,
            better: answer.better.as_ref(),
            better_costs: answer.better_costs,
            search: answer.search,
            reason: answer.reason.as_ref(),
            stats: answer.stats,
            link: None,
        }
    }
}
