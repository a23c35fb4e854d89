//! The lines before the steps: what the plan is for and what it costs.

use crate::cursor::Cursor;
use crate::limits::robots;
use crate::unknown_keys::UnknownKeys;
use crate::{WrittenAt, WrittenCell};
use giveway_model::compare::{Claimed, ClaimedBounds};
use giveway_model::{Fault, tr, tr_later};

/// The keys by which such a file is known.
pub(super) const KEYS: [&str; 12] = [
    "agents",
    "map_file",
    "instance",
    "solver",
    "solved",
    "soc",
    "makespan",
    "comp_time",
    "seed",
    "starts",
    "goals",
    "solution",
];

/// The lines before the steps.
#[derive(Debug, Default)]
pub(super) struct Header {
    pub(super) agents: Option<usize>,
    pub(super) map: Option<String>,
    pub(super) claimed: Claimed,
    pub(super) bounds: ClaimedBounds,
    pub(super) is_unsolved: bool,
    pub(super) starts: Vec<WrittenCell>,
    pub(super) goals: Vec<WrittenCell>,
    /// Keys of unknown meaning.
    pub(super) unknown: UnknownKeys,
}

/// Keys by which the makers tell of the search, or that say what each robot
/// has as a task.
const MAKERS: [&str; 11] = [
    "checkpoints",
    "comp_time_initial_solution",
    "cost_initial_solution",
    "max_comp_time",
    "max_timestep",
    "num_high_level_node",
    "num_low_level_node",
    "preprocessing_comp_time",
    "problem_type",
    "search_iteration",
    "task",
];

impl Header {
    /// Reads all lines up to the first step.
    ///
    /// # Errors
    /// When a line is no `key=value`, a number is none, or the steps do not come.
    pub(super) fn read(cursor: &mut Cursor<'_>) -> Result<Self, Fault> {
        let mut header = Self::default();
        cursor.space();
        if cursor.peek().is_some_and(|byte| byte.is_ascii_digit()) {
            return Ok(header);
        }
        let mut is_in_tasks = false;
        loop {
            cursor.space();
            let begin = cursor.clone();
            if cursor.is_at_end() {
                return Err(cursor.fault(tr!("\"solution=\" and a line for each time step")));
            }
            let key = key(cursor);
            if !cursor.eat("=") {
                if is_in_tasks && key.is_empty() {
                    cursor.line();
                    continue;
                }
                return Err(begin.fault(tr!("a line \"key=value\"")));
            }
            is_in_tasks = key == "task";
            if key == "solution" {
                cursor.end_of_line(tr_later!("the end of the line, with the steps below"))?;
                return header.checked(cursor);
            }
            header.take(key, cursor)?;
        }
    }

    fn take(&mut self, key: &str, cursor: &mut Cursor<'_>) -> Result<(), Fault> {
        match key {
            "agents" => {
                let begin = cursor.clone();
                let agents = count(cursor)? as usize;
                robots(agents).map_err(|fault| begin.place(fault))?;
                self.agents = Some(agents);
            }
            "soc" => self.claimed.sum_of_costs = Some(count(cursor)?),
            "makespan" => self.claimed.makespan = Some(count(cursor)?),
            "solved" => self.is_unsolved = cursor.line() == "0",
            "map_file" => {
                let map = cursor.line();
                self.map = (!map.is_empty()).then(|| map.to_owned());
            }
            "starts" => self.starts = cells(cursor)?,
            "goals" => self.goals = cells(cursor)?,
            "soc_lb" | "lb_soc" => self.bounds.sum_of_costs = self.bound(key, cursor),
            "makespan_lb" | "lb_makespan" => self.bounds.makespan = self.bound(key, cursor),
            "sum_of_loss_lb" => self.bounds.sum_of_loss = self.bound(key, cursor),
            "sum_of_loss" => self.bounds.loss = self.bound(key, cursor),
            _ => {
                if !KEYS.contains(&key) && !MAKERS.contains(&key) {
                    self.unknown.note("", key);
                }
                cursor.line();
            }
        }
        Ok(())
    }

    /// A number from 0 to the end of the line; where there is none, the key counts as unknown.
    fn bound(&mut self, key: &str, cursor: &mut Cursor<'_>) -> Option<u64> {
        let number = cursor.line().trim().parse().ok();
        if number.is_none() {
            self.unknown.note("", key);
        }
        number
    }

    /// Whether the counts of robots agree.
    fn checked(self, cursor: &Cursor<'_>) -> Result<Self, Fault> {
        for (is_start, cells) in [(true, &self.starts), (false, &self.goals)] {
            let agents = self.agents.unwrap_or(self.starts.len());
            if !cells.is_empty() && cells.len() != agents {
                let n = cells.len();
                let found = if is_start {
                    tr!("{n} start before the steps" | "{n} starts before the steps" % n)
                } else {
                    tr!("{n} goal before the steps" | "{n} goals before the steps" % n)
                };
                let expected = tr!("{agents}, one of each robot", agents);
                return Err(cursor.fault_saying(found, expected));
            }
        }
        Ok(self)
    }
}

/// Passes over a key: letters, digits after them, and underscores.
fn key<'a>(cursor: &mut Cursor<'a>) -> &'a str {
    let rest = cursor.rest();
    let is_key = |byte: &u8| byte.is_ascii_alphanumeric() || *byte == b'_';
    let length = rest.bytes().take_while(|byte| is_key(byte)).count();
    let word = rest.get(..length).unwrap_or("");
    if word.starts_with(|c: char| c.is_ascii_digit()) {
        return "";
    }
    cursor.eat(word);
    word
}

/// A number from 0, alone on the rest of its line.
fn count(cursor: &mut Cursor<'_>) -> Result<u64, Fault> {
    cursor.blanks();
    let begin = cursor.clone();
    let number = cursor.number(tr_later!("a number from 0"))?;
    let number = u64::try_from(number).map_err(|_| begin.fault(tr!("a number from 0")))?;
    cursor.end_of_line(tr_later!("the end of the line"))?;
    Ok(number)
}

/// Cells up to the end of the line, with commas between them.
fn cells(cursor: &mut Cursor<'_>) -> Result<Vec<WrittenCell>, Fault> {
    let begin = cursor.clone();
    let mut cells = Vec::new();
    cursor.blanks();
    while cursor.peek() == Some(b'(') {
        robots(cells.len() + 1).map_err(|fault| begin.place(fault))?;
        let at = WrittenAt::Byte(cursor.offset());
        let pair = cursor.pair()?;
        cells.push(WrittenCell { pair, at });
        cursor.expect(")", "\")\"")?;
        cursor.eat(",");
        cursor.blanks();
    }
    cursor.end_of_line(tr_later!("a cell, such as (3,1), or the end of the line"))?;
    Ok(cells)
}
