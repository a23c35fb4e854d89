//! The solver on instances whose answers are known: the worked examples of the
//! literature, graded instances, and standard scenarios (`data/README.md`).
//!
//! The usual run takes the rows that are solved fast even in the dev profile. The
//! others are ignored by default:
//!
//! ```text
//! cargo test --release -p giveway-tests --test known_answers -- --include-ignored
//! ```
#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "a test that cannot go on ends with a panic"
)]

use std::time::SystemTime;

use giveway_model::{Cost, Instance, Objective, check};
use giveway_solve::{
    Host, Limits, Progress, Request, Response, SolveAnswer, SolveRequest, Status, serve,
};
use giveway_tests::{ask, known};

/// The rows of `mmapf` in the usual run.
const QUICK_ROWS: &[&str] = &[
    "A01", "A02", "A03", "A04", "A05", "A06", "A07", "A08", "A09", "A10", "A12", "A13", "A14",
    "B01", "B02", "B03", "B04", "B05", "B06", "B07", "B08", "B09", "B10", "B11", "B12", "B13",
    "B14", "B15", "B16", "B18", "B19", "B20", "B21", "B23",
];

/// The standard scenarios in the usual run have at most so many agents.
const QUICK_AGENTS: usize = 30;

/// The rows without a proved optimum.
const OPEN_ROWS: &[&str] = &["A11", "A17", "B17"];

/// Expects an optimum, and a plan that the judge passes; returns the answer.
#[track_caller]
fn check_optimal(instance: &Instance, expect: &[(Cost, u32)]) -> SolveAnswer {
    let answer = ask::best(instance, None);
    let name = instance.name();
    let objective = instance.objective();
    assert_eq!(answer.status, Status::Optimal, "{name} for {objective}");
    let costs = answer.costs.unwrap();
    for &(cost, value) in expect {
        assert_eq!(costs.get(cost), value, "{cost} of {name} for {objective}");
    }
    let report = check::check(instance, answer.plan.as_ref().unwrap());
    assert_eq!(report.violations, [], "{name} for {objective}");
    assert_eq!(report.costs, Some(costs), "{name} for {objective}");
    answer
}

fn with_objective(instance: &Instance, objective: &str) -> Instance {
    let objective: Objective = objective.parse().unwrap();
    instance.clone().with_objective(objective)
}

mod seed {
    use super::{check_optimal, known, with_objective};
    use giveway_model::Cost::{Charges, Makespan, SumOfCosts};
    use giveway_model::check;
    use giveway_solve::Status;
    use giveway_tests::ask;

    #[test]
    fn the_warehouse_in_each_order_of_the_costs() {
        let warehouse = known::instance("seed/warehouse.json");
        for objective in [
            "makespan,sum-of-costs,charges",
            "makespan,charges,sum-of-costs",
            "sum-of-costs,makespan,charges",
            "sum-of-costs,charges,makespan",
            "charges,makespan,sum-of-costs",
            "charges,sum-of-costs,makespan",
        ] {
            let warehouse = with_objective(&warehouse, objective);
            let expect = [(Makespan, 18), (SumOfCosts, 35), (Charges, 3)];
            let answer = check_optimal(&warehouse, &expect);
            assert!(answer.reach.is_complete(), "for {objective}");
            assert_eq!(answer.reach.within(), None, "for {objective}");
        }
    }

    #[test]
    fn the_warehouse_within_17() {
        let warehouse = known::instance("seed/warehouse.json");
        let answer = ask::best(&warehouse, Some(17));
        assert_eq!(answer.status, Status::Impossible);
        assert_eq!(
            (answer.reach.is_complete(), answer.reach.within()),
            (false, Some(17))
        );
    }

    #[test]
    fn the_printed_plan_of_the_warehouse() {
        let warehouse = known::instance("seed/warehouse.json");
        let plan = known::plan("seed/warehouse.plan.json");
        let report = check::check(&warehouse, &plan);
        assert_eq!(report.violations, []);
        let costs = report.costs.unwrap();
        assert_eq!(
            (costs.makespan, costs.sum_of_costs, costs.charges),
            (18, 35, 3)
        );
        let printed = [
            vec![10, 9, 8, 7, 6, 5, 4, 3, 2, 1, 10, 9, 8, 7, 6, 5, 4, 3],
            vec![8, 7, 6, 5, 10, 9, 8, 7, 6, 5, 4, 3, 2, 1, 10, 9, 8, 7, 6],
        ];
        for (agent, row) in printed.iter().enumerate() {
            assert_eq!(
                check::levels(&warehouse, agent, &plan),
                *row,
                "agent {agent}"
            );
        }
    }

    #[test]
    fn scenario_1() {
        let scenario = known::instance("seed/scenario-1.json");
        check_optimal(&scenario, &[(Makespan, 4), (SumOfCosts, 7)]);
        for printed in ["seed/scenario-1.plan-1.json", "seed/scenario-1.plan-2.json"] {
            let report = check::check(&scenario, &known::plan(printed));
            assert_eq!(report.violations, [], "{printed}");
            let costs = report.costs.unwrap();
            assert_eq!((costs.makespan, costs.sum_of_costs), (4, 7), "{printed}");
        }
    }

    #[test]
    fn scenario_6() {
        let answer = ask::best(&known::instance("seed/scenario-6.json"), None);
        assert_eq!(answer.status, Status::Impossible);
        assert_eq!(
            (answer.reach.is_complete(), answer.reach.within()),
            (true, None)
        );
    }

    #[test]
    fn the_dynamic_example_before_its_changes() {
        let example = known::instance("seed/dynamic-3x3.json");
        check_optimal(&example, &[(Makespan, 4), (SumOfCosts, 8)]);
        let report = check::check(&example, &known::plan("seed/dynamic-3x3.plan.json"));
        assert_eq!(report.violations, []);
    }
}

/// Makespan, then sum of costs, then charges.
fn check_row(row: &known::Row) {
    let mut expect = vec![(Cost::Makespan, row.makespan)];
    expect.extend(row.sum_of_costs.map(|value| (Cost::SumOfCosts, value)));
    expect.extend(row.charges.map(|value| (Cost::Charges, value)));
    let answer = check_optimal(&known::mmapf(&row.name), &expect);
    assert!(answer.reach.is_complete(), "{}", row.name);
}

/// Sum of costs first: alone, and followed by the others.
fn check_row_sum_of_costs_first(row: &known::Row) {
    let Some(value) = row.sum_of_costs_first else {
        return;
    };
    for objective in ["sum-of-costs", "sum-of-costs,makespan,charges"] {
        let instance = with_objective(&known::mmapf(&row.name), objective);
        let answer = check_optimal(&instance, &[(Cost::SumOfCosts, value)]);
        assert!(answer.reach.is_complete(), "{} for {objective}", row.name);
    }
}

fn closed_rows(quick: bool) -> Vec<known::Row> {
    let is_quick = |row: &known::Row| QUICK_ROWS.contains(&row.name.as_str());
    let is_open = |row: &known::Row| OPEN_ROWS.contains(&row.name.as_str());
    let mut rows = known::rows();
    rows.retain(|row| !is_open(row) && is_quick(row) == quick);
    assert_eq!(rows.len() == QUICK_ROWS.len(), quick, "a name of no row");
    rows
}

#[test]
fn quick_rows() {
    closed_rows(true).iter().for_each(check_row);
}

#[test]
fn quick_rows_sum_of_costs_first() {
    closed_rows(true)
        .iter()
        .for_each(check_row_sum_of_costs_first);
}

#[test]
#[ignore = "takes minutes in the dev profile"]
fn slow_rows() {
    closed_rows(false).iter().for_each(check_row);
}

#[test]
#[ignore = "takes minutes in the dev profile"]
fn slow_rows_sum_of_costs_first() {
    closed_rows(false)
        .iter()
        .for_each(check_row_sum_of_costs_first);
}

fn check_scenarios(wanted: impl Fn(usize) -> bool) {
    for row in known::scenario_rows() {
        if wanted(row.agents) {
            let instance = known::scenario(&row.map, row.agents);
            let instance = with_objective(&instance, "sum-of-costs");
            let answer = check_optimal(&instance, &[(Cost::SumOfCosts, row.sum_of_costs)]);
            assert!(
                answer.reach.is_complete(),
                "{} with {} agents",
                row.map,
                row.agents
            );
        }
    }
}

#[test]
fn quick_scenarios() {
    check_scenarios(|agents| agents <= QUICK_AGENTS);
}

#[test]
#[ignore = "takes minutes in the dev profile"]
fn slow_scenarios() {
    check_scenarios(|agents| agents > QUICK_AGENTS);
}

/// A host with a clock.
struct Clock(SystemTime);

impl Host for Clock {
    fn wall_seconds(&self) -> f64 {
        self.0.elapsed().map_or(0.0, |passed| passed.as_secs_f64())
    }

    fn progress(&self, _: &Progress) {}
}

/// The open rows end with a plan and a bound from below that are close.
#[test]
#[ignore = "takes 30 seconds a row"]
fn open_rows_end_with_a_small_gap() {
    for name in OPEN_ROWS {
        for objective in ["makespan,sum-of-costs,charges", "sum-of-costs"] {
            let instance = with_objective(&known::mmapf(name), objective);
            let request = Request::Solve(SolveRequest {
                scene: instance.to_scene(),
                limits: Limits {
                    seconds: Some(30.0),
                    ..Limits::default()
                },
                ..SolveRequest::default()
            });
            let clock = Clock(SystemTime::now());
            let Response::Solved(answer) = serve(&request, &clock) else {
                panic!("{name} for {objective} was not answered");
            };
            let plan = answer.plan.as_ref().unwrap();
            assert_eq!(check::check(&instance, plan).violations, [], "{name}");
            let cost = f64::from(answer.costs.unwrap().sum_of_costs);
            let bound = f64::from(answer.bounds[&Cost::SumOfCosts]);
            println!(
                "{name} for {objective}: {:?}, sum-of-costs {bound} to {cost}, {:.1} s",
                answer.status,
                clock.wall_seconds()
            );
            assert!(
                bound <= cost && cost <= 1.1 * bound,
                "{name} for {objective}"
            );
            assert!(clock.wall_seconds() < 32.0, "{name} for {objective}");
        }
    }
}
