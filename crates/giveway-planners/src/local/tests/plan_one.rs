//! The best walk among others, against a search of all states of all times.

use std::collections::BTreeMap;

use giveway_model::Cell;

use super::crowd::Crowd;
use crate::{
    budget::Unlimited,
    local::{OtherAgents, Query, Reservations, plan_one, space_time::DEAR},
    problem::Problem,
    single::Place,
    tests::{Lone, Spot, State, instance},
};

/// The agent that is planned; all others are in its way.
const AGENT: usize = 0;

fn budget() -> Unlimited {
    Unlimited::default()
}

fn others(crowd: &Crowd) -> Vec<usize> {
    (1..crowd.ways.len()).collect()
}

/// What `plan_one` finds: the walk, and the collisions that it states.
fn found(crowd: &Crowd, latest: u32, conflict_penalty: Option<u32>) -> Option<(Vec<Spot>, u32)> {
    let mut reserved = Reservations::new(&crowd.problem);
    for other in others(crowd) {
        reserved.add(other, &crowd.walk(&crowd.ways[other]));
    }
    let query = Query {
        agent: AGENT,
        latest,
        conflict_penalty,
        expansion_limit: u32::MAX,
    };
    let found = plan_one(&crowd.problem, &reserved, query, &budget()).unwrap();
    found.map(|(walk, collisions)| (crowd.way(&walk), collisions))
}

/// The least arrival plus price for collisions, of all walks by the latest
/// time; without a price, of those that do not collide.
fn least(crowd: &Crowd, latest: u32, conflict_penalty: Option<u32>) -> Option<u32> {
    let lone = Lone::new(&crowd.instance, AGENT);
    let others = others(crowd);
    let allowed = |collisions: &u32| conflict_penalty.is_some() || *collisions == 0;
    // Of each state the fewest collisions, and a way there that has them; what
    // is to come depends on the state alone, as long as that way goes on.
    let mut reached: BTreeMap<State, (u32, Vec<Spot>)> = BTreeMap::new();
    let start = lone.start()?;
    reached.insert(start, (0, vec![start.spot]));
    let mut least: Option<u32> = None;
    for time in 0..=latest {
        let mut next: BTreeMap<State, (u32, Vec<Spot>)> = BTreeMap::new();
        for (state, (_, way)) in &reached {
            if lone.is_end(state) {
                let collisions = crowd.met(way, &others);
                if allowed(&collisions) {
                    let total = time + conflict_penalty.unwrap_or(0) * collisions;
                    least = Some(least.map_or(total, |least| least.min(total)));
                }
            }
            for (to, _) in lone.onward(state) {
                let way = [way.as_slice(), &[to.spot]].concat();
                let collisions = met_so_far(crowd, &way, &others);
                let best = next.get(&to).map_or(u32::MAX, |(fewest, _)| *fewest);
                if allowed(&collisions) && collisions < best {
                    next.insert(to, (collisions, way));
                }
            }
        }
        reached = next;
    }
    least
}

/// The collisions of a walk that goes on, up to now: as if it vanished now,
/// and the others went on.
fn met_so_far(crowd: &Crowd, way: &[Spot], others: &[usize]) -> u32 {
    let others = others.iter().map(|&other| &crowd.ways[other]);
    // At its end it stands where it stands once, and under `stay` for good,
    // which does not count yet: so the others end at the same time, too.
    let cut = others.map(|other| {
        let mut other = other.clone();
        if crowd.instance.stays()
            && let Some(&last) = other.last()
        {
            other.resize(way.len().max(other.len()), last);
        }
        other.truncate(way.len());
        crowd.collisions(way, &other)
    });
    cut.sum()
}

/// Plays crowds of three; returns how many there were, and how many of them
/// had to go out of the way.
fn check(
    seeds: std::ops::Range<u64>,
    conflict_penalty: Option<u32>,
    batteries: bool,
) -> (u32, u32) {
    let (mut checked, mut delayed) = (0, 0);
    for seed in seeds {
        let Some(mut crowd) = Crowd::random(seed, 3) else {
            continue;
        };
        if !batteries && crowd.instance.agents()[AGENT].battery.is_some() {
            continue;
        }
        let optimum = crowd.problem.optima[AGENT];
        let latest = optimum + crowd.rng.u32(0..=6);
        let found = found(&crowd, latest, conflict_penalty);
        let least = least(&crowd, latest, conflict_penalty);
        let what = format!(
            "seed {seed}: {:#?} {:#?}",
            crowd.instance.to_scene(),
            crowd.ways
        );
        checked += 1;
        delayed += u32::from(least > Some(optimum));
        let Some((way, stated)) = found else {
            assert_eq!(None, least, "{what}");
            continue;
        };
        assert!(
            Lone::new(&crowd.instance, AGENT).can_follow(&way),
            "{way:?} {what}"
        );
        let arrival = way.len() as u32 - 1;
        assert!(arrival <= latest, "{way:?} {what}");
        let collisions = crowd.met(&way, &others(&crowd));
        let total = arrival + conflict_penalty.unwrap_or(0) * collisions;
        if conflict_penalty == Some(DEAR) {
            // Where a collision cannot be avoided it may arrive later than it could.
            let fewest = least.map(|least| least / DEAR);
            assert_eq!(Some(collisions), fewest, "{way:?} {what}");
        } else {
            assert_eq!(Some(total), least, "{way:?} {what}");
        }
        assert!(
            conflict_penalty.is_some() || collisions == 0,
            "{way:?} {what}"
        );
        if conflict_penalty.is_some() {
            assert_eq!(stated, collisions, "{way:?} {what}");
        }
    }
    (checked, delayed)
}

#[test]
fn without_collisions_it_arrives_as_soon_as_can_be() {
    let (checked, delayed) = check(0..1_500, None, true);
    assert!(checked > 100 && delayed > 30, "{checked}, {delayed}");
}

#[test]
fn at_a_price_it_weighs_collisions_against_delay() {
    for conflict_penalty in [1, 3, DEAR] {
        let (checked, delayed) = check(2_000..3_000, Some(conflict_penalty), false);
        assert!(checked > 50 && delayed > 20, "{checked}, {delayed}");
    }
}

/// Walks of the other agents, in their order, by cell; then the arrival of a
/// within time 10, and the collisions.
fn arrival(
    picture: &str,
    walks: &[&[(u32, u32)]],
    conflict_penalty: Option<u32>,
) -> Option<(usize, u32)> {
    let problem = Problem::new(&instance(picture), &budget()).ok().unwrap();
    let place = |&(x, y): &(u32, u32)| {
        let vertex = problem.terrain.vertex(Cell::new(x, y));
        Place::At(vertex.unwrap())
    };
    let mut reserved = Reservations::new(&problem);
    for (other, walk) in (1..).zip(walks) {
        reserved.add(other, &walk.iter().map(place).collect::<Vec<_>>());
    }
    let query = Query {
        agent: AGENT,
        latest: 10,
        conflict_penalty,
        expansion_limit: u32::MAX,
    };
    let found = plan_one(&problem, &reserved, query, &budget()).unwrap();
    found.map(|(walk, collisions)| (walk.len() - 1, collisions))
}

#[test]
fn a_way_by_the_charger_counts_although_it_comes_second() {
    // Both ways to (1, 1) take two steps. Only who charged at (0, 1) can wait
    // there for b, and c leaves no time to charge later.
    let picture = "
        a   .  #  #
        +C  .  B  bA
        c   #  #  #
        battery a 4/4
        vanish";
    let b = [(3, 1), (3, 1), (3, 1), (2, 1)];
    let c = [(0, 2), (0, 2), (0, 1)];
    let found = arrival(picture, &[&b, &c], None);
    assert_eq!(found.map(|(arrival, _)| arrival), Some(5));
}

#[test]
fn a_dear_collision_is_worth_waiting() {
    let picture = "
        a A b
        . B .";
    // b comes by the goal of a at time 4.
    let b = [(2, 0), (2, 0), (2, 0), (2, 0), (1, 0), (1, 1)];
    assert_eq!(arrival(picture, &[&b], None), Some((5, 0)));
    assert_eq!(arrival(picture, &[&b], Some(1)), Some((1, 1)));
    assert_eq!(arrival(picture, &[&b], Some(DEAR)), Some((5, 0)));
}
