//! Tables and curves of a few rows.

use giveway_model::{Cost, Costs};
use giveway_proof::Certified;

use super::*;
use crate::{Method, RowCertificate, Task};

fn row(agents: usize, status: RowStatus, seconds: f64) -> Row {
    let task = Task {
        instance: format!("a,{seconds}.scen"),
        agents: Some(agents),
        objective: Some("sum-of-costs,makespan".parse().unwrap()),
        planner: Method::Search,
        limits: giveway_solve::Limits::default(),
        clock: crate::Clock::Wall,
        certificate: None,
    };
    let mut row = Row::bare(&task, status, None);
    row.map = Some("a".to_owned());
    row.took.cpu_seconds = seconds;
    if matches!(status, RowStatus::Optimal | RowStatus::Feasible) {
        let costs = Costs {
            sum_of_costs: 22,
            ..Costs::default()
        };
        row.costs = Some(costs);
        let bound = if status == RowStatus::Optimal { 22 } else { 20 };
        row.bounds.insert(Cost::SumOfCosts, bound);
    }
    row
}

fn rows() -> Vec<Row> {
    vec![
        row(5, RowStatus::Optimal, 0.25),
        row(5, RowStatus::Optimal, 0.5),
        row(10, RowStatus::Feasible, 30.0),
        row(10, RowStatus::Impossible, 0.125),
        row(10, RowStatus::Unknown, 30.5),
    ]
}

#[test]
fn groups_are_counted() {
    let text = summary(&rows()).csv();
    let lines: Vec<&str> = text.lines().collect();
    assert_eq!(lines.len(), 3);
    assert_eq!(
        lines[1],
        "a,\"sum-of-costs,makespan\",search,5,2,2,0,0,0,0,0,0,0.00,0.25"
    );
    assert_eq!(
        lines[2],
        "a,\"sum-of-costs,makespan\",search,10,3,0,1,1,1,0,0,0,10.00,0.12"
    );
}

#[test]
fn every_row_has_a_line_and_odd_names_are_quoted() {
    let sheet = all(&rows());
    assert!(
        sheet.csv().contains("\"a,0.25.scen\",a,5,"),
        "{}",
        sheet.csv()
    );
    let markdown = sheet.markdown();
    assert_eq!(markdown.lines().count(), 2 + 5);
    assert!(markdown.contains("| ---: |"), "{markdown}");
}

#[test]
fn what_was_tried_is_listed_by_scenario_and_number_with_its_certificate() {
    let mut rows = rows();
    rows[1] = row(100, RowStatus::Optimal, 0.25);
    rows[1].certificate = Some(RowCertificate {
        certified: Certified::Proved,
        bytes: 1234,
        manifest: Some("abc".to_owned()),
        reason: None,
    });
    rows[1].took.certificate_cpu_seconds = Some(0.5);
    rows[4] = row(20, RowStatus::Skipped, 0.25);
    for row in &mut rows {
        row.instance = "maps/a-even-1.scen".to_owned();
    }
    let text = optima(&rows).csv();
    let expected = [
        "a,a-even-1,5,\"sum-of-costs,makespan\",22,22,optimal,0.00,0.25,,,,",
        "a,a-even-1,10,\"sum-of-costs,makespan\",20,22,feasible,10.00,30.00,,,,",
        "a,a-even-1,10,\"sum-of-costs,makespan\",,,impossible,,0.12,,,,",
        "a,a-even-1,100,\"sum-of-costs,makespan\",22,22,optimal,0.00,0.25,proved,1234,0.50,abc",
    ];
    let lines: Vec<&str> = text.lines().skip(1).collect();
    assert_eq!(lines, expected);
}

#[test]
fn curves_count_what_is_answered_for_good() {
    let success = success(&rows());
    assert_eq!(success.len(), 1);
    assert_eq!(success[0].name, "search");
    assert_eq!(success[0].points, [(5.0, 1.0), (10.0, 1.0 / 3.0)]);
    let cactus = cactus(&rows());
    assert_eq!(cactus[0].points, [(1.0, 0.125), (2.0, 0.25), (3.0, 0.5)]);
    for (curves, axes) in [(&success, Axes::Success), (&cactus, Axes::Cactus)] {
        let svg = plot(curves, axes).unwrap();
        assert!(svg.starts_with("<svg") && svg.contains("search"), "{svg}");
        assert!(plot(&[], axes).is_ok(), "nothing to draw");
    }
}

#[test]
fn a_planner_that_proves_nothing_succeeds_with_a_plan() {
    let mut found = row(5, RowStatus::Feasible, 1.0);
    assert!(!found.is_success(), "the search promises a proof");
    found.planner = "lacam".parse().unwrap();
    assert!(found.is_success());
    found.status = RowStatus::Unknown;
    assert!(!found.is_success());
}
