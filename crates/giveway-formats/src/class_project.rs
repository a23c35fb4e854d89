//! Instances of the class project on multi-agent path finding, rows first.
//!
//! ```text
//!   ROWS COLUMNS
//!   . . @ .                                  a line for each row, with or without blanks
//!   ROBOTS
//!   START-ROW START-COLUMN GOAL-ROW GOAL-COLUMN    a line for each robot, from 0
//! ```
//!
//! Source: `import_mapf_instance` in `run_experiments.py` of "A Project on Multi-Agent
//! Path Finding" (Hönig, Li, Koenig; Model AI Assignments 2020).

mod write;

use super::Held;
use super::marks::{Rows, row};
use crate::lines::{Line, lines};
use giveway_model::{Agent, Cell, Fault, Grid, Instance, Scene, tr, tr_later};
use giveway_model::{MAX_AGENTS, MAX_SIDE};
pub(super) use write::write;

/// Whether a text begins with a line of two numbers and a row of a grid.
pub(super) fn sniff(text: &str) -> bool {
    let mut all = lines(text).filter(|line| !line.text.is_empty());
    let (Some(first), Some(second)) = (all.next(), all.next()) else {
        return false;
    };
    let numbers = first.text.split_whitespace().map(str::parse::<u32>);
    let Ok(numbers) = numbers.collect::<Result<Vec<u32>, _>>() else {
        return false;
    };
    let is_grid = row(second.text).is_some_and(|marks| {
        let points = marks
            .iter()
            .any(|mark| matches!(mark.letter, '.' | '@' | '#'));
        let all_ground = marks.iter().all(|mark| mark.is_ground());
        // Two digits could be a row of a grid themselves.
        all_ground && (points || numbers.iter().any(|&side| side > 1))
    });
    numbers.len() == 2 && is_grid
}

/// Reads an instance, or a map where the robots are left out.
pub(super) fn read(text: &str) -> Result<Held, Vec<Fault>> {
    let mut all = lines(text).filter(|line| !line.text.is_empty());
    let (scene, places) = scene(&mut all).map_err(|fault| vec![fault])?;
    let note = tr!(
        "It is read as an instance of the class project: the row first, then the column, both from 0."
    );
    let mut notes = vec![note.to_owned()];
    let Some(places) = places else {
        notes.push(tr!("The file ends after the map: it has no robots.").to_owned());
        let grid = Grid::from_rows(&scene.map);
        return grid.map(|grid| Held::Map(grid, notes)).map_err(|_| {
            vec![Fault::at("", tr_later!("no rows"), tr_later!("at least one")).in_text(1, 1)]
        });
    };
    match Instance::new(scene.clone()) {
        Ok(_) => Ok(Held::Scene(scene, notes.into())),
        Err(faults) => Err(faults
            .into_iter()
            .map(|fault| placed(fault, &places))
            .collect()),
    }
}

/// The fault of a robot at its line.
fn placed(fault: Fault, places: &[Line<'_>]) -> Fault {
    let index = fault
        .place
        .strip_prefix("agents[")
        .and_then(|rest| rest.split_once(']'));
    let line = index.and_then(|(index, _)| places.get(index.parse::<usize>().ok()?));
    fault.in_text(line.map_or(1, |line| line.number), 1)
}

type Lines<'a, 'b> = &'b mut dyn Iterator<Item = Line<'a>>;

/// The scene, and the lines of its robots; `None` where the file ends with the map.
fn scene<'a>(all: Lines<'a, '_>) -> Result<(Scene, Option<Vec<Line<'a>>>), Fault> {
    const SIZE: &str = "ROWS COLUMNS";
    let first = all.next().ok_or_else(|| lacking(None, SIZE))?;
    let [height, width] = numbers::<2>(first, SIZE)?;
    for side in [height, width] {
        if !(1..=MAX_SIDE).contains(&side) {
            let expected = tr!("rows and columns from 1 to {most}", most = MAX_SIDE);
            return Err(first.fault(first.text, expected));
        }
    }
    let mut rows = Rows::default();
    let mut last = first;
    for _ in 0..height {
        let line = all.next().ok_or_else(|| {
            let expected = tr!("{height} rows, as the first line says", height);
            lacking(Some(last), &expected)
        })?;
        let marks = row(line.text).filter(|marks| marks.iter().all(|mark| mark.is_ground()));
        let marks = marks.ok_or_else(|| {
            let n = rows.rows.len();
            let expected = tr!(
                "a row of . and @, since the first line says {height} rows and {n} came",
                height,
                n
            );
            line.fault(line.text, expected)
        })?;
        let expected = || tr!("{width}, the columns in the first line", width);
        rows.push(line, &marks, (width as usize, expected))?;
        last = line;
    }
    let mut scene = Scene {
        map: rows.rows,
        ..Scene::default()
    };
    let Some(line) = all.next() else {
        return Ok((scene, None));
    };
    let [robots] = numbers::<1>(line, tr!("the number of robots"))?;
    if robots as usize > MAX_AGENTS {
        return Err(line.fault(line.text, tr!("at most {most} robots", most = MAX_AGENTS)));
    }
    let mut places = Vec::new();
    last = line;
    for i in 1..=robots {
        let line = all.next().ok_or_else(|| {
            let expected = tr!("a line for each of the {robots} robots", robots);
            lacking(Some(last), &expected)
        })?;
        let [sy, sx, gy, gx] = numbers::<4>(line, "START-ROW START-COLUMN GOAL-ROW GOAL-COLUMN")?;
        for (row, column) in [(sy, sx), (gy, gx)] {
            if row >= height || column >= width {
                let found = tr!("row {row}, column {column}", row, column);
                let expected = tr!(
                    "a cell of the {height} rows and {width} columns, from 0, the row first",
                    height,
                    width
                );
                return Err(line.fault_saying(line.text, found, expected));
            }
        }
        scene.agents.push(Agent::new(
            format!("A{i}"),
            Cell::new(sx, sy),
            Some(Cell::new(gx, gy)),
        ));
        places.push(line);
        last = line;
    }
    match all.next() {
        None => Ok((scene, Some(places))),
        Some(line) => {
            let expected = tr!("the end of the file after the {robots} robots", robots);
            Err(line.fault(line.text, expected))
        }
    }
}

/// A fault at the end of the file.
fn lacking(last: Option<Line<'_>>, expected: &str) -> Fault {
    let found = tr_later!("the end of the file");
    match last {
        Some(line) => line.fault_saying(line.end(), found, expected),
        None => Fault::at("", found, expected).in_text(1, 1),
    }
}

/// The numbers of a line.
fn numbers<const N: usize>(line: Line<'_>, expected: &str) -> Result<[u32; N], Fault> {
    let mut numbers = [0; N];
    let mut words = line.text.split_whitespace();
    for number in &mut numbers {
        let word = words.next().unwrap_or_else(|| line.end());
        *number = line.number(word, || expected.to_owned())?;
    }
    match words.next() {
        None => Ok(numbers),
        Some(word) => Err(line.fault(word, expected)),
    }
}
