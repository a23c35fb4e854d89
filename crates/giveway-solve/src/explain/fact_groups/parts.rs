//! Facts sorted into groups, and few enough of these.

use std::collections::BTreeMap;

use giveway_model::{Cell, Instance};

use super::{FactGroup, FactGroupKind, FactPrice, MOST_GROUPS};
use crate::explain::{
    answer::{Core, FactKind, Helps},
    group::Group,
    group_mus::CoreFound,
    shelves::{aisles, shelf_blocks},
    words,
};

/// A group under way.
pub(super) struct Part {
    kind: FactGroupKind,
    /// The facts, by their places.
    facts: Vec<usize>,
    /// The cells of an aisle.
    aisle: Vec<Cell>,
}

/// What facts of one group have in common.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Key {
    Agent(usize),
    Collisions,
    Aisle(usize),
    Shelf(usize),
    Rule(usize),
}

pub(super) struct Parts {
    pub(super) parts: Vec<Part>,
}

impl Parts {
    pub(super) fn new(instance: &Instance, groups: &[Group]) -> Self {
        let blocks = shelf_blocks(instance.grid());
        let block = |group: &Group| {
            let Group::Obstacle(cell) = group else {
                return None;
            };
            blocks.get(cell).copied()
        };
        let used: Vec<usize> = groups.iter().filter_map(block).collect();
        let aisles = aisles(instance.grid(), &blocks, |block| used.contains(&block));
        let mut aisle_of: BTreeMap<usize, usize> = BTreeMap::new();
        for (number, aisle) in aisles.iter().enumerate() {
            let (one, other) = aisle.blocks;
            if !aisle_of.contains_key(&one) && !aisle_of.contains_key(&other) {
                aisle_of.insert(one, number);
                aisle_of.insert(other, number);
            }
        }
        let mut parts: BTreeMap<Key, Vec<usize>> = BTreeMap::new();
        for (place, &group) in groups.iter().enumerate() {
            let key = match group {
                Group::Task(a)
                | Group::Waypoint(a, _)
                | Group::Battery(a)
                | Group::Stay(a)
                | Group::Breakdown(a, _) => Key::Agent(a),
                Group::Collision(..) => Key::Collisions,
                Group::Obstacle(_) => {
                    let block = block(&group).unwrap_or(usize::MAX);
                    let aisle = aisle_of.get(&block);
                    aisle.map_or(Key::Shelf(block), |&aisle| Key::Aisle(aisle))
                }
                Group::Slow | Group::Deadline | Group::Floor | Group::Constraint(_) => {
                    Key::Rule(place)
                }
            };
            parts.entry(key).or_default().push(place);
        }
        let part = |(key, facts): (Key, Vec<usize>)| {
            let aisle = match key {
                Key::Aisle(number) => aisles.get(number).map(|aisle| aisle.cells.clone()),
                Key::Agent(_) | Key::Collisions | Key::Shelf(_) | Key::Rule(_) => None,
            };
            let kind = match key {
                Key::Agent(_) => FactGroupKind::Agent,
                Key::Collisions => FactGroupKind::Collisions,
                Key::Aisle(_) => FactGroupKind::Aisle,
                Key::Shelf(_) => FactGroupKind::Shelf,
                Key::Rule(_) => FactGroupKind::Rule,
            };
            Part {
                kind,
                facts,
                aisle: aisle.unwrap_or_default(),
            }
        };
        Self {
            parts: parts.into_iter().map(part).collect(),
        }
    }

    /// Joins groups of one kind until there are few enough: the kind of which there are most.
    pub(super) fn merge(&mut self) {
        while self.parts.len() > MOST_GROUPS {
            let wider = |kind| match kind {
                FactGroupKind::Agent | FactGroupKind::Agents => FactGroupKind::Agents,
                FactGroupKind::Shelf | FactGroupKind::Shelves | FactGroupKind::Aisle => {
                    FactGroupKind::Shelves
                }
                FactGroupKind::Rule | FactGroupKind::Rules => FactGroupKind::Rules,
                FactGroupKind::Collisions => FactGroupKind::Collisions,
            };
            let count = |kind| {
                self.parts
                    .iter()
                    .filter(|it| wider(it.kind) == kind)
                    .count()
            };
            let kinds = [
                FactGroupKind::Shelves,
                FactGroupKind::Agents,
                FactGroupKind::Rules,
            ];
            let Some(most) = kinds.into_iter().max_by_key(|&kind| count(kind)) else {
                return;
            };
            // The last two of them.
            let mut of_kind = self.parts.iter().rposition(|it| wider(it.kind) == most);
            let Some(last) = of_kind.take() else { return };
            let removed = self.parts.remove(last);
            let Some(part) = self.parts.iter_mut().rfind(|it| wider(it.kind) == most) else {
                self.parts.push(removed);
                return;
            };
            part.kind = most;
            part.facts.extend(removed.facts);
            part.aisle.clear();
        }
    }
}

impl Part {
    pub(super) fn group(&self, instance: &Instance, found: &CoreFound, core: &Core) -> FactGroup {
        let facts: Vec<_> = self
            .facts
            .iter()
            .filter_map(|&it| core.facts.get(it))
            .collect();
        let mut agents: Vec<String> = Vec::new();
        for agent in instance.agents() {
            if facts.iter().any(|fact| fact.agents.contains(&agent.name)) {
                agents.push(agent.name.clone());
            }
        }
        let obstacles = facts.iter().filter(|fact| fact.kind == FactKind::Obstacle);
        let obstacles: Vec<Cell> = obstacles.filter_map(|fact| fact.cell).collect();
        let has = |helps| facts.iter().any(|fact| fact.helps == helps);
        let own = |price: &&FactPrice| self.facts.contains(&(price.fact as usize));
        let priced = core.prices.iter().filter(own);
        let is_needed = |&place: &usize| {
            let fact = found.groups.get(place);
            fact.is_some_and(|fact| found.is_needed(instance, fact))
        };
        let objective = instance.objective();
        FactGroup {
            kind: self.kind,
            text: words::fact_group(self.kind, &facts, &agents, &self.aisle),
            agents,
            cells: if self.aisle.is_empty() {
                obstacles
            } else {
                self.aisle.clone()
            },
            facts: self.facts.iter().map(|&place| place as u32).collect(),
            needed: self.facts.iter().any(is_needed),
            helps: if has(Helps::Yes) {
                Helps::Yes
            } else if has(Helps::Unknown) {
                Helps::Unknown
            } else {
                Helps::No
            },
            price: priced
                .min_by_key(|price| price.costs.vector(objective))
                .cloned(),
        }
    }
}
