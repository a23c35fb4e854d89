//! Plans that an order alone would let wait for themselves: the one of `tests/none.rs`, turned and begun later.

use giveway_model::change::Changes;
use giveway_model::format::native::{read_instance, read_plan};
use giveway_model::{Agent, Cell, Scene};
use rand::RngExt as _;
use rand_chacha::ChaCha8Rng;

use crate::dress::Case;

/// The plan, mirrored or not along each side, rows as columns or not, after up to four waits of all robots.
pub(crate) fn random(rng: &mut ChaCha8Rng) -> Case {
    let scene = read_instance(include_str!("../data/waits-for-itself.json"));
    let scene = scene.unwrap().to_scene();
    let mut plan = read_plan(include_str!("../data/waits-for-itself.plan.json")).unwrap();
    let (width, height) = (scene.map[0].len() as u32, scene.map.len() as u32);
    let [across, down, turned] = [(); 3].map(|()| rng.random_bool(0.5));
    let place = |cell: Cell| {
        let x = if across { width - 1 - cell.x } else { cell.x };
        let y = if down { height - 1 - cell.y } else { cell.y };
        if turned {
            Cell::new(y, x)
        } else {
            Cell::new(x, y)
        }
    };
    let (columns, rows) = if turned {
        (height, width)
    } else {
        (width, height)
    };
    let mut map = vec![vec!['.'; columns as usize]; rows as usize];
    for (y, row) in scene.map.iter().enumerate() {
        for (x, ground) in row.chars().enumerate() {
            let cell = place(Cell::new(x as u32, y as u32));
            map[cell.y as usize][cell.x as usize] = ground;
        }
    }
    let waits = rng.random_range(0..=4);
    for path in plan.paths.values_mut() {
        let turned = path.iter().map(|cell| cell.map(place));
        let first = path.first().copied().flatten().map(place);
        *path = vec![first; waits].into_iter().chain(turned).collect();
    }
    let agents = scene.agents.iter().map(|agent| Agent {
        start: place(agent.start),
        goal: agent.goal.map(place),
        ..agent.clone()
    });
    Case {
        scene: Scene {
            map: map.into_iter().map(String::from_iter).collect(),
            agents: agents.collect(),
            ..scene.clone()
        },
        changes: Changes::default(),
        plan,
    }
}
