//! Another walk of one agent, with all others on the ways that they have, only at other times.
//!
//! The others pass each cell in the order of the plan; who would be in the way of the walk, or is
//! behind somebody who waits, is later. So plans are executed whose agents are late (Hönig et
//! al., 2016).

use std::collections::BTreeMap;

use giveway_model::{Cell, Path, Plan};

/// The plan in which an agent takes its path in any case, and the others wait where they have to;
/// `None` where they cannot let it pass so, or arrive later than `latest`.
///
/// The judge has the last word: what waiting does to batteries and rules is not looked at here.
pub(super) fn retimed(plan: &Plan, agent: &str, latest: u32) -> Option<Plan> {
    let path = plan.paths.get(agent)?;
    let others = plan.paths.iter().filter(|(name, _)| *name != agent);
    let (names, paths): (Vec<&String>, Vec<&Path>) = others.unzip();
    let mut retiming = Retiming {
        visits: visits(&paths),
        places: vec![0; paths.len()],
        taken: vec![vec![0]; paths.len()],
        paths,
        path,
    };
    for time in 0..latest as usize {
        if retiming.is_done(time) {
            return Some(retiming.plan(plan, &names));
        }
        retiming.step(time)?;
    }
    None
}

/// Who is at each cell in the plan, and when: the agent's place among the others.
type Visits = BTreeMap<Cell, Vec<(usize, usize)>>;

fn visits(paths: &[&Path]) -> Visits {
    let mut visits = Visits::new();
    for (other, path) in paths.iter().enumerate() {
        for (time, cell) in path.iter().enumerate() {
            if let Some(cell) = cell {
                visits.entry(*cell).or_default().push((time, other));
            }
        }
    }
    visits
}

struct Retiming<'a> {
    visits: Visits,
    /// The paths of the others in the plan.
    paths: Vec<&'a Path>,
    /// How far each has come on its path.
    places: Vec<usize>,
    /// The places of each up to now, by time.
    taken: Vec<Vec<usize>>,
    /// The path of the agent.
    path: &'a Path,
}

impl Retiming<'_> {
    fn is_done(&self, time: usize) -> bool {
        let mut others = self.places.iter().zip(&self.paths);
        time + 1 >= self.path.len() && others.all(|(place, path)| place + 1 >= path.len())
    }

    /// The entry of the agent; its last one once it has arrived.
    fn agent_at(&self, time: usize) -> Option<Cell> {
        let last = self.path.len().saturating_sub(1);
        self.path.get(time.min(last)).copied().flatten()
    }

    fn cell(&self, other: usize, place: usize) -> Option<Cell> {
        self.paths.get(other)?.get(place).copied().flatten()
    }

    /// One step: as many as can go on do; `None` where somebody is in the agent's way.
    fn step(&mut self, time: usize) -> Option<()> {
        let mut next: Vec<usize> = self.places.iter().map(|place| place + 1).collect();
        for (place, path) in next.iter_mut().zip(&self.paths) {
            *place = (*place).min(path.len().saturating_sub(1));
        }
        // Who cannot go on stays, which may hold up others.
        loop {
            let moves = (0..next.len()).filter(|&it| next.get(it) != self.places.get(it));
            let Some(held) = moves.into_iter().find(|&it| self.is_held(it, &next, time)) else {
                break;
            };
            let now = *self.places.get(held)?;
            // Nobody stays on the way of a slow move.
            self.cell(held, now)?;
            *next.get_mut(held)? = now;
        }
        let agent = self.agent_at(time + 1);
        for (other, &place) in next.iter().enumerate() {
            if agent.is_some() && self.cell(other, place) == agent {
                return None;
            }
        }
        for (taken, &place) in self.taken.iter_mut().zip(&next) {
            taken.push(place);
        }
        self.places = next;
        Some(())
    }

    /// Whether another agent cannot go on as it would, where all go on as in `next`.
    fn is_held(&self, other: usize, next: &[usize], time: usize) -> bool {
        let (Some(&now), Some(&then)) = (self.places.get(other), next.get(other)) else {
            return true;
        };
        let (from, Some(to)) = (self.cell(other, now), self.cell(other, then)) else {
            return false; // on a slow move
        };
        let meets = |before: Option<Cell>, after: Option<Cell>| {
            after == Some(to) || (before == Some(to) && after == from && from != Some(to))
        };
        if meets(self.agent_at(time), self.agent_at(time + 1)) {
            return true;
        }
        let mut others = self.places.iter().zip(next).enumerate();
        if others.any(|(it, (&before, &after))| {
            it != other && meets(self.cell(it, before), self.cell(it, after))
        }) {
            return true;
        }
        let visits = self.visits.get(&to).into_iter().flatten();
        let mut earlier = visits.filter(|(when, it)| *when < then && *it != other);
        earlier.any(|(when, it)| next.get(*it).is_some_and(|place| place <= when))
    }

    /// The plan of the others, in which the agent has its path from before.
    fn plan(&self, plan: &Plan, names: &[&String]) -> Plan {
        let mut retimed = plan.clone();
        for (other, (&name, taken)) in names.iter().zip(&self.taken).enumerate() {
            let end = self
                .paths
                .get(other)
                .map_or(0, |path| path.len().saturating_sub(1));
            let arrived = taken.iter().position(|&place| place == end);
            let taken = arrived.and_then(|it| taken.get(..=it)).unwrap_or(taken);
            let path = taken.iter().map(|&place| self.cell(other, place));
            retimed.paths.insert(name.clone(), path.collect());
            for charge in retimed.charges.get_mut(name).into_iter().flatten() {
                // It charges in the last step at that place.
                let when = taken.iter().rposition(|&place| place == *charge as usize);
                *charge = when.map_or(*charge, |when| when as u32);
            }
        }
        retimed
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn plan(paths: &[(&str, &[(u32, u32)])]) -> Plan {
        let mut plan = Plan::default();
        for (name, cells) in paths {
            let path = cells.iter().map(|&(x, y)| Some(Cell::new(x, y)));
            plan.paths.insert((*name).to_owned(), path.collect());
        }
        plan
    }

    /// B would meet A at (1, 1), and C follows B.
    #[test]
    fn those_in_the_way_wait_and_so_do_those_behind_them() {
        let way_of_a: &[(u32, u32)] = &[(0, 1), (1, 1), (2, 1)];
        let before = plan(&[
            ("A", way_of_a),
            ("B", &[(1, 0), (1, 1), (1, 2)]),
            ("C", &[(0, 0), (1, 0)]),
        ]);
        let after = plan(&[
            ("A", way_of_a),
            ("B", &[(1, 0), (1, 0), (1, 1), (1, 2)]),
            ("C", &[(0, 0), (0, 0), (1, 0)]),
        ]);
        assert_eq!(retimed(&before, "A", 9), Some(after));
        assert_eq!(retimed(&before, "A", 2), None, "too late");
    }

    #[test]
    fn who_stays_in_the_way_lets_nobody_pass() {
        let head_on = plan(&[
            ("A", &[(0, 0), (1, 0), (2, 0)]),
            ("B", &[(2, 0), (1, 0), (0, 0)]),
        ]);
        assert_eq!(retimed(&head_on, "A", 20), None);
        let at_rest = plan(&[("A", &[(0, 0), (1, 0)]), ("B", &[(1, 0)])]);
        assert_eq!(retimed(&at_rest, "A", 20), None);
    }
}
