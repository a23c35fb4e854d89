//! Writes a problem, a solution, or both.

use serde::Serialize;

use crate::loss::Part;
use crate::whole_steps::WholeSteps;
use crate::write::Job;
use crate::{Format, Written};
use giveway_model::{Agent, Cell, Fault, Instance, tr};

#[derive(Serialize)]
struct Problem<'a> {
    grid: Vec<Vec<u8>>,
    width: u32,
    height: u32,
    starts: Vec<Cell>,
    goals: Vec<Cell>,
    waypoints: Vec<&'a [Cell]>,
}

#[derive(Serialize)]
struct Upload {
    solutions: [Solved; 1],
}

#[derive(Serialize)]
struct Solved {
    /// The number that the server gave the problem; nobody knows it here.
    problem: u32,
    /// How long it took, in milliseconds.
    time: u32,
    solution: Vec<Vec<(i32, i32)>>,
}

/// Writes `STEM.json`, `STEM-solution.json`, or both.
///
/// # Errors
/// When the instance is missing, or a path is missing or in transit.
pub(crate) fn write(job: &Job<'_>) -> Result<Written, Fault> {
    let Some(instance) = job.instance else {
        job.both(Format::Mapfw)?;
        return Ok(Written::default());
    };
    let mut written = job.written([(".json", text(&problem(instance))?)], &[Part::Waypoints]);
    if let Some(plan) = job.plan {
        let steps = WholeSteps::new(instance, plan, Format::Mapfw)?;
        let route = |path: &Vec<Cell>| path.iter().map(|cell| cell.signed()).collect();
        let upload = Upload {
            solutions: [Solved {
                problem: 0,
                time: 0,
                solution: steps.paths.iter().map(route).collect(),
            }],
        };
        let name = format!("{}-solution.json", job.stem);
        written.files.push((name, text(&upload)?));
    }
    Ok(written)
}

fn problem(instance: &Instance) -> Problem<'_> {
    let grid = instance.grid();
    let agents = instance.agents();
    let row = |y| {
        let cells = grid.row(y).iter();
        cells.map(|ground| u8::from(!ground.is_vertex())).collect()
    };
    Problem {
        grid: (0..grid.height()).map(row).collect(),
        width: grid.width(),
        height: grid.height(),
        starts: agents.iter().map(|agent| agent.start).collect(),
        goals: agents.iter().map(Agent::goal_or_start).collect(),
        waypoints: agents.iter().map(|agent| &*agent.waypoints).collect(),
    }
}

fn text(value: &impl Serialize) -> Result<String, Fault> {
    serde_json::to_string(value)
        .map(|text| text + "\n")
        .map_err(|error| Fault::at("", error.to_string(), tr!("a file that can be written")))
}
