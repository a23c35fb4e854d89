//! Plans that the solver finds for graded instances without batteries, written in every
//! format, read again and audited: each is the best, proved; with a step spoiled none is.
//!
//! The usual run takes the rows that are solved within a second; `GIVEWAY_LONG=1` all rows
//! whose optimum is known.
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "a test that cannot go on ends with a panic"
)]

use giveway_formats::{Combined, Format, Options, Source, combine, write};
use giveway_model::{Cell, Instance, Plan};
use giveway_solve::audit::{AuditAnswer, AuditRequest, AuditStatus};
use giveway_solve::{Request, Response, SilentHost, SolveRequest, Status, serve};
use giveway_tests::known;

const QUICK: [&str; 10] = [
    "B01", "B02", "B03", "B07", "B08", "B13", "B14", "B15", "B18", "B19",
];
const SLOWER: [&str; 9] = [
    "B04", "B05", "B09", "B10", "B11", "B16", "B20", "B21", "B22",
];

const PLANS: [Format; 7] = [
    Format::Tracker,
    Format::Paths,
    Format::Result,
    Format::MultiRobot,
    Format::League,
    Format::Asprilo,
    Format::Mapfw,
];

fn rows() -> Vec<&'static str> {
    let long = std::env::var_os("GIVEWAY_LONG").is_some();
    let slower = SLOWER.into_iter().filter(|_| long);
    QUICK.into_iter().chain(slower).collect()
}

fn best(instance: &Instance) -> Plan {
    let request = Request::Solve(SolveRequest {
        scene: instance.to_scene(),
        ..SolveRequest::default()
    });
    match serve(&request, &SilentHost) {
        Response::Solved(answer) if answer.status == Status::Optimal => answer.plan.unwrap(),
        other => panic!("{other:?}"),
    }
}

/// What is written, read again; `None` where the format cannot hold the plan.
fn through(format: Format, instance: &Instance, plan: &Plan) -> Option<Combined> {
    let written = write(format, "row", Some(instance), Some(plan)).ok()?;
    let files = written.files.iter();
    let sources: Vec<Source<'_>> = files.map(|(name, text)| Source { name, text }).collect();
    let combined = combine(&sources, &Options::default());
    Some(combined.unwrap_or_else(|refused| panic!("{format}: {refused:?}")))
}

fn audit(combined: &Combined, plan: &Plan, instance: &Instance) -> AuditAnswer {
    let request = Request::Audit(AuditRequest {
        scene: combined.instance.to_scene(),
        plan: plan.clone(),
        objective: Some(instance.objective().clone()),
        ..AuditRequest::default()
    });
    match serve(&request, &SilentHost) {
        Response::Audited(answer) => *answer,
        other => panic!("{other:?}"),
    }
}

/// A step of an agent repeated, or one cell of its path beside where it was: by the number.
fn spoil(plan: &Plan, number: usize) -> Plan {
    let mut plan = plan.clone();
    let index = number % plan.paths.len();
    let path = plan.paths.values_mut().nth(index).unwrap();
    let at = (7 * number + 3) % path.len();
    let cell = path[at].unwrap();
    if number.is_multiple_of(2) && at + 1 < path.len() {
        path.insert(at, Some(cell));
    } else {
        path[at] = Some(Cell::new(cell.x ^ 1, cell.y));
    }
    plan
}

#[test]
fn the_best_plan_is_the_best_in_every_format() {
    for row in rows() {
        let instance = known::mmapf(row);
        let plan = best(&instance);
        for format in PLANS {
            let combined = through(format, &instance, &plan).unwrap();
            let tasks = |instance: &Instance| -> Vec<(Cell, Cell)> {
                let agents = instance.agents().iter();
                agents
                    .map(|agent| (agent.start, agent.goal.unwrap()))
                    .collect()
            };
            assert_eq!(
                tasks(&combined.instance),
                tasks(&instance),
                "{row} {format}"
            );
            assert!(!combined.plans.is_empty(), "{row} {format}");
            for read in &combined.plans {
                let answer = audit(&combined, &read.plan, &instance);
                assert_eq!(answer.status, AuditStatus::Optimal, "{row} {format}");
                assert!(answer.better.is_none());
            }
        }
    }
}

#[test]
fn one_step_spoiled_is_found_in_every_format() {
    let (mut refused, mut found) = (0, 0);
    for (number, row) in rows().into_iter().enumerate() {
        let instance = known::mmapf(row);
        let plan = best(&instance);
        for (i, format) in PLANS.into_iter().enumerate() {
            let spoiled = spoil(&plan, 5 * number + i);
            // A jump is no move, so formats of moves refuse it when writing.
            let Some(combined) = through(format, &instance, &spoiled) else {
                refused += 1;
                continue;
            };
            for read in &combined.plans {
                let answer = audit(&combined, &read.plan, &instance);
                assert_ne!(answer.status, AuditStatus::Optimal, "{row} {format}");
                let is_found = !answer.legal || answer.better.is_some();
                assert!(is_found, "{row} {format}: {answer:?}");
                found += 1;
            }
        }
    }
    assert!(found > 2 * refused, "found {found}, refused {refused}");
}
