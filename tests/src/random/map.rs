//! Random maps.

use giveway_model::Cell;
use rand::RngExt;
use rand::seq::IndexedRandom;
use rand_chacha::ChaCha8Rng;

/// A map under construction.
pub(super) struct Map {
    pub(super) rows: Vec<Vec<char>>,
    pub(super) free: Vec<Cell>,
}

impl Map {
    /// Obstacles with a probability, perhaps a slow rectangle, perhaps chargers.
    pub(super) fn new(
        random: &mut ChaCha8Rng,
        width: usize,
        height: usize,
        obstacles: f64,
    ) -> Self {
        let mut rows = vec![vec!['.'; width]; height];
        let slow = random.random_bool(0.5).then(|| {
            let (x, y) = (
                random.random_range(0..width),
                random.random_range(0..height),
            );
            (
                x..=x + random.random_range(1..=3),
                y..=y + random.random_range(0..=2),
            )
        });
        let chargers = *[0.0, 0.1, 0.25].choose(random).unwrap();
        for (y, row) in rows.iter_mut().enumerate() {
            for (x, c) in row.iter_mut().enumerate() {
                let is_slow = slow
                    .as_ref()
                    .is_some_and(|(xs, ys)| xs.contains(&x) && ys.contains(&y));
                let is_charger = random.random_bool(chargers);
                *c = match (random.random_bool(obstacles), is_slow, is_charger) {
                    (true, _, _) => '#',
                    (_, true, true) => '*',
                    (_, true, _) => '~',
                    (_, _, true) => '+',
                    _ => '.',
                };
            }
        }
        let mut map = Self {
            rows,
            free: Vec::new(),
        };
        map.free = map
            .cells()
            .filter(|&(_, c)| c != '#')
            .map(|(cell, _)| cell)
            .collect();
        map
    }

    pub(super) fn cells(&self) -> impl Iterator<Item = (Cell, char)> + '_ {
        self.rows.iter().enumerate().flat_map(|(y, row)| {
            let cell = move |(x, &c): (usize, &char)| (Cell::new(x as u32, y as u32), c);
            row.iter().enumerate().map(cell)
        })
    }

    /// The same map, of whose free cells only those count that are connected
    /// with the first.
    pub(super) fn connected(mut self) -> Self {
        let mut reached: Vec<Cell> = self.free.iter().take(1).copied().collect();
        let mut next = 0;
        while let Some(&u) = reached.get(next) {
            next += 1;
            for &v in &self.free {
                if u.touches(v) && !reached.contains(&v) {
                    reached.push(v);
                }
            }
        }
        self.free = reached;
        self
    }
}
