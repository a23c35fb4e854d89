//! PIBT by hand, and against the judge.

use giveway_model::{Instance, check::check};

use super::{Guide, Inheritance, Options, Outcome, Ranks, Report, Step, pibt};
use crate::{
    budget::Unlimited,
    plain::Plain,
    problem::Problem,
    single::Place,
    tests::{instance, plain},
    walk::to_plan,
};

const OPTIONS: Options = Options {
    step_limit: 300,
    told: 0,
};

/// What it does; `None` where an agent has no way alone.
fn run(instance: &Instance, options: Options) -> Option<Report> {
    let budget = Unlimited::default();
    let problem = Problem::new(instance, &budget).ok()?;
    let report = pibt(&problem, options, &budget).unwrap();
    if let Outcome::Plan(walks) = &report.outcome {
        let names: Vec<String> = instance.agents().iter().map(|a| a.name.clone()).collect();
        let judged = check(instance, &to_plan(&problem, &names, walks));
        let rows = instance.grid().rows();
        assert_eq!(judged.violations, [], "{:?} {rows:#?}", instance.agents());
    }
    Some(report)
}

#[test]
fn a_chain_of_three_by_hand() {
    // All move one to the right. a has the longest way; b stands before it, and
    // c before b.
    let options = Options { told: 9, ..OPTIONS };
    let report = run(&instance("a b c . A B C"), options).unwrap();
    let lent = |from, to, at| Inheritance { from, to, at };
    assert_eq!(
        report.inherited[..2],
        [(0, lent(0, 1, 1)), (0, lent(1, 2, 2))]
    );
    assert_eq!(
        report.leaders,
        [0, 0, 0, 0],
        "who is on its way for longest, by its way"
    );
    let Outcome::Plan(walks) = report.outcome else {
        panic!("{:?}", report.outcome);
    };
    let way = |from: u32| (from..=from + 4).map(Place::At).collect::<Vec<_>>();
    assert_eq!(walks, [way(0), way(1), way(2)]);
}

#[test]
fn two_in_a_corridor_change_places_where_it_has_a_bay() {
    let report = run(
        &instance(
            "aB . . . bA
              #  # . #  #",
        ),
        OPTIONS,
    );
    let report = report.unwrap();
    assert!(matches!(report.outcome, Outcome::Plan(_)), "{report:?}");
}

#[test]
fn two_in_a_corridor_without_a_bay_are_stuck() {
    let report = run(&instance("aB . . bA"), OPTIONS).unwrap();
    assert_eq!((report.outcome, report.steps), (Outcome::Stuck(0), 300));
}

#[test]
fn nothing_is_told_that_nobody_asked_for() {
    let instance = instance("a b c . A B C");
    let untold = run(&instance, OPTIONS).unwrap();
    assert!(untold.inherited.is_empty() && untold.leaders.is_empty());
    let options = Options { told: 1, ..OPTIONS };
    assert_eq!(run(&instance, options).unwrap().inherited.len(), 1);
}

#[test]
fn random_instances() {
    let mut plans = 0;
    for seed in 0..600 {
        let instance = plain(seed, 1 + seed as usize % 25, [7, 6], 15);
        let report = run(&instance, OPTIONS);
        plans += usize::from(report.is_some_and(|r| matches!(r.outcome, Outcome::Plan(_))));
    }
    assert!(plans > 300, "{plans} plans");
}

#[test]
fn where_nobody_is_fixed_everybody_finds_a_cell() {
    for seed in 0..200 {
        let instance = plain(seed, 20, [6, 6], 20);
        let budget = Unlimited::default();
        let Ok(problem) = Problem::new(&instance, &budget) else {
            continue;
        };
        let plain = Plain::new(&problem).unwrap();
        let order = super::Priorities::first(&Ranks::new(&plain)).order;
        let mut step = Step::new(&plain, None, seed, false);
        let mut now = plain.starts().to_vec();
        for _ in 0..30 {
            step.begin(&now);
            assert!(step.choose(&order));
            now = step.next().to_vec();
        }
    }
}

#[test]
fn a_guide_sends_those_who_meet_into_lanes() {
    // Two rows between the same two columns: each pair would meet in a row.
    let instance = instance(
        "aC . . . cA
         bD . . . dB",
    );
    let budget = Unlimited::default();
    let problem = Problem::new(&instance, &budget).ok().unwrap();
    let plain = Plain::new(&problem).unwrap();
    let guide = Guide::new(&plain, &budget).unwrap().unwrap();
    for agent in 0..4 {
        assert_eq!(guide.cost(agent, plain.goals()[agent]), 0);
        for v in 0..10 {
            assert!(guide.cost(agent, v) >= 20 * plain.distance(agent, v));
        }
    }
    // Whoever stands in the middle of a row pays more against its traffic.
    let dear = (0..4).filter(|&agent| {
        let start = plain.starts()[agent];
        guide.cost(agent, start) > 20 * plain.distance(agent, start)
    });
    assert!(dear.count() > 0);
}
