//! A walk of one agent, held against its conditions.

use giveway_model::Costs;

use super::Problem;
use crate::{
    single::{Mask, Part, Place, Required},
    walk::{Walk, costs_of},
};

impl Problem {
    /// Whether a walk of an agent, with so many charges, keeps to what is asked for
    /// beside its task, as far as walks made outside the SAT solver may fail to.
    pub fn keeps_alone(&self, agent: usize, walk: &Walk, charges: u32) -> bool {
        let task = &self.tasks[agent];
        task.conditions.parts().all(|part| match part {
            // Every search keeps to these.
            Part::Forbidden(_) | Part::Required(_, Required::Cross { .. }) => true,
            Part::Counter(_) => self.keeps_counts(agent, walk),
            Part::Required(_, Required::Charge { .. }) => {
                crate::walk::charges(task, &self.terrain, walk).is_some()
            }
            Part::Limit(cost, most) => {
                let own = Costs {
                    charges,
                    ..costs_of(self, agent, walk)
                };
                own.get(cost) <= most
            }
        })
    }

    /// Whether the counters of an agent allow all steps of a walk, and its end.
    fn keeps_counts(&self, agent: usize, walk: &Walk) -> bool {
        let task = &self.tasks[agent];
        let masks = self.follow(agent, walk);
        match (masks.last(), walk.last()) {
            (Some(&mask), Some(&Place::At(v))) if masks.len() == walk.len() => {
                let now = walk.len() as u32 - 1;
                task.conditions.may_end(mask, v, now)
            }
            _ => false,
        }
    }

    /// How far an agent has come at each time of a walk; up to a step that its counters
    /// forbid.
    fn follow(&self, agent: usize, walk: &[Place]) -> Vec<Mask> {
        let task = &self.tasks[agent];
        let first = task.first().map(|state| state.mask);
        let mut masks = Vec::from_iter(first);
        for (pair, now) in walk.windows(2).zip(0..) {
            let Some(&mask) = masks.last() else { break };
            let counted = task.counted(&self.terrain, mask, [pair[0], pair[1]], now);
            let Some(mut mask) = counted else { break };
            if let Place::At(v) = pair[1] {
                mask |= task.bit(v);
            }
            masks.push(mask);
        }
        masks
    }

    /// The same, where rules between agents ask for it; else nothing is known of how far it
    /// came.
    pub(crate) fn masks_of(&self, agent: usize, walk: &[Place]) -> Vec<Mask> {
        let mut rules = self.between.rules.iter();
        let asks = !self.precedences.is_empty() || rules.any(|rule| !rule.uncounted.is_empty());
        if !asks {
            return vec![0; walk.len()];
        }
        let mut masks = self.follow(agent, walk);
        masks.resize(walk.len(), masks.last().copied().unwrap_or(0));
        masks
    }
}
