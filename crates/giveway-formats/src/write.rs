//! Writes an instance or a plan in a format.

use crate::limits::refuse;
use crate::loss::{Loss, Part, losses};
use crate::{
    Format, asprilo, class_project, grid, league, mapfw, movingai, multi_robot, paths, result,
    tracker,
};
use giveway_model::format::native;
use giveway_model::{Fault, Instance, Plan, tr};

/// Texts to be saved, and what they cannot hold.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Written {
    /// Each file: its name, and its text.
    pub files: Vec<(String, String)>,
    /// The lost parts, phrases: `the batteries of 2 robots`.
    pub losses: Vec<String>,
}

/// The files to write; their names begin with `stem`.
#[derive(Clone, Copy)]
pub(crate) struct Job<'a> {
    pub(crate) stem: &'a str,
    pub(crate) instance: Option<&'a Instance>,
    pub(crate) plan: Option<&'a Plan>,
}

impl<'a> Job<'a> {
    /// The instance and the plan, for a format of plans that needs both.
    ///
    /// # Errors
    /// When one of them is missing.
    pub(crate) fn both(&self, format: Format) -> Result<(&'a Instance, &'a Plan), Fault> {
        match (self.instance, self.plan) {
            (Some(instance), Some(plan)) => Ok((instance, plan)),
            (Some(_), None) => {
                let expected = tr!("a plan, too, since {format} holds nothing else", format);
                refuse(tr!("an instance"), expected)
            }
            (None, _) => {
                let expected = tr!(
                    "its instance, too, since {format} has robots in its order",
                    format
                );
                refuse(tr!("a plan"), expected)
            }
        }
    }

    /// The instance, for a format without plans.
    ///
    /// # Errors
    /// When there is a plan, or no instance.
    pub(crate) fn instance_alone(
        &self,
        expected: impl Into<String>,
    ) -> Result<&'a Instance, Fault> {
        self.instance
            .filter(|_| self.plan.is_none())
            .ok_or_else(|| Fault::at("", tr!("a plan"), expected))
    }

    /// The files, each with what follows `stem` in its name, and what is lost besides the parts
    /// that they hold.
    pub(crate) fn written<const N: usize>(
        &self,
        files: [(&str, String); N],
        holds: &[Part],
    ) -> Written {
        let losses = losses(holds, self.instance, self.plan);
        let file = |(ending, text)| (format!("{}{ending}", self.stem), text);
        Written {
            files: files.map(file).into(),
            losses: losses.iter().map(ToString::to_string).collect(),
        }
    }

    /// The file of a plan, with the map and the scenario that it is for.
    ///
    /// # Errors
    /// When the name of the files cannot be that of a map.
    pub(crate) fn with_map(
        &self,
        instance: &Instance,
        (ending, text): (&str, String),
    ) -> Result<Written, Fault> {
        let scenario = movingai::write_scenario(&format!("{}.map", self.stem), instance)?;
        let map = movingai::write_map(instance.grid());
        Ok(self.written([(".map", map), (".scen", scenario), (ending, text)], &[]))
    }
}

/// Writes files whose names begin with `stem`. Most formats of plans need their
/// instance, too, since they write agents in its order.
///
/// # Errors
/// When the format cannot hold what is given at all: a plan in a format of maps,
/// a plan with slow moves in a format of whole steps, a plan without its instance.
pub fn write(
    format: Format,
    stem: &str,
    instance: Option<&Instance>,
    plan: Option<&Plan>,
) -> Result<Written, Fault> {
    if format != Format::Giveway
        && let Some(instance) = instance
        && instance.agents().iter().any(|agent| agent.goal.is_none())
    {
        return write_ends(format, stem, instance, plan);
    }
    let job = Job {
        stem,
        instance,
        plan,
    };
    match format {
        Format::Giveway => Ok(own(&job)),
        Format::MovingAi => moving_ai(&job),
        Format::Tracker => tracker::write(&job),
        Format::Paths => paths::write(&job),
        Format::Result => result::write(&job),
        Format::Asprilo => asprilo::write(&job),
        Format::League => league::write(&job),
        Format::Mapfw => mapfw::write(&job),
        Format::MultiRobot => multi_robot::write(&job),
        Format::ClassProject => class_project::write(&job),
        Format::Grid => grid::write(&job),
    }
}

/// Writes an instance with agents that have no goal, which only the project's own
/// format holds: where a plan is there, its ends become their goals.
fn write_ends(
    format: Format,
    stem: &str,
    instance: &Instance,
    plan: Option<&Plan>,
) -> Result<Written, Fault> {
    let mut scene = instance.to_scene();
    for agent in &mut scene.agents {
        if agent.goal.is_none() {
            let end = plan.and_then(|plan| plan.path(&agent.name).last().copied().flatten());
            let Some(end) = end else {
                return refuse(
                    tr!("{name}, a robot without a goal", name = agent.name),
                    tr!(
                        "a goal for each robot in this format, or a plan whose end becomes the goal"
                    ),
                );
            };
            agent.goal = Some(end);
        }
    }
    let settled = Instance::new(scene).map_err(|mut faults| faults.swap_remove(0))?;
    let mut written = write(format, stem, Some(&settled), plan)?;
    let agents = instance.agents().iter();
    let agents = agents.filter(|agent| agent.goal.is_none()).count();
    let lost = Loss {
        part: Part::NoGoal,
        count: agents,
    };
    written.losses.push(lost.to_string());
    Ok(written)
}

fn own(job: &Job<'_>) -> Written {
    let scene = job.instance.map(|it| native::write_scene(&it.to_scene()));
    let ending = if scene.is_some() {
        "-plan.json"
    } else {
        ".json"
    };
    let plan = job.plan.map(native::write_plan);
    let files = [(".json", scene), (ending, plan)].into_iter();
    let files = files.filter_map(|(ending, text)| Some((format!("{}{ending}", job.stem), text?)));
    Written {
        files: files.collect(),
        losses: Vec::new(),
    }
}

fn moving_ai(job: &Job<'_>) -> Result<Written, Fault> {
    let instance = job.instance_alone(tr!("an instance, since MovingAI files hold no plans"))?;
    let scenario = movingai::write_scenario(&format!("{}.map", job.stem), instance)?;
    let map = movingai::write_map(instance.grid());
    Ok(job.written([(".map", map), (".scen", scenario)], &[]))
}
