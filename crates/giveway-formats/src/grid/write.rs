//! Writes a scene as a bare grid with letters.

use crate::Written;
use crate::loss::Part;
use crate::write::Job;
use giveway_model::{Fault, tr, tr_later};

/// Writes an instance.
///
/// # Errors
/// When there is a plan, no instance, more robots than letters, or a robot's start or
/// goal at a cell of another one.
pub(crate) fn write(job: &Job<'_>) -> Result<Written, Fault> {
    let instance = job.instance_alone(tr_later!("an instance, since a grid holds no plans"))?;
    let width = instance.grid().width() as usize;
    let mut marks: Vec<char> = Vec::new();
    marks.extend(
        instance
            .grid()
            .cells()
            .map(|(_, ground)| if ground.is_vertex() { '.' } else { '#' }),
    );
    let agents = instance.agents();
    if agents.len() > 26 {
        let found = tr!("{n} robot" | "{n} robots" % agents.len());
        return Err(Fault::at(
            "agents",
            found,
            tr_later!("at most 26, a letter each"),
        ));
    }
    for (agent, letter) in agents.iter().zip('a'..='z') {
        let both = [
            (agent.start, letter),
            // An agent without a goal has got one before.
            (
                agent.goal.unwrap_or(agent.start),
                letter.to_ascii_uppercase(),
            ),
        ];
        for (cell, letter) in both {
            let at = cell.y as usize * width + cell.x as usize;
            let mark = marks.get_mut(at).filter(|mark| **mark == '.');
            *mark.ok_or_else(|| {
                let found = tr!("a start and a goal at {cell}", cell);
                Fault::at("agents", found, tr_later!("one letter in each cell"))
            })? = letter;
        }
    }
    let rows = marks.chunks(width.max(1));
    let text: String = rows.flat_map(|row| row.iter().chain(&['\n'])).collect();
    if !super::sniff(&text) {
        let expected = tr_later!("more cells without a start or a goal, by which a grid is known");
        return Err(Fault::at(
            "map",
            tr_later!("a map full of robots"),
            expected,
        ));
    }
    let is_kept = agents
        .iter()
        .zip('A'..)
        .all(|(agent, letter)| agent.name == letter.to_string());
    let names: &[Part] = if is_kept { &[Part::Names] } else { &[] };
    Ok(job.written([(".txt", text)], names))
}
