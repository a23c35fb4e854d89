//! Writes a solution of the tracker, as a table and as JSON, with the map and the
//! scenario that it is for.

use std::fmt::Write as _;

use crate::format::foreign::whole_steps::{WholeSteps, both, with_map};
use crate::format::foreign::{Format, Written};
use crate::{Cell, Fault, Instance, Plan, tr};

/// Writes a plan.
///
/// # Errors
/// When the instance or the plan is missing; when a robot is between two cells,
/// jumps, does not begin at its start, or has no path.
pub(in crate::format::foreign) fn write(
    stem: &str,
    instance: Option<&Instance>,
    plan: Option<&Plan>,
) -> Result<Written, Fault> {
    let (instance, plan) = both(Format::Tracker, instance, plan)?;
    let steps = WholeSteps::new(instance, plan, Format::Tracker)?;
    steps.some(Format::Tracker)?;
    let mut paths = Vec::with_capacity(steps.paths.len());
    for (agent, cells) in instance.agents().iter().zip(&steps.paths) {
        let first = cells.first().copied().unwrap_or(agent.start);
        if first != agent.start {
            let found = tr!("{name} at {first} at time 0", name = agent.name, first);
            let expected = tr!(
                "its start {start}, which the scenario has",
                start = agent.start
            );
            return Err(Fault::at("", found, expected));
        }
        paths.push(letters(&agent.name, cells)?);
    }
    let (map, kind, number) = names(stem);
    let (agents, cost) = (paths.len(), steps.sum_of_costs());
    let csv = format!(
        "map_name,scen_type,type_id,agents,solution_cost,flip_up_down,solution_plan\n\
         \"{}\",{kind},{number},{agents},{cost},FALSE,\"{}\"\n",
        map.replace('"', "\"\""),
        paths.join("\n"),
    );
    let mut json = String::from("{\n");
    let _ = write!(
        json,
        "  \"map_name\": {},\n  \"scen_type\": \"{kind}\",\n  \"type_id\": {number},\n",
        serde_json::Value::from(map)
    );
    let _ = write!(
        json,
        "  \"agents\": {agents},\n  \"solution_cost\": {cost},\n  \"flip_up_down\": false,\n"
    );
    json.push_str("  \"solution_plan\": [");
    for (i, path) in paths.iter().enumerate() {
        let comma = if i == 0 { "" } else { "," };
        let _ = write!(json, "{comma}\n    \"{path}\"");
    }
    json.push_str("\n  ]\n}\n");
    let mut written = with_map(stem, "-tracker.csv", csv, (instance, plan), &[])?;
    let json = (format!("{stem}-tracker.json"), json);
    written.files.push(json);
    Ok(written)
}

/// The map, the kind of the scenario and its number, which the benchmark's files
/// have in their names: `empty-8-8-random-1`.
fn names(stem: &str) -> (&str, &str, u32) {
    let parts = || {
        let (rest, number) = stem.rsplit_once('-')?;
        let (map, kind) = rest.rsplit_once('-')?;
        let is_word = !kind.is_empty() && kind.bytes().all(|byte| byte.is_ascii_lowercase());
        Some((map, kind, number.parse().ok()?)).filter(|_| is_word)
    };
    parts().unwrap_or((stem, "custom", 0))
}

/// The moves of an agent, equal ones in a row as their number and one letter.
fn letters(name: &str, cells: &[Cell]) -> Result<String, Fault> {
    let mut text = String::new();
    let mut run: Option<(char, usize)> = None;
    for (time, pair) in cells.windows(2).enumerate() {
        let &[from, to] = pair else { continue };
        let Some(letter) = letter(from, to) else {
            let found = tr!(
                "{name} jumping from {from} to {to} at time {time}",
                name,
                from,
                to,
                time = time + 1
            );
            return Err(Fault::at(
                "",
                found,
                tr!("a move to a cell beside it, or a wait"),
            ));
        };
        run = match run {
            Some((last, length)) if last == letter => Some((letter, length + 1)),
            other => {
                end(&mut text, other);
                Some((letter, 1))
            }
        };
    }
    end(&mut text, run);
    Ok(text)
}

fn end(text: &mut String, run: Option<(char, usize)>) {
    if let Some((letter, length)) = run {
        if length > 1 {
            let _ = write!(text, "{length}");
        }
        text.push(letter);
    }
}

fn letter(from: Cell, to: Cell) -> Option<char> {
    if from == to {
        return Some('w');
    }
    if !from.touches(to) {
        return None;
    }
    Some(if to.x > from.x {
        'r'
    } else if to.x < from.x {
        'l'
    } else if to.y > from.y {
        'd'
    } else {
        'u'
    })
}
