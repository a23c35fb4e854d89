//! What closing each cell would cost: numbers on the board, and words in the cells'
//! names.

use giveway_model::{Cell, Cost, tr};
use giveway_solve::freedom::{Closed, FreedomAnswer};
use giveway_solve::price::words::amount;

use super::words::{outcome, worse};
use crate::board::CELL;
use crate::words::at;
use crate::{Point, State};

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
    /// What pressing it looks at; nothing where that is not known.
    pub title: Option<String>,
}

impl Number {
    /// Left of it and above it within its cell, in units, and how high it is.
    pub const LEFT: f64 = 8.0;
    /// See [`Number::LEFT`].
    pub const TOP: f64 = 70.0;
    /// See [`Number::LEFT`].
    pub const HEIGHT: f64 = 25.0;

    /// How wide it is, in units: within its cell.
    pub fn width(&self) -> f64 {
        let letters = f64::from(u8::try_from(self.text.chars().count()).unwrap_or(u8::MAX));
        (14.0 + 11.0 * letters).clamp(42.0, 86.0)
    }

    /// Whether its text has to be narrower than it would be.
    pub fn is_tight(&self) -> bool {
        self.text.chars().count() > 7
    }
}

/// The cell whose number is at a point of the board, where pressing it closes the cell
/// for a look.
pub fn pressed(state: &State, point: Point) -> Option<Cell> {
    let cell = state.document.draft.clamp(point.nearest_cell());
    let numbers = numbers(state);
    let number = numbers.iter().find(|number| number.cell == cell)?;
    let within = |at: f64, side: u32| (at - f64::from(side) + 0.5) * CELL;
    let (x, y) = (within(point.x, cell.x), within(point.y, cell.y));
    // Whoever aims at it may miss it by a little.
    let across = 0.0..=Number::LEFT + number.width() + Number::LEFT;
    let down = Number::TOP - Number::LEFT..=CELL;
    let is_hit = across.contains(&x) && down.contains(&y);
    (is_hit && number.title.is_some()).then_some(cell)
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
            Closed::Impossible { needed: None, .. } => (Weight::NoPlan, tr!("no plan").to_owned()),
            Closed::Impossible { .. } => return None,
            Closed::Optimal { .. } => (Weight::Costs, short(told, &it.closed)?),
        };
        let outcome = outcome(told, &it.closed).filter(|_| matters(&it.closed));
        Some(Number {
            cell: it.cell,
            weight,
            text,
            title: outcome
                .map(|outcome| tr!("Close {cell}: {outcome}", cell = at(it.cell), outcome)),
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
        Cost::SumOfCosts => tr!("sum of costs, in short" => "sum"),
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
            Closed::Unknown { worse: true } => {
                tr!("closing it costs something, not yet known how much")
            }
            Closed::Unknown { worse: false } => tr!("not known what closing it costs"),
            Closed::Impossible { needed: None, .. } => tr!("closing it leaves no plan"),
            Closed::Impossible { .. } => return None,
            Closed::Optimal { .. } => {
                let (_, cost, delta) = worse(&told.objective, &it.closed)?;
                return Some((
                    it.cell,
                    tr!("closing it costs {price}", price = amount(cost, delta)),
                ));
            }
        };
        Some((it.cell, note.to_owned()))
    };
    told.critical.iter().flatten().filter_map(note).collect()
}
