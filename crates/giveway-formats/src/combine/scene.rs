//! The scene that plans are for: a whole one, a map with a scenario, or a map and
//! the ends of the first plan's paths.

use super::from_plan::from_plan;
use super::missing::missing;
use super::scenario::{self, Tasks};
use super::{Options, Refused};
use crate::movingai::Scenario;
use crate::{Format, Remarks, WrittenPlan};
use giveway_model::format::{base_name, stem};
use giveway_model::{Cost, Grid, Instance, Objective, Scene, tr};

/// The parts of a scene that were found so far, each with the name of its file.
#[derive(Default)]
pub(super) struct Base {
    scene: Option<(String, (Format, Scene, Remarks))>,
    map: Option<(String, Grid)>,
    scenario: Option<(String, Scenario)>,
}

/// A scene, checked.
pub(super) struct Settled {
    pub(super) instance: Instance,
    /// The file of the map, where it is one of its own.
    pub(super) map_file: Option<String>,
    /// The remarks of its file.
    pub(super) remarks: Remarks,
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

impl Options {
    /// Sets the rules that a person chose.
    pub(super) fn rule(&self, scene: &mut Scene) {
        let rules = &mut scene.rules;
        rules.at_goal = self.at_goal.unwrap_or(rules.at_goal);
        rules.battery_floor = self.battery_floor.unwrap_or(rules.battery_floor);
    }
}

fn one_at_a_time(one: &str, other: &str) -> Refused {
    Refused::Apart(tr!(
        "Open one scene at a time: {one} and {other} are of the same kind.",
        one,
        other
    ))
}

/// Puts a part where there may be only one.
fn take<T>(part: &mut Option<(String, T)>, file: String, value: T) -> Result<(), Refused> {
    if let Some((other, _)) = part {
        return Err(one_at_a_time(other, &file));
    }
    *part = Some((file, value));
    Ok(())
}

impl Base {
    /// Whether nothing was found.
    pub(super) const fn is_empty(&self) -> bool {
        self.scene.is_none() && self.map.is_none() && self.scenario.is_none()
    }

    /// Takes a map.
    pub(super) fn take_map(&mut self, file: String, grid: Grid) -> Result<(), Refused> {
        take(&mut self.map, file, grid)
    }

    /// Takes a scenario.
    pub(super) fn take_scenario(&mut self, file: String, tasks: Scenario) -> Result<(), Refused> {
        take(&mut self.scenario, file, tasks)
    }

    /// Takes a whole scene, with what its file says beyond it.
    pub(super) fn take_scene(
        &mut self,
        (file, format): (String, Format),
        scene: Scene,
        remarks: Remarks,
    ) -> Result<(), Refused> {
        take(&mut self.scene, file, (format, scene, remarks))
    }

    /// Makes the scene.
    pub(super) fn settle(
        self,
        plan: Option<First<'_>>,
        options: &Options,
    ) -> Result<Settled, Refused> {
        if let Some((file, (format, mut scene, remarks))) = self.scene {
            if let Some((other, _)) = self.map {
                return Err(one_at_a_time(&file, &other));
            }
            scene.agents.truncate(options.agents.unwrap_or(usize::MAX));
            if let (true, Some(objective)) = (plan.is_some(), of_makers(format)) {
                scene.objective = objective;
            }
            return settled(&file, scene, remarks, options);
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
        let settled = Self::on_map((&map_file, &grid), scenario, plan, options)?;
        Ok(Settled {
            map_file: Some(map_file),
            ..settled
        })
    }

    /// The scene of a map with a scenario, with a plan, or of a map alone.
    fn on_map(
        (map_file, grid): (&str, &Grid),
        scenario: Option<(String, Scenario)>,
        plan: Option<First<'_>>,
        options: &Options,
    ) -> Result<Settled, Refused> {
        match (scenario, plan) {
            (Some((file, scenario)), plan) => {
                match scenario::tasks(&file, grid, &scenario, plan, options.agents)? {
                    Tasks::Scene(mut scene, mut notes) => {
                        if plan.is_some() {
                            scene.objective = sum_first();
                        }
                        notes.extend(another_map(&file, scenario.map_name(), map_file));
                        notes.extend(scenario.note());
                        settled(&file, scene, notes.into(), options)
                    }
                    Tasks::FromPlan(note) => {
                        let Some(plan) = plan else {
                            return Err(Refused::Apart(note));
                        };
                        let mut settled = from_plan(map_file, grid, plan, options)?;
                        settled.remarks.notes.insert(0, note);
                        settled.remarks.notes.extend(scenario.note());
                        Ok(settled)
                    }
                }
            }
            (None, Some(plan)) => from_plan(map_file, grid, plan, options),
            (None, None) => {
                let scene = Scene {
                    name: stem(map_file).to_owned(),
                    map: grid.rows(),
                    ..Scene::default()
                };
                settled(map_file, scene, Remarks::default(), options)
            }
        }
    }
}

/// The remark that a scenario or a plan is used with a map of another name than it states.
pub(super) fn another_map(file: &str, map: Option<&str>, map_file: &str) -> Option<String> {
    let map = base_name(map?.trim());
    let is_named = map_file
        .rsplit_once('.')
        .is_some_and(|(_, kind)| kind.eq_ignore_ascii_case("map"));
    let is_another = is_named && !map.is_empty() && stem(map) != stem(map_file);
    is_another.then(|| {
        tr!(
            "{file} is made for the map {map}; {map_file} is used for it.",
            file,
            map,
            map_file
        )
    })
}

/// The objective of the makers of a format, where the format itself states none: plans of other planners are
/// judged by it. The project's own files state it, and planners for asprilo look for the smallest makespan,
/// which is the default here.
fn of_makers(format: Format) -> Option<Objective> {
    match format {
        Format::Giveway | Format::Asprilo => None,
        _ => Some(sum_first()),
    }
}

/// The objective of the makers of most planners.
pub(super) fn sum_first() -> Objective {
    Objective::new(vec![Cost::SumOfCosts, Cost::Makespan]).unwrap_or_default()
}

fn settled(
    file: &str,
    mut scene: Scene,
    remarks: Remarks,
    options: &Options,
) -> Result<Settled, Refused> {
    options.rule(&mut scene);
    let instance = Instance::new(scene).map_err(|faults| Refused::File {
        file: file.to_owned(),
        faults,
    })?;
    Ok(Settled {
        instance,
        remarks,
        map_file: None,
        tasks_of: None,
    })
}
