//! Shortest walks under rules: where they pass, and which has the fewest collisions.

use giveway_model::Cell;

use super::problem;
use crate::{
    budget::Unlimited,
    cbs::{
        constraint::{Own, Rule},
        mdd::Mdd,
        rulebook::Rulebook,
    },
    local::{OtherAgents, Reservations},
    problem::Problem,
    single::Place,
    terrain::Vertex,
};

fn vertex(problem: &Problem, x: u32, y: u32) -> Vertex {
    problem.terrain.vertex(Cell::new(x, y)).unwrap()
}

/// The shortest walks of the first agent.
fn mdd(problem: &Problem, rules: &[Own]) -> Option<Mdd> {
    let mut rulebook = Rulebook::default();
    for rule in rules {
        rulebook.add(*rule);
    }
    Mdd::new(problem, 0, &rulebook, 0, 30, &Unlimited::default()).unwrap()
}

fn arrival(problem: &Problem, rules: &[Own]) -> Option<u32> {
    mdd(problem, rules).map(|mdd| mdd.arrival())
}

const SQUARE: &str = "
    a . .
    . # .
    . . A";

#[test]
fn a_rule_costs_what_it_takes_to_keep_it() {
    let problem = problem(SQUARE);
    let at = |x, y| vertex(&problem, x, y);
    let rule = Own::Rule;
    let not_at = |x, y, time| rule(Rule::NotAt { v: at(x, y), time });
    assert_eq!(arrival(&problem, &[]), Some(4));
    // One side, both sides; the goal at its arrival, and later.
    assert_eq!(arrival(&problem, &[not_at(1, 0, 1)]), Some(4));
    assert_eq!(
        arrival(&problem, &[not_at(1, 0, 1), not_at(0, 1, 1)]),
        Some(5)
    );
    assert_eq!(arrival(&problem, &[not_at(2, 2, 4)]), Some(5));
    assert_eq!(arrival(&problem, &[not_at(2, 2, 9)]), Some(10));
    let middle = Rule::At {
        v: at(1, 0),
        time: 3,
    };
    assert_eq!(arrival(&problem, &[rule(middle)]), Some(6));
    // It may rest where it has to be; it cannot be in two places.
    let goal = Rule::At {
        v: at(2, 2),
        time: 8,
    };
    assert_eq!(arrival(&problem, &[rule(goal)]), Some(4));
    let elsewhere = Rule::At {
        v: at(1, 0),
        time: 8,
    };
    assert_eq!(arrival(&problem, &[rule(elsewhere)]), Some(11));
    assert_eq!(arrival(&problem, &[rule(goal), rule(elsewhere)]), None);
    assert_eq!(arrival(&problem, &[rule(Rule::ArriveAfter(6))]), Some(7));
    assert_eq!(arrival(&problem, &[rule(Rule::ArriveBy(3))]), None);
    // Others rest on both sides from a time on.
    let closed = |x, y, from| Own::Closed { v: at(x, y), from };
    assert_eq!(
        arrival(&problem, &[closed(2, 0, 3), closed(0, 2, 3)]),
        Some(4)
    );
    assert_eq!(arrival(&problem, &[closed(2, 0, 2), closed(0, 2, 2)]), None);
}

#[test]
fn where_it_is_gone_on_arrival_its_goal_may_be_closed_later() {
    let picture = format!("{SQUARE}\nvanish");
    let problem = problem(&picture);
    let v = vertex(&problem, 2, 2);
    let later = Own::Rule(Rule::NotAt { v, time: 9 });
    assert_eq!(arrival(&problem, &[later]), Some(4));
    let there = Own::Rule(Rule::At { v, time: 9 });
    assert_eq!(arrival(&problem, &[there]), Some(9));
}

#[test]
fn a_slow_edge_is_crossed_in_both_of_its_steps() {
    let problem = problem("a ~ ~ A");
    let (u, v) = (vertex(&problem, 1, 0), vertex(&problem, 2, 0));
    let arc = problem.terrain.arcs(u).iter().find(|arc| arc.to == v);
    let arc = arc.unwrap().id;
    assert_eq!(arrival(&problem, &[]), Some(4));
    // Begun at 1 it is under way from 1 and 2.
    let not = |time| Own::Rule(Rule::NotCross { arc, time });
    assert_eq!(arrival(&problem, &[not(1)]), Some(5));
    assert_eq!(arrival(&problem, &[not(2)]), Some(6));
    let under_way = Own::Rule(Rule::Cross { arc, time: 3 });
    assert_eq!(arrival(&problem, &[under_way]), Some(5));
    assert!(mdd(&problem, &[under_way]).unwrap().always_crosses(arc, 3));
    assert!(mdd(&problem, &[]).unwrap().always_crosses(arc, 2));
}

#[test]
fn it_tells_where_all_shortest_walks_pass() {
    let problem = problem(SQUARE);
    let mdd = mdd(&problem, &[]).unwrap();
    let is = |x, y, time| mdd.is_always_at(&problem, vertex(&problem, x, y), time);
    assert!(is(0, 0, 0) && is(2, 2, 4) && is(2, 2, 9));
    assert!(!is(1, 0, 1) && !is(2, 0, 2) && !is(0, 0, 1));
}

#[test]
fn a_battery_counts() {
    // Straight it is two steps to the charger; who waits before gets stuck.
    let problem = problem("a . + . . A\nbattery a 2/4");
    assert_eq!(arrival(&problem, &[]), Some(5));
    let v = vertex(&problem, 1, 0);
    assert_eq!(
        arrival(&problem, &[Own::Rule(Rule::NotAt { v, time: 1 })]),
        None
    );
    let v = vertex(&problem, 3, 0);
    assert_eq!(
        arrival(&problem, &[Own::Rule(Rule::NotAt { v, time: 3 })]),
        Some(6)
    );
}

#[test]
fn of_the_shortest_walks_the_calmest_is_taken() {
    let problem = problem(
        "a . .
         . # b
         . B A",
    );
    let at = |x, y| Place::At(vertex(&problem, x, y));
    let mut others = Reservations::new(&problem);
    // b goes around the upper side and meets whoever comes there.
    let b = [
        at(2, 1),
        at(2, 0),
        at(1, 0),
        at(0, 0),
        at(0, 1),
        at(0, 2),
        at(1, 2),
    ];
    others.add(1, &b);
    let walk = mdd(&problem, &[]).unwrap().calmest(&problem, &others);
    assert_eq!(walk, [at(0, 0), at(0, 1), at(0, 2), at(1, 2), at(2, 2)]);
}
