//! Best plans that differ from one that was found in the way of a single agent: found
//! without the SAT solver.
//!
//! Most scenes have thousands of best plans, and each call of the solver assigns every
//! variable of the formula. Here one agent takes another way of the same arrival among
//! the others. The judge decides whether that is a best plan.

use std::collections::{BTreeMap, btree_map::Entry};

use super::{
    every::Every,
    formula::{Spot, Succession, Way},
};
use crate::{budget::Budget, budget::Stop, single::Place, terrain::Vertex};

/// Ways of one agent that are tried in one plan.
const MOST_WAYS: usize = 200;
/// Plans in a row whose variations are all known, after which no more are looked at.
const FRUITLESS: u32 = 60;

/// The variations of the plans that were found, looked at plan by plan.
#[derive(Default)]
pub(super) struct Variations {
    /// By agent and arrival.
    successions: BTreeMap<(usize, u32), Succession>,
    /// Plans that were looked at.
    next: usize,
}

impl Variations {
    /// Looks for more best plans, until more than a number are found or the variations
    /// add no more.
    ///
    /// # Errors
    /// When the budget is spent.
    pub(super) fn find(
        &mut self,
        every: &mut Every,
        limit: u32,
        budget: &Budget,
    ) -> Result<(), Stop> {
        let mut fruitless = 0;
        while fruitless < FRUITLESS && every.found().len() as u32 <= limit {
            let Some(plan) = every.found().get(self.next).cloned() else {
                return Ok(());
            };
            self.next += 1;
            let before = every.found().len();
            for agent in 0..plan.len() {
                self.vary(every, &plan, agent, budget)?;
                if every.found().len() as u32 > limit {
                    return Ok(());
                }
            }
            fruitless = if every.found().len() == before {
                fruitless + 1
            } else {
                0
            };
        }
        Ok(())
    }

    /// Tries the other ways of one agent.
    fn vary(
        &mut self,
        every: &mut Every,
        plan: &[Way],
        agent: usize,
        budget: &Budget,
    ) -> Result<(), Stop> {
        let Some(own) = plan.get(agent) else {
            return Ok(());
        };
        budget.check()?;
        let arrival = own.arrival();
        let key = (agent, arrival);
        let all = match self.successions.entry(key) {
            Entry::Occupied(known) => known.into_mut(),
            Entry::Vacant(new) => new.insert(Succession::new(every.problem, key, budget)?),
        };
        let taken = taken(every, plan, agent, arrival);
        let others = |time: u32| taken.get(time as usize).map_or(&[][..], Vec::as_slice);
        let at = |spot: Spot| match spot.place() {
            Some(Place::At(v)) => Some(v),
            Some(Place::Along(_)) | None => None,
        };
        let left = all.where_free(
            |time, spot| {
                let mut others = others(time).iter();
                others.all(|&(here, _)| Some(here) != at(spot))
            },
            |time, from, to| {
                let mut others = others(time).iter();
                let moves = from.place() != to.place();
                !(moves && others.any(|&(here, next)| Some(here) == at(to) && next == at(from)))
            },
        );
        for spots in left.ways(MOST_WAYS) {
            let way = Way {
                places: spots.into_iter().filter_map(Spot::place).collect(),
                charges: own.charges.clone(),
            };
            if way != *own {
                let mut other = plan.to_vec();
                if let Some(own) = other.get_mut(agent) {
                    *own = way;
                }
                budget.check()?;
                every.offer(other);
            }
        }
        Ok(())
    }
}

/// Where the other agents are at each time up to an arrival, and one step later.
fn taken(
    every: &Every,
    plan: &[Way],
    agent: usize,
    arrival: u32,
) -> Vec<Vec<(Vertex, Option<Vertex>)>> {
    let others = plan.iter().enumerate().filter(|&(other, _)| other != agent);
    let others: Vec<(usize, &Way)> = others.collect();
    let at = |other: usize, way: &Way, time: u32| match every.place(other, way, time) {
        Some(Place::At(v)) => Some(v),
        _ => None,
    };
    let each = (0..=arrival).map(|time| {
        let here = others
            .iter()
            .filter_map(|&(other, way)| Some((at(other, way, time)?, at(other, way, time + 1))));
        here.collect()
    });
    each.collect()
}
