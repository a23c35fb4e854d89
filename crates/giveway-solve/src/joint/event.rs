//! The events of one agent's step, and the counters of the conditions on it.

use giveway_model::Cost;

use crate::single::{Mask, Part, Place, Required, Task};

/// The events of one agent's step.
#[derive(Clone, Copy, Debug)]
pub(super) struct Event {
    pub(super) from: Place,
    pub(super) to: Place,
    pub(super) charged: bool,
    /// The penalty of the step.
    pub(super) penalty: u32,
}

impl Event {
    pub(super) fn waits(self) -> bool {
        matches!((self.from, self.to), (Place::At(u), Place::At(v)) if u == v)
    }

    /// The share of the step in a cost of the agent. (A makespan is of all agents.)
    pub(super) fn costs(self, cost: Cost) -> u32 {
        let counts = match cost {
            Cost::Charges => self.charged,
            Cost::Waits => self.waits(),
            Cost::Moves => matches!(self.from, Place::At(_)) && !self.waits(),
            Cost::SumOfCosts => true,
            Cost::Makespan => false,
            Cost::Penalty => return self.penalty,
        };
        u32::from(counts)
    }
}

/// The counters of the conditions on an agent, packed into one number, digit by digit.
#[derive(Clone, Copy)]
struct Counts {
    before: u32,
    after: u32,
    unit: u32,
}

impl Counts {
    const fn of(count: u32) -> Self {
        Self {
            before: count,
            after: 0,
            unit: 1,
        }
    }

    /// The digit of a condition that counts up to less than `size`, which becomes what
    /// `next` makes of it; whether that is still allowed.
    fn update(&mut self, size: u32, next: impl FnOnce(u32) -> u32) -> bool {
        let digit = next(self.before % size);
        self.before /= size;
        self.after = self.after.wrapping_add(digit.wrapping_mul(self.unit));
        self.unit = self.unit.wrapping_mul(size);
        digit < size
    }
}

/// The sizes of the digits of [`Counts`].
fn sizes(task: &Task) -> impl Iterator<Item = u32> + '_ {
    task.conditions.parts().filter_map(size)
}

/// The size of the digit of a part; `None` where nothing is counted for it.
fn size(part: Part<'_>) -> Option<u32> {
    match part {
        Part::Required(_, Required::Charge { .. }) => Some(2),
        Part::Limit(
            Cost::SumOfCosts | Cost::Charges | Cost::Moves | Cost::Waits | Cost::Penalty,
            most,
        ) => Some(most.saturating_add(1)),
        // The place, the mask and the clock tell.
        Part::Forbidden(_)
        | Part::Counter(_)
        | Part::Required(_, Required::Cross { .. })
        | Part::Limit(Cost::Makespan, _) => None,
    }
}

/// Whether all that the conditions on an agent count fits into one number.
pub(super) fn can_count(task: &Task) -> bool {
    sizes(task).try_fold(1, u32::checked_mul).is_some()
}

/// The counters after a step, and the mask; `None` where a condition is broken.
pub(super) fn follow(
    task: &Task,
    count: u32,
    [before, mut mask]: [Mask; 2],
    event: Event,
) -> Option<(u32, Mask)> {
    let mut counts = Counts::of(count);
    let mut allowed = true;
    for part in task.conditions.parts() {
        let Some(size) = size(part) else { continue };
        allowed &= counts.update(size, |digit| match part {
            Part::Required(number, Required::Charge { at, .. }) => {
                let charged = digit.max(u32::from(event.charged));
                match (event.from == Place::At(*at), event.waits()) {
                    (false, _) => 0,
                    (true, true) => charged,
                    (true, false) => {
                        // Leaving sets the bit just where it charged while it was there.
                        if charged == 0 {
                            let bit = task.required_bit(number);
                            mask = mask & !bit | before & bit;
                        }
                        0
                    }
                }
            }
            Part::Limit(cost, _) => digit.saturating_add(event.costs(cost)),
            Part::Required(_, Required::Cross { .. }) | Part::Forbidden(_) | Part::Counter(_) => {
                digit
            }
        });
    }
    allowed.then_some((counts.after, mask))
}
