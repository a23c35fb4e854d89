//! Edits that are worth trying: those that weaken one of the facts that exclude a plan.

use giveway_model::{Cell, Constraint, Instance, MAX_CAPACITY, constraint::MAX_NUMBER};

use super::super::{answer::Edit, group::Group};

/// Cells beyond which new chargers and normal cells are not all tried.
const MOST_CELLS: usize = 64;

/// An edit to try; a battery, a floor or a deadline by as much as is needed.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Candidate {
    Edit(Edit),
    Battery(usize),
    Floor,
    Deadline,
    /// The limit of a rule, by its number.
    Most(usize),
    /// The last time of a rule, by its number.
    Until(usize),
}

impl Candidate {
    /// The edit that helps if any of its kind does; `None` for no deadline at all.
    pub(super) fn strongest(&self, instance: &Instance) -> Option<Edit> {
        match self {
            Self::Edit(edit) => Some(edit.clone()),
            Self::Battery(agent) => battery(instance, *agent, MAX_CAPACITY, MAX_CAPACITY),
            Self::Floor => Some(Edit::BatteryFloor { floor: 0 }),
            Self::Deadline => None,
            Self::Most(rule) => allow_more(instance, *rule, MAX_NUMBER),
            Self::Until(rule) => give_until(instance, *rule, MAX_NUMBER),
        }
    }

    /// Whether the edit leaves a fact about an agent, or a rule, out as it is.
    pub(super) const fn leaves_fact_out(&self) -> bool {
        let Self::Edit(edit) = self else { return false };
        matches!(
            edit,
            Edit::LeaveOut { .. } | Edit::DropWaypoint { .. } | Edit::SwitchOff { .. }
        )
    }

    /// Whether the edit weakens a fact, so that a set with it may no longer exclude a
    /// plan.
    pub(super) fn weakens(&self, fact: Group, instance: &Instance) -> bool {
        let is = |agent: usize, name: &str| {
            let agent = instance.agents().get(agent);
            agent.is_some_and(|agent| agent.name == name)
        };
        match (self, fact) {
            (Self::Battery(agent), fact) => fact == Group::Battery(*agent),
            (Self::Floor, fact) => matches!(fact, Group::Floor | Group::Battery(_)),
            (Self::Deadline, fact) => fact == Group::Deadline,
            (Self::Most(rule) | Self::Until(rule), fact) => fact == Group::Constraint(*rule),
            (Self::Edit(edit), fact) => match edit {
                Edit::RemoveObstacle { cell } => fact == Group::Obstacle(*cell),
                Edit::AddCharger { .. } => matches!(fact, Group::Battery(_) | Group::Floor),
                Edit::Battery { agent, .. } => matches!(fact, Group::Battery(a) if is(a, agent)),
                Edit::BatteryFloor { .. } => matches!(fact, Group::Floor | Group::Battery(_)),
                Edit::Deadline { .. } => fact == Group::Deadline,
                Edit::MakeNormal { .. } => fact == Group::Slow,
                Edit::DropWaypoint { agent, cell } => {
                    matches!(fact, Group::Waypoint(a, at) if at == *cell && is(a, agent))
                }
                Edit::Vanish => matches!(fact, Group::Stay(_)),
                Edit::LeaveOut { agent } => {
                    let binds = |rule: &Constraint| {
                        let mut named = rule.named_agents().peekable();
                        named.peek().is_none() || named.any(|name| name == agent)
                    };
                    fact.agents().iter().any(|&of_fact| is(of_fact, agent))
                        || fact.constraint(instance).is_some_and(binds)
                }
                Edit::SwitchOff { index, .. }
                | Edit::AllowMore { index, .. }
                | Edit::GiveUntil { index, .. } => fact == Group::Constraint(*index as usize),
            },
        }
    }
}

/// A battery of this size and level for an agent that has one.
pub(super) fn battery(
    instance: &Instance,
    agent: usize,
    capacity: u32,
    initial: u32,
) -> Option<Edit> {
    let agent = instance.agents().get(agent)?;
    agent.battery.map(|_| Edit::Battery {
        agent: agent.name.clone(),
        capacity,
        initial,
    })
}

/// More agents in the zone of a rule, or more wait steps on end.
pub(super) fn allow_more(instance: &Instance, rule: usize, most: u32) -> Option<Edit> {
    let constraint = instance.rule_as_written(rule)?;
    constraint.kind.most().map(|_| Edit::AllowMore {
        index: rule as u32,
        rule: constraint.called_among(instance.agents()),
        most,
    })
}

/// A later last time of a rule, in times of the whole plan.
pub(super) fn give_until(instance: &Instance, rule: usize, to: u32) -> Option<Edit> {
    let constraint = instance.rule_as_written(rule)?;
    constraint.kind.last_chance().map(|_| Edit::GiveUntil {
        index: rule as u32,
        rule: constraint.called_among(instance.agents()),
        to,
    })
}

/// Every edit that weakens one of the facts, each once, and whether no cell was passed
/// over. Agents that are `asked` about are never left out.
pub(super) fn candidates(
    instance: &Instance,
    facts: &[Group],
    asked: &[usize],
) -> (Vec<Candidate>, bool) {
    let agents = instance.agents();
    let name = |a: usize| agents.get(a).map_or_else(String::new, |a| a.name.clone());
    let mut candidates = Vec::new();
    let mut are_all = true;
    let any = |test: fn(&Group) -> bool| facts.iter().any(test);
    let mut some = |cells: Vec<Cell>, edit: fn(Cell) -> Edit| {
        are_all &= cells.len() <= MOST_CELLS;
        let cells = cells.into_iter().take(MOST_CELLS);
        cells
            .map(|cell| Candidate::Edit(edit(cell)))
            .collect::<Vec<_>>()
    };
    for &fact in facts {
        candidates.extend(match fact {
            Group::Obstacle(cell) => Some(Candidate::Edit(Edit::RemoveObstacle { cell })),
            Group::Battery(a) => Some(Candidate::Battery(a)),
            Group::Floor => Some(Candidate::Floor),
            Group::Deadline => Some(Candidate::Deadline),
            Group::Waypoint(a, cell) => {
                let agent = name(a);
                Some(Candidate::Edit(Edit::DropWaypoint { agent, cell }))
            }
            Group::Task(a) if !asked.contains(&a) => {
                Some(Candidate::Edit(Edit::LeaveOut { agent: name(a) }))
            }
            Group::Constraint(rule) => {
                let off = instance.rule_as_written(rule).map(|it| Edit::SwitchOff {
                    index: rule as u32,
                    rule: it.called_among(instance.agents()),
                });
                off.map(Candidate::Edit)
            }
            Group::Task(_)
            | Group::Collision(..)
            | Group::Stay(_)
            | Group::Slow
            | Group::Breakdown(..) => None,
        });
    }
    for &fact in facts {
        if let (Group::Constraint(rule), Some(it)) = (fact, fact.constraint(instance)) {
            candidates.extend(it.kind.most().map(|_| Candidate::Most(rule)));
            candidates.extend(it.kind.last_chance().map(|_| Candidate::Until(rule)));
        }
    }
    if any(|fact| matches!(fact, Group::Battery(_))) {
        let cells = instance.grid().cells();
        let free = cells.filter(|(_, ground)| ground.is_vertex() && !ground.is_charger());
        let cells = free.map(|(cell, _)| cell).collect();
        candidates.extend(some(cells, |cell| Edit::AddCharger { cell }));
    }
    if any(|fact| matches!(fact, Group::Slow)) {
        let cells = instance.grid().cells();
        let slow = cells.filter(|(_, ground)| ground.is_slow());
        let cells = slow.map(|(cell, _)| cell).collect();
        candidates.extend(some(cells, |cell| Edit::MakeNormal { cell }));
    }
    if any(|fact| matches!(fact, Group::Stay(_))) {
        candidates.push(Candidate::Edit(Edit::Vanish));
    }
    (candidates, are_all)
}
