//! A scene whose tasks a plan tells, where there is no scenario.

use std::collections::BTreeSet;

use super::scene::{First, Settled, sum_first};
use super::{Missing, Options, Refused, origin};
use crate::written_at::Places;
use crate::{Walk, decide, place};
use giveway_model::format::stem;
use giveway_model::{Agent, AtGoal, Cell, Fault, Grid, Instance, Scene, tr};

/// A scene whose tasks are what a plan says of them, else the ends of its paths.
pub(super) fn from_plan(
    map_file: &str,
    grid: &Grid,
    First {
        file, text, plan, ..
    }: First<'_>,
    options: &Options,
) -> Result<Settled, Refused> {
    let lacks_start = plan
        .agents
        .iter()
        .any(|agent| agent.start.is_none() && !matches!(agent.walk, Walk::Cells(_)));
    if lacks_start {
        return Err(Refused::Missing {
            file: file.to_owned(),
            what: Missing::Scenario,
            sentence: tr!(
                "{file} does not say where its robots start: open the scenario (.scen) that the plan was made for, too.",
                file
            ),
        });
    }
    let conventions = decide::decide(plan, grid, None, options.conventions).conventions;
    let of = |pair| place::cell(pair, conventions);
    let mut notes = Vec::new();
    let vanish = options.at_goal == Some(AtGoal::Vanish);
    let mut goals = BTreeSet::new();
    let mut agents = Vec::with_capacity(plan.agents.len());
    for (i, written) in plan.agents.iter().enumerate() {
        let name = decide::name(written, i);
        let (path, _) = place::path(written, None, conventions);
        let cells: Vec<Cell> = path.into_iter().flatten().collect();
        let (Some(&first), Some(&last)) = (cells.first(), cells.last()) else {
            return Err(Refused::Apart(tr!(
                "{file} has no path for {name}.",
                file,
                name
            )));
        };
        let stated = written.goal.map(|cell| of(cell.pair));
        // Two that end at one cell cannot both have it as their goal.
        let end = cells
            .iter()
            .rev()
            .find(|cell| (vanish || !goals.contains(*cell)) && grid.is_vertex(**cell));
        let goal = stated.or(end.copied()).unwrap_or(last);
        if stated.is_none() && goal != last {
            notes.push(format!(
                "{name} ends at {last} like another robot; its goal is taken to be {goal}, where it was before."
            ));
        }
        goals.insert(goal);
        let start = written.start.map_or(first, |cell| of(cell.pair));
        let mut seen = BTreeSet::new();
        let waypoints = written.waypoints.iter().map(|cell| of(cell.pair));
        let waypoints = waypoints.filter(|&cell| seen.insert(cell)).collect();
        agents.push(Agent {
            waypoints,
            ..Agent::new(name, start, Some(goal))
        });
    }
    let mut scene = Scene {
        name: stem(map_file).to_owned(),
        map: grid.rows(),
        objective: sum_first(),
        agents,
        ..Scene::default()
    };
    options.rule(&mut scene);
    let instance = Instance::new(scene).map_err(|faults| {
        let mut places = Places::new(text);
        let placed = |fault: Fault| places.place(origin::of_place(plan, &fault.place), fault);
        Refused::File {
            file: file.to_owned(),
            faults: faults.into_iter().map(placed).collect(),
        }
    })?;
    Ok(Settled {
        instance,
        remarks: notes.into(),
        map_file: None,
        tasks_of: Some(file.to_owned()),
    })
}
