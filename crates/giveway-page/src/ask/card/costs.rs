//! What both plans cost: this one and the other one.

use giveway_model::{Cost, Costs, tr};
use giveway_solve::explain::Repair;

use crate::{Asking, words};

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

/// What a repair saves or costs more: in the arrival that is asked about, else in the first cost of the
/// objective that differs.
pub(super) fn of_repair(asking: &Asking, repair: &Repair) -> Option<(String, bool)> {
    let arriving = asking.question().arriving().zip(repair.arrival);
    let before = arriving.and_then(|(name, arrival)| {
        let agents = asking.about.agents();
        let agent = agents.iter().position(|agent| agent.name == name)?;
        let before = *asking.about.arrivals.get(agent)?;
        Some(i64::from(arrival) - i64::from(before?))
    });
    match before {
        Some(delta) => Some((words::by(Cost::Makespan, delta), delta < 0)),
        None => first_difference(asking, &repair.costs),
    }
}

/// By how much a plan differs from the one that is asked about, in the first cost of the objective
/// in which it does: with the unit, and whether it is less. Nothing where there is no plan.
fn first_difference(asking: &Asking, other: &Costs) -> Option<(String, bool)> {
    let before = asking.about.solved.costs?;
    let delta = |cost: Cost| i64::from(other.get(cost)) - i64::from(before.get(cost));
    let costs = asking.objective().costs();
    let mut deltas = costs.iter().map(|&cost| (cost, delta(cost)));
    let first = *costs.first()?;
    let (cost, delta) = deltas.find(|(_, delta)| *delta != 0).unwrap_or((first, 0));
    Some((words::by(cost, delta), delta < 0))
}

impl CostRow {
    /// The difference in words: `same`, `+1`.
    pub fn difference(&self) -> String {
        match i64::from(self.other) - i64::from(self.this) {
            0 => tr!("a cost is the" => "same").to_owned(),
            more => format!("{more:+}").replace('-', "\u{2212}"),
        }
    }

    /// All of the row as it is read aloud: `A14 arrives: 77 here, 122 in the other plan, 45 more`.
    pub fn aloud(&self) -> String {
        let Self {
            title, this, other, ..
        } = self;
        let difference = match i64::from(self.other) - i64::from(self.this) {
            0 => tr!("a cost is the" => "same").to_owned(),
            n if n > 0 => tr!("{n} more", n),
            n => tr!("{n} less", n = n.unsigned_abs()),
        };
        tr!(
            "{title}: {this} here, {other} in the other plan, {difference}",
            title,
            this,
            other,
            difference
        )
    }
}
