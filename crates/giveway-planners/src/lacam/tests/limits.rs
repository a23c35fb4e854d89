//! How it ends where it does not find all there is: by its limits, with what it
//! refuses, and with what the budget leaves.

use std::cell::Cell;

use giveway_model::{AtGoal, Cost, Instance};

use super::{OPTIONS, judge, search};
use crate::{
    budget::{Budget, HeldBytes, Stop, Unlimited},
    lacam::{Ended, Options, lacam},
    plain::{Plain, Unsupported},
    problem::{Problem, Relaxed},
    single::Bounds,
    tests::{instance, plain},
};

/// Two that cannot pass each other.
const CORRIDOR: &str = "aB . . bA";

#[test]
fn an_impossible_scene_is_exhausted_or_ends_with_the_limit() {
    let instance = instance(CORRIDOR);
    let all = search(&instance, OPTIONS).unwrap();
    assert!(matches!(all.ended, Ended::Exhausted(_)) && all.best.is_none());
    let few = Options {
        step_limit: all.steps - 1,
        ..OPTIONS
    };
    let few = search(&instance, few).unwrap();
    assert_eq!((few.ended, few.steps), (Ended::StepLimit, all.steps - 1));
}

#[test]
fn a_guide_that_leads_to_no_plan_is_given_up() {
    let instance = instance(
        "aB . . bA # cF . . . eD
         #  #  # #  # .  . . . .
         .  .  .  . # .  . . . .
         .  .  .  . # dE . . . fC",
    );
    let of = |guided, step_limit| {
        let options = Options {
            step_limit,
            guided,
            told: 100,
            ..OPTIONS
        };
        let report = search(&instance, options).unwrap();
        assert_eq!((report.ended, report.steps), (Ended::StepLimit, step_limit));
        report.trace
    };
    assert!(of(true, 900) != of(false, 900));
    assert!(of(true, 9_000) == of(false, 900));
}

#[test]
fn the_first_plan_ends_it_where_no_more_is_asked_for() {
    let instance = instance("a B\nb A");
    let options = Options {
        first_only: true,
        ..OPTIONS
    };
    let report = search(&instance, options).unwrap();
    assert_eq!(report.ended, Ended::FirstPlan);
    assert!(report.best.is_some());
}

/// A budget for so many looks at it.
struct Looks {
    left: Cell<u32>,
    held: HeldBytes,
}

impl Budget for Looks {
    fn check(&self) -> Result<(), Stop> {
        let left = self.left.get().checked_sub(1).ok_or(Stop::Cancelled)?;
        self.left.set(left);
        Ok(())
    }

    fn tick(&self) -> Result<(), Stop> {
        self.check()
    }

    fn spend(&self, _states: u64) -> Result<(), Stop> {
        self.check()
    }

    fn held_bytes(&self) -> &HeldBytes {
        &self.held
    }
}

#[test]
fn a_spent_budget_leaves_the_plans_that_were_found() {
    let instance = plain(3, 12, [8, 8], 10);
    let problem = Problem::new(&instance, &Unlimited::default()).ok().unwrap();
    let (mut without, mut with) = (0, 0);
    for looks in 0..200 {
        let budget = Looks {
            left: Cell::new(looks),
            held: HeldBytes::default(),
        };
        let report = lacam(&problem, OPTIONS, &budget, &mut |found| {
            judge(&instance, &problem, found);
        });
        let report = report.unwrap();
        assert_eq!(report.ended, Ended::Stopped(Stop::Cancelled));
        match report.best {
            Some(_) => with += 1,
            None => without += 1,
        }
        assert_eq!(budget.held.get(), 0, "memory is given back");
    }
    assert!(
        with > 50 && without > 30,
        "{with} with a plan, {without} without"
    );
}

#[test]
fn memory_is_counted_while_it_is_held() {
    let instance = plain(3, 12, [8, 8], 10);
    let problem = Problem::new(&instance, &Unlimited::default()).ok().unwrap();
    let budget = Unlimited::default();
    let mut held = 0;
    let options = Options {
        guided: false,
        first_only: true,
        ..OPTIONS
    };
    let report = lacam(&problem, options, &budget, &mut |_| {
        held = budget.held_bytes().get();
    });
    let configurations = report.unwrap().steps;
    assert!(held > configurations * 12 * 12, "{held} bytes");
    assert_eq!(budget.held_bytes().get(), 0);
}

/// What a scene, changed somewhat, is refused for.
fn refused(picture: &str, change: impl FnOnce(&mut Problem)) -> Option<Unsupported> {
    refused_of(&instance(picture), change)
}

fn refused_of(instance: &Instance, change: impl FnOnce(&mut Problem)) -> Option<Unsupported> {
    let budget = Unlimited::default();
    let mut problem = Problem::new(instance, &budget).ok().unwrap();
    change(&mut problem);
    Plain::new(&problem).err()
}

#[test]
fn what_it_cannot_do_is_refused_by_name() {
    let same = |_: &mut Problem| {};
    assert_eq!(refused("a . A\nb . B", same), None);
    let cases = [
        ("a . A\nb b! B", Unsupported::Waypoints(1)),
        ("a . A\nbattery a 5/5", Unsupported::Battery(0)),
        ("a ~ ~ A", Unsupported::SlowZones),
    ];
    for (picture, expected) in cases {
        assert_eq!(refused(picture, same), Some(expected));
    }
    let condition = |problem: &mut Problem| problem.tasks[1].conditions.limit(Cost::Makespan, 9);
    let bounds =
        |problem: &mut Problem| problem.tasks[1].bounds = Bounds::Within([true; 6].to_vec().into());
    let held = |problem: &mut Problem| problem.tasks[1].earliest_move = 1;
    let relaxed = |problem: &mut Problem| {
        problem.relaxed = Relaxed {
            ignored: [(0, 1)].into(),
            ..Relaxed::default()
        };
    };
    let two = "a . A\nb . B";
    assert_eq!(refused(two, condition), Some(Unsupported::Condition(1)));
    assert_eq!(refused(two, bounds), Some(Unsupported::Bounds(1)));
    assert_eq!(refused(two, held), Some(Unsupported::UnderWay(1)));
    assert_eq!(refused(two, relaxed), Some(Unsupported::Relaxed));
    let mut scene = instance("a . A\nb . B").to_scene();
    scene.rules.at_goal = AtGoal::Vanish;
    scene.agents[1].goal = scene.agents[0].goal;
    let shared = refused_of(&Instance::new(scene).unwrap(), same);
    assert_eq!(shared, Some(Unsupported::SharedGoal(0, 1)));
}
