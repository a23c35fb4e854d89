//! Nodes, levels and steps of the MDD: all states of all times.

use std::collections::{BTreeMap, BTreeSet};

use giveway_model::Instance;

use super::PICTURES;
use crate::{
    budget::Unlimited,
    problem::Problem,
    single::{Mask, Mdd, Metric, Place},
    tests::{Lone, State, instance, random},
};

/// A place, and the waypoints visited.
type Key = (Place, Mask);

/// What is said of a node: its level, and the levels of its steps.
type Node = (u32, BTreeMap<Key, u32>);

/// All nodes of an MDD, by time.
type Nodes = BTreeMap<(u32, Key), Node>;

/// The nodes up to a deadline, by the rules: of every state that can be reached
/// at a time, the time plus what it has still to go.
fn expected(instance: &Instance, problem: &Problem, deadline: u32) -> Nodes {
    let lone = Lone::new(instance, 0);
    let cost_to_go = lone.cost_to_go(Metric::Time);
    let key = |state: &State| (state.spot.place(&problem.terrain), state.visited.into());
    let mut nodes = Nodes::new();
    let mut reached: BTreeSet<State> = lone.start().into_iter().collect();
    for time in 0..=deadline {
        let mut next = BTreeSet::new();
        for state in &reached {
            let Some(rest) = cost_to_go.get(state) else {
                continue;
            };
            let node = nodes.entry((time, key(state)));
            let (level, steps) = node.or_insert((u32::MAX, BTreeMap::new()));
            *level = (*level).min(time + rest);
            for (to, _) in lone.onward(state) {
                next.insert(to);
                if let Some(rest) = cost_to_go.get(&to) {
                    let level = steps.entry(key(&to)).or_insert(u32::MAX);
                    *level = (*level).min(time + 1 + rest);
                }
            }
        }
        reached = next;
    }
    nodes.retain(|_, (level, _)| *level <= deadline);
    nodes
}

/// What the MDD says.
fn nodes(mdd: &Mdd) -> Nodes {
    let mut nodes = Nodes::new();
    for id in 0..mdd.size() {
        let node = mdd.node(id);
        assert_eq!(mdd.find(node.time, node.place, node.mask), Some(id));
        let levels: Vec<u32> = node.steps.iter().map(|step| step.f_value).collect();
        assert!(levels.is_sorted(), "{node:?}");
        let steps = node.steps.iter();
        let steps: BTreeMap<Key, u32> = steps.map(|s| ((s.place, s.mask), s.f_value)).collect();
        assert_eq!(steps.len(), levels.len(), "a step twice in {node:?}");
        let key = (node.time, (node.place, node.mask));
        let before = nodes.insert(key, (node.f_value, steps));
        assert_eq!(before, None, "{key:?} twice");
    }
    nodes
}

/// Grows an MDD step by step, and others at once; false if there is no plan.
fn check(instance: &Instance, delays: u32) -> bool {
    let budget = Unlimited::default();
    let Ok(problem) = Problem::new(instance, &budget) else {
        return false;
    };
    let (task, cost_to_go, optimum) =
        (&problem.tasks[0], &problem.cost_to_go[0], problem.optima[0]);
    let mut grown = Mdd::new(task, optimum);
    assert_eq!(grown.deadline(), None);
    for deadline in optimum..=optimum + delays {
        let grow = |mdd: &mut Mdd| {
            let grown = mdd.grow(deadline, task, &problem.terrain, cost_to_go, &budget);
            grown.unwrap();
            assert_eq!(mdd.deadline(), Some(deadline));
            nodes(mdd)
        };
        let in_steps = grow(&mut grown);
        let at_once = grow(&mut Mdd::new(task, optimum));
        let what = format!("deadline {deadline}, {:#?}", instance.to_scene());
        assert_eq!(in_steps, expected(instance, &problem, deadline), "{what}");
        assert_eq!(at_once, in_steps, "{what}");
    }
    true
}

#[test]
fn pictures() {
    for picture in PICTURES {
        assert!(check(&instance(picture), 5), "{picture}");
    }
}

#[test]
fn random_instances() {
    let checked = (1_000..1_300).filter(|&seed| check(&random(seed, 1), 4));
    assert!(checked.count() > 100);
}

#[test]
fn a_known_diagram() {
    // Straight on at level 2, and a wait or a step back at most at level 4.
    let instance = instance("a . A");
    let budget = Unlimited::default();
    let problem = Problem::new(&instance, &budget).ok().unwrap();
    let mut mdd = Mdd::new(&problem.tasks[0], problem.optima[0]);
    let mut sizes = Vec::new();
    for deadline in 2..=3 {
        let grown = mdd.grow(
            deadline,
            &problem.tasks[0],
            &problem.terrain,
            &problem.cost_to_go[0],
            &budget,
        );
        grown.unwrap();
        sizes.push(mdd.size());
    }
    assert_eq!(sizes, [3, 6]);
    assert_eq!(mdd.find(1, Place::At(2), 0), None);
}
