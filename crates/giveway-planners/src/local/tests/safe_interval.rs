//! Safe intervals against space-time A*: the same arrival among the same others.

use super::crowd::Crowd;
use crate::{
    budget::Unlimited,
    local::{OtherAgents, Query, Reservations, Timetable, plan_one},
    walk::arrival,
};

/// The agent that is planned.
const AGENT: usize = 0;

/// The arrival by safe intervals, and that by A*, among the others whose walks do
/// not collide with those of others before them.
fn arrivals(crowd: &Crowd, latest: u32) -> [Option<u32>; 2] {
    let mut table = Timetable::new(&crowd.problem).unwrap();
    let mut reserved = Reservations::new(&crowd.problem);
    for (other, way) in crowd.ways.iter().enumerate().skip(1) {
        let walk = crowd.walk(way);
        if reserved.met_by(other, &walk).is_empty() {
            table.add(other, &walk);
            reserved.add(other, &walk);
        }
    }
    let query = Query {
        agent: AGENT,
        latest,
        conflict_penalty: None,
        expansion_limit: u32::MAX,
    };
    let budget = Unlimited::default();
    let by_intervals = table.plan(query, &budget).unwrap();
    if let Some((walk, _)) = &by_intervals {
        assert!(reserved.met_by(AGENT, walk).is_empty(), "{walk:?}");
    }
    let by_a_star = plan_one(&crowd.problem, &reserved, query, &budget).unwrap();
    [by_intervals, by_a_star].map(|found| found.map(|(walk, _)| arrival(&walk)))
}

#[test]
fn they_arrive_at_the_same_time() {
    let (mut at_once, mut delayed, mut none) = (0, 0, 0);
    for seed in 0..3_000 {
        let Some(crowd) = Crowd::random(seed, 5) else {
            continue;
        };
        if !crowd.problem.tasks[AGENT].is_plain() {
            continue;
        }
        let optimum = crowd.problem.optima[AGENT];
        let [by_intervals, by_a_star] = arrivals(&crowd, optimum + (seed % 15) as u32);
        assert_eq!(by_intervals, by_a_star, "seed {seed}");
        match by_intervals {
            Some(arrival) if arrival > optimum => delayed += 1,
            Some(_) => at_once += 1,
            None => none += 1,
        }
    }
    assert!(
        at_once > 50 && delayed > 50 && none > 50,
        "{at_once}, {delayed}, {none}"
    );
}
