//! What could be done instead: small variations of the plan, a row for each kind, the cheapest first.

use std::collections::BTreeMap;

use giveway_model::{Cell, Cost, Question, tr};
use giveway_solve::explain::{AgentDifference, Near, Variation, VariationKind, Verdict};

use crate::beside::same_walks;
use crate::{Asking, State, words};

/// The most cells that are marked on the board.
const CELLS: usize = 40;

/// What could be done instead, in a row.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CouldRow {
    /// The variation, by its place among those of the answer; `None`: the best other plan.
    pub index: Option<usize>,
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
    let (Some(told), Some(near)) = (asking.told.as_deref(), near(asking)) else {
        return Vec::new();
    };
    let chosen = asking.variation();
    let best = best(asking, near);
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
        let (difference, is_costlier) = difference(asking, &it.deltas, false);
        rows.push(CouldRow {
            index: Some(index),
            icon: icon(it.kind),
            text: text(&told.question, it, places),
            detail: detail(it),
            difference,
            is_costlier,
            is_chosen: match chosen {
                Some(chosen) => (chosen.kind, chosen.other.as_ref()) == kind,
                None => best.is_some_and(|best| (best.kind, best.other.as_ref()) == kind),
            },
        });
    }
    if let Some(row) = own_row(asking, near, best) {
        rows.insert(0, row);
    }
    rows
}

/// The variation that is the best other plan, where one is.
fn best<'a>(asking: &Asking, near: &'a Near) -> Option<&'a Variation> {
    let best = asking.told.as_deref()?.alternative.as_ref()?;
    let agents = asking.about.agents();
    let is_best = |it: &&Variation| {
        let plan = asking.varied(it);
        plan.is_some_and(|plan| same_walks(&plan, best, agents))
    };
    near.variations.iter().find(is_best)
}

/// The row of the best other plan, where it is no variation and none costs less.
fn own_row(asking: &Asking, near: &Near, is_variation: Option<&Variation>) -> Option<CouldRow> {
    let told = asking.told.as_deref().filter(|_| is_variation.is_none())?;
    told.alternative.as_ref()?;
    let objective = asking.objective();
    let (own, cheapest) = (told.costs?, near.variations.first()?.costs);
    if cheapest.vector(objective) < own.vector(objective) {
        return None;
    }
    let is_least = is_done(asking) && told.verdict != Verdict::Unknown && !told.at_most;
    let (difference, is_costlier) = difference(asking, &told.deltas, is_least);
    Some(CouldRow {
        index: None,
        icon: "compare",
        text: if is_done(asking) {
            tr!("The best that was found").to_owned()
        } else {
            tr!("The best found so far").to_owned()
        },
        detail: own_detail(asking, &told.pays),
        difference,
        is_costlier,
        is_chosen: asking.chosen.is_none(),
    })
}

/// The name of a question's other plan, where a person can choose: the same on its board as in
/// the answer.
pub(crate) fn other_name(state: &State) -> Option<String> {
    let asking = state.document.mode.asking()?;
    which(asking, &could(asking))
}

/// Which plan is the other one, where a person can choose: a row of these, or the best that is
/// known.
pub(super) fn which(asking: &Asking, rows: &[CouldRow]) -> Option<String> {
    if rows.is_empty() {
        return None;
    }
    let chosen = rows.iter().find(|row| row.is_chosen);
    Some(match chosen {
        Some(row) if row.index.is_some() => row.text.clone(),
        Some(_) | None if is_done(asking) => {
            tr!("another plan" => "the best that was found").to_owned()
        }
        Some(_) | None => tr!("another plan" => "the best found so far").to_owned(),
    })
}

/// Whether nothing is looked for any more.
fn is_done(asking: &Asking) -> bool {
    let told = asking.told.as_deref();
    told.is_some_and(|told| told.pending.is_empty())
}

/// The cells at which the wait costs as little as at the cheapest, each with whether it is the one
/// that is looked at; the cell closest to the wait of now is the first. None where a variation of
/// another kind is looked at.
pub(crate) fn instead(asking: &Asking) -> Vec<(Cell, bool)> {
    let Some(near) = near(asking) else {
        return Vec::new();
    };
    let mut variations = near.variations.iter();
    let Some(first) = variations.find(|it| it.kind == VariationKind::Elsewhere) else {
        return Vec::new();
    };
    let chosen = asking.variation();
    if chosen.is_some_and(|chosen| chosen.kind != VariationKind::Elsewhere) {
        return Vec::new();
    }
    let chosen = chosen.or_else(|| best(asking, near));
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

fn text(question: &Question, it: &Variation, places: usize) -> String {
    match (it.kind, it.cell, &it.other) {
        (VariationKind::Elsewhere, ..) if places > 1 => {
            tr!("Wait at any of {n} cells", n = places)
        }
        (VariationKind::Elsewhere, Some(cell), _) => tr!("Wait at {cell}", cell = words::at(cell)),
        (VariationKind::Elsewhere, None, _) => tr!("Wait elsewhere").to_owned(),
        (VariationKind::OtherWay, ..) => {
            let mut pays = it.pays.iter();
            let own = pays.find(|it| Some(it.agent.as_str()) == question.agent());
            if is_of_wait(question) && own.is_some_and(|own| own.more_waits >= 0) {
                tr!("Go another way and wait there").to_owned()
            } else {
                tr!("Go another way").to_owned()
            }
        }
        (VariationKind::Swapped, _, Some(other)) => {
            let mut pays = it.pays.iter();
            match pays.find(|it| it.agent == *other) {
                Some(it) if it.more_waits <= 0 && it.other_way => {
                    tr!("Go first, and {other} goes another way", other)
                }
                Some(_) | None => tr!("Go first, and {other} waits instead", other),
            }
        }
        (VariationKind::Swapped, _, None) => tr!("Go first").to_owned(),
        (VariationKind::Others, ..) => {
            tr!("{n} robot moves differently"
                | "{n} robots move differently" % it.pays.len() as u32)
        }
    }
}

/// Whether it is asked why a robot waits.
const fn is_of_wait(question: &Question) -> bool {
    matches!(question, Question::Wait { .. } | Question::Yield { .. })
}

/// Who arrives later by most; where the first wait would be.
fn detail(it: &Variation) -> String {
    let late = it.pays.first().and_then(later);
    match (late, it.cell, it.from) {
        (Some(late), ..) => late,
        (None, Some(cell), Some(time)) => {
            tr!("closest: {cell} at {time}", cell = words::at(cell), time)
        }
        (None, ..) => nobody(),
    }
}

/// What the robot that is asked about does in the best other plan, and who arrives later by most.
fn own_detail(asking: &Asking, pays: &[AgentDifference]) -> String {
    let late = pays.first().and_then(later).unwrap_or_else(nobody);
    let asked = asking.question().agent();
    let Some(own) = pays.iter().find(|it| Some(it.agent.as_str()) == asked) else {
        return late;
    };
    let name = &own.agent;
    let does = match (own.other_way, own.more_waits) {
        (true, waits) if waits > 0 => tr!("{name} goes another way and waits more", name),
        (true, _) => tr!("{name} goes another way", name),
        (false, waits) if waits > 0 => tr!("{name} waits more", name),
        (false, waits) if waits < 0 => tr!("{name} waits less", name),
        // It may charge elsewhere instead: nothing is said of how it drives.
        (false, _) if !is_of_wait(asking.question()) => return late,
        (false, _) => tr!("{name} waits elsewhere", name),
    };
    tr!("{does}; {late}", does, late)
}

fn later(late: &AgentDifference) -> Option<String> {
    let n = late.other.checked_sub(late.arrival).filter(|&n| n > 0)?;
    Some(tr!(
        "{name} arrives at {other}, {n} later",
        name = late.agent,
        other = late.other,
        n
    ))
}

fn nobody() -> String {
    tr!("nobody arrives later").to_owned()
}

/// The first cost of the objective that differs, and whether it grows. Unless it is proved to be
/// least, it is a bound.
fn difference(asking: &Asking, deltas: &BTreeMap<Cost, i64>, is_least: bool) -> (String, bool) {
    let costs = asking.objective().costs().iter();
    let delta = |cost: &Cost| deltas.get(cost).copied().filter(|&delta| delta != 0);
    match costs.copied().find_map(|cost| Some((cost, delta(&cost)?))) {
        None => (tr!("a cost is the" => "same").to_owned(), false),
        Some((cost, more)) if more > 0 && is_least => (words::by_named(cost, more), true),
        Some((cost, more)) if more > 0 => {
            (tr!("at most {by}", by = words::by_named(cost, more)), true)
        }
        Some((cost, less)) => (words::by_named(cost, less), false),
    }
}
