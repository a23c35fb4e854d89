//! `LaCAM` against the judge, a search of all configurations, and by hand.

mod limits;
mod small;
mod steps;

use giveway_model::{Instance, check::check};

use super::{Found, Options, Report, lacam};
use crate::{
    budget::Unlimited,
    problem::Problem,
    walk::{costs, to_plan},
};

const OPTIONS: Options = Options {
    step_limit: 1_000_000,
    guided: true,
    first_only: false,
    told: 0,
};

/// What is searched, each plan judged; `None` where an agent has no way alone.
fn search(instance: &Instance, options: Options) -> Option<Report> {
    let budget = Unlimited::default();
    let problem = Problem::new(instance, &budget).ok()?;
    let mut told: Vec<Found> = Vec::new();
    let report = lacam(&problem, options, &budget, &mut |found| {
        judge(instance, &problem, found);
        assert!(told.last().is_none_or(|last| found.loss < last.loss));
        told.push(found.clone());
    });
    let report = report.unwrap();
    assert_eq!(report.best, told.pop());
    Some(report)
}

/// A plan that the judge passes, and whose losses are no more than its costs.
fn judge(instance: &Instance, problem: &Problem, found: &Found) {
    let names: Vec<String> = instance.agents().iter().map(|a| a.name.clone()).collect();
    let judged = check(instance, &to_plan(problem, &names, &found.walks));
    let rows = instance.grid().rows();
    assert_eq!(judged.violations, [], "{:?} {rows:#?}", instance.agents());
    if instance.stays() {
        let costs = costs(problem, &found.walks);
        assert!(found.loss <= u64::from(costs.sum_of_costs));
    }
}
