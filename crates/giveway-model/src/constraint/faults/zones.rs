//! Faults of zones, and cells off the map.

use std::collections::BTreeSet;

use crate::{Cell, Fault, Grid, Zone, tr, tr_later};

/// Finds the faults of a zone, but for its name.
pub(super) fn check_zone(zone: &Zone, place: &str, grid: &Grid, faults: &mut Vec<Fault>) {
    match (&zone.listed, zone.rect) {
        (Some(_), Some(_)) => faults.push(Fault::at(
            format!("{place}.rect"),
            tr_later!("both cells and a rect"),
            tr_later!("one of them"),
        )),
        (None, None) => faults.push(Fault::at(
            place,
            tr_later!("neither cells nor a rect"),
            tr_later!("one of them"),
        )),
        (Some(cells), None) => check_listed(cells, place, grid, faults),
        (None, Some([x0, y0, x1, y1])) => {
            let place = format!("{place}.rect");
            if x0 > x1 || y0 > y1 {
                faults.push(Fault::at(
                    place,
                    format!("[{x0}, {y0}, {x1}, {y1}]"),
                    tr_later!("the corner at the top left, then the one at the bottom right"),
                ));
            } else if let Some(fault) = off_map(Cell::new(x1, y1), grid, &place) {
                faults.push(fault);
            }
        }
    }
}

fn check_listed(cells: &[Cell], place: &str, grid: &Grid, faults: &mut Vec<Fault>) {
    if cells.is_empty() {
        faults.push(Fault::at(
            format!("{place}.cells"),
            tr_later!("no cell"),
            tr_later!("at least one cell"),
        ));
    }
    let mut seen = BTreeSet::new();
    for (k, &cell) in cells.iter().enumerate() {
        let place = format!("{place}.cells[{k}]");
        if let Some(fault) = off_map(cell, grid, &place) {
            faults.push(fault);
        } else if !seen.insert(cell) {
            faults.push(Fault::at(
                place,
                tr!("{cell} again", cell),
                tr_later!("each cell once"),
            ));
        }
    }
}

/// The fault of a cell that is not on the map.
pub(super) fn off_map(cell: Cell, grid: &Grid, place: &str) -> Option<Fault> {
    let is_off = grid.ground(cell).is_none();
    is_off.then(|| {
        Fault::at(
            place,
            format!("({}, {})", cell.x, cell.y),
            tr!(
                "a cell of the {width} x {height} map",
                width = grid.width(),
                height = grid.height()
            ),
        )
    })
}
