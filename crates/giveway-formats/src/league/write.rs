//! Writes a plan as a result of 2024, with its map.
//!
//! Where a rule of the scene has robots turn, a step for a quarter turn, the action model is
//! `MAPF_T`; else robots turn for nothing, and it is `MAPF`. Each
//! waypoint that a robot visits is a task of one errand. Costs are written by the
//! definitions here: they count arrivals.

use std::collections::BTreeMap;

use serde::Serialize;

use super::turning::Turning;
use crate::loss::Part;
use crate::movingai;
use crate::whole_steps::WholeSteps;
use crate::write::Job;
use crate::{Format, Move, Written};
use giveway_model::check::{Report, check};
use giveway_model::words::count;
use giveway_model::{Cell, Fault, Instance, tr};

/// A result, its keys in the order of the League's own program.
#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
struct Output {
    action_model: &'static str,
    #[serde(rename = "AllValid")]
    all_valid: &'static str,
    version: &'static str,
    team_size: usize,
    start: Vec<(u32, u32, &'static str)>,
    num_task_finished: usize,
    sum_of_cost: usize,
    makespan: usize,
    actual_paths: Vec<String>,
    planner_paths: Vec<String>,
    planner_times: Vec<f64>,
    errors: Vec<(i64, i64, u32, String)>,
    actual_schedule: Vec<String>,
    planner_schedule: Vec<String>,
    schedule_errors: Vec<()>,
    /// Time, robot, task, errands done.
    events: Vec<(usize, usize, usize, usize)>,
    /// Task, release, its one errand.
    tasks: Vec<(usize, usize, [u32; 2])>,
}

/// Writes `STEM.map` and `STEM.json`.
///
/// # Errors
/// When the instance or the plan is missing, or a path jumps or is in transit.
pub(crate) fn write(job: &Job<'_>) -> Result<Written, Fault> {
    let (instance, plan) = job.both(Format::League)?;
    let paths = WholeSteps::new(instance, plan, Format::League)?;
    let plain = all_letters(instance, &paths)?;
    let turning = Turning::of(instance, &paths);
    let letters = match &turning {
        Some(turning) => {
            let all = turning.letters.iter().cloned();
            all.map(|letters| joined(letters, &paths)).collect()
        }
        None => plain,
    };
    let heading = |robot: usize| {
        let headings = turning.as_ref().map(|turning| &turning.headings);
        headings
            .and_then(|all| all.get(robot))
            .map_or("N/A", |heading| *heading)
    };
    let visits = visits(instance, &paths);
    let report = check(instance, plan);
    let output = Output {
        action_model: if turning.is_some() { "MAPF_T" } else { "MAPF" },
        all_valid: if report.is_valid() { "Yes" } else { "No" },
        version: "2024 LoRR",
        team_size: instance.agents().len(),
        start: instance
            .agents()
            .iter()
            .enumerate()
            .map(|(robot, it)| (it.start.y, it.start.x, heading(robot)))
            .collect(),
        num_task_finished: visits.len(),
        sum_of_cost: paths.sum_of_costs(),
        makespan: paths.makespan(),
        actual_paths: letters.clone(),
        planner_paths: letters,
        planner_times: Vec::new(),
        errors: errors(instance, &report),
        actual_schedule: schedules(instance, &visits),
        planner_schedule: schedules(instance, &visits),
        schedule_errors: Vec::new(),
        events: events(&visits),
        tasks: tasks(&visits),
    };
    let text = serde_json::to_string(&output)
        .map_err(|error| Fault::at("", error.to_string(), tr!("a result that can be written")))?;
    let map = movingai::write_map(instance.grid());
    let of_rest = Job {
        instance: turning
            .as_ref()
            .map(|turning| &turning.rest)
            .or(job.instance),
        ..*job
    };
    let files = [(".map", map), (".json", text + "\n")];
    let mut written = of_rest.written(files, &[Part::Waypoints]);
    written.losses.extend(unreached(instance, &paths, &visits));
    Ok(written)
}

/// The letters of each robot up to the end of the plan: all are of one length.
fn all_letters(instance: &Instance, paths: &WholeSteps) -> Result<Vec<String>, Fault> {
    let letters = |moves: Vec<Move>| {
        let letters = moves.iter().map(|step| match step {
            Move::Up => "D",
            Move::Down => "U",
            Move::Left => "L",
            Move::Right => "R",
            Move::Wait => "W",
        });
        joined(letters.collect(), paths)
    };
    Ok(paths.moves(instance)?.into_iter().map(letters).collect())
}

/// The letters of a robot up to the end of the plan.
fn joined(mut letters: Vec<&str>, paths: &WholeSteps) -> String {
    letters.resize(paths.makespan(), "W");
    letters.join(",")
}

/// A waypoint that is visited, as a task.
struct Visit {
    robot: usize,
    time: usize,
    cell: Cell,
}

/// The visits of the robots, robot by robot and in the order of their waypoints: the number of a visit is
/// that of its task.
fn visits(instance: &Instance, paths: &WholeSteps) -> Vec<Visit> {
    let mut visits = Vec::new();
    for (robot, (agent, path)) in instance.agents().iter().zip(&paths.paths).enumerate() {
        for &cell in &agent.waypoints {
            if let Some(time) = path.iter().position(|&at| at == cell) {
                visits.push(Visit { robot, time, cell });
            }
        }
    }
    visits
}

fn events(visits: &[Visit]) -> Vec<(usize, usize, usize, usize)> {
    let mut events: Vec<_> = visits
        .iter()
        .enumerate()
        .map(|(task, visit)| (visit.time, visit.robot, task, 1))
        .collect();
    events.sort_unstable();
    events
}

fn tasks(visits: &[Visit]) -> Vec<(usize, usize, [u32; 2])> {
    let tasks = visits.iter().enumerate();
    tasks
        .map(|(task, visit)| (task, 0, [visit.cell.y, visit.cell.x]))
        .collect()
}

/// The first task of each robot, and each next one when the one before is done.
fn schedules(instance: &Instance, visits: &[Visit]) -> Vec<String> {
    let mut own: BTreeMap<usize, Vec<(usize, usize)>> = BTreeMap::new();
    for (task, visit) in visits.iter().enumerate() {
        own.entry(visit.robot).or_default().push((visit.time, task));
    }
    let schedule = |robot| {
        let mut tasks = own.get(&robot).cloned().unwrap_or_default();
        tasks.sort_unstable();
        let begins = std::iter::once(0).chain(tasks.iter().map(|&(time, _)| time));
        let entries = begins
            .zip(&tasks)
            .map(|(begin, (_, task))| format!("{begin}:{task}"));
        entries.collect::<Vec<_>>().join(",")
    };
    (0..instance.agents().len()).map(schedule).collect()
}

/// The violations as the League lists errors: two robots, or one and -1.
fn errors(instance: &Instance, report: &Report) -> Vec<(i64, i64, u32, String)> {
    let names = instance.agents().iter().map(|it| &*it.name);
    let numbers: BTreeMap<&str, i64> = names.zip(0..).collect();
    let errors = report.violations.iter().map(|violation| {
        let robot = |i: usize| {
            let name = violation.agents.get(i);
            name.and_then(|name| numbers.get(name.as_str()))
                .copied()
                .unwrap_or(-1)
        };
        (
            robot(0),
            robot(1),
            violation.time,
            violation.message.clone(),
        )
    });
    errors.collect()
}

/// Goals and waypoints that the plan does not reach: a result knows nothing of them.
fn unreached(instance: &Instance, paths: &WholeSteps, visits: &[Visit]) -> Vec<String> {
    let pairs = || instance.agents().iter().zip(&paths.paths);
    let astray = pairs().filter(|(agent, path)| path.last() != Some(&agent.goal_or_start()));
    let astray = astray.count();
    let waypoints: usize = instance.agents().iter().map(|it| it.waypoints.len()).sum();
    let missed = waypoints.saturating_sub(visits.len());
    let mut lost = Vec::new();
    if astray > 0 {
        lost.push(format!(
            "the goals of {}, which their paths do not reach",
            count(astray, "robot")
        ));
    }
    if missed > 0 {
        lost.push(format!(
            "{} that no robot visits",
            count(missed, "waypoint")
        ));
    }
    lost
}
