//! From where to where one agent can go at each time, in ways of one arrival.

use std::collections::{BTreeMap, BTreeSet};

use super::layers::{Spot, Steps, layers};
use crate::{
    budget::{Budget, Stop},
    problem::Problem,
};

/// The spots of an agent at each time up to its arrival, with those that follow.
pub(in crate::freedom) struct Succession {
    layers: Vec<BTreeMap<Spot, Vec<Spot>>>,
}

impl Succession {
    /// All ways of an agent that end at a time.
    pub(in crate::freedom) fn new(
        problem: &Problem,
        (agent, arrival): (usize, u32),
        budget: &Budget,
    ) -> Result<Self, Stop> {
        let steps = Steps::new(problem, agent);
        let mut reached = layers(&steps, arrival, budget)?;
        if let Some(last) = reached.last_mut() {
            last.retain(|&spot| steps.may_end(spot, arrival));
        }
        let mut later: BTreeSet<Spot> = BTreeSet::new();
        let mut all = Vec::with_capacity(reached.len());
        for (time, layer) in (0..=arrival).rev().zip(reached.into_iter().rev()) {
            let mut here = BTreeMap::new();
            for spot in layer {
                budget.tick()?;
                let mut next = steps.onward(spot, time);
                next.retain(|to| later.contains(to));
                if time == arrival || !next.is_empty() {
                    here.insert(spot, next);
                }
            }
            later = here.keys().copied().collect();
            all.push(here);
        }
        all.reverse();
        Ok(Self { layers: all })
    }

    /// The succession without some spots and steps. A step is given by the time at which it begins.
    pub(in crate::freedom) fn where_free(
        &self,
        is_free: impl Fn(u32, Spot) -> bool,
        may_step: impl Fn(u32, Spot, Spot) -> bool,
    ) -> Self {
        let mut later: Option<BTreeSet<Spot>> = None;
        let mut all = Vec::with_capacity(self.layers.len());
        for (time, layer) in self.layers.iter().enumerate().rev() {
            let time = time as u32;
            let mut here = BTreeMap::new();
            for (&spot, next) in layer {
                if !is_free(time, spot) {
                    continue;
                }
                let next: Vec<Spot> = match &later {
                    None => Vec::new(),
                    Some(later) => {
                        let next = next.iter().copied();
                        next.filter(|to| later.contains(to) && may_step(time, spot, *to))
                            .collect()
                    }
                };
                if later.is_none() || !next.is_empty() {
                    here.insert(spot, next);
                }
            }
            later = Some(here.keys().copied().collect());
            all.push(here);
        }
        all.reverse();
        Self { layers: all }
    }

    /// Ways through it, up to a number.
    pub(in crate::freedom) fn ways(&self, most: usize) -> Vec<Vec<Spot>> {
        let mut ways = Vec::new();
        let Some(start) = self.layers.first().and_then(|layer| layer.keys().next()) else {
            return ways;
        };
        let mut begun = vec![vec![*start]];
        while let Some(way) = begun.pop() {
            if ways.len() >= most {
                break;
            }
            if way.len() == self.layers.len() {
                ways.push(way);
                continue;
            }
            let here = way.last().and_then(|spot| {
                let layer = self.layers.get(way.len() - 1)?;
                layer.get(spot)
            });
            for &to in here.into_iter().flatten() {
                let mut longer = way.clone();
                longer.push(to);
                begun.push(longer);
            }
        }
        ways
    }
}
