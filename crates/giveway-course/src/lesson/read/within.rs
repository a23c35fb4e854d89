//! Finds the place of a fault within a task or a statement.
//!
//! Which keys a task has depends on its kind, so it is held back until the kind is
//! known; what is wrong in it then has the place of the whole. Here it is read once
//! more by its kind alone.

use giveway_model::{Fault, format::native};
use serde::de::DeserializeOwned;
use serde_json::Value;

use crate::lesson::task::{Change, Choose, Lead, Order, Paint, Predict, Spot};

/// The same fault, with a closer place where it is one of a task.
pub(super) fn task(text: &str, fault: Fault) -> Fault {
    closer(text, &fault).unwrap_or(fault)
}

fn closer(text: &str, fault: &Fault) -> Option<Fault> {
    let steps = fault.place.strip_prefix("steps[")?;
    let (step, rest) = steps.split_once(']')?;
    if rest != ".task" {
        return None;
    }
    let step: usize = step.parse().ok()?;
    let whole: Value = serde_json::from_str(text).ok()?;
    let mut task = whole.get("steps")?.get(step)?.get("task")?.clone();
    let kind = task.as_object_mut()?.remove("kind")?;
    let task = task.to_string();
    let found = match kind.as_str()? {
        "paint" => wrong::<Paint>(&task),
        "lead" => wrong::<Lead>(&task),
        "predict" => wrong::<Predict>(&task),
        "spot" => wrong::<Spot>(&task),
        "choose" => wrong::<Choose>(&task),
        "order" => wrong::<Order>(&task),
        "change" => wrong::<Change>(&task),
        _ => None,
    }?;
    let found = Fault::at(found.place, found.found, found.expected).of_part(&fault.place);
    native::in_text(text, vec![found]).pop()
}

fn wrong<T: DeserializeOwned>(text: &str) -> Option<Fault> {
    native::read_object::<T>(text).err()
}
