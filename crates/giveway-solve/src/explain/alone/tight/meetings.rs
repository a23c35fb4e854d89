//! Which agents meet where each takes its best way alone.

use std::collections::{BTreeMap, BTreeSet};

use giveway_model::{check::check, sorting::set};

use super::Tightness;
use crate::{
    explain::{
        ask::{names, walks},
        lone_walk::{lone_walk, replaced},
    },
    problem::Problem,
    walk::to_plan,
};

impl Tightness<'_, '_> {
    /// The pairs that would meet if one of them took its best way alone, the others as in the plan,
    /// and how often.
    pub(super) fn meetings(&self) -> BTreeMap<BTreeSet<usize>, u32> {
        let mut meetings = BTreeMap::new();
        let instance = self.needs.instance();
        let Ok(problem) = Problem::new(instance, self.budget) else {
            return meetings;
        };
        let Some(mut walks) = walks(instance, &problem, self.here) else {
            return meetings;
        };
        let names = names(instance);
        let latest = problem.default_horizon(instance.grid());
        for (agent, name) in names.iter().enumerate() {
            let Ok(Some(lone)) = lone_walk(&problem, &walks, (agent, latest), self.budget) else {
                continue;
            };
            let Some(own) = walks.get_mut(agent) else {
                continue;
            };
            let own = std::mem::replace(own, lone);
            let plan = replaced(self.here, name, &to_plan(&problem, &names, &walks));
            if let Some(walk) = walks.get_mut(agent) {
                *walk = own;
            }
            for violation in check(instance, &plan).violations {
                let numbers = violation.agents.iter();
                let numbers = numbers.filter_map(|name| names.iter().position(|it| it == name));
                let met: BTreeSet<usize> = set(numbers);
                if met.len() == 2 {
                    *meetings.entry(met).or_default() += 1;
                }
            }
        }
        meetings
    }
}
