//! One agent alone: moves, waypoints, arrival, battery.

mod asked;
mod costs;
mod rules;
mod zones;

use std::collections::BTreeMap;

use giveway_model::{Agent, Cell, sorting};

use super::distance::Distances;
use super::{Cnf, Lit, Name, World};

pub(super) use zones::Moment;

/// The variables of one agent.
pub(super) struct Walker<'a> {
    world: World<'a>,
    agent: &'a Agent,
    /// At each time, the cells where it may be.
    at: Vec<BTreeMap<Cell, Lit>>,
    /// At each time, the slow moves of which it may be half way.
    transit: Vec<BTreeMap<(Cell, Cell), Lit>>,
    /// At each time, whether it has arrived.
    done: Vec<Lit>,
    /// For each waypoint, at each time, whether it has been there.
    seen: Vec<(Cell, Vec<Lit>)>,
    /// At each time but the last, whether it charges, where it could.
    charge: Vec<Option<Lit>>,
}

impl<'a> Walker<'a> {
    /// Makes the variables.
    pub(super) fn new(cnf: &mut Cnf, world: World<'a>) -> Self {
        let World {
            instance,
            index,
            last,
            by,
        } = world;
        let (grid, agent) = (instance.grid(), &instance.agents()[index]);
        let from_start = Distances::from(grid, agent.start);
        let to_goal = agent.goal.map(|goal| Distances::from(grid, goal));
        // Where the goal is too far there would be no variable at all, and a
        // proof about nothing: then only the distance from the start counts.
        let to_goal = to_goal.filter(|to_goal| {
            let steps = to_goal.to(agent.start);
            steps.is_some_and(|steps| steps <= by)
        });
        let may_be = |cell: Cell, time: u32| {
            from_start.to(cell).is_some_and(|steps| steps <= time)
                && to_goal.as_ref().is_none_or(|to_goal| {
                    let steps = to_goal.to(cell);
                    steps.is_some_and(|steps| steps <= by.saturating_sub(time))
                })
        };
        let cells: Vec<Cell> = grid
            .cells()
            .filter_map(|(cell, ground)| ground.is_vertex().then_some(cell))
            .collect();
        let mut at = Vec::new();
        for time in 0..=last {
            let here = cells.iter().filter(|&&cell| may_be(cell, time));
            let named = here.map(|&cell| (cell, cnf.variable(Name::At(index, cell, time))));
            at.push(sorting::map(named));
        }
        let mut transit = vec![BTreeMap::new(); last as usize + 1];
        for time in 1..last {
            for &u in &cells {
                for v in grid.neighbours(u) {
                    let t = time as usize;
                    if grid.is_slow_edge(u, v)
                        && at[t - 1].contains_key(&u)
                        && at[t + 1].contains_key(&v)
                    {
                        let lit = cnf.variable(Name::Transit(index, u, v, time));
                        transit[t].insert((u, v), lit);
                    }
                }
            }
        }
        let times = |cnf: &mut Cnf, name: &dyn Fn(u32) -> Name| -> Vec<Lit> {
            (0..=last).map(|time| cnf.variable(name(time))).collect()
        };
        let done = times(cnf, &|time| Name::Done(index, time));
        let seen = agent.waypoints.iter().map(|&waypoint| {
            let seen = times(cnf, &|time| Name::Seen(index, waypoint, time));
            (waypoint, seen)
        });
        let seen = seen.collect();
        let charge = (0..last).map(|time| {
            let at_charger = at[time as usize].keys().any(|&cell| grid.is_charger(cell));
            (agent.battery.is_some() && at_charger).then(|| cnf.variable(Name::Charge(index, time)))
        });
        let charge = charge.collect();
        Self {
            world,
            agent,
            at,
            transit,
            done,
            seen,
            charge,
        }
    }

    /// All rules of this agent alone.
    pub(super) fn rules(&self, cnf: &mut Cnf) {
        self.be_somewhere(cnf);
        self.step(cnf);
        self.visit(cnf);
        self.arrive(cnf);
        self.use_battery(cnf);
    }
}
