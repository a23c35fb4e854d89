//! The rules of a scene's own, as planners see them.
//!
//! A rule of one agent is a part of that agent's task ([`alone`]): its tables, its MDD and
//! its searches keep to it by construction. A rule between agents is a [`Between`]: who
//! plans several agents looks for what breaks it as for collisions.

mod alone;
mod between;
mod moving;
mod past;
mod precedence;
mod table;

use std::collections::BTreeMap;

use giveway_model::{
    Instance, Zone,
    condition::Times,
    constraint::InForce,
    sorting::{map, sort},
};

use crate::{
    AgentId,
    single::{Act, Area, Forbidden, NoPlanAlone, Task},
    terrain::Terrain,
};

pub use between::{Between, Shared, SharedKind, near, touched};
pub use precedence::Precedence;
pub use table::{Presence, RuleTable};

/// The rules in force, with the zones that they name.
pub(crate) struct OwnRules<'i> {
    instance: &'i Instance,
    rules: Vec<InForce<'i>>,
    areas: BTreeMap<&'i str, Area>,
}

impl<'i> OwnRules<'i> {
    pub(crate) fn new(instance: &'i Instance, terrain: &Terrain) -> Self {
        let area = |zone: &'i Zone| {
            let mut vertices = zone.cells().filter_map(|cell| terrain.vertex(cell));
            let area = match (vertices.next(), vertices.next()) {
                (Some(only), None) => Area::One(only),
                (first, second) => {
                    let all = first.into_iter().chain(second).chain(vertices);
                    Area::of(all, terrain.size())
                }
            };
            (zone.name.as_str(), area)
        };
        let rules: Vec<InForce<'_>> = instance.constraints_in_force().collect();
        // Without rules there is no need of zones.
        let zones = if rules.is_empty() {
            &[]
        } else {
            instance.zones()
        };
        Self {
            instance,
            rules,
            areas: map(zones.iter().map(area)),
        }
    }

    fn area(&self, zone: &str) -> Area {
        let area = self.areas.get(zone).cloned();
        area.unwrap_or_else(|| Area::of(std::iter::empty(), 0))
    }

    /// Makes an agent's task keep its rules.
    ///
    /// # Errors
    /// Where the agent cannot keep one whatever it does.
    pub(crate) fn impose(
        &self,
        agent: AgentId,
        task: &mut Task,
        terrain: &Terrain,
    ) -> Result<(), NoPlanAlone> {
        for rule in &self.rules {
            if rule.agents.binary_search(&agent).is_ok() {
                self.impose_one(rule, agent, task, terrain)?;
            }
        }
        self.heed_moving(agent, task, terrain);
        self.ask_for_entry(agent, task);
        self.impose_past(agent, task, terrain);
        join_lanes(task);
        Ok(())
    }

    /// The rules between agents.
    pub(crate) fn between(&self) -> Between {
        let agents = self.instance.agents().len();
        let shared = self
            .rules
            .iter()
            .filter_map(|rule| self.shared(rule, agents));
        Between {
            rules: shared.collect(),
        }
    }

    /// Which agents have to be somewhere before others.
    pub(crate) fn precedences(&self, terrain: &Terrain) -> Vec<Precedence> {
        let rules = self.rules.iter();
        rules
            .filter_map(|rule| self.precedence(rule, terrain))
            .collect()
    }

    /// The last time that a rule names, or at which an obstacle moves.
    pub(crate) fn last_time(&self) -> u32 {
        let times = self.rules.iter().map(|rule| rule.constraint.last_time());
        times.max().unwrap_or(0).max(self.last_time_moving())
    }

    fn number(&self, name: &str) -> Option<AgentId> {
        let mut agents = self.instance.agents().iter();
        agents.position(|agent| agent.name == name)
    }
}

/// Makes one list of the arcs that are forbidden at all times: searches look at each list for
/// each arc.
fn join_lanes(task: &mut Task) {
    let mut closed = Vec::new();
    task.conditions.forbidden.retain(|forbidden| {
        let is_lane = forbidden.times.are_all() && forbidden.unless == 0;
        match &forbidden.act {
            Act::Cross(arcs) if is_lane => {
                closed.extend_from_slice(arcs);
                false
            }
            Act::Cross(_) | Act::Stand(_) | Act::Charge(_) => true,
        }
    });
    if !closed.is_empty() {
        sort(&mut closed);
        closed.dedup();
        task.conditions.forbidden.push(Forbidden {
            act: Act::Cross(closed),
            times: Times::default(),
            unless: 0,
        });
    }
}
