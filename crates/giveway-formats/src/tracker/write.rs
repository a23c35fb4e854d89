//! Writes a solution of the tracker, as a table and as JSON, with the map and the
//! scenario that it is for.

use std::fmt::Write as _;

use crate::whole_steps::WholeSteps;
use crate::write::Job;
use crate::{Format, Move, Written};
use giveway_model::Fault;

/// Writes a plan.
///
/// # Errors
/// When the instance or the plan is missing; when a robot is between two cells,
/// jumps, does not begin at its start, or has no path.
pub(crate) fn write(job: &Job<'_>) -> Result<Written, Fault> {
    let (instance, plan) = job.both(Format::Tracker)?;
    let steps = WholeSteps::new(instance, plan, Format::Tracker)?;
    steps.some(Format::Tracker)?;
    let moves = steps.moves(instance)?;
    let paths: Vec<String> = moves.iter().map(|moves| letters(moves)).collect();
    let (map, kind, number) = of_benchmark(instance.name())
        .or_else(|| of_benchmark(job.stem))
        .unwrap_or((job.stem, "custom", 0));
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
    let mut written = job.with_map(instance, ("-tracker.csv", csv))?;
    let json = (format!("{}-tracker.json", job.stem), json);
    written.files.push(json);
    Ok(written)
}

/// The map, the kind of the scenario and its number, which the benchmark's files
/// have in their names: `empty-8-8-random-1`; `None` for other names.
fn of_benchmark(name: &str) -> Option<(&str, &str, u32)> {
    let (rest, number) = name.rsplit_once('-')?;
    let (map, kind) = rest.rsplit_once('-')?;
    let is_word = !kind.is_empty() && kind.bytes().all(|byte| byte.is_ascii_lowercase());
    Some((map, kind, number.parse().ok()?)).filter(|_| is_word)
}

/// The moves of an agent, equal ones in a row as their number and one letter.
fn letters(moves: &[Move]) -> String {
    let mut text = String::new();
    for run in moves.chunk_by(|one, next| one == next) {
        if run.len() > 1 {
            let _ = write!(text, "{}", run.len());
        }
        text.extend(run.first().map(|step| match step {
            Move::Up => 'u',
            Move::Down => 'd',
            Move::Left => 'l',
            Move::Right => 'r',
            Move::Wait => 'w',
        }));
    }
    text
}
