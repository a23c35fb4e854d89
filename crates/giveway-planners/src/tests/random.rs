//! Small instances made by chance.

use fastrand::Rng;
use giveway_model::{Agent, AtGoal, Battery, Cell, Instance, Scene};

/// An instance on a map of at most 4 x 3 cells, with all that there is:
/// obstacles, slow zones, chargers, waypoints, batteries, both rules at goals.
pub(crate) fn random(seed: u64, agents: usize) -> Instance {
    let mut rng = Rng::with_seed(seed);
    let mut scene = Scene::default();
    scene.rules.at_goal = [AtGoal::Stay, AtGoal::Vanish][rng.usize(..2)];
    scene.rules.battery_floor = [0, 0, 1][rng.usize(..3)];
    let grounds = [".......#~~++*", ".........##.", "~~~~~...#***"][rng.usize(..3)];
    let grounds: Vec<char> = grounds.chars().collect();
    loop {
        let (width, height) = (rng.u32(2..=4), rng.u32(2..=3));
        let mut row = || {
            (0..width)
                .map(|_| grounds[rng.usize(..grounds.len())])
                .collect()
        };
        scene.map = (0..height).map(|_| row()).collect();
        let cells = (0..height).flat_map(|y| (0..width).map(move |x| Cell::new(x, y)));
        let ground = |c: &Cell| scene.map[c.y as usize].as_bytes()[c.x as usize];
        let mut free: Vec<Cell> = cells.filter(|c| ground(c) != b'#').collect();
        if free.len() <= agents {
            continue;
        }
        scene.agents.clear();
        rng.shuffle(&mut free);
        let starts = free.clone();
        rng.shuffle(&mut free);
        let goals = free.clone();
        for i in 0..agents {
            rng.shuffle(&mut free);
            let capacity = rng.u32(1..=6);
            let battery = Battery {
                capacity,
                initial: rng.u32(0..=capacity),
            };
            scene.agents.push(Agent {
                name: i.to_string(),
                start: starts[i],
                goal: Some(goals[i]),
                waypoints: free[..rng.usize(..3).min(free.len())].to_vec(),
                battery: Some(battery).filter(|_| rng.bool()),
                heading: None,
            });
        }
        return Instance::new(scene).unwrap();
    }
}
