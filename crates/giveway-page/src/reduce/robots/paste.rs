//! A table of robots is pasted: rows are found by their names, others are robots that come.

use std::collections::BTreeMap;

use giveway_model::tr_data;

use super::settle_given;
use crate::reduce::{ask, board, stroke};
use crate::robots::{Column, Given, Grid, Part, Target, Waiting, grid};
use crate::{Notice, Selection, State};

/// A table was pasted: rows are found by their names, others are robots that come.
pub(super) fn paste(state: &mut State, text: &str, at_cursor: bool) {
    stroke::release(state);
    let Grid {
        columns,
        has_heads,
        rows,
    } = grid(text);
    let shown = crate::robots::shown(state);
    let (first, column) = state.view.robots.at;
    let is_block = at_cursor && !has_heads;
    let columns: Vec<Option<Part>> = if is_block {
        let from = Column::ALL
            .iter()
            .position(|&other| other == column)
            .unwrap_or(0);
        Column::ALL
            .into_iter()
            .skip(from)
            .map(|column| Some(Part::Whole(column)))
            .collect()
    } else {
        columns
    };
    let agents = state.document.draft.agents();
    let mut given: Vec<Given> = Vec::new();
    for (index, row) in rows.into_iter().enumerate() {
        let cells = cells(&columns, row);
        let target = if is_block {
            let at = shown.get(first + index).filter(|&&at| at < agents.len());
            at.map_or(Target::New, |&at| Target::Old(at))
        } else {
            let name = cells.get(&Column::Name);
            let at = agents.iter().position(|agent| Some(&agent.name) == name);
            at.map_or(Target::New, Target::Old)
        };
        if !cells.is_empty() {
            given.push(Given { target, cells });
        }
    }
    let room = crate::MAX_AGENTS.saturating_sub(agents.len());
    if given.is_empty()
        || given
            .iter()
            .filter(|given| given.target == Target::New)
            .count()
            > room
    {
        return ask::refuse(
            state,
            tr_data!("There is no table of robots in what was pasted."),
        );
    }
    board::select(state, Selection::Nothing);
    let count = given.len();
    settle_given(
        state,
        Waiting {
            given,
            is_pasted: true,
        },
    );
    if state.view.robots.waiting.is_some() {
        state.view.robots.is_open = true;
        state.view.robots.filter.clear();
    } else if state.view.notice.is_none() && !state.shows_robots() {
        state.view.notice = Some(Notice::information(tr_data!(
            "{n} robot pasted." | "{n} robots pasted." % count
        )));
    }
}

/// The cells of a row by their columns; a place in two columns is put together.
fn cells(columns: &[Option<Part>], row: Vec<String>) -> BTreeMap<Column, String> {
    let mut cells: BTreeMap<Column, String> = BTreeMap::new();
    for (part, text) in columns.iter().zip(row) {
        match part {
            Some(Part::Whole(column)) if !column.is_result() => {
                cells.insert(*column, text);
            }
            Some(Part::Half(column, is_y)) => {
                let cell = cells.entry(*column).or_default();
                *cell = match (cell.is_empty(), is_y) {
                    (true, _) => text,
                    (false, true) => format!("{cell}, {text}"),
                    (false, false) => format!("{text}, {cell}"),
                };
            }
            Some(Part::Whole(_)) | None => {}
        }
    }
    cells
}
