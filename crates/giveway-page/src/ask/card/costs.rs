//! What both plans cost: this one and the other one.

use giveway_model::{Cost, tr};

use crate::timeline::Lane;
use crate::{Answer, Asking, words};

/// A cost of both plans.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CostRow {
    /// Which cost, or whose arrival.
    pub title: String,
    /// The agent whose arrival it is, by its index.
    pub agent: Option<usize>,
    /// Of this plan.
    pub this: u32,
    /// Of the other plan.
    pub other: u32,
}

impl CostRow {
    /// The difference in words: `same`, `+1`.
    pub fn difference(&self) -> String {
        match i64::from(self.other) - i64::from(self.this) {
            0 => tr!("a cost is the" => "same").to_owned(),
            more => format!("{more:+}").replace('-', "\u{2212}"),
        }
    }
}

/// The costs of the objective, then the arrivals that differ.
pub(super) fn rows(asking: &Asking, other: &Answer) -> Vec<CostRow> {
    let this = &asking.about;
    let (Some(before), Some(after)) = (this.solved.costs, other.solved.costs) else {
        return Vec::new();
    };
    let scene = this.draft.scene();
    let objective = asking
        .request
        .objective
        .as_ref()
        .unwrap_or(&scene.objective);
    let others = Cost::USUAL
        .into_iter()
        .filter(|cost| !objective.costs().contains(cost) && before.get(*cost) != after.get(*cost));
    let costs = objective.costs().iter().copied().chain(others);
    let mut rows: Vec<CostRow> = costs
        .map(|cost| CostRow {
            title: words::title(cost).to_owned(),
            agent: None,
            this: before.get(cost),
            other: after.get(cost),
        })
        .collect();
    for (agent, who) in this.draft.agents().iter().enumerate() {
        let arrival = |answer| Lane::of(answer, agent).map(|lane| lane.arrival);
        if let (Some(before), Some(after)) = (arrival(this), arrival(other))
            && before != after
        {
            rows.push(CostRow {
                title: tr!("{name} arrives", name = who.name),
                agent: Some(agent),
                this: before,
                other: after,
            });
        }
    }
    rows
}
