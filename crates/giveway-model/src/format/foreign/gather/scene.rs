//! The scene that plans are for: a whole one, a map with a scenario, or a map and
//! the ends of the first plan's paths.

use std::collections::BTreeSet;

use super::{Missing, Options, Refused, origin};
use crate::format::foreign::written_at::Places;
use crate::format::foreign::{Conventions, Format, Walk, WrittenPlan, decide, place};
use crate::format::movingai::{self, Scenario};
use crate::format::{base_name, stem};
use crate::{Agent, Cell, Cost, Fault, Grid, Instance, Objective, Scene, tr};

/// What was found of a scene so far, each part with the name of its file.
#[derive(Default)]
pub(super) struct Base {
    scene: Option<((String, Format), Scene, Vec<String>)>,
    map: Option<(String, Grid)>,
    scenario: Option<(String, Scenario)>,
}

/// A scene, checked.
pub(super) struct Settled {
    pub(super) instance: Instance,
    pub(super) notes: Vec<String>,
    /// The file of the plan whose paths say what the tasks are, where nothing else
    /// does: they tell nothing about how that plan is to be read.
    pub(super) tasks_of: Option<String>,
}

/// The first plan that is not by names, with its file.
#[derive(Clone, Copy)]
pub(super) struct First<'a> {
    pub(super) format: Format,
    pub(super) file: &'a str,
    pub(super) text: &'a str,
    pub(super) plan: &'a WrittenPlan,
}

fn one_at_a_time(one: &str, other: &str) -> Refused {
    Refused::Apart(tr!(
        "Open one scene at a time: {one} and {other} are of the same kind.",
        one,
        other
    ))
}

impl Base {
    pub(super) fn take_map(&mut self, file: String, grid: Grid) -> Result<(), Refused> {
        if let Some((other, _)) = &self.map {
            return Err(one_at_a_time(other, &file));
        }
        self.map = Some((file, grid));
        Ok(())
    }

    pub(super) fn take_scenario(&mut self, file: String, tasks: Scenario) -> Result<(), Refused> {
        if let Some((other, _)) = &self.scenario {
            return Err(one_at_a_time(other, &file));
        }
        self.scenario = Some((file, tasks));
        Ok(())
    }

    pub(super) fn take_scene(
        &mut self,
        file: (String, Format),
        scene: Scene,
        notes: Vec<String>,
    ) -> Result<(), Refused> {
        if let Some(((other, _), ..)) = &self.scene {
            return Err(one_at_a_time(other, &file.0));
        }
        self.scene = Some((file, scene, notes));
        Ok(())
    }

    /// Makes the scene.
    pub(super) fn settle(
        self,
        plan: Option<First<'_>>,
        options: &Options,
    ) -> Result<Settled, Refused> {
        if let Some(((file, format), mut scene, notes)) = self.scene {
            if let Some((other, _)) = self.map {
                return Err(one_at_a_time(&file, &other));
            }
            scene.agents.truncate(options.agents.unwrap_or(usize::MAX));
            if let (true, Some(objective)) = (plan.is_some(), of_makers(format)) {
                scene.objective = objective;
            }
            return settled(&file, scene, notes);
        }
        let (grid, scenario) = match (self.map, self.scenario) {
            (Some(map), scenario) => (map, scenario),
            (None, Some((file, scenario))) => {
                return Err(missing(file, Format::MovingAi, scenario.map_name()));
            }
            (None, None) => {
                return Err(match plan {
                    Some(First {
                        file, format, plan, ..
                    }) => missing(file.to_owned(), format, plan.map.as_deref()),
                    None => Refused::Apart(tr!("There is no scene in these files.").to_owned()),
                });
            }
        };
        let (map_file, grid) = grid;
        match (scenario, plan) {
            (Some((file, scenario)), plan) => {
                let agents = plan.map(|it| it.plan.agents.len()).or(options.agents);
                let name = stem(&file).to_owned();
                let mut scene =
                    movingai::to_scene(&name, &grid, &scenario, agents).map_err(|fault| {
                        Refused::File {
                            file: file.clone(),
                            faults: vec![fault],
                        }
                    })?;
                if plan.is_some() {
                    scene.objective = sum_first();
                }
                settled(&file, scene, Vec::new())
            }
            (None, Some(plan)) => of_plan(&map_file, &grid, plan, options.conventions),
            (None, None) => {
                let scene = Scene {
                    name: stem(&map_file).to_owned(),
                    map: grid.rows(),
                    ..Scene::default()
                };
                settled(&map_file, scene, Vec::new())
            }
        }
    }
}

/// What the makers of a format minimise, where the format itself does not say it:
/// plans of elsewhere are judged by that. The project's own files do say it, and
/// planners for asprilo look for the smallest makespan, which is the default here.
fn of_makers(format: Format) -> Option<Objective> {
    match format {
        Format::Giveway | Format::Asprilo => None,
        _ => Some(sum_first()),
    }
}

/// What the makers of most planners minimise.
fn sum_first() -> Objective {
    Objective::new(vec![Cost::SumOfCosts, Cost::Makespan]).unwrap_or_default()
}

fn settled(file: &str, scene: Scene, notes: Vec<String>) -> Result<Settled, Refused> {
    let instance = Instance::new(scene).map_err(|faults| Refused::File {
        file: file.to_owned(),
        faults,
    })?;
    Ok(Settled {
        instance,
        notes,
        tasks_of: None,
    })
}

/// What a file without a map lacks: the problem of its makers' own format, else a
/// map, by its name where the file tells it.
fn missing(file: String, format: Format, map: Option<&str>) -> Refused {
    if let Some(problem) = problem(format) {
        return Refused::Missing {
            sentence: tr!(
                "{file} is a solution without its problem: open {problem}, which has the map and the robots, together with it.",
                file,
                problem
            ),
            what: Missing::Problem,
            file,
        };
    }
    let map = map
        .map(|map| base_name(map).to_owned())
        .filter(|map| !map.is_empty());
    let sentence = match &map {
        Some(map) => tr!(
            "{file} is for the map {map}: open {map}.map, too.",
            file,
            map = stem(map)
        ),
        None if format == Format::MovingAi => tr!(
            "{file} is a scenario that does not name its map: open the map (.map) that it was made for, too.",
            file
        ),
        None => tr!(
            "{file} does not name its map: open the map (.map) that the plan was made for, too.",
            file
        ),
    };
    Refused::Missing {
        file,
        what: Missing::Map(map),
        sentence,
    }
}

/// The file that holds the problem, where a format has one of its own.
fn problem(format: Format) -> Option<&'static str> {
    match format {
        Format::MultiRobot => Some(tr!("the input file of libMultiRobotPlanning (.yaml)")),
        Format::Asprilo => Some(tr!("its instance (.lp)")),
        Format::Mapfw => Some(tr!("the benchmark of mapfw.nl (.json)")),
        Format::Giveway
        | Format::MovingAi
        | Format::Tracker
        | Format::Paths
        | Format::Result
        | Format::League => None,
    }
}

/// A scene whose tasks are what a plan says of them, else the ends of its paths.
fn of_plan(
    map_file: &str,
    grid: &Grid,
    First {
        file, text, plan, ..
    }: First<'_>,
    chosen: Option<Conventions>,
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
    let conventions = decide::decide(plan, grid, None, chosen).conventions;
    let of = |pair| place::cell(pair, conventions);
    let mut notes = Vec::new();
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
        let told = written.goal.map(|told| of(told.pair));
        // Two that end at one cell cannot both have it as their goal.
        let end = cells
            .iter()
            .rev()
            .find(|cell| !goals.contains(*cell) && grid.is_vertex(**cell));
        let goal = told.or(end.copied()).unwrap_or(last);
        if told.is_none() && goal != last {
            notes.push(format!(
                "{name} ends at {last} like another robot; its goal is taken to be {goal}, where it was before."
            ));
        }
        goals.insert(goal);
        let start = written.start.map_or(first, |told| of(told.pair));
        let mut seen = BTreeSet::new();
        let waypoints = written.waypoints.iter().map(|told| of(told.pair));
        let waypoints = waypoints.filter(|&cell| seen.insert(cell)).collect();
        agents.push(Agent {
            name,
            start,
            goal,
            waypoints,
            battery: None,
        });
    }
    let scene = Scene {
        name: stem(map_file).to_owned(),
        map: grid.rows(),
        objective: sum_first(),
        agents,
        ..Scene::default()
    };
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
        notes,
        tasks_of: Some(file.to_owned()),
    })
}
