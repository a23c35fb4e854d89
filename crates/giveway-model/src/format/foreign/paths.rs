//! Plans with a line for each robot.
//!
//! ```text
//!   file = { line }
//!   line = "Agent" number ":" [ cell { "->" cell } [ "->" ] ] end
//!   cell = "(" number "," number ")"
//! ```
//!
//! Sources: `CBS::savePaths` in `src/CBS.cpp` of Jiaoyang-Li/CBSH2-RTC and
//! Jiaoyang-Li/EECBS, `PBS::savePaths` in `src/PBS.cpp` of Jiaoyang-Li/PBS. They
//! write a blank after the colon, the row before the column, both from 0, an arrow
//! after every cell, and the robots in the order of the scenario, from 0.
//! `Instance::savePaths` in `src/Instance.cpp` of Jiaoyang-Li/MAPF-LNS2 writes no
//! blank, and for a `.scen` the column before the row.
//!
//! A path ends at its arrival; a robot without a path has none on its line.

mod write;

pub(super) use write::write;

use super::cursor::Cursor;
use super::limits::{Steps, robots};
use super::{CellOrder, Claimed, Conventions, Held, Origin, Pair, Up, Walk, WrittenAt};
use super::{WrittenAgent, WrittenPlan};
use crate::{Fault, tr, tr_later};

/// Whether a text begins with `Agent`, a number and a colon.
pub(super) fn sniff(text: &str) -> bool {
    let Some(rest) = text.trim_start().strip_prefix("Agent") else {
        return false;
    };
    let number = rest.trim_start_matches([' ', '\t']);
    let rest = number.trim_start_matches(|c: char| c.is_ascii_digit());
    rest.len() < number.len() && rest.trim_start_matches([' ', '\t']).starts_with(':')
}

pub(super) fn read(text: &str) -> Result<Held, Vec<Fault>> {
    plan(text).map(Held::Plan).map_err(|fault| vec![fault])
}

fn plan(text: &str) -> Result<WrittenPlan, Fault> {
    let mut cursor = Cursor::new(text);
    let mut steps = Steps::default();
    let mut agents = Vec::new();
    let mut has_blanks = true;
    let mut begins_with = 0;
    cursor.space();
    while !cursor.is_at_end() {
        let begin = cursor.clone();
        cursor.expect("Agent", tr_later!("a line \"Agent 0: (3,1)->\""))?;
        cursor.blanks();
        let at = cursor.clone();
        let number = cursor.number(tr_later!("the number of the robot"))?;
        if agents.is_empty() && number == 1 {
            begins_with = 1;
        }
        if usize::try_from(number) != Ok(agents.len() + begins_with) {
            let expected = tr!(
                "{n}, the next robot in order",
                n = agents.len() + begins_with
            );
            return Err(at.fault_saying(number.to_string(), expected));
        }
        cursor.blanks();
        cursor.expect(":", "\":\"")?;
        if agents.is_empty() {
            has_blanks = cursor.peek() != Some(b'(');
        }
        let cells = cells(&mut cursor)?;
        let counted = steps
            .add(cells.len())
            .and_then(|()| robots(agents.len() + 1));
        counted.map_err(|fault| begin.place(fault))?;
        agents.push(WrittenAgent::walking(
            Walk::Cells(cells),
            WrittenAt::Byte(begin.offset()),
        ));
        cursor.space();
    }
    Ok(WrittenPlan {
        map: None,
        agents,
        claimed: Claimed::default(),
        documented: Conventions {
            cells: if has_blanks {
                CellOrder::RowColumn
            } else {
                CellOrder::ColumnRow
            },
            origin: Origin::Zero,
            up: Up::Lowers,
        },
        notes: Vec::new(),
    })
}

/// The cells of a line, whose end it passes over.
fn cells(cursor: &mut Cursor<'_>) -> Result<Vec<Pair>, Fault> {
    let mut cells = Vec::new();
    cursor.blanks();
    while cursor.peek() == Some(b'(') {
        cells.push(cursor.pair()?);
        cursor.expect(")", "\")\"")?;
        cursor.blanks();
        if !cursor.eat("->") {
            break;
        }
        cursor.blanks();
    }
    let expected = if cells.is_empty() {
        tr_later!("a cell, such as (3,1)")
    } else {
        tr_later!("\"->\" and a cell, or the end of the line")
    };
    cursor.end_of_line(expected)?;
    cells.shrink_to_fit();
    Ok(cells)
}
