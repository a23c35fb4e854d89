//! Reads `statistics` and `schedule`.

use std::collections::BTreeSet;

use crate::format::foreign::limits::Steps;
use crate::format::foreign::yaml::Yaml;
use crate::format::foreign::{Claimed, Pair, Walk, WrittenAgent, WrittenAt};
use crate::format::text::shorten;
use crate::{Fault, tr, tr_later};

/// Reads `statistics`.
pub(super) fn statistics(y: &mut Yaml<'_>) -> Result<Claimed, Fault> {
    let mut claimed = Claimed::default();
    y.object(tr_later!("an object with cost and makespan"), |y, key| {
        match key {
            "cost" | "makespan" => claim(&mut claimed, key, &y.text(tr_later!("a number"))?),
            _ => y.skip()?,
        }
        Ok(())
    })?;
    Ok(claimed)
}

/// Takes a number of the statistics for what its key says.
pub(super) fn claim(claimed: &mut Claimed, key: &str, number: &str) {
    match key {
        "cost" => claimed.sum_of_costs = number.parse().ok(),
        "makespan" => claimed.makespan = number.parse().ok(),
        _ => {}
    }
}

/// Reads `schedule`: the agents in the order of the file.
pub(super) fn agents(y: &mut Yaml<'_>, steps: &mut Steps) -> Result<Vec<WrittenAgent>, Fault> {
    let mut names = BTreeSet::new();
    let mut agents = Vec::new();
    y.object(
        tr_later!("an object with a list of states for each agent"),
        |y, name| {
            if !names.insert(name.to_owned()) {
                let found = tr!("the agent \"{name}\" again", name = shorten(name));
                return Err(y.fault(found, tr!("each agent once")));
            }
            let (line, column) = y.at();
            let track = states(y, steps)?;
            agents.push(WrittenAgent {
                name: Some(name.to_owned()),
                ..WrittenAgent::walking(Walk::Cells(track.cells), WrittenAt::Line(line, column))
            });
            Ok(())
        },
    )?;
    Ok(agents)
}

fn states(y: &mut Yaml<'_>, steps: &mut Steps) -> Result<Track, Fault> {
    let mut track = Track::default();
    y.list(tr_later!("a list of states"), |y, _| {
        let (mut x, mut row, mut time) = (None, None, None);
        y.object(tr_later!("a state with x, y and t"), |y, key| {
            match key {
                "x" => x = Some(y.number(tr_later!("a whole number"))?),
                "y" => row = Some(y.number(tr_later!("a whole number"))?),
                "t" => time = Some(y.number::<u32>(tr_later!("a time from 0"))?),
                _ => y.skip()?,
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
            return Err(Fault::at("", tr!("the time {time}", time), expected));
        }
        steps.add(time + 1 - length)?;
        let cell = Pair::new(x, y);
        let before = self.cells.last().copied().unwrap_or(cell);
        self.cells.resize(time, before);
        self.cells.push(cell);
        Ok(())
    }

    /// The walk, where there is a state.
    pub(super) fn walk(self) -> Option<Walk> {
        (!self.cells.is_empty()).then_some(Walk::Cells(self.cells))
    }
}
