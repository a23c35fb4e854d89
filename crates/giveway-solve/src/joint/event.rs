//! What happens to one agent in a step, and what conditions on it count.

use giveway_model::Cost;

use crate::single::{Place, Task};

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

/// What the conditions on an agent count, packed into one number, digit by digit.
#[derive(Clone, Copy)]
struct Counts {
    before: u32,
    after: u32,
    unit: u32,
}

impl Counts {
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
    let conditions = &task.conditions;
    let waits = conditions.waits.iter().map(|wait| wait.steps);
    let charges = conditions.charges().map(|_| 2);
    let limits = conditions.counted_limits();
    let limits = limits.map(|(_, most)| most.saturating_add(1));
    waits.chain(charges).chain(limits)
}

/// Whether all that the conditions on an agent count fits into one number.
pub(super) fn can_count(task: &Task) -> bool {
    sizes(task).try_fold(1, u32::checked_mul).is_some()
}

/// What the conditions on an agent count at time 0: waits that began before.
pub(super) fn first_count(task: &Task) -> u32 {
    let waits = task.conditions.waits.iter();
    let (count, _) = waits.fold((0_u32, 1_u32), |(count, unit), wait| {
        let digit = wait.begun.wrapping_mul(unit);
        (count.wrapping_add(digit), unit.wrapping_mul(wait.steps))
    });
    count
}

/// What the conditions on an agent count after a step, and its mask; `None` where
/// they count too much.
pub(super) fn follow(
    task: &Task,
    count: u32,
    [before, mut mask]: [u32; 2],
    event: Event,
) -> Option<(u32, u32)> {
    let conditions = &task.conditions;
    let mut counts = Counts {
        before: count,
        after: 0,
        unit: 1,
    };
    let mut allowed = true;
    for wait in &conditions.waits {
        let counted = |v| event.waits() && wait.counts(v, event.clock);
        let counted = matches!(event.from, Place::At(v) if counted(v));
        allowed &= counts.update(wait.steps, |run| if counted { run + 1 } else { 0 });
    }
    for (number, v) in conditions.charges() {
        allowed &= counts.update(2, |charged| {
            let charged = charged.max(u32::from(event.charged));
            match (event.from == Place::At(v), event.waits()) {
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
        });
    }
    for (cost, most) in conditions.counted_limits() {
        let more = event.costs(cost);
        allowed &= counts.update(most.saturating_add(1), |used| used + more);
    }
    allowed.then_some((counts.after, mask))
}
