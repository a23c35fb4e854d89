//! The lines of the steps: where every robot is at each time.

use crate::cursor::Cursor;
use crate::limits::{Steps, robots};
use crate::{Pair, WrittenAt};
use giveway_model::{Fault, tr, tr_later};

/// The content of the steps.
#[derive(Debug, Default)]
pub(super) struct Read {
    /// The cells of each robot.
    pub(super) paths: Vec<Vec<Pair>>,
    /// Where the first cell of each robot is written.
    pub(super) places: Vec<WrittenAt>,
    /// Whether a cell has a heading.
    pub(super) has_headings: bool,
    /// Whether a cell has a task behind it.
    pub(super) has_tasks: bool,
}

/// Reads all steps, up to the end of the text.
///
/// # Errors
/// When a line is no step, when its time is not the next one, or when it does not
/// have as many cells as there are robots.
pub(super) fn read(cursor: &mut Cursor<'_>, agents: Option<usize>) -> Result<Read, Fault> {
    let mut read = Read::default();
    let mut counted = Steps::default();
    let mut time = 0;
    cursor.space();
    while !cursor.is_at_end() {
        let begin = cursor.clone();
        let number = cursor.number(tr_later!("a line \"0:(3,1),\" for each time step"))?;
        if number != time {
            let expected = tr!("{time}, the next time step", time);
            return Err(begin.fault_saying(number.to_string(), expected));
        }
        cursor.expect(":", "\":\"")?;
        let cells = read.step(cursor, time == 0)?;
        let known = agents.filter(|_| time == 0).unwrap_or(read.paths.len());
        if cells != known {
            let found = tr!(
                "{n} cell at time {time}" | "{n} cells at time {time}" % cells,
                time
            );
            return Err(begin.fault_saying(found, tr!("{known}, one for each robot", known)));
        }
        // A step takes time to read even where it has no cell.
        let counted = counted.add(cells.max(1));
        counted.map_err(|fault| begin.place(fault))?;
        time += 1;
        cursor.space();
    }
    for path in &mut read.paths {
        path.shrink_to_fit();
    }
    Ok(read)
}

impl Read {
    /// Reads the cells of a step up to the end of its line, and says how many there are.
    fn step(&mut self, cursor: &mut Cursor<'_>, is_first: bool) -> Result<usize, Fault> {
        let mut agent = 0;
        cursor.blanks();
        while cursor.peek() == Some(b'(') {
            let begin = cursor.clone();
            let cell = self.cell(cursor)?;
            match self.paths.get_mut(agent) {
                Some(path) => path.push(cell),
                None if is_first => {
                    robots(agent + 1).map_err(|fault| begin.place(fault))?;
                    self.paths.push(vec![cell]);
                    self.places.push(WrittenAt::Byte(begin.offset()));
                }
                None => {
                    let expected = tr!("the end of the line after {n} robot"
                        | "the end of the line after {n} robots" % self.paths.len());
                    return Err(begin.fault(expected));
                }
            }
            agent += 1;
            if !cursor.eat(",") {
                break;
            }
            cursor.blanks();
        }
        let expected = if agent == 0 {
            tr_later!("a cell, such as (3,1)")
        } else {
            tr_later!("\",\" and a cell, or the end of the line")
        };
        cursor.end_of_line(expected)?;
        Ok(agent)
    }

    fn cell(&mut self, cursor: &mut Cursor<'_>) -> Result<Pair, Fault> {
        let cell = self.place(cursor)?;
        if cursor.eat("->") {
            self.has_tasks = true;
            self.place(cursor)?;
            cursor.expect(":", tr_later!("\":\" and the number of a task"))?;
            cursor.number(tr_later!("the number of a task, or -1"))?;
        }
        Ok(cell)
    }

    /// A cell, with a heading or without.
    fn place(&mut self, cursor: &mut Cursor<'_>) -> Result<Pair, Fault> {
        let cell = cursor.pair()?;
        if cursor.eat(",") {
            self.has_headings = true;
            let known = ["X_PLUS", "X_MINUS", "Y_PLUS", "Y_MINUS", "NONE"];
            if !known.iter().any(|&word| cursor.eat(word)) {
                return Err(cursor.fault(tr!("X_PLUS, X_MINUS, Y_PLUS or Y_MINUS")));
            }
        }
        cursor.expect(")", "\")\"")?;
        Ok(cell)
    }
}
