//! The signs of the heat map in the legend, and what the name of a cell says of it.

use giveway_model::{Cell, tr};

use super::heat::most;
use crate::State;
use crate::inside::Sign;

/// The signs of the heat map; `None` where it is not shown.
pub fn legend(state: &State) -> Option<Vec<Sign>> {
    let told = state.ledger()?.told.as_deref()?;
    if told.reason.is_some() {
        return None;
    }
    let sign = |class, words| Sign {
        class,
        agent: None,
        words,
    };
    let most = most(told);
    let mut signs = Vec::new();
    if most > 0 {
        let words = tr!("0 to {n} step lost at a cell" | "0 to {n} steps lost at a cell" % most);
        signs.push(sign("k-scale", words));
    }
    if !told.places.is_empty() {
        signs.push(sign("k-loss", tr!("Where most is lost").to_owned()));
    }
    Some(signs)
}

/// What the names of cells end with: `18 steps lost, A2 18`; `None` where the ledger is not shown.
pub fn notes(state: &State) -> Option<Vec<(Cell, String)>> {
    let told = state.ledger()?.told.as_deref()?;
    let note = |lost: &giveway_solve::delays::CellLoss| {
        let mut who = Vec::new();
        for row in &told.agents {
            let here = row.lost.iter().filter(|it| it.cell == lost.cell);
            let steps: u32 = here.map(|it| it.steps).sum();
            if steps > 0 {
                who.push(format!("{} {steps}", row.agent));
            }
        }
        let who = who.join(", ");
        let note = tr!(
            "{n} step lost: {who}" | "{n} steps lost: {who}" % lost.steps,
            who
        );
        (lost.cell, note)
    };
    Some(told.lost.iter().map(note).collect())
}
