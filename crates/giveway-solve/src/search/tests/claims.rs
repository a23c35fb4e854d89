//! The tokens of claims: each is given for its proof, and not one step beyond.

use std::rc::Rc;

use giveway_model::{Cost, Instance, format::native};

use crate::{
    Limits, SilentHost,
    budget::Budget,
    problem::Problem,
    search::{
        Horizon, Minima,
        deadlines::{Deadlines, Keeping},
    },
};

/// Two agents with optima of 4 and 2 steps.
fn scene() -> Instance {
    let scene = r#"{ "giveway": 1, "map": [".....", "....."], "agents": [
        { "name": "A", "start": [0, 0], "goal": [4, 0] },
        { "name": "B", "start": [0, 1], "goal": [2, 1] }] }"#;
    native::read_instance(scene).unwrap()
}

/// Checks something of the scene's problem.
fn with_problem(check: impl Fn(&Problem, &Budget)) {
    let budget = Rc::new(Budget::new(&SilentHost, Limits::default()));
    let Ok(problem) = Problem::new(&scene(), &budget) else {
        panic!("the scene is a problem");
    };
    assert_eq!(problem.optima, [4, 2]);
    check(&problem, &budget);
}

#[test]
fn a_horizon_covers_what_bounds_time() {
    with_problem(|problem, _| {
        let covers = |cost, most| Horizon::at(6).covers(problem, cost, most).is_some();
        assert!(covers(Cost::Makespan, 6) && !covers(Cost::Makespan, 7));
        // With a sum of 8 one agent may be 2 steps late.
        assert!(covers(Cost::SumOfCosts, 8) && !covers(Cost::SumOfCosts, 9));
        for cost in [Cost::Charges, Cost::Moves, Cost::Waits] {
            assert!(!covers(cost, 0), "{cost:?} take any time");
        }
        assert!(Horizon::at(6).covers_all().is_none());
    });
}

#[test]
fn what_agents_need_alone_shows_no_more_than_that() {
    with_problem(|problem, budget| {
        for (cost, least) in [
            (Cost::Makespan, 4),
            (Cost::SumOfCosts, 6),
            (Cost::Moves, 6),
            (Cost::Waits, 0),
            (Cost::Charges, 0),
        ] {
            let bound = Minima::default().bound(problem, cost, budget).unwrap();
            assert_eq!(bound.at_least(), least);
            assert!(bound.shows(least).is_some() && bound.shows(least + 1).is_none());
            assert_eq!(bound.spare(least + 3), Ok(3));
            assert!(least == 0 || bound.spare(least - 1).is_err());
        }
    });
}

#[test]
fn a_cap_of_the_horizon_spoils_what_names_it() {
    with_problem(|problem, _| {
        let deadlines = Deadlines::new(problem, Horizon::at(9), None, Keeping::Assumed);
        assert!(deadlines.free_of_horizon(&[]).is_some());
        assert!(deadlines.free_of_horizon(&[0]).is_none());
        // A limit excludes later arrivals at any horizon.
        let deadlines = Deadlines::new(problem, Horizon::at(9), Some(9), Keeping::Assumed);
        assert!(deadlines.free_of_horizon(&[0, 1]).is_some());
    });
}

#[test]
fn a_cap_of_the_horizon_spoils_all_once_it_is_a_clause() {
    with_problem(|problem, _| {
        let mut deadlines = Deadlines::new(problem, Horizon::at(9), None, Keeping::Hard);
        assert_eq!(deadlines.harden(0, 8), None, "the MDD does not reach it");
        assert!(deadlines.free_of_horizon(&[]).is_some());
        // What is claimed lowers the cap of one agent: that one is harmless.
        assert!(deadlines.lower(0, 7));
        assert_eq!(deadlines.harden(0, 8), Some(7));
        assert!(deadlines.free_of_horizon(&[0]).is_some());
        assert_eq!(deadlines.harden(1, 9), Some(9));
        assert!(deadlines.free_of_horizon(&[]).is_none());
    });
}
