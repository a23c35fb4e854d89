//! Where steps are lost, as shapes on the map.

use std::collections::BTreeMap;
use std::fmt::Write;

use giveway_model::Cell;
use giveway_solve::delays::{DelaysAnswer, LossPlace};

use super::LedgerLit;
use crate::board::CELL;
use crate::{MAX_SIDE, State};

/// How dark the cells are where least and most is lost.
const DARKNESS: (f64, f64) = (0.14, 0.74);

/// Cells at which as many steps are lost.
#[derive(Clone, Debug, PartialEq)]
pub struct Shade {
    /// How dark they are, from 0 to 1.
    pub opacity: f64,
    /// The `d` of their path.
    pub path: String,
}

/// A frame around a place where most is lost.
#[derive(Clone, Debug, PartialEq)]
pub struct Frame {
    /// The place, by its number from 1.
    pub number: usize,
    /// Its left and upper edge, its width and height, in units.
    pub area: (f64, f64, f64, f64),
    /// The middle of the cell that its number stands on, in units.
    pub at: (f64, f64),
    /// Whether it is lit up.
    pub is_lit: bool,
}

/// What the board shows of the ledger.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Heat {
    /// The cells, by how much is lost there.
    pub shades: Vec<Shade>,
    /// The places where most is lost.
    pub frames: Vec<Frame>,
}

/// What to draw; nothing where the ledger is not open or not known yet.
pub fn heat(state: &State) -> Option<Heat> {
    let told = state.ledger()?.told.as_deref()?;
    if told.reason.is_some() {
        return None;
    }
    let lit = state.view.ledger.lit;
    let most = most(told).max(1);
    let mut shades: BTreeMap<u32, String> = BTreeMap::new();
    for (cell, steps) in losses(state, told) {
        let path = shades.entry(steps).or_default();
        let side = CELL - 6.0;
        let (x, y) = (corner(cell.x) + 3.0, corner(cell.y) + 3.0);
        // (a string takes all that is written to it)
        let _ = write!(path, "M{x} {y}h{side}v{side}h-{side}z");
    }
    let shades = shades.into_iter().map(|(steps, path)| {
        let share = f64::from(steps) / f64::from(most);
        Shade {
            opacity: DARKNESS.0 + (DARKNESS.1 - DARKNESS.0) * share.min(1.0),
            path,
        }
    });
    let board = state.world().grid();
    let places = told.places.iter().enumerate();
    let frames = places.filter_map(|(rank, place)| {
        let is_lit = lit == Some(LedgerLit::Place(rank));
        frame(rank, place, (board.width(), board.height()), is_lit)
    });
    Some(Heat {
        shades: shades.collect(),
        frames: frames.collect(),
    })
}

/// The most steps that are lost at a cell.
pub(super) fn most(told: &DelaysAnswer) -> u32 {
    told.lost.iter().map(|it| it.steps).max().unwrap_or(0)
}

/// The cells and steps to show: of all robots, of the one that is lit up, or at a place.
fn losses(state: &State, told: &DelaysAnswer) -> BTreeMap<Cell, u32> {
    let mut losses = BTreeMap::new();
    let agents = state.document.fresh_answer();
    let agents = agents.map_or(&[][..], |answer| answer.agents());
    let lost: Vec<_> = match state.view.ledger.lit {
        Some(LedgerLit::Robot(agent)) => {
            let name = agents.get(agent).map(|agent| agent.name.as_str());
            let row = told.agents.iter().find(|row| Some(&*row.agent) == name);
            row.into_iter().flat_map(|row| &row.lost).collect()
        }
        Some(LedgerLit::Place(rank)) => {
            let place = told.places.get(rank);
            let is_in = |cell| place.is_some_and(|place| place.cells.contains(&cell));
            told.lost.iter().filter(|it| is_in(it.cell)).collect()
        }
        None => told.lost.iter().collect(),
    };
    for it in lost {
        if it.cell.x < MAX_SIDE && it.cell.y < MAX_SIDE {
            *losses.entry(it.cell).or_insert(0) += it.steps;
        }
    }
    losses
}

/// The frame of a place. Its number stands behind a row and above a column, or on the other side
/// where the map ends.
fn frame(rank: usize, place: &LossPlace, board: (u32, u32), is_lit: bool) -> Option<Frame> {
    let (first, last) = (*place.cells.first()?, *place.cells.last()?);
    let is_column = first.x == last.x && first.y != last.y;
    let at = if is_column {
        match (first.y.checked_sub(1), last.y + 1 < board.1) {
            (Some(above), _) => Cell::new(first.x, above),
            (None, true) => Cell::new(first.x, last.y + 1),
            (None, false) => first,
        }
    } else {
        match (last.x + 1 < board.0, first.x.checked_sub(1)) {
            (true, _) => Cell::new(last.x + 1, last.y),
            (false, Some(before)) => Cell::new(before, first.y),
            (false, None) => first,
        }
    };
    let size = |from: u32, to: u32| f64::from(to.abs_diff(from) + 1) * CELL;
    Some(Frame {
        number: rank + 1,
        area: (
            corner(first.x),
            corner(first.y),
            size(first.x, last.x),
            size(first.y, last.y),
        ),
        at: (corner(at.x) + CELL / 2.0, corner(at.y) + CELL / 2.0),
        is_lit,
    })
}

fn corner(cells: u32) -> f64 {
    f64::from(cells) * CELL
}
