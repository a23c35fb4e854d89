//! Random walks of several robots that do not collide, slow edges and rotations included.

use std::collections::BTreeMap;

use giveway_model::{Cell, Grid};
use rand::RngExt as _;
use rand::seq::SliceRandom as _;
use rand_chacha::ChaCha8Rng;

/// A robot's walk from a time on.
#[derive(Clone, Debug)]
pub(crate) struct Walk {
    pub(crate) from: u32,
    /// The time before which it is taken away.
    pub(crate) until: Option<u32>,
    /// The time after which it is gone, where it vanishes.
    pub(crate) ends: Option<u32>,
    pub(crate) path: Vec<Option<Cell>>,
}

impl Walk {
    fn is_there(&self, time: u32) -> bool {
        self.from <= time
            && self.until.is_none_or(|until| time < until)
            && self.ends.is_none_or(|ends| time <= ends)
    }

    fn at(&self, time: u32) -> Option<Cell> {
        let index = time.checked_sub(self.from)?;
        self.path.get(index as usize).copied().flatten()
    }
}

#[derive(Clone, Copy, Debug, PartialEq)]
struct Going {
    from: Cell,
    to: Cell,
    slow: bool,
}

/// Walks until a time; `None` where they got stuck. `grid` is the map at each time.
pub(crate) fn walk(
    walks: &mut [Walk],
    grid: &dyn Fn(u32) -> Grid,
    last: u32,
    rng: &mut ChaCha8Rng,
) -> Option<()> {
    let restless = rng.random_range(0.3..0.95);
    let daring = rng.random_bool(0.5);
    // Who is half way: from, to.
    let mut transit: BTreeMap<usize, Going> = BTreeMap::new();
    appear(walks, &grid(0), 0, &transit, rng)?;
    for time in 0..last {
        let map = grid(time);
        let reserved: Vec<Cell> = transit.values().map(|it| it.to).collect();
        let mut goings: BTreeMap<usize, Going> = BTreeMap::new();
        for (robot, walk) in walks.iter().enumerate() {
            let Some(from) = walk.at(time).filter(|_| walk.is_there(time + 1)) else {
                continue;
            };
            let must = reserved.contains(&from);
            if must || rng.random_bool(restless) {
                let mut next: Vec<Cell> = map.neighbours(from).collect();
                next.shuffle(rng);
                let next = next.into_iter().find(|it| !reserved.contains(it));
                if let Some(to) = next {
                    let slow = map.is_slow_edge(from, to);
                    let in_time = !slow || (time + 2 <= last && walk.is_there(time + 2));
                    if in_time {
                        goings.insert(robot, Going { from, to, slow });
                    }
                }
            }
        }
        if rng.random_bool(0.5) {
            rotate(walks, time, &map, &mut goings, rng);
        }
        settle(walks, time, &transit, &mut goings, daring, rng);
        let landing = std::mem::take(&mut transit);
        for (robot, walk) in walks.iter_mut().enumerate() {
            if !walk.is_there(time + 1) || walk.from > time {
                continue;
            }
            let entry = match (landing.get(&robot), goings.get(&robot)) {
                (None, Some(going)) if going.slow => {
                    transit.insert(robot, *going);
                    None
                }
                (Some(going), _) | (None, Some(going)) => Some(going.to),
                (None, None) => walk.at(time),
            };
            walk.path.push(entry);
        }
        appear(walks, &grid(time + 1), time + 1, &transit, rng)?;
        let cells: Vec<Cell> = walks.iter().filter_map(|it| it.at(time + 1)).collect();
        let mut sorted = cells.clone();
        sorted.sort();
        sorted.dedup();
        if sorted.len() < cells.len() {
            return None; // a daring slow move
        }
    }
    Some(())
}

/// Puts those on the floor that appear at a time.
fn appear(
    walks: &mut [Walk],
    grid: &Grid,
    time: u32,
    transit: &BTreeMap<usize, Going>,
    rng: &mut ChaCha8Rng,
) -> Option<()> {
    for robot in 0..walks.len() {
        if walks[robot].from != time {
            continue;
        }
        let mut cells: Vec<Cell> = grid.cells().map(|(cell, _)| cell).collect();
        cells.retain(|&cell| {
            grid.is_vertex(cell)
                && walks.iter().all(|it| it.at(time) != Some(cell))
                && transit.values().all(|it| it.to != cell)
        });
        cells.shuffle(rng);
        let cell = cells.pop()?;
        walks[robot].path.push(Some(cell));
    }
    Some(())
}

/// Lets a full block of four cells rotate.
fn rotate(
    walks: &[Walk],
    time: u32,
    grid: &Grid,
    goings: &mut BTreeMap<usize, Going>,
    rng: &mut ChaCha8Rng,
) {
    let mut corners: Vec<Cell> = grid.cells().map(|(cell, _)| cell).collect();
    corners.shuffle(rng);
    for Cell { x, y } in corners {
        let mut ring = [(x, y), (x + 1, y), (x + 1, y + 1), (x, y + 1)].map(|(x, y)| Cell { x, y });
        if rng.random_bool(0.5) {
            ring.reverse();
        }
        let robots = ring.map(|cell| walks.iter().position(|it| it.at(time) == Some(cell)));
        let ready = robots
            .iter()
            .flatten()
            .all(|&it| walks[it].is_there(time + 2));
        let slow = (0..4).map(|i| grid.is_slow_edge(ring[i], ring[(i + 1) % 4]));
        let slow: Vec<bool> = slow.collect();
        if robots.iter().all(Option::is_some) && ready && slow.iter().all(|it| *it == slow[0]) {
            for i in 0..4 {
                let (from, to) = (ring[i], ring[(i + 1) % 4]);
                goings.insert(
                    robots[i].unwrap(),
                    Going {
                        from,
                        to,
                        slow: slow[i],
                    },
                );
            }
            return;
        }
    }
}

/// Takes back goings until none collides.
fn settle(
    walks: &[Walk],
    time: u32,
    transit: &BTreeMap<usize, Going>,
    goings: &mut BTreeMap<usize, Going>,
    daring: bool,
    rng: &mut ChaCha8Rng,
) {
    loop {
        // Who is where one step later.
        let mut next: BTreeMap<Cell, Vec<usize>> = BTreeMap::new();
        for (robot, walk) in walks.iter().enumerate() {
            if !walk.is_there(time + 1) || walk.from > time {
                continue;
            }
            let cell = match (transit.get(&robot), goings.get(&robot)) {
                (Some(going), _) => Some(going.to),
                (None, Some(going)) => (!going.slow).then_some(going.to),
                (None, None) => walk.at(time),
            };
            if let Some(cell) = cell {
                next.entry(cell).or_default().push(robot);
            }
        }
        let mut bad: Vec<usize> = Vec::new();
        for (&robot, going) in goings.iter() {
            let taken = next
                .get(&going.to)
                .is_some_and(|it| it.iter().any(|&it| it != robot));
            let same = |(&other, it): (&usize, &Going)| other != robot && it.to == going.to;
            let is_bad = if going.slow {
                goings.iter().any(|it| it.1.slow && same(it)) || (taken && !daring)
            } else {
                taken || transit.values().any(|it| it.to == going.to)
            };
            let back = |it: &Going| it.from == going.to && it.to == going.from;
            if is_bad || goings.values().any(back) || transit.values().any(back) {
                bad.push(robot);
            }
        }
        bad.shuffle(rng);
        let Some(robot) = bad.pop() else {
            return;
        };
        goings.remove(&robot);
    }
}
