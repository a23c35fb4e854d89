//! Names, refusals, and what may be claimed.

use giveway_model::{Cost, Objective};

use super::{Asked, Halt, Inability, Outcome, Planner, Report, Trace, plan};
use crate::{
    budget::Unlimited, cbs::LowerBound, prioritised::Order, problem::Problem, tests::instance,
    walk::Walk,
};

fn asked<'a>(problem: &'a Problem, objective: &'a Objective, horizon: u32) -> Asked<'a> {
    Asked {
        problem,
        objective,
        within: Some(horizon),
        default_horizon: 50,
        order: Order::default(),
        traced: true,
    }
}

fn planned(picture: &str, planner: Planner, objective: &str, horizon: u32) -> Report {
    let problem = Problem::new(&instance(picture), &Unlimited::default())
        .ok()
        .unwrap();
    let objective = objective.parse().unwrap();
    let asked = asked(&problem, &objective, horizon);
    let mut better: Vec<Vec<Walk>> = Vec::new();
    let mut on_better = |walks: &[Walk]| better.push(walks.to_vec());
    let report = plan(planner, &asked, &mut on_better, &Unlimited::default());
    let last = better.last().map(Vec::as_slice);
    assert_eq!(
        last,
        report.outcome.walks(),
        "the last plan is that of the report"
    );
    report
}

#[test]
fn names_parse_and_print() {
    for planner in Planner::ALL {
        assert_eq!(planner.to_string().parse(), Ok(planner));
    }
    let unknown = "best".parse::<Planner>().unwrap_err().to_string();
    for planner in Planner::ALL {
        assert!(unknown.contains(planner.name()), "{unknown}");
    }
}

const CROSSING: &str = "
    # b #
    a . A
    # B #";

#[test]
fn only_cbs_says_best() {
    let report = planned(CROSSING, Planner::Cbs, "sum-of-costs", 20);
    let Outcome::Best { proved, .. } = &report.outcome else {
        panic!("{report:?}");
    };
    assert_eq!(proved.within(), None);
    let bound = proved.bound();
    assert_eq!((bound.cost(), bound.at_least()), (Cost::SumOfCosts, 5));
    assert!(matches!(report.trace, Some(Trace::Cbs(_))));

    let report = planned(CROSSING, Planner::Prioritised, "sum-of-costs", 20);
    assert!(
        matches!(report.outcome, Outcome::Found { .. }),
        "{report:?}"
    );
    assert_eq!(report.outcome.bound(), None);
    assert!(matches!(report.trace, Some(Trace::Prioritised(_))));
}

#[test]
fn what_a_horizon_hides_is_not_claimed() {
    // Within makespan 3 one of them waits once. Whoever arrives later than that
    // could not cost less than 2 + 4.
    let report = planned(CROSSING, Planner::Cbs, "sum-of-costs", 3);
    assert!(matches!(report.outcome, Outcome::Best { .. }), "{report:?}");
    // Within makespan 2 nothing is left; a longer plan has makespan 3 at least.
    let report = planned(CROSSING, Planner::Cbs, "makespan", 2);
    let Outcome::Stopped { halt, bound, .. } = &report.outcome else {
        panic!("{report:?}");
    };
    assert_eq!(*halt, Halt::Horizon(2));
    assert_eq!(bound.map(LowerBound::at_least), Some(3));
}

#[test]
fn a_best_plan_of_a_horizon_is_best_only_up_to_it() {
    // b meets a, then c. Each of them could wait a step for b; or b waits, once,
    // and arrives at 6.
    let picture = "
        # # # c # #
        # # a . # #
        # # . . # #
        b . . . . B
        # # A C # #";
    let claimed = |horizon| {
        let report = planned(picture, Planner::Cbs, "sum-of-costs", horizon);
        let Outcome::Best { proved, walks } = &report.outcome else {
            panic!("{report:?}");
        };
        let sum: usize = walks.iter().map(|walk| walk.len() - 1).sum();
        (sum, proved.bound().at_least(), proved.within())
    };
    assert_eq!(claimed(6), (13, 13, None));
    assert_eq!(claimed(5), (14, 13, Some(5)));
}

#[test]
fn what_a_method_cannot_do_it_refuses_by_name() {
    let lack = |picture: &str, planner, objective| match planned(picture, planner, objective, 20)
        .outcome
    {
        Outcome::Refused { lack } => lack,
        other => panic!("{other:?}"),
    };
    let (waypoint, battery) = ("a . A b b! B", "a . A\nbattery a 9/9");
    let (slow, shared) = ("a ~ ~ A", "a AB b\nvanish");
    for planner in [Planner::Pibt, Planner::Lacam] {
        assert_eq!(lack(waypoint, planner, "makespan"), Inability::Waypoints(1));
        assert_eq!(lack(battery, planner, "makespan"), Inability::Battery(0));
        assert_eq!(lack(slow, planner, "makespan"), Inability::SlowZones);
        let both = Inability::SharedGoal(0, 1);
        assert_eq!(lack(shared, planner, "makespan"), both);
    }
    let charges = lack(CROSSING, Planner::Cbs, "charges,makespan");
    assert_eq!(charges, Inability::Cost(Cost::Charges));
    for picture in [waypoint, battery, slow, shared] {
        for planner in [Planner::Cbs, Planner::Prioritised, Planner::Lns] {
            let report = planned(picture, planner, "makespan", 20);
            assert!(report.outcome.walks().is_some(), "{planner}: {report:?}");
        }
    }
}

#[test]
fn crowds_and_neighbourhoods_find_plans_and_tell_how() {
    for planner in [Planner::Pibt, Planner::Lacam, Planner::Lns] {
        let report = planned(CROSSING, planner, "sum-of-costs", 20);
        let Outcome::Found { walks } = &report.outcome else {
            panic!("{planner}: {report:?}");
        };
        assert_eq!(walks.len(), 2);
        assert_eq!(report.outcome.bound(), None);
        assert!(report.trace.is_some());
    }
}

#[test]
fn none_of_them_says_that_there_is_no_plan() {
    let swap = "aB . bA";
    for planner in [Planner::Pibt, Planner::Lacam, Planner::Lns] {
        let report = planned(swap, planner, "makespan", 20);
        let Outcome::Stopped { halt, walks, .. } = &report.outcome else {
            panic!("{planner}: {report:?}");
        };
        let stuck = matches!(halt, Halt::Stuck { .. } | Halt::Effort);
        assert!(stuck && walks.is_none(), "{planner}: {report:?}");
    }
}

#[test]
fn conditions_are_refused() {
    let budget = Unlimited::default();
    let mut problem = Problem::new(&instance(CROSSING), &budget).ok().unwrap();
    let mut task = problem.tasks[1].clone();
    task.conditions.limit(Cost::Makespan, 9);
    assert!(problem.add(1, task, &budget).is_ok());
    let objective = Objective::default();
    for planner in Planner::ALL {
        let report = plan(
            planner,
            &asked(&problem, &objective, 20),
            &mut |_| {},
            &budget,
        );
        let Outcome::Refused { lack } = report.outcome else {
            panic!("{planner}: {report:?}");
        };
        assert_eq!(lack, Inability::Condition(1), "{planner}");
    }
}
