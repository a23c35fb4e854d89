//! What could be done instead: small variations of the plan, a row for each kind, the cheapest first.

use giveway_model::{Cell, Cost, tr};
use giveway_solve::explain::{Near, Variation, VariationKind};

use crate::{Asking, words};

/// The most cells that are marked on the board.
const CELLS: usize = 40;

/// What could be done instead, in a row.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CouldRow {
    /// The variation, by its place among those of the answer.
    pub index: usize,
    /// The icon of its kind.
    pub icon: &'static str,
    /// What.
    pub text: String,
    /// Who arrives when.
    pub detail: String,
    /// What it costs beside this plan: `same`, `at most +13`.
    pub difference: String,
    /// Whether it costs more.
    pub is_costlier: bool,
    /// Whether it is the other plan that is looked at.
    pub is_chosen: bool,
}

/// A row for each way that was looked at.
pub(super) fn could(asking: &Asking) -> Vec<CouldRow> {
    let Some(near) = near(asking) else {
        return Vec::new();
    };
    let mut rows: Vec<CouldRow> = Vec::new();
    let mut seen: Vec<(VariationKind, Option<&String>)> = Vec::new();
    for (index, it) in near.variations.iter().enumerate() {
        let kind = (it.kind, it.other.as_ref());
        if seen.contains(&kind) {
            continue;
        }
        seen.push(kind);
        let places = match it.kind {
            VariationKind::Elsewhere => cells(near, it).len(),
            VariationKind::OtherWay | VariationKind::Swapped | VariationKind::Others => 0,
        };
        let (difference, is_costlier) = difference(asking, it);
        let chosen = asking.chosen.and_then(|chosen| near.variations.get(chosen));
        rows.push(CouldRow {
            index,
            icon: icon(it.kind),
            text: text(it, places),
            detail: detail(it),
            difference,
            is_costlier,
            is_chosen: chosen.is_some_and(|chosen| (chosen.kind, chosen.other.as_ref()) == kind),
        });
    }
    rows
}

/// Which plan is the other one, where a person can choose: a row of these, or the best that is
/// known.
pub(super) fn which(asking: &Asking, rows: &[CouldRow]) -> Option<String> {
    if rows.is_empty() {
        return None;
    }
    let chosen = rows.iter().find(|row| row.is_chosen);
    let is_proved = asking
        .told
        .as_deref()
        .is_some_and(|told| told.pending.is_empty());
    Some(match chosen {
        Some(row) => row.text.clone(),
        None if is_proved => tr!("another plan" => "the best that was found").to_owned(),
        None => tr!("another plan" => "the best found so far").to_owned(),
    })
}

/// The cells at which the wait costs as little as at the cheapest, each with whether it is the one
/// that is looked at; the cell closest to the wait of now is the first.
pub(crate) fn instead(asking: &Asking) -> Vec<(Cell, bool)> {
    let Some(near) = near(asking) else {
        return Vec::new();
    };
    let mut variations = near.variations.iter();
    let Some(first) = variations.find(|it| it.kind == VariationKind::Elsewhere) else {
        return Vec::new();
    };
    let chosen = asking.chosen.and_then(|chosen| near.variations.get(chosen));
    let lit = chosen.map_or(first.cell, |chosen| chosen.cell);
    let cells = cells(near, first).into_iter().take(CELLS);
    cells.map(|cell| (cell, Some(cell) == lit)).collect()
}

fn near(asking: &Asking) -> Option<&Near> {
    asking.told.as_deref()?.near.as_ref()
}

/// The cells of the waits that cost the same, each once.
fn cells(near: &Near, like: &Variation) -> Vec<Cell> {
    let same = near.variations.iter();
    let same = same.filter(|it| it.kind == VariationKind::Elsewhere && it.deltas == like.deltas);
    let mut cells: Vec<Cell> = Vec::new();
    for cell in same.filter_map(|it| it.cell) {
        if !cells.contains(&cell) {
            cells.push(cell);
        }
    }
    cells
}

const fn icon(kind: VariationKind) -> &'static str {
    match kind {
        VariationKind::Elsewhere => "pause",
        VariationKind::OtherWay => "trail",
        VariationKind::Swapped | VariationKind::Others => "compare",
    }
}

fn text(it: &Variation, places: usize) -> String {
    match (it.kind, it.cell, &it.other) {
        (VariationKind::Elsewhere, ..) if places > 1 => {
            tr!("Wait at any of {n} cells", n = places)
        }
        (VariationKind::Elsewhere, Some(cell), _) => tr!("Wait at {cell}", cell = words::at(cell)),
        (VariationKind::Elsewhere, None, _) => tr!("Wait elsewhere").to_owned(),
        (VariationKind::OtherWay, ..) => tr!("Go another way").to_owned(),
        (VariationKind::Swapped, _, Some(other)) => {
            tr!("Go first, and {other} waits instead", other)
        }
        (VariationKind::Swapped, _, None) => tr!("Go first").to_owned(),
        (VariationKind::Others, ..) => {
            tr!("{n} robot moves differently"
                | "{n} robots move differently" % it.pays.len() as u32)
        }
    }
}

/// Who arrives later by most; where the first wait would be.
fn detail(it: &Variation) -> String {
    let late = it.pays.first().filter(|late| late.other > late.arrival);
    match (late, it.cell, it.from) {
        (Some(late), ..) => tr!(
            "{name} arrives at {other}, {n} later",
            name = late.agent,
            other = late.other,
            n = late.other - late.arrival
        ),
        (None, Some(cell), Some(time)) => {
            tr!("closest: {cell} at {time}", cell = words::at(cell), time)
        }
        (None, ..) => tr!("nobody arrives later").to_owned(),
    }
}

/// The first cost of the objective that differs, and whether it grows.
fn difference(asking: &Asking, it: &Variation) -> (String, bool) {
    let costs = asking.objective().costs().iter();
    let delta = |cost: &Cost| it.deltas.get(cost).copied().filter(|&delta| delta != 0);
    match costs.copied().find_map(|cost| Some((cost, delta(&cost)?))) {
        None => (tr!("a cost is the" => "same").to_owned(), false),
        Some((cost, more)) if more > 0 => (tr!("at most {by}", by = words::by(cost, more)), true),
        Some((cost, less)) => (words::by(cost, less), false),
    }
}
