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

use std::collections::BTreeMap;

pub(super) use write::write;

use super::cursor::Cursor;
use super::limits::{Steps, robots};
use super::{CellOrder, Conventions, Held, Pair, Walk, WrittenAgent, WrittenAt, WrittenPlan};
use giveway_model::format::text::at_byte;
use giveway_model::{Fault, tr, tr_later};

/// Whether a text begins with `Agent`, a number and a colon.
pub(super) fn sniff(text: &str) -> bool {
    let Some(rest) = text.trim_start().strip_prefix("Agent") else {
        return false;
    };
    let number = rest.trim_start_matches([' ', '\t']);
    let rest = number.trim_start_matches(|c: char| c.is_ascii_digit());
    rest.len() < number.len() && rest.trim_start_matches([' ', '\t']).starts_with(':')
}

/// Reads a plan.
pub(super) fn read(text: &str) -> Result<Held, Fault> {
    let mut cursor = Cursor::new(text);
    let mut steps = Steps::default();
    let mut agents: BTreeMap<usize, (usize, WrittenAgent)> = BTreeMap::new();
    let mut has_blanks = true;
    let mut is_in_order = true;
    cursor.space();
    while !cursor.is_at_end() {
        let begin = cursor.clone();
        cursor.expect("Agent", tr_later!("a line \"Agent 0: (3,1)->\""))?;
        cursor.blanks();
        let at = cursor.clone();
        let number = cursor.number(tr_later!("the number of the robot"))?;
        let number = usize::try_from(number).map_err(|_| at.fault(tr!("a number from 0")))?;
        if agents.contains_key(&number) {
            let expected = tr!("each robot once");
            let found = tr!("a second path of robot {number}", number);
            return Err(at.fault_saying(found, expected));
        }
        is_in_order &= agents
            .last_key_value()
            .is_none_or(|(&last, _)| last < number);
        let at = at.offset();
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
        let walk = Walk::Cells(cells);
        let agent = WrittenAgent::walking(walk, WrittenAt::Byte(begin.offset()));
        agents.insert(number, (at, agent));
        cursor.space();
    }
    let begins_with = usize::from(!agents.contains_key(&0));
    if let Some((n, (_, (at, _)))) = (begins_with..).zip(&agents).find(|(n, (own, _))| n != *own) {
        let found = tr!("no path of robot {n}", n);
        let expected = tr!("a path of each robot, numbered from 0 or 1 without a gap");
        return Err(at_byte(text, *at, Fault::at("", found, expected)));
    }
    let mut notes = Vec::new();
    if !is_in_order {
        notes.push(
            tr!("The robots of the file are not in order; they are read by their numbers.")
                .to_owned(),
        );
    }
    let documented = Conventions {
        cells: if has_blanks {
            CellOrder::RowColumn
        } else {
            CellOrder::ColumnRow
        },
        ..Conventions::OWN
    };
    let agents = agents.into_values().map(|(_, agent)| agent);
    Ok(Held::Plan(WrittenPlan {
        notes,
        ..WrittenPlan::new(agents.collect(), documented)
    }))
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
