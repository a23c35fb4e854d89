//! Reads `statistics` and `schedule`.

use std::collections::BTreeSet;

use crate::Fault;
use crate::format::foreign::limits::Steps;
use crate::format::foreign::yaml::Yaml;
use crate::format::foreign::{Claimed, Pair, Walk, WrittenAgent};
use crate::format::text::shorten;

/// Reads `statistics`.
pub(super) fn statistics(y: &mut Yaml<'_>) -> Result<Claimed, Fault> {
    let mut claimed = Claimed::default();
    y.object("an object with cost and makespan", |y, key| {
        match key {
            "cost" => claimed.sum_of_costs = y.text("a number")?.parse().ok(),
            "makespan" => claimed.makespan = y.text("a number")?.parse().ok(),
            _ => y.skip()?,
        }
        Ok(())
    })?;
    Ok(claimed)
}

/// Reads `schedule`: the agents in the order of the file.
pub(super) fn agents(y: &mut Yaml<'_>, steps: &mut Steps) -> Result<Vec<WrittenAgent>, Fault> {
    let mut names = BTreeSet::new();
    let mut agents = Vec::new();
    y.object(
        "an object with a list of states for each agent",
        |y, name| {
            if !names.insert(name.to_owned()) {
                let found = format!("the agent \"{}\" again", shorten(name));
                return Err(y.fault(found, "each agent once"));
            }
            let cells = states(y, steps)?;
            agents.push(WrittenAgent {
                name: Some(name.to_owned()),
                ..WrittenAgent::walking(Walk::Cells(cells))
            });
            Ok(())
        },
    )?;
    Ok(agents)
}

/// The cell at each time from 0.
fn states(y: &mut Yaml<'_>, steps: &mut Steps) -> Result<Vec<Pair>, Fault> {
    let mut cells: Vec<Pair> = Vec::new();
    y.list("a list of states", |y, _| {
        let (mut x, mut row, mut time) = (None, None, None);
        y.object("a state with x, y and t", |y, key| {
            match key {
                "x" => x = Some(y.number("a whole number")?),
                "y" => row = Some(y.number("a whole number")?),
                "t" => time = Some(y.number::<u32>("a time from 0")?),
                _ => y.skip()?,
            }
            Ok(())
        })?;
        let (Some(x), Some(row), Some(time)) = (x, row, time) else {
            return Err(y.fault("a state without x, y or t", "all three"));
        };
        let time = time as usize;
        if time < cells.len() {
            let expected = format!("a later one: the times up to {} are there", cells.len() - 1);
            return Err(y.fault(format!("the time {time}"), expected));
        }
        steps
            .add(time + 1 - cells.len())
            .map_err(|fault| y.fault(fault.found, fault.expected))?;
        let cell = Pair::new(x, row);
        let before = cells.last().copied().unwrap_or(cell);
        cells.resize(time, before);
        cells.push(cell);
        Ok(())
    })?;
    Ok(cells)
}
