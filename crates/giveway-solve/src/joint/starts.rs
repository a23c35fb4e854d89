//! The joint states at time 0, with what is paid for the time before.

use giveway_model::Cost;

use super::{Joint, agent::Single, tally::Tally};
use crate::single::Task;

impl Joint<'_> {
    /// The states at time 0. An agent that begins at its goal with nothing left to do, and goes on
    /// all the same, pays for the time since it arrived.
    pub(super) fn starts(&self) -> Vec<(Vec<Single>, Tally)> {
        let mut joint = vec![(Vec::new(), Tally::default())];
        for i in 0..self.agents.len() {
            let task = self.task(i);
            let Some(state) = task.first() else {
                return Vec::new();
            };
            let first = Single::Going {
                place: state.place,
                mask: state.mask,
                battery: state.battery,
                clock: 0,
                count: 0,
            };
            let choices = self.or_arrived(i, first);
            let mut longer = Vec::new();
            for (head, paid) in joint {
                for &choice in &choices {
                    let mut state: Vec<Single> = head.clone();
                    state.push(choice);
                    let goes_on = self.going_on(task, choice);
                    longer.push((state, paid.and(goes_on)));
                }
            }
            joint = longer;
        }
        joint
    }

    /// The costs of an agent that has not arrived at time 0.
    fn going_on(&self, task: &Task, state: Single) -> Tally {
        if state.has_arrived() {
            return Tally::default();
        }
        self.counted.tally(|cost| match cost {
            Cost::SumOfCosts => task.cost_if_it_leaves_goal,
            Cost::Waits => task.waits_if_it_leaves_goal,
            Cost::Makespan | Cost::Charges | Cost::Moves | Cost::Penalty => 0,
        })
    }
}
