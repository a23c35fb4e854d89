//! Cores of a search as guesses for the lemmas of a certificate.

use giveway_model::sorting::map;
use giveway_proof::Hint;

use crate::trace::{Core, SearchEvent, SearchTrace};

/// The cores that a search tells of, in their order. What it left out of its list is missing.
pub(super) fn hints(trace: Option<&SearchTrace>) -> Vec<Hint> {
    let events = trace.map_or(&[][..], |trace| &trace.events);
    let cores = events.iter().filter_map(|told| match &told.event {
        SearchEvent::Core(core) => Some(hint(core)),
        _ => None,
    });
    cores.collect()
}

fn hint(core: &Core) -> Hint {
    let limits = core.limits.iter();
    let own = || core.limits.iter().map(|limit| limit.agent.clone());
    let (agents, more) = match &core.together {
        None => (own().collect(), 0),
        Some(together) => {
            let agents = together.agents.iter();
            (
                agents.map(|agent| agent.agent.clone()).collect(),
                together.more,
            )
        }
    };
    Hint {
        cost: core.cost,
        limits: map(limits.map(|limit| (limit.agent.clone(), limit.at_most))),
        agents,
        more,
        is_clause: core.sums.is_empty(),
    }
}
