//! Plain instances made by chance, and what they are worth by a search of all
//! configurations.

use std::collections::{BTreeMap, BTreeSet};

use fastrand::Rng;
use giveway_model::{Agent, AtGoal, Cell, Instance, Scene};

/// An instance of starts and goals alone, on a map with some obstacles.
pub(crate) fn plain(
    seed: u64,
    agents: usize,
    [width, height]: [u32; 2],
    obstacles: u32,
) -> Instance {
    let mut rng = Rng::with_seed(seed);
    let mut scene = Scene::default();
    scene.rules.at_goal = [AtGoal::Stay, AtGoal::Vanish][rng.usize(..2)];
    loop {
        let mut ground = || if rng.u32(..100) < obstacles { '#' } else { '.' };
        let rows = (0..height).map(|_| (0..width).map(|_| ground()).collect());
        scene.map = rows.collect();
        let cells = (0..height).flat_map(|y| (0..width).map(move |x| Cell::new(x, y)));
        let mut free: Vec<Cell> = cells
            .filter(|c| scene.map[c.y as usize].as_bytes()[c.x as usize] == b'.')
            .collect();
        if free.len() < agents {
            continue;
        }
        rng.shuffle(&mut free);
        let starts = free.clone();
        rng.shuffle(&mut free);
        let ways = starts.iter().zip(&free).take(agents).enumerate();
        let agent = |(i, (&start, &goal)): (usize, (&Cell, &Cell))| Agent {
            name: i.to_string(),
            start,
            goal: Some(goal),
            waypoints: Vec::new(),
            battery: None,
            heading: None,
        };
        scene.agents = ways.map(agent).collect();
        return Instance::new(scene).unwrap();
    }
}

/// The least sum of losses of a plan in which agents stay at their goals, by
/// all configurations in the order of their losses; `None` where there is none.
pub(crate) fn least_loss(instance: &Instance) -> Option<u32> {
    let cells = |cell: fn(&Agent) -> Cell| instance.agents().iter().map(cell).collect();
    let (start, goals): (Vec<Cell>, Vec<Cell>) = (
        cells(|a| a.start),
        cells(giveway_model::Agent::goal_or_start),
    );
    let mut open: BTreeMap<u32, BTreeSet<Vec<Cell>>> = BTreeMap::new();
    open.entry(0).or_default().insert(start);
    let mut closed = BTreeSet::new();
    while let Some((loss, layer)) = open.pop_first() {
        let mut layer: Vec<Vec<Cell>> = layer.into_iter().collect();
        while let Some(now) = layer.pop() {
            if now == goals {
                return Some(loss);
            }
            if !closed.insert(now.clone()) {
                continue;
            }
            for next in successors(instance, &now) {
                let resting = |i: &usize| now[*i] == goals[*i] && next[*i] == goals[*i];
                let lost = (0..now.len()).filter(|i| !resting(i)).count() as u32;
                if lost == 0 {
                    layer.push(next);
                } else {
                    open.entry(loss + lost).or_default().insert(next);
                }
            }
        }
    }
    None
}

/// All configurations one step later.
fn successors(instance: &Instance, now: &[Cell]) -> Vec<Vec<Cell>> {
    let mut partial: Vec<Vec<Cell>> = vec![Vec::new()];
    for (i, &at) in now.iter().enumerate() {
        let ways = [(0, 0), (1, 0), (0, 1), (-1, 0), (0, -1)].map(|(x, y)| {
            Some(Cell::new(
                at.x.checked_add_signed(x)?,
                at.y.checked_add_signed(y)?,
            ))
        });
        let ways = ways.into_iter().flatten();
        let ways: Vec<Cell> = ways.filter(|&c| instance.grid().is_vertex(c)).collect();
        let mut longer = Vec::new();
        for before in partial {
            for &to in &ways {
                let meets = |j: usize| before[j] == to || (before[j] == at && now[j] == to);
                if !(0..i).any(meets) {
                    longer.push([before.as_slice(), &[to]].concat());
                }
            }
        }
        partial = longer;
    }
    partial
}
