//! Facts of an instance that can be left out, and the instance without some.

use std::collections::BTreeSet;

use giveway_model::{Breakdown, Cell, Constraint, Grid, Instance, Plan, ends_with_rest};

use super::answer::{Fact, FactKind, Helps};
use super::words;
use crate::problem::Relaxed;
use giveway_model::sorting::sort;

/// A fact; agents by their numbers. The order is that in which facts are tried:
/// without agents everything else is quickly tried.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Group {
    /// The agent is there.
    Task(usize),
    /// It must visit the waypoint.
    Waypoint(usize, Cell),
    /// Its battery is limited.
    Battery(usize),
    /// The cell is an obstacle.
    Obstacle(Cell),
    /// The two, the lower number first, must not collide.
    Collision(usize, usize),
    /// It stays where it arrives.
    Stay(usize),
    /// Slow zones are slow.
    Slow,
    /// A person set the horizon.
    Deadline,
    /// No battery may fall below the floor.
    Floor,
    /// It has broken down at a time, and is held.
    Breakdown(usize, u32),
    /// A rule of the scene's own is in force, by its number there.
    Constraint(usize),
}

impl Group {
    pub(crate) const fn kind(self) -> FactKind {
        match self {
            Self::Task(_) => FactKind::Task,
            Self::Waypoint(..) => FactKind::Waypoint,
            Self::Battery(_) => FactKind::Battery,
            Self::Obstacle(_) => FactKind::Obstacle,
            Self::Collision(..) => FactKind::Collision,
            Self::Stay(_) => FactKind::Stay,
            Self::Slow => FactKind::Slow,
            Self::Deadline => FactKind::Deadline,
            Self::Floor => FactKind::Floor,
            Self::Breakdown(..) => FactKind::Breakdown,
            Self::Constraint(_) => FactKind::Constraint,
        }
    }

    /// The agents that it is about.
    pub(crate) fn agents(self) -> Vec<usize> {
        match self {
            Self::Task(a)
            | Self::Waypoint(a, _)
            | Self::Battery(a)
            | Self::Stay(a)
            | Self::Breakdown(a, _) => vec![a],
            Self::Collision(a, b) => vec![a, b],
            Self::Obstacle(_) | Self::Slow | Self::Deadline | Self::Floor | Self::Constraint(_) => {
                Vec::new()
            }
        }
    }

    /// The fact for people.
    pub(crate) fn fact(self, instance: &Instance, within: Option<u32>) -> Fact {
        let name = |&a: &usize| instance.agents().get(a).map_or("", |a| a.name.as_str());
        let rule = self.constraint(instance);
        let agents: Vec<String> = match rule {
            Some(rule) => rule.named_agents().map(str::to_owned).collect(),
            None => self.agents().iter().map(|a| name(a).to_owned()).collect(),
        };
        let cell = match self {
            Self::Waypoint(_, cell) | Self::Obstacle(cell) => Some(cell),
            Self::Task(_)
            | Self::Battery(_)
            | Self::Collision(..)
            | Self::Stay(_)
            | Self::Slow
            | Self::Deadline
            | Self::Floor
            | Self::Breakdown(..)
            | Self::Constraint(_) => None,
        };
        let breakdown = self.breakdown(instance);
        let agent = |a: usize| instance.agents().get(a);
        let has_no_goal = |a: usize| agent(a).is_some_and(|agent| agent.goal.is_none());
        let kind = match self {
            Self::Task(a) if has_no_goal(a) => FactKind::Presence,
            Self::Stay(a) if has_no_goal(a) => FactKind::Rest,
            _ => self.kind(),
        };
        Fact {
            kind,
            text: words::fact(self, instance, within),
            agents,
            cell,
            index: match self {
                Self::Constraint(index) => Some(index as u32),
                Self::Task(_)
                | Self::Waypoint(..)
                | Self::Battery(_)
                | Self::Obstacle(_)
                | Self::Collision(..)
                | Self::Stay(_)
                | Self::Slow
                | Self::Deadline
                | Self::Floor
                | Self::Breakdown(..) => None,
            },
            helps: Helps::Unknown,
            time: match self {
                Self::Constraint(index) => instance.rule_added_at(index),
                Self::Task(_)
                | Self::Waypoint(..)
                | Self::Battery(_)
                | Self::Obstacle(_)
                | Self::Collision(..)
                | Self::Stay(_)
                | Self::Slow
                | Self::Deadline
                | Self::Floor
                | Self::Breakdown(..) => breakdown.map(|breakdown| breakdown.from),
            },
            until: breakdown.map(|breakdown| breakdown.to),
        }
    }

    /// The rule of the scene's own that it is, as it was written, where it is one.
    pub(crate) fn constraint(self, instance: &Instance) -> Option<&Constraint> {
        let Self::Constraint(index) = self else {
            return None;
        };
        instance.rule_as_written(index)
    }

    /// The breakdown that it is, where it is one.
    pub(crate) fn breakdown(self, instance: &Instance) -> Option<&Breakdown> {
        let Self::Breakdown(agent, from) = self else {
            return None;
        };
        let agent = instance.agents().get(agent)?;
        let mut breakdowns = instance.start_state(&agent.name).breakdowns.iter();
        breakdowns.find(|it| it.from == from)
    }
}

/// Every fact of an instance that can be left out. `asked` is never left out;
/// a deadline is a fact only where a person set one.
pub(crate) fn groups(instance: &Instance, asked: &[usize], deadline: bool) -> Vec<Group> {
    let mut groups = Vec::new();
    let agents = instance.agents().iter().enumerate();
    for (i, agent) in agents {
        if !asked.contains(&i) {
            groups.push(Group::Task(i));
        }
        groups.extend(agent.waypoints.iter().map(|&w| Group::Waypoint(i, w)));
        groups.extend(agent.battery.map(|_| Group::Battery(i)));
        groups.extend(instance.keeps(agent).then_some(Group::Stay(i)));
        groups.extend((0..i).map(|other| Group::Collision(other, i)));
        let own = instance.start_state(&agent.name).breakdowns.iter();
        groups.extend(own.map(|breakdown| Group::Breakdown(i, breakdown.from)));
    }
    let cells = instance.grid().cells();
    groups.extend(
        cells
            .filter(|(_, ground)| !ground.is_vertex())
            .map(|(cell, _)| Group::Obstacle(cell)),
    );
    if has_slow_edge(instance.grid()) {
        groups.push(Group::Slow);
    }
    groups.extend(deadline.then_some(Group::Deadline));
    let has_battery = instance
        .agents()
        .iter()
        .any(|agent| agent.battery.is_some());
    let has_floor = has_battery && instance.rules().battery_floor > 0;
    groups.extend(has_floor.then_some(Group::Floor));
    let rules = instance.rules_in_effect().into_iter();
    groups.extend(rules.map(Group::Constraint));
    sort(&mut groups);
    groups
}

/// Whether some move is slow.
pub(crate) fn has_slow_edge(grid: &Grid) -> bool {
    let mut slow = grid.cells().filter(|(_, ground)| ground.is_slow());
    slow.any(|(cell, _)| grid.neighbours(cell).any(|v| grid.is_slow_edge(cell, v)))
}

/// An instance without some facts.
#[derive(Clone, Debug)]
pub(crate) struct Variant {
    pub(crate) instance: Instance,
    pub(crate) relaxed: Relaxed,
    /// The horizon, where a person set one and it is not left out.
    pub(crate) within: Option<u32>,
}

/// The instance without some facts.
pub(crate) fn without(
    instance: &Instance,
    left_out: &BTreeSet<Group>,
    within: Option<u32>,
) -> Variant {
    let mut variant = instance.clone();
    let mut relaxed = Relaxed::default();
    let (mut free, mut off) = (BTreeSet::new(), BTreeSet::new());
    let mut within = within;
    // Agents that are left out move the numbers of those behind them.
    let gone = |a: usize| left_out.contains(&Group::Task(a));
    let number = |a: usize| a - (0..a).filter(|&b| gone(b)).count();
    for &group in left_out {
        match group {
            Group::Task(_) => {}
            Group::Waypoint(a, cell) => variant.drop_waypoint(a, cell),
            Group::Battery(a) => variant.drop_battery(a),
            Group::Obstacle(cell) => {
                free.insert(cell);
            }
            Group::Collision(a, b) => {
                if !gone(a) && !gone(b) {
                    relaxed.ignored.insert((number(a), number(b)));
                }
            }
            // (Of an agent that vanishes, there is no such fact.)
            Group::Stay(a) => {
                let keeps = instance
                    .agents()
                    .get(a)
                    .is_some_and(|it| instance.keeps(it));
                if !gone(a) && keeps {
                    relaxed.gone.insert(number(a));
                }
            }
            Group::Slow => variant.make_normal(|_| true),
            Group::Deadline => within = None,
            Group::Floor => variant = variant.with_battery_floor(0),
            Group::Constraint(rule) => {
                off.insert(rule);
            }
            Group::Breakdown(a, from) => {
                if let Some(agent) = instance.agents().get(a) {
                    let state = variant.start_state_mut(&agent.name);
                    state.breakdowns.retain(|it| it.from != from);
                }
            }
        }
    }
    if !off.is_empty() {
        variant.switch_off(|rule| off.contains(&rule));
    }
    if !free.is_empty() {
        variant.remove_obstacles(|cell| free.contains(&cell));
    }
    let mut index = 0;
    variant.retain_agents(|_| {
        index += 1;
        !gone(index - 1)
    });
    Variant {
        instance: variant,
        relaxed,
        within,
    }
}

/// A plan without what a variant has no place for: agents that are not there,
/// charges of batteries that are unlimited.
pub(crate) fn fit(plan: &Plan, instance: &Instance) -> Plan {
    let agent = |name: &String| instance.agents().iter().find(|a| a.name == *name);
    let mut plan = plan.clone();
    plan.paths.retain(|name, _| agent(name).is_some());
    plan.charges
        .retain(|name, _| agent(name).is_some_and(|a| a.battery.is_some()));
    for (name, path) in &mut plan.paths {
        let goal = agent(name).and_then(|a| a.goal);
        while ends_with_rest(path, goal) {
            path.pop();
        }
    }
    for (name, charges) in &mut plan.charges {
        let arrival = plan.paths.get(name).map_or(0, |path| path.len() as u32);
        charges.retain(|&charge| charge + 1 < arrival);
    }
    plan.charges.retain(|_, charges| !charges.is_empty());
    plan
}
