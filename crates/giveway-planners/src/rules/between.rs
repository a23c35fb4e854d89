//! Rules between agents: zones with a limit, gaps, distances.

use giveway_model::{
    Cell,
    condition::Times,
    constraint::{ConstraintKind, InForce, meant},
};

use super::OwnRules;
use crate::{
    AgentId,
    single::{Area, Place},
    terrain::{NO_VERTEX, Terrain, Vertex},
};

/// All rules between agents.
#[derive(Clone, Debug, Default)]
pub struct Between {
    /// The rules.
    pub rules: Vec<Shared>,
}

/// A rule between agents.
#[derive(Clone, Debug)]
pub struct Shared {
    /// Its number in the scene.
    pub index: usize,
    /// Whether it binds an agent, by number.
    pub members: Vec<bool>,
    /// The agents that it does not count in its area until they have left it, ascending.
    pub uncounted: Vec<AgentId>,
    /// What it demands of them.
    pub kind: SharedKind,
}

/// What a rule between agents demands.
#[derive(Clone, Debug)]
pub enum SharedKind {
    /// At most so many are in an area at each of these times.
    Capacity {
        /// The area.
        area: Area,
        /// How many, at least 1.
        most: u32,
        /// When.
        times: Times,
    },
    /// No other one is at a vertex within so many steps behind one.
    Gap {
        /// The steps, at least 1.
        steps: u32,
    },
    /// Any two have at least this distance at each of these times.
    Apart {
        /// The distance, in cells.
        distance: u32,
        /// When.
        times: Times,
    },
}

impl OwnRules<'_> {
    pub(super) fn shared(&self, rule: &InForce<'_>, agents: usize) -> Option<Shared> {
        let (kind, fewest) = match &rule.constraint.kind {
            ConstraintKind::Capacity { zone, most, times } if *most > 0 => {
                let area = self.area(zone);
                let (most, times) = (*most, meant(*times));
                let kind = SharedKind::Capacity { area, most, times };
                (kind, (most as usize).saturating_add(1))
            }
            ConstraintKind::Gap { steps } => (SharedKind::Gap { steps: *steps }, 2),
            ConstraintKind::Apart { distance, times } => {
                let times = meant(*times);
                let distance = *distance;
                (SharedKind::Apart { distance, times }, 2)
            }
            // Each agent keeps these by itself; a precedence is apart.
            ConstraintKind::Capacity { .. }
            | ConstraintKind::Closed { .. }
            | ConstraintKind::OneWay { .. }
            | ConstraintKind::Sequence { .. }
            | ConstraintKind::Visit { .. }
            | ConstraintKind::Arrive { .. }
            | ConstraintKind::Late { .. }
            | ConstraintKind::Depart { .. }
            | ConstraintKind::Before { .. }
            | ConstraintKind::NoWaiting { .. }
            | ConstraintKind::Turns { .. }
            | ConstraintKind::Avoid { .. } => return None,
        };
        // Fewer agents cannot break it.
        (rule.agents.len() >= fewest).then(|| Shared {
            index: rule.index,
            members: (0..agents)
                .map(|agent| rule.agents.binary_search(&agent).is_ok())
                .collect(),
            uncounted: {
                let agents = rule.agents.iter().copied();
                let is_uncounted = |&agent: &AgentId| {
                    let state = self.state(agent);
                    state.uncounted.contains(&rule.index)
                };
                agents.filter(is_uncounted).collect()
            },
            kind,
        })
    }
}

impl Shared {
    /// Whether it binds an agent.
    pub fn binds(&self, agent: AgentId) -> bool {
        self.members.get(agent) == Some(&true)
    }

    /// Whether it does not count an agent in its area until that has left it.
    pub fn begins_uncounted(&self, agent: AgentId) -> bool {
        self.uncounted.contains(&agent)
    }

    /// The times that it names.
    pub const fn times(&self) -> Times {
        match self.kind {
            SharedKind::Capacity { times, .. } | SharedKind::Apart { times, .. } => times,
            SharedKind::Gap { .. } => Times {
                from: None,
                to: None,
            },
        }
    }
}

impl Between {
    /// Whether there are none.
    pub const fn is_empty(&self) -> bool {
        self.rules.is_empty()
    }

    /// The longest gap.
    pub fn gap(&self) -> u32 {
        let gaps = self.rules.iter().map(|rule| match rule.kind {
            SharedKind::Gap { steps } => steps,
            SharedKind::Capacity { .. } | SharedKind::Apart { .. } => 0,
        });
        gaps.max().unwrap_or(0)
    }

    /// The last time at which it matters which time it is; `None` where none does.
    pub fn last_time(&self) -> Option<u32> {
        let named = self.rules.iter().flat_map(|rule| {
            let times = rule.times();
            times
                .from
                .filter(|&from| from > 0)
                .into_iter()
                .chain(times.to)
        });
        named.max()
    }

    /// The last time from which on a rule begins to hold.
    pub fn last_begin(&self) -> u32 {
        let begins = self.rules.iter().map(|rule| rule.times().first());
        begins.max().unwrap_or(0)
    }
}

/// The vertices that a place counts at for zones and distances: both ends in transit.
pub fn touched(terrain: &Terrain, place: Place) -> impl Iterator<Item = Vertex> + use<> {
    let (one, other) = match place {
        Place::At(v) => (v, None),
        Place::Along(arc) => {
            let (from, to) = terrain.ends(arc);
            (to, Some(from))
        }
    };
    // (In transit at time 0, it may come from a cell that is an obstacle now.)
    let other = other.filter(|&from| from != NO_VERTEX);
    std::iter::once(one).chain(other)
}

/// The vertices nearer to a vertex than a distance, itself among them.
pub fn near(terrain: &Terrain, v: Vertex, distance: u32) -> impl Iterator<Item = Vertex> + '_ {
    let Cell { x, y } = terrain.cell(v);
    let last = terrain.last_cell();
    let within = distance.saturating_sub(1);
    let rows = y.saturating_sub(within)..=y.saturating_add(within).min(last.y);
    rows.flat_map(move |row| {
        let left = within - row.abs_diff(y);
        let columns = x.saturating_sub(left)..=x.saturating_add(left).min(last.x);
        columns.filter_map(move |column| terrain.vertex(Cell::new(column, row)))
    })
}
