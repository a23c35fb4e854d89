//! Reads `statistics` and `schedule`.

use crate::limits::refuse;
use std::collections::BTreeSet;

use crate::limits::Steps;
use crate::unknown_keys::UnknownKeys;
use crate::yaml::Yaml;
use crate::{Pair, Walk, WrittenAgent, WrittenAt};
use giveway_model::compare::Claimed;
use giveway_model::format::text::shorten;
use giveway_model::words::and;
use giveway_model::{Fault, tr, tr_later};

/// Reads `statistics`.
pub(super) fn statistics(
    y: &mut Yaml<'_>,
    (claimed, unknown): (&mut Claimed, &mut UnknownKeys),
) -> Result<(), Fault> {
    y.object(tr_later!("an object with cost and makespan"), |y, key| {
        match key {
            "cost" | "makespan" => claim(claimed, key, &y.text(tr_later!("a number"))?),
            _ => y.skip_unknown(unknown, ("statistics", key))?,
        }
        Ok(())
    })
}

/// Takes a number of the statistics for what its key says.
pub(super) fn claim(claimed: &mut Claimed, key: &str, number: &str) {
    match key {
        "cost" => claimed.sum_of_costs = whole(number),
        "makespan" => claimed.makespan = whole(number),
        _ => {}
    }
}

/// A whole number, also one that is written like `4.0`.
fn whole(number: &str) -> Option<u64> {
    let digits = number.split_once('.').map_or(number, |(digits, zeros)| {
        if zeros.bytes().all(|zero| zero == b'0') {
            digits
        } else {
            number
        }
    });
    digits.parse().ok()
}

/// How many agents a note names.
const MAX_NAMED: usize = 8;

/// Reads `schedule`: the agents in the order of the file, and a note where times are missing.
pub(super) fn agents(
    y: &mut Yaml<'_>,
    (steps, unknown): (&mut Steps, &mut UnknownKeys),
) -> Result<(Vec<WrittenAgent>, Option<String>), Fault> {
    let mut names = BTreeSet::new();
    let mut with_gaps = Vec::new();
    let mut agents = Vec::new();
    y.object(
        tr_later!("an object with a list of states for each agent"),
        |y, name| {
            if !names.insert(name.to_owned()) {
                let found = tr!("the agent \"{name}\" again", name = shorten(name));
                return Err(y.fault(found, tr!("each agent once")));
            }
            let (line, column) = y.at();
            let track = states(y, (steps, unknown, "schedule"))?;
            if track.has_gaps {
                with_gaps.push(name.to_owned());
            }
            agents.push(WrittenAgent {
                name: Some(name.to_owned()),
                ..WrittenAgent::walking(Walk::Cells(track.cells), WrittenAt::Line(line, column))
            });
            Ok(())
        },
    )?;
    Ok((agents, gaps(with_gaps)))
}

/// The remark that agents have no state at some times, a sentence.
pub(super) fn gaps(mut names: Vec<String>) -> Option<String> {
    let more = names.len().saturating_sub(MAX_NAMED);
    names.truncate(MAX_NAMED);
    if more > 0 {
        names.push(tr!("{n} more" | "{n} more" % more));
    }
    (!names.is_empty()).then(|| {
        tr!(
            "The schedule has no state at some times of {names}: until the next state they are taken to wait.",
            names = and(&names)
        )
    })
}

/// Reads the states of an agent or an obstacle, in a list that is the value of `way`.
pub(super) fn states(
    y: &mut Yaml<'_>,
    (steps, unknown, way): (&mut Steps, &mut UnknownKeys, &str),
) -> Result<Track, Fault> {
    let mut track = Track::default();
    y.list(tr_later!("a list of states"), |y, _| {
        let (mut x, mut row, mut time) = (None, None, None);
        y.object(tr_later!("a state with x, y and t"), |y, key| {
            match key {
                "x" => x = Some(y.number(tr_later!("a whole number"))?),
                "y" => row = Some(y.number(tr_later!("a whole number"))?),
                "t" => time = Some(y.number::<u32>(tr_later!("a time from 0"))?),
                _ => y.skip_unknown(unknown, (way, key))?,
            }
            Ok(())
        })?;
        let (Some(x), Some(row), Some(time)) = (x, row, time) else {
            return Err(y.fault(tr!("a state without x, y or t"), tr!("all three")));
        };
        track
            .push(x, row, time, steps)
            .map_err(|fault| y.fault(fault.found, fault.expected))
    })?;
    Ok(track)
}

/// The cell of an agent at each time from 0.
#[derive(Default)]
pub(super) struct Track {
    cells: Vec<Pair>,
    /// The time of the first state.
    begins: usize,
    /// Whether a time has no state of its own.
    pub(super) has_gaps: bool,
}

impl Track {
    /// Adds a state. The agent waits up to the time before it.
    ///
    /// # Errors
    /// When the time is not a later one, or too late; the fault has no place yet.
    pub(super) fn push(
        &mut self,
        x: i32,
        y: i32,
        time: u32,
        steps: &mut Steps,
    ) -> Result<(), Fault> {
        let (time, length) = (time as usize, self.cells.len());
        if time < length {
            let expected = tr!("a later one: the times up to {n} are there", n = length - 1);
            return refuse(tr!("the time {time}", time), expected);
        }
        steps.add(time + 1 - length)?;
        self.has_gaps |= time > length;
        let cell = Pair::new(x, y);
        if length == 0 {
            self.begins = time;
        }
        let before = self.cells.last().copied().unwrap_or(cell);
        self.cells.resize(time, before);
        self.cells.push(cell);
        Ok(())
    }

    /// The cells, with the time at which the first state is.
    pub(super) fn timed(self) -> (usize, Vec<Pair>) {
        (self.begins, self.cells)
    }

    /// The walk, where there is a state.
    pub(super) fn walk(self) -> Option<Walk> {
        (!self.cells.is_empty()).then_some(Walk::Cells(self.cells))
    }
}
