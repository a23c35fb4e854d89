//! What happens to one agent in a step, and what a demand on it counts.

use giveway_model::Cost;

use crate::single::{Place, Task, TaskConstraint};

/// What happens to one agent in a step.
#[derive(Clone, Copy, Debug)]
pub(super) struct Event {
    pub(super) from: Place,
    pub(super) to: Place,
    pub(super) clock: u32,
    pub(super) charged: bool,
}

impl Event {
    pub(super) fn waits(self) -> bool {
        matches!((self.from, self.to), (Place::At(u), Place::At(v)) if u == v)
    }

    /// What the step adds to a cost of the agent. (A makespan is of all agents.)
    pub(super) fn costs(self, cost: Cost) -> u32 {
        let counts = match cost {
            Cost::Charges => self.charged,
            Cost::Waits => self.waits(),
            Cost::Moves => matches!(self.from, Place::At(_)) && !self.waits(),
            Cost::SumOfCosts => true,
            Cost::Makespan => false,
        };
        u32::from(counts)
    }
}

/// What the demand on an agent counts after a step, and its mask; `None` where
/// it counts too much.
pub(super) fn follow(
    task: &Task,
    count: u32,
    [before, mask]: [u32; 2],
    event: Event,
) -> Option<(u32, u32)> {
    match (&task.demand, event.from) {
        (Some(demand @ TaskConstraint::Wait { steps, .. }), Place::At(v)) => {
            let counts = event.waits() && demand.counts_wait(v, event.clock);
            let run = if counts { count + 1 } else { 0 };
            (run < *steps).then_some((run, mask))
        }
        (Some(TaskConstraint::AtMost { cost, most }), _) => {
            let count = count + event.costs(*cost);
            (count <= *most).then_some((count, mask))
        }
        // Leaving sets the bit just where it charged while it was there.
        (Some(TaskConstraint::Charge { v, .. }), Place::At(u)) if u == *v => {
            let charged = count.max(u32::from(event.charged));
            if event.waits() {
                return Some((charged, mask));
            }
            let bit = task.demanded_bit();
            let uncharged = mask & !bit | before & bit;
            Some((0, if charged == 0 { uncharged } else { mask }))
        }
        _ => Some((0, mask)),
    }
}
