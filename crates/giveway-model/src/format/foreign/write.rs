//! Writes an instance or a plan in a format.

use super::{Format, asprilo, league, mapfw, multi_robot, paths, result, tracker};
use crate::format::{movingai, native};
use crate::{Fault, Instance, Plan, tr};

/// Texts to be saved, and what they cannot hold.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Written {
    /// Each file: its name, and its text.
    pub files: Vec<(String, String)>,
    /// What is lost, phrases: `the batteries of 2 robots`.
    pub losses: Vec<String>,
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
    match format {
        Format::Giveway => Ok(own(stem, instance, plan)),
        Format::MovingAi => moving_ai(stem, instance, plan),
        Format::Tracker => tracker::write(stem, instance, plan),
        Format::Paths => paths::write(stem, instance, plan),
        Format::Result => result::write(stem, instance, plan),
        Format::Asprilo => asprilo::write(stem, instance, plan),
        Format::League => league::write(stem, instance, plan),
        Format::Mapfw => mapfw::write(stem, instance, plan),
        Format::MultiRobot => multi_robot::write(stem, instance, plan),
    }
}

fn own(stem: &str, instance: Option<&Instance>, plan: Option<&Plan>) -> Written {
    let mut files = Vec::new();
    if let Some(instance) = instance {
        files.push((
            format!("{stem}.json"),
            native::write_scene(&instance.to_scene()),
        ));
    }
    if let Some(plan) = plan {
        let name = if instance.is_some() {
            format!("{stem}-plan.json")
        } else {
            format!("{stem}.json")
        };
        files.push((name, native::write_plan(plan)));
    }
    Written {
        files,
        losses: Vec::new(),
    }
}

fn moving_ai(
    stem: &str,
    instance: Option<&Instance>,
    plan: Option<&Plan>,
) -> Result<Written, Fault> {
    let (Some(instance), None) = (instance, plan) else {
        return Err(Fault::at(
            "",
            tr!("a plan"),
            tr!("an instance, since MovingAI files hold no plans"),
        ));
    };
    let map = format!("{stem}.map");
    let scenario = movingai::write_scenario(&map, instance)?;
    let losses = movingai::losses(instance);
    Ok(Written {
        files: vec![
            (map, movingai::write_map(instance.grid())),
            (format!("{stem}.scen"), scenario),
        ],
        losses: losses.iter().map(ToString::to_string).collect(),
    })
}
