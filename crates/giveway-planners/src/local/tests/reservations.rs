//! Who meets whom; and taking a walk away leaves nothing behind.

use std::collections::BTreeSet;

use super::crowd::Crowd;
use crate::{
    local::{OtherAgents, Reservations},
    walk::Walk,
};

/// Crowds of four agents.
fn crowds() -> impl Iterator<Item = Crowd> {
    (5_000..7_000).filter_map(|seed| Crowd::random(seed, 4))
}

fn walks(crowd: &Crowd) -> Vec<Walk> {
    crowd.ways.iter().map(|way| crowd.walk(way)).collect()
}

#[test]
fn those_met_are_those_collided_with() {
    let (mut met, mut unmet) = (0, 0);
    for mut crowd in crowds() {
        let walks = walks(&crowd);
        let more: Vec<_> = (0..walks.len()).map(|agent| crowd.wander(agent)).collect();
        let all = Reservations::of(&crowd.problem, &walks);
        for (agent, other) in more.iter().enumerate() {
            // Its own walk, which is in the table, and one that is not.
            for way in [&crowd.ways[agent], other] {
                let found = all.met_by(agent, &crowd.walk(way));
                let others = (0..walks.len()).filter(|&other| other != agent);
                let expect: BTreeSet<usize> = others
                    .filter(|&other| crowd.met(way, &[other]) > 0)
                    .collect();
                let ways = &crowd.ways;
                assert_eq!(found, expect, "{agent} by {way:?} in {ways:#?}");
                met += found.len();
                unmet += walks.len() - 1 - found.len();
            }
        }
    }
    assert!(met > 100 && unmet > 100, "{met}, {unmet}");
}

#[test]
fn without_walks_nobody_is_met() {
    for mut crowd in crowds() {
        let walks = walks(&crowd);
        let mut all = Reservations::of(&crowd.problem, &walks);
        let mut order: Vec<usize> = (0..walks.len()).collect();
        crowd.rng.shuffle(&mut order);
        for (i, &agent) in order.iter().enumerate() {
            all.remove(agent, &walks[agent]);
            // As if the agent had never been there.
            let mut rest = Reservations::new(&crowd.problem);
            for &other in &order[i + 1..] {
                rest.add(other, &walks[other]);
            }
            assert_same(&crowd, &all, &rest);
        }
        assert_same(&crowd, &all, &Reservations::new(&crowd.problem));
        for (agent, walk) in walks.iter().enumerate() {
            assert_eq!(all.met_by(agent, walk), BTreeSet::new());
        }
    }
}

#[test]
fn taken_away_and_put_back_is_as_before() {
    for crowd in crowds() {
        let walks = walks(&crowd);
        let all = Reservations::of(&crowd.problem, &walks);
        let mut changed = Reservations::of(&crowd.problem, &walks);
        for agent in (0..walks.len()).rev() {
            changed.remove(agent, &walks[agent]);
            changed.add(agent, &walks[agent]);
            assert_same(&crowd, &changed, &all);
        }
    }
}

/// Both tell the same of every vertex, arc and time, but for the order.
#[track_caller]
fn assert_same(crowd: &Crowd, a: &Reservations, b: &Reservations) {
    let sorted = |agents: &mut dyn Iterator<Item = usize>| {
        let mut agents: Vec<usize> = agents.collect();
        agents.sort_unstable();
        agents
    };
    let latest = crowd.ways.iter().map(Vec::len).max().unwrap() as u32 + 1;
    for time in 0..=latest {
        for v in 0..crowd.problem.terrain.size() as u32 {
            let [here, there] = [a, b].map(|r| sorted(&mut r.at(time, v)));
            assert_eq!(here, there, "at {v}, {time}");
            let [here, there] = [a, b].map(|r| sorted(&mut r.after(time, v)));
            assert_eq!(here, there, "after {time} at {v}");
            assert_eq!(a.last_visit(v), b.last_visit(v), "the last at {v}");
            for arc in crowd.problem.terrain.arcs(v) {
                let [here, there] = [a, b].map(|r| sorted(&mut r.against(time, arc.id)));
                assert_eq!(here, there, "against {} at {time}", arc.id);
            }
        }
    }
}
