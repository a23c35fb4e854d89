//! Random warehouse floors of 40 x 24 cells: rack rows with aisles of one or two cells, cross
//! aisles, chargers at the left wall, a slow zone before the packing area at the right, robots
//! with batteries that start at both sides and have stops at the racks.

use std::collections::{BTreeSet, VecDeque};
use std::error::Error;

use fastrand::Rng;
use giveway_model::{Agent, Battery, Cell, Scene};

const WIDTH: u32 = 40;
const HEIGHT: u32 = 24;
/// The first column of the racks.
const RACKS: u32 = 4;

type Rows = Vec<Vec<char>>;

/// The floor of a seed.
///
/// # Errors
/// Where there is no room for its robots.
pub(super) fn floor(seed: u64) -> Result<Scene, Box<dyn Error>> {
    let mut rng = Rng::with_seed(seed);
    let robots = *pick(&mut rng, &[16, 20, 24, 30, 40]);
    let last = *pick(&mut rng, &[29, 30, 31]);
    let rows = rows(&mut rng, last);
    let reached = reached(&rows);
    let within = |from: u32, to: u32| {
        let cells = reached
            .iter()
            .filter(move |cell| (from..=to).contains(&cell.x));
        cells.copied().collect::<Vec<Cell>>()
    };
    let (mut left, mut right) = (within(1, 3), within(last + 2, WIDTH - 1));
    let is_free = |x: u32, y: u32| at(&rows, x, y).is_some_and(|ground| ground != '#');
    let mut stops = within(RACKS, last);
    stops.retain(|cell| !is_free(cell.x, cell.y.wrapping_sub(1)) || !is_free(cell.x, cell.y + 1));
    let mut starts = Vec::new();
    rng.shuffle(&mut left);
    rng.shuffle(&mut right);
    for robot in 0..robots {
        let side = if robot % 2 == 0 { &left } else { &right };
        starts.push(*side.get(robot / 2).ok_or("too few starts")?);
    }
    rng.shuffle(&mut left);
    rng.shuffle(&mut right);
    let mut agents = Vec::new();
    for (robot, start) in starts.into_iter().enumerate() {
        let side = if robot % 2 == 0 { &right } else { &left };
        let count = *pick(&mut rng, &[1, 1, 2, 2, 3]);
        rng.shuffle(&mut stops);
        let mut waypoints: Vec<Cell> = stops.iter().copied().take(count).collect();
        waypoints.sort();
        let initial = *pick(&mut rng, &[60, 70, 80]);
        let has_battery = rng.u8(..4) < 3;
        agents.push(Agent {
            name: format!("A{}", robot + 1),
            start,
            goal: side.get(robot / 2).copied(),
            waypoints,
            battery: has_battery.then_some(Battery {
                capacity: 80,
                initial,
            }),
            heading: None,
        });
    }
    Ok(Scene {
        map: rows.iter().map(|row| row.iter().collect()).collect(),
        agents,
        ..Scene::default()
    })
}

fn pick<'a, T>(rng: &mut Rng, all: &'a [T]) -> &'a T {
    &all[rng.usize(..all.len())]
}

fn at(rows: &Rows, x: u32, y: u32) -> Option<char> {
    rows.get(y as usize)?.get(x as usize).copied()
}

/// The map, with racks up to a column.
fn rows(rng: &mut Rng, last: u32) -> Rows {
    let mut rows = vec![vec!['.'; WIDTH as usize]; HEIGHT as usize];
    let mut put = |x: u32, y: u32, ground: char| {
        let row = rows.get_mut(y as usize);
        if let Some(cell) = row.and_then(|row| row.get_mut(x as usize)) {
            *cell = ground;
        }
    };
    let crossings = *pick(rng, &[0, 1, 1, 2]);
    let crossings: Vec<u32> = (0..crossings)
        .map(|_| rng.u32(RACKS + 6..last - 5))
        .collect();
    let mut y = rng.u32(2..=3);
    while y < HEIGHT - 3 {
        let depth = if rng.u8(..5) < 4 { 2 } else { 1 };
        for y in y..y + depth {
            for x in (RACKS..=last).filter(|x| !crossings.contains(x)) {
                put(x, y, '#');
            }
        }
        y += depth + if rng.u8(..10) < 7 { 1 } else { 2 };
    }
    let apart = *pick(rng, &[3, 4]);
    for y in (4..HEIGHT - 4).step_by(apart) {
        put(0, y, '+');
    }
    let (top, height) = (rng.u32(5..12), *pick(rng, &[5, 7]));
    for y in top..top + height {
        for x in last + 3..last + 6 {
            put(x, y, '~');
        }
    }
    rows
}

/// The free cells that are connected with the upper left.
fn reached(rows: &Rows) -> BTreeSet<Cell> {
    let mut seen = BTreeSet::from([Cell::new(1, 1)]);
    let mut queue = VecDeque::from([Cell::new(1, 1)]);
    while let Some(Cell { x, y }) = queue.pop_front() {
        let near = [
            (x + 1, y),
            (x.wrapping_sub(1), y),
            (x, y + 1),
            (x, y.wrapping_sub(1)),
        ];
        for (x, y) in near {
            let is_free = at(rows, x, y).is_some_and(|ground| ground != '#');
            if is_free && seen.insert(Cell::new(x, y)) {
                queue.push_back(Cell::new(x, y));
            }
        }
    }
    seen
}
