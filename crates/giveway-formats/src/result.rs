//! Plans with a line for each time step.
//!
//! ```text
//!   file   = { header } "solution=" end { step } | { step }
//!   header = key "=" value end                 in any order; unknown keys pass
//!   step   = time ":" { cell "," } end         times from 0; the last comma may lack
//!   cell   = "(" x "," y [ "," heading ] ")" [ "->" cell ":" task ]
//! ```
//!
//! Sources: `make_log` in `lacam/src/post_processing.cpp` of Kei18/lacam and in
//! `lacam3/src/post_processing.cpp` of Kei18/lacam3 (whose lines `checkpoints=` and
//! so on are in `planner.cpp`), `makeLogBasicInfo` and `makeLogSolution` in
//! `pibt2/src/solver.cpp` of Kei18/pibt2, which for pickup and delivery also write
//! lines after `task=`, and behind each cell where the robot is going and its task;
//! `src/main.cpp` of Kei18/mapf-visualizer, which needs no header, and reads
//! headings such as `X_PLUS`.
//!
//! A cell is `x` first, from 0 at the top left. All robots stand on every line, up to
//! the makespan. `soc` is the sum of the arrivals. A run that found nothing has
//! `solved=0` and no step.

mod header;
mod steps;
mod write;

pub(super) use write::write;

use std::iter::repeat;

use super::cursor::Cursor;
use super::{Conventions, Held, Walk, WrittenAgent, WrittenAt, WrittenPlan};
use giveway_model::{Fault, tr};
use header::Header;

/// Whether a text begins with a step, or with a line of a header that such files
/// have.
pub(super) fn sniff(text: &str) -> bool {
    let text = text.trim_start();
    let rest = text.trim_start_matches(|c: char| c.is_ascii_digit());
    if rest.len() < text.len() {
        return rest.starts_with(":(");
    }
    header::KEYS.iter().any(|&key| {
        let rest = text.strip_prefix(key);
        rest.is_some_and(|rest| rest.starts_with('='))
    })
}

/// Reads a plan.
pub(super) fn read(text: &str) -> Result<Held, Fault> {
    let mut cursor = Cursor::new(text);
    let header = Header::read(&mut cursor)?;
    let mut notes = Vec::new();
    let end = cursor.clone();
    let read = steps::read(&mut cursor, header.agents)?;
    if header.is_unsolved && read.paths.is_empty() {
        let found = tr!("a run in which the other program found no plan (solved=0)");
        return Err(end.fault_saying(found, tr!("a run with a plan: here is nothing to judge")));
    }
    if header.is_unsolved {
        let note = "The file says itself that no plan was found (solved=0).";
        notes.push(note.to_owned());
    }
    if read.has_headings {
        notes.push("Where the robots look is not read.".to_owned());
    }
    if read.has_tasks {
        let note = "It is a plan for pickups and deliveries; only where the robots are is read.";
        notes.push(note.to_owned());
    }
    notes.extend(header.unknown.sentence());
    let mut paths = read.paths;
    let known = header.agents.unwrap_or(0).max(header.starts.len());
    if paths.is_empty() && known > 0 {
        paths = vec![Vec::new(); known];
    }
    let places = read.places.into_iter().chain(repeat(WrittenAt::Whole));
    let mut agents: Vec<WrittenAgent> = paths
        .into_iter()
        .zip(places)
        .map(|(cells, at)| WrittenAgent::walking(Walk::Cells(cells), at))
        .collect();
    for (agent, start) in agents.iter_mut().zip(header.starts) {
        agent.start = Some(start);
    }
    for (agent, goal) in agents.iter_mut().zip(header.goals) {
        agent.goal = Some(goal);
    }
    Ok(Held::Plan(WrittenPlan {
        map: header.map,
        claimed: header.claimed,
        bounds: header.bounds,
        notes,
        ..WrittenPlan::new(agents, Conventions::OWN)
    }))
}
