//! What closing each cell would cost: numbers on the board, and words in the cells'
//! names.

use giveway_model::{Cell, Cost};
use giveway_solve::freedom::{Closed, FreedomAnswer, Proved};

use super::words::{price, worse};
use crate::State;

/// How much it matters that a cell is open.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Weight {
    /// Closing it costs something.
    Costs,
    /// Closing it leaves no plan.
    NoPlan,
    /// What closing it costs is not known.
    Open,
}

/// A number on a cell.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Number {
    /// The cell.
    pub cell: Cell,
    /// How much it matters.
    pub weight: Weight,
    /// What stands there: `+2`, `sum +2`, `no plan`.
    pub text: String,
}

/// How far a proof reaches, where that is not for ever.
pub(super) const fn within(proved: Proved) -> Option<u32> {
    match proved {
        Proved::ForEver => None,
        Proved::Within(makespan) => Some(makespan),
    }
}

/// Whether closing a cell makes something worse that could be looked at: that nothing
/// is left without a start or a goal goes without saying.
pub(super) fn matters(closed: &Closed) -> bool {
    match closed {
        Closed::Optimal { .. } => !closed.is_harmless(),
        Closed::Impossible { needed, .. } => needed.is_none(),
        Closed::Unknown { .. } => false,
    }
}

/// The numbers on the board; none where nothing is laid over it.
pub fn numbers(state: &State) -> Vec<Number> {
    let told = state.freedom().and_then(|freedom| freedom.told.as_deref());
    let Some(told) = told else {
        return Vec::new();
    };
    let is_counting = state.is_counting();
    let cells = told.critical.iter().flatten();
    let number = |it: &giveway_solve::freedom::CriticalCell| {
        let (weight, text) = match &it.closed {
            Closed::Unknown { worse: true } if is_counting => (Weight::Open, "\u{2026}".to_owned()),
            // Most of them will turn out to cost nothing.
            Closed::Unknown { .. } if is_counting => return None,
            Closed::Unknown { worse: true } => (Weight::Open, "+?".to_owned()),
            Closed::Unknown { worse: false } => (Weight::Open, "?".to_owned()),
            Closed::Impossible { needed: None, .. } => (Weight::NoPlan, "no plan".to_owned()),
            Closed::Impossible { .. } => return None,
            Closed::Optimal { .. } => (Weight::Costs, short(told, &it.closed)?),
        };
        Some(Number {
            cell: it.cell,
            weight,
            text,
        })
    };
    cells.filter_map(number).collect()
}

/// `+2` of the first cost, `sum +2` of a later one.
fn short(told: &FreedomAnswer, closed: &Closed) -> Option<String> {
    let (place, cost, delta) = worse(&told.objective, closed)?;
    if place == 0 {
        return Some(format!("+{delta}"));
    }
    let word = match cost {
        Cost::SumOfCosts => "sum",
        cost => giveway_model::words::name(cost),
    };
    Some(format!("{word} +{delta}"))
}

/// What the names of cells end with; none where nothing is laid over them.
pub fn notes(state: &State) -> Vec<(Cell, String)> {
    let told = state.freedom().and_then(|freedom| freedom.told.as_deref());
    let Some(told) = told else {
        return Vec::new();
    };
    let note = |it: &giveway_solve::freedom::CriticalCell| {
        let note = match &it.closed {
            Closed::Unknown { worse: true } => "closing it costs something, not yet known how much",
            Closed::Unknown { worse: false } => "not known what closing it costs",
            Closed::Impossible { needed: None, .. } => "closing it leaves no plan",
            Closed::Impossible { .. } => return None,
            Closed::Optimal { .. } => {
                let (_, cost, delta) = worse(&told.objective, &it.closed)?;
                return Some((it.cell, format!("closing it costs {}", price(cost, delta))));
            }
        };
        Some((it.cell, note.to_owned()))
    };
    told.critical.iter().flatten().filter_map(note).collect()
}
