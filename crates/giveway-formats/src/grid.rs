//! A grid without a header, as people paste it: rows of marks, and perhaps letters for
//! robots.
//!
//! ```text
//!   .a.#A      a small letter is the start of a robot, its capital the goal;
//!   ..#..      S and G alone are the start and the goal of one robot
//! ```

mod blanks;
mod letters;
mod write;

use super::Held;
use super::marks::{Rows, Signs, row};
use crate::lines::{Line, lines};
use giveway_model::{Fault, Grid, Instance, Scene, tr, tr_later};
use letters::Letters;
pub(super) use write::write;

/// The lines by which a grid is known.
const LOOKED_AT: usize = 50;

/// Whether the first line of a text is a row, most of the lines below are, and enough
/// cells have no letter: half of them in a single row, else a third.
pub(super) fn sniff(text: &str) -> bool {
    if blanks::filled(text).is_some() {
        return true;
    }
    let mut all = lines(text).filter(|line| !line.text.is_empty());
    let Some(first) = all.next().and_then(|line| row(line.text)) else {
        return false;
    };
    let is_column = first.len() == 1 && first.iter().any(|mark| "01".contains(mark.letter));
    let (mut rows, mut others) = (vec![first], 0_usize);
    for line in all.take(LOOKED_AT) {
        match row(line.text) {
            Some(row) => rows.push(row),
            None => others += 1,
        }
    }
    let cells = rows.iter().map(Vec::len).sum::<usize>();
    let marks = rows.iter().flatten();
    let ground = marks.filter(|mark| mark.is_ground()).count();
    let share = if rows.len() + others == 1 { 2 } else { 3 };
    !is_column && others <= rows.len() && cells > 1 && ground * share >= cells
}

/// Reads a grid: a map, or a scene where it has letters.
pub(super) fn read(text: &str) -> Result<Held, Fault> {
    let Some(filled) = blanks::filled(text) else {
        return held(text);
    };
    let note = tr!("Blanks in the grid are read as free cells.").to_owned();
    match held(&filled)? {
        Held::Map(grid, mut notes) => {
            notes.push(note);
            Ok(Held::Map(grid, notes))
        }
        Held::Scene(scene, mut remarks) => {
            remarks.notes.push(note);
            Ok(Held::Scene(scene, remarks))
        }
        other => Ok(other),
    }
}

fn held(text: &str) -> Result<Held, Fault> {
    let mut rows = Rows::default();
    let mut letters = Letters::default();
    let mut width = None;
    let mut has_own = false;
    let mut empty: Option<Line<'_>> = None;
    for line in lines(text) {
        if line.text.is_empty() {
            empty = empty.or(width.map(|_| line));
            continue;
        }
        if let (Some(empty), Some(width)) = (empty, width) {
            let expected = tr!(
                "a row of {width} cells: no empty line within the grid",
                width
            );
            return Err(empty.fault_saying("", tr_later!("an empty line"), expected));
        }
        let marks = row(line.text).ok_or_else(|| odd(line))?;
        let width = *width.get_or_insert(marks.len());
        let expected = || {
            tr!(
                "{width}, as in the first row: fill short rows up with # or .",
                width
            )
        };
        has_own |= marks.iter().any(|mark| mark.is_own());
        rows.push(line, &marks, (width, expected))?;
        letters.take(rows.rows.len() - 1, line, &marks)?;
    }
    let grid = Grid::from_rows(&rows.rows).map_err(|_| {
        Fault::at("", tr_later!("no rows"), tr_later!("at least one")).in_text(1, 1)
    })?;
    let ground = match rows.signs {
        Some(Signs::Digits) => tr!("It is read as a bare grid: 0 is free, 1 is an obstacle."),
        _ => tr!("It is read as a bare grid: . is free, # and @ are obstacles."),
    };
    let mut notes = vec![ground.to_owned()];
    if has_own {
        notes.push(tr!("As in Giveway's own maps, ~ is the slow zone, + a charger, * a charger in the slow zone.").to_owned());
    }
    if letters.is_empty() {
        return Ok(Held::Map(grid, notes));
    }
    let (agents, note) = letters.agents()?;
    notes.push(note);
    let scene = Scene {
        map: grid.rows(),
        agents,
        ..Scene::default()
    };
    // Letters stand at cells of their own, so only the size could be wrong.
    match Instance::new(scene.clone()) {
        Ok(_) => Ok(Held::Scene(scene, notes.into())),
        Err(faults) => {
            let fault = faults.into_iter().next();
            let fault = fault.unwrap_or_else(|| Fault::at("", "", ""));
            Err(fault.in_text(1, 1))
        }
    }
}

/// A line that is no row, at its first odd character.
fn odd(line: Line<'_>) -> Fault {
    let expected = tr_later!(
        "a row of . and @ (or #), or of 0 and 1, with letters for robots; a map of the benchmark begins with its height and width"
    );
    let is_odd =
        |&(_, c): &(usize, char)| !(c.is_ascii_alphabetic() || " \t,;.@#01~+*".contains(c));
    let odd = line.text.char_indices().find(is_odd);
    let part = odd.and_then(|(at, c)| line.text.get(at..at + c.len_utf8()));
    line.fault(part.unwrap_or(line.text), expected)
}
