//! A scene with its plan, and what changed while that ran: files of the
//! project's own JSON, opened together.

use giveway_model::change::Changes;
use giveway_model::check::check;
use giveway_model::format::native;
use giveway_model::{Fault, Plan, Scene, tr};
use serde_json::Value;

use super::{Opened, Reading, faulty, named, refusal};
use crate::{Draft, Notice, link};

/// What one of the files holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Holds {
    Scene,
    Plan,
    Changes,
}

impl Holds {
    /// By its keys; what cannot be read is taken to be a scene, and told as one.
    fn of(text: &str) -> Self {
        let read = serde_json::from_str::<Value>(text).unwrap_or_default();
        if read.get("changes").is_some() {
            Self::Changes
        } else if read.get("paths").is_some() {
            Self::Plan
        } else {
            Self::Scene
        }
    }
}

/// Why a file alone is none that can be opened, if it is of another kind than a
/// scene.
pub(super) fn alone(file: &Opened, text: &str) -> Option<Notice> {
    let why = match Holds::of(text) {
        Holds::Scene => return None,
        Holds::Plan => tr!("it is a plan: open it together with its scene"),
        Holds::Changes => tr!("these are changes: open them together with their scene and plan"),
    };
    Some(refusal(&file.name, why))
}

/// Reads a scene with its plan and its changes; `None` where the files are
/// others.
pub(super) fn read(files: &[(&Opened, &str)]) -> Option<Result<Reading, Notice>> {
    let of = |holds: Holds| {
        let mut own = files.iter().filter(|(_, text)| Holds::of(text) == holds);
        let first = own.next().copied();
        (first, own.next().is_some())
    };
    let (scene, plan, changes) = (of(Holds::Scene), of(Holds::Plan), of(Holds::Changes));
    let (Some(scene), false, Some(plan), false, false) =
        (scene.0, scene.1, plan.0, plan.1, changes.1)
    else {
        return None;
    };
    Some(together(scene, plan, changes.0))
}

fn together(
    (scene, scene_text): (&Opened, &str),
    (plan, plan_text): (&Opened, &str),
    changes: Option<(&Opened, &str)>,
) -> Result<Reading, Notice> {
    let one = |file: &Opened, fault: Fault| faulty(&file.name, &[fault]);
    let read: Scene = native::read_instance(scene_text)
        .map_err(|faults| faulty(&scene.name, &faults))?
        .to_scene();
    let draft =
        Draft::new(named(read, &scene.name)).map_err(|faults| faulty(&scene.name, &faults))?;
    let told: Plan = native::read_plan(plan_text).map_err(|fault| one(plan, fault))?;
    let changed: Option<Changes> = match changes {
        None => None,
        Some((file, text)) => Some(native::read_changes(text).map_err(|fault| one(file, fault))?),
    };
    let mut names = draft.agents().iter().map(|agent| &agent.name);
    let is_for_it = names.any(|name| told.paths.contains_key(name));
    if let (None, Ok(instance)) = (&changed, draft.instance())
        && is_for_it
        && !check(instance, &told).is_valid()
    {
        return Ok(Reading::Illegal(vec![scene.clone(), plan.clone()]));
    }
    let linked = link::judged(draft, told, changed);
    let linked = linked.map_err(|why| refusal(&plan.name, &why))?;
    Ok(Reading::Linked(Box::new(linked)))
}
