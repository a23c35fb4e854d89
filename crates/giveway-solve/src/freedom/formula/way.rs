//! One agent's way in a plan, as the formula tells ways apart.

use giveway_model::{Instance, Plan, Version, sorting::sort};

use crate::{
    problem::Problem,
    single::Place,
    walk::{Walk, to_plan, walks_of_plan},
};

/// Where an agent is at each time up to its arrival, and when it charges.
#[derive(Clone, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub(in crate::freedom) struct Way {
    pub(in crate::freedom) places: Walk,
    pub(in crate::freedom) charges: Vec<u32>,
}

impl Way {
    /// Where it is at a time; `None` after its arrival.
    pub(in crate::freedom) fn at(&self, time: u32) -> Option<Place> {
        self.places.get(time as usize).copied()
    }

    /// When it arrives.
    pub(in crate::freedom) fn arrival(&self) -> u32 {
        crate::walk::arrival(&self.places)
    }
}

/// The ways of a plan that the judge passes, agent by agent.
pub(in crate::freedom) fn ways_of(
    problem: &Problem,
    instance: &Instance,
    plan: &Plan,
) -> Option<Vec<Way>> {
    let names = names(instance);
    let walks = walks_of_plan(problem, &names, plan)?;
    let ways = walks.into_iter().zip(&names).map(|(places, name)| {
        let mut charges = plan.charges(name).to_vec();
        sort(&mut charges);
        Way { places, charges }
    });
    Some(ways.collect())
}

/// Ways as a plan.
pub(in crate::freedom) fn plan_of(problem: &Problem, instance: &Instance, ways: &[Way]) -> Plan {
    let names = names(instance);
    let walks: Vec<Walk> = ways.iter().map(|way| way.places.clone()).collect();
    let mut plan = Plan {
        giveway: Version,
        paths: to_plan(problem, &names, &walks).paths,
        ..Plan::default()
    };
    for (name, way) in names.into_iter().zip(ways) {
        if !way.charges.is_empty() {
            plan.charges.insert(name, way.charges.clone());
        }
    }
    plan
}

/// The agents' names, in the order of the instance.
pub(in crate::freedom) fn names(instance: &Instance) -> Vec<String> {
    let agents = instance.agents().iter();
    agents.map(|agent| agent.name.clone()).collect()
}
