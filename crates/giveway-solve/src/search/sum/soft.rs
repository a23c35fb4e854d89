//! The cost of an agent as something that a core raises.

use giveway_model::Cost;

use crate::{
    budget::Stop,
    encode::collisions::AgentId,
    sat::{Lit, Sat},
    search::{
        oll::{self, Formula, Kept, Level},
        stage::Search,
    },
};

/// The soft constraint of a stage.
pub(super) type Soft = oll::Soft<AtMost>;

/// An agent has at most this of a cost.
#[derive(Clone, Copy, Debug)]
pub(super) struct AtMost {
    pub(super) agent: AgentId,
    pub(super) cost: Cost,
    pub(super) most: u32,
    /// What a level costs.
    pub(super) unit: u32,
}

impl Level for AtMost {
    fn raised(self, by: u32) -> Option<Self> {
        let most = self.most.checked_add(by.checked_mul(self.unit)?)?;
        Some(Self { most, ..self })
    }
}

impl<'h> Formula for Search<'_, 'h, '_> {
    type Out = Sat<'h>;

    fn clauses(&mut self) -> &mut Sat<'h> {
        self.team.clauses()
    }
}

impl Kept<Search<'_, '_, '_>> for AtMost {
    fn literal(self, search: &mut Search) -> Result<Option<Lit>, Stop> {
        let Self {
            agent, cost, most, ..
        } = self;
        if cost != Cost::SumOfCosts {
            let more = search.team.more_than(agent, cost, most)?;
            return Ok(more.map(|lit| !lit));
        }
        let time = search.problem.time_of(agent, most);
        search.grow(agent, time)?;
        if time >= search.cap(agent) {
            return Ok(None);
        }
        Ok(search.team.by(agent, time))
    }
}
