//! The world over time of a question after a change: which changes count, and
//! that the plan is right up to the last of them.

use giveway_model::{
    Instance, Plan,
    change::{Changes, History},
    check::{Rule, check_history},
};

use super::ExplainRequest;
use crate::Refusal;

/// The changes that count: those up to the time shown.
pub(crate) fn counting(request: &ExplainRequest) -> Option<Changes> {
    let mut changes = request.changes.clone()?;
    changes
        .changes
        .retain(|change| request.at.is_none_or(|at| change.at <= at));
    (!changes.changes.is_empty()).then_some(changes)
}

/// A plan as one that knows of no more than these changes.
pub(crate) fn up_to(changes: &Changes, plan: &Plan) -> Plan {
    let times = changes.changes.iter().map(|change| change.at);
    let last = times.max().unwrap_or(0);
    let mut plan = plan.clone();
    plan.knows = plan.knows.map(|knows| knows.min(last));
    for slept in plan.slept.values_mut() {
        slept.retain(|&[_, to]| to <= last);
    }
    plan.slept.retain(|_, slept| !slept.is_empty());
    plan
}

/// The world over time, and the time of its last change.
pub(crate) struct World {
    pub(crate) changed: u32,
    pub(crate) history: History,
}

impl World {
    /// The world of the changes that count, around the plan.
    ///
    /// # Errors
    /// Where a change contradicts the plan, or the plan breaks a rule before
    /// the last change.
    pub(crate) fn new(
        instance: &Instance,
        changes: &Changes,
        plan: &Plan,
    ) -> Result<Self, Refusal> {
        let mut history = History::new(instance);
        let times = changes.by_time();
        let mut changed = 0;
        for (i, (at, list)) in times.iter().enumerate() {
            let before = (i + 1 == times.len()).then(|| history.clone());
            if let Err(faults) = history.apply(*at, list, plan) {
                if let Some(before) = before {
                    past_is_right(&before, plan, *at)?;
                }
                return Err(Refusal::Changes { faults });
            }
            changed = *at;
        }
        past_is_right(&history, plan, changed)?;
        Ok(Self { changed, history })
    }
}

/// A plan must be right up to the last change, whatever is to come. It is judged
/// in the world with that change, since the plan may know of it already.
fn past_is_right(history: &History, plan: &Plan, at: u32) -> Result<(), Refusal> {
    let mut violations = check_history(history, plan).violations;
    // What it lists from then on is for the world to come.
    violations.retain(|violation| {
        let of_its_time = !matches!(
            violation.rule,
            Rule::Shape | Rule::Goal | Rule::Waypoint | Rule::Charge
        );
        of_its_time && violation.time < at
    });
    if violations.is_empty() {
        return Ok(());
    }
    Err(Refusal::Plan { violations })
}
