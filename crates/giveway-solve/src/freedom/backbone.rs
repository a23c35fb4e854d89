//! Computes the backbone: visits that every best plan has, and visits that only this one has.
//!
//! A visit that a best plan lacks is not in the backbone. For the rest, one call asks for a plan that lacks
//! *any* of them: where there is none, all of them are proved at once.

use std::collections::BTreeMap;

use super::{
    Known, Shared, Visit,
    every::Every,
    formula::{Way, names},
};
use crate::{budget::Stop, sat::Lit, single::Place};

/// Something that the plan has.
struct Item {
    agent: usize,
    time: u32,
    what: VisitSlot,
    lit: Lit,
    always: Known,
    only: Known,
}

/// An entry of the agent's path.
#[derive(Clone, Copy, PartialEq, Eq)]
enum VisitSlot {
    Visit(Place),
    Charge,
}

impl Item {
    fn is_in(&self, every: &Every, plan: &[Way]) -> bool {
        plan.get(self.agent).is_some_and(|way| match self.what {
            VisitSlot::Visit(place) => every.place(self.agent, way, self.time) == Some(place),
            VisitSlot::Charge => way.charges.contains(&self.time),
        })
    }
}

/// The backbone, as far as it is known.
pub(super) struct Backbone {
    items: Vec<Item>,
}

impl Backbone {
    /// All that the plan has, nothing known of it.
    pub(super) fn new(every: &Every) -> Self {
        let mut items = Vec::new();
        for (agent, way) in every.own().iter().enumerate() {
            let mut item = |time, what, lit: Option<Lit>| {
                items.extend(lit.map(|lit| Item {
                    agent,
                    time,
                    what,
                    lit,
                    always: Known::Open,
                    only: Known::Open,
                }));
            };
            for (time, &place) in way.places.iter().enumerate() {
                let lit = every.formula.at(agent, time as u32, place);
                item(time as u32, VisitSlot::Visit(place), lit);
            }
            for (time, lit) in every.formula.charges(agent) {
                if way.charges.contains(&time) {
                    item(time, VisitSlot::Charge, Some(lit));
                }
            }
        }
        Self { items }
    }

    /// Settles all of it.
    ///
    /// # Errors
    /// When the budget is spent; what is known until then stays.
    pub(super) fn settle(&mut self, every: &mut Every) -> Result<(), Stop> {
        loop {
            self.learn(every);
            let open = self.open(|item| item.always);
            if open.is_empty() {
                break;
            }
            let lacks = every.formula.some(open.into_iter().map(|lit| !lit));
            let is_found = every.find(&[lacks])?;
            every.formula.retire(lacks);
            if !is_found {
                self.prove(|item| &mut item.always);
            }
        }
        let own = every.own().to_vec();
        let another = every.other_than(&own);
        loop {
            self.learn(every);
            let open = self.open(|item| item.only);
            if open.is_empty() {
                break;
            }
            let has = every.formula.some(open);
            let is_found = every.find(&[another, has])?;
            every.formula.retire(has);
            if !is_found {
                self.prove(|item| &mut item.only);
            }
        }
        every.formula.retire(another);
        Ok(())
    }

    /// Takes in the plans that were found.
    pub(super) fn learn(&mut self, every: &Every) {
        for item in &mut self.items {
            for plan in every.others() {
                let known = if item.is_in(every, plan) {
                    &mut item.only
                } else {
                    &mut item.always
                };
                *known = Known::No;
            }
        }
    }

    fn open(&self, known: impl Fn(&Item) -> Known) -> Vec<Lit> {
        let open = self.items.iter().filter(|it| known(it) == Known::Open);
        open.map(|it| it.lit).collect()
    }

    fn prove(&mut self, known: impl Fn(&mut Item) -> &mut Known) {
        for item in &mut self.items {
            let known = known(item);
            if *known == Known::Open {
                *known = Known::Yes;
            }
        }
    }

    /// The backbone as it is told, by the agents' names.
    pub(super) fn told(&self, every: &Every) -> BTreeMap<String, Vec<Visit>> {
        let mut told: BTreeMap<String, Vec<Visit>> = BTreeMap::new();
        let names = names(every.instance);
        for item in &self.items {
            let Some(name) = names.get(item.agent) else {
                continue;
            };
            let visits = told.entry(name.clone()).or_default();
            let shared = Shared {
                always: item.always,
                only: item.only,
            };
            match item.what {
                VisitSlot::Visit(place) => visits.push(Visit {
                    time: item.time,
                    cell: match place {
                        Place::At(v) => Some(every.problem.terrain.cell(v)),
                        Place::Along(_) => None,
                    },
                    always: item.always,
                    only: item.only,
                    charge: None,
                }),
                VisitSlot::Charge => {
                    if let Some(visit) = visits.get_mut(item.time as usize) {
                        visit.charge = Some(shared);
                    }
                }
            }
        }
        told
    }
}
