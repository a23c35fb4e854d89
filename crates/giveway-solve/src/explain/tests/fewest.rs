//! The fewest broken rules, against a search of all joint states.

use std::cmp::Reverse;
use std::collections::{BTreeMap, BinaryHeap};
use std::rc::Rc;

use giveway_model::{Cell, Instance, Scene};

use crate::{
    Limits, SilentHost,
    budget::Budget,
    explain::soft,
    tests::{Lone, Spot, State, random},
};

fn budget() -> Rc<Budget<'static>> {
    Rc::new(Budget::new(&SilentHost, Limits::default()))
}

/// One agent: on its way, holding its goal for the last time, or gone.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum One {
    Going(State),
    Ends(Cell),
    Gone,
}

struct Two<'i> {
    agents: [Lone<'i>; 2],
    stays: bool,
    /// What a joint step costs, and whether it is allowed.
    price: &'i dyn Fn([One; 2], [One; 2]) -> Option<u32>,
}

impl Two<'_> {
    fn onward(&self, i: usize, one: One) -> Vec<One> {
        let ends = |state: State| match state.spot {
            Spot::At(cell) if self.agents[i].is_end(&state) => Some(One::Ends(cell)),
            _ => None,
        };
        match one {
            One::Going(state) => {
                let next = self.agents[i].onward(&state);
                next.into_iter()
                    .flat_map(|(next, _)| [Some(One::Going(next)), ends(next)])
                    .flatten()
                    .collect()
            }
            One::Ends(cell) if self.stays => vec![One::Ends(cell)],
            One::Ends(_) | One::Gone => vec![One::Gone],
        }
    }

    /// The least price of a plan of both.
    fn least(&self) -> Option<u32> {
        let first = |i: usize| {
            let start = self.agents[i].start()?;
            let mut starts = vec![One::Going(start)];
            if let Spot::At(cell) = start.spot
                && self.agents[i].is_end(&start)
            {
                starts.push(One::Ends(cell));
            }
            Some(starts)
        };
        let mut heap = BinaryHeap::new();
        for a in first(0)? {
            for &b in &first(1)? {
                heap.push(Reverse((0, [a, b])));
            }
        }
        let mut best: BTreeMap<[One; 2], u32> = BTreeMap::new();
        while let Some(Reverse((paid, now))) = heap.pop() {
            if best.get(&now).is_some_and(|&other| other <= paid) {
                continue;
            }
            best.insert(now, paid);
            if !now.iter().any(|one| matches!(one, One::Going(_))) {
                return Some(paid);
            }
            for a in self.onward(0, now[0]) {
                for &b in &self.onward(1, now[1]) {
                    if let Some(price) = (self.price)(now, [a, b]) {
                        heap.push(Reverse((paid + price, [a, b])));
                    }
                }
            }
        }
        None
    }
}

fn spot(one: One) -> Option<Spot> {
    match one {
        One::Going(state) => Some(state.spot),
        One::Ends(cell) => Some(Spot::At(cell)),
        One::Gone => None,
    }
}

/// The collisions of a joint step: at its end, or on its way.
fn collisions(now: [One; 2], next: [One; 2]) -> u32 {
    let [a, b] = now.map(spot);
    let [c, d] = next.map(spot);
    let (Some(a), Some(b), Some(c), Some(d)) = (a, b, c, d) else {
        return 0;
    };
    let vertex = matches!((c, d), (Spot::At(u), Spot::At(v)) if u == v);
    let swap = match (a, b, c, d) {
        (Spot::At(p), Spot::At(q), Spot::At(r), Spot::At(s)) => p != q && p == s && q == r,
        _ => false,
    };
    // The later of two slow moves begins now; the other began now or one before.
    let enters = |from, to| match (from, to) {
        (Spot::At(_), Spot::Amid(u, v)) => Some((u, v)),
        _ => None,
    };
    let slow = match (enters(a, c), enters(b, d)) {
        (Some((u, v)), Some((w, x))) => (u, v) == (x, w),
        (Some((u, v)), None) => b == Spot::Amid(v, u),
        (None, Some((u, v))) => a == Spot::Amid(v, u),
        (None, None) => false,
    };
    u32::from(vertex) + u32::from(swap) + u32::from(slow)
}

#[test]
fn no_plan_has_fewer_collisions() {
    let mut counts: BTreeMap<u32, u32> = BTreeMap::new();
    for seed in 0..400 {
        let instance = random(seed, 2);
        let agents = [Lone::new(&instance, 0), Lone::new(&instance, 1)];
        let price = |now, next| Some(collisions(now, next));
        let two = Two {
            agents,
            stays: instance.stays(),
            price: &price,
        };
        let Some(least) = two.least() else { continue };
        if least == 0 {
            continue; // never asked: there is a plan
        }
        let broken = soft::collisions(&instance, None, 0, &budget()).unwrap();
        assert!(broken.fewest, "{seed}");
        assert_eq!(broken.count as u32, least, "{seed}");
        *counts.entry(least).or_default() += 1;
    }
    assert!(counts.len() >= 2 && counts[&1] > 10, "{counts:?}");
}

#[test]
fn no_plan_has_fewer_steps_in_obstacles() {
    let mut counts: BTreeMap<u32, u32> = BTreeMap::new();
    for seed in 0..400 {
        let instance = random(seed, 2);
        let mut open = instance.clone();
        open.remove_obstacles(|_| true);
        let hit = |one: One| match spot(one) {
            Some(Spot::At(cell)) => u32::from(!instance.grid().is_vertex(cell)),
            _ => 0,
        };
        let price =
            |now, next: [One; 2]| (collisions(now, next) == 0).then(|| hit(next[0]) + hit(next[1]));
        let two = Two {
            agents: [Lone::new(&open, 0), Lone::new(&open, 1)],
            stays: instance.stays(),
            price: &price,
        };
        let least = two.least();
        if least == Some(0) {
            continue;
        }
        let broken = soft::obstacles(&instance, None, 0, &budget());
        let count = broken.as_ref().map(|broken| broken.count as u32);
        assert_eq!(count, least, "{seed}");
        if let Some(broken) = broken {
            assert!(broken.fewest, "{seed}");
            *counts.entry(broken.count as u32).or_default() += 1;
        }
    }
    assert!(counts.len() >= 2 && counts[&1] > 5, "{counts:?}");
}

/// A helper of the test itself is looked at once, by an instance known by heart.
#[test]
fn the_comparison_knows_a_corridor() {
    let instance = Instance::new(Scene {
        map: vec!["...".to_owned()],
        agents: crate::tests::instance("aB . bA").agents().to_vec(),
        ..Scene::default()
    })
    .unwrap();
    let price = |now, next| Some(collisions(now, next));
    let two = Two {
        agents: [Lone::new(&instance, 0), Lone::new(&instance, 1)],
        stays: true,
        price: &price,
    };
    assert_eq!(two.least(), Some(1));
}
