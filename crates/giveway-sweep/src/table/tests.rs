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
        command: None,
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

/// A row of a sweep without objectives, under a budget.
fn named(instance: &str, agents: usize, status: RowStatus, budget: Option<f64>) -> Row {
    let limits = giveway_solve::Limits {
        seconds: budget,
        ..giveway_solve::Limits::default()
    };
    let task = Task {
        instance: instance.to_owned(),
        agents: Some(agents),
        objective: None,
        planner: Method::Search,
        command: None,
        limits,
        clock: crate::Clock::Wall,
        certificate: None,
    };
    let is_read = !matches!(status, RowStatus::Skipped | RowStatus::Error);
    Row {
        map: is_read.then(|| "a".to_owned()),
        objective: is_read.then(|| "makespan".parse().unwrap()),
        ..Row::bare(&task, status, None)
    }
}

/// The cells of a table by lines, without its head.
fn cells(rows: &[Row], show: Show) -> Vec<Vec<String>> {
    let text = write(rows, show, Written::Csv).unwrap();
    let line = |line: &str| line.split(',').map(str::to_owned).collect();
    text.lines().skip(1).map(line).collect()
}

#[test]
fn what_was_skipped_is_counted_with_what_was_tried() {
    let rows = [
        named("x 1.scen", 5, RowStatus::Unknown, None),
        named("x 2.scen", 5, RowStatus::Optimal, None),
        named("x 1.scen", 10, RowStatus::Skipped, None),
        named("x 2.scen", 10, RowStatus::Optimal, None),
    ];
    let summary = cells(&rows, Show::Summary);
    let ten = [
        "a", "makespan", "search", "10", "2", "1", "0", "0", "0", "0", "0", "1",
    ];
    assert_eq!(summary.len(), 2, "{summary:?}");
    assert_eq!(summary[1][..12], ten);
    let success = cells(&rows, Show::Success);
    assert_eq!(
        success,
        [["search", "5", "0.500"], ["search", "10", "0.500"]]
    );
}

#[test]
fn what_cannot_be_read_lowers_no_success_rate_and_has_no_curve() {
    let mut rows = vec![
        named("x.scen", 5, RowStatus::Optimal, None),
        named("x.scen", 99, RowStatus::Error, None),
        named("away.json", 5, RowStatus::Error, None),
    ];
    rows[2].agents = None;
    assert_eq!(cells(&rows, Show::Success), [["search", "5", "1.000"]]);
    let summary = cells(&rows, Show::Summary);
    assert_eq!(summary[2][..5], ["away.json", "", "search", "", "1"]);
    assert!(plot(&success(&rows[1..]), Axes::Success).is_ok());
}

#[test]
fn budgets_and_planners_are_told_where_there_are_several() {
    let mut rows = vec![
        named("x.scen", 5, RowStatus::Unknown, Some(1.0)),
        named("x.scen", 5, RowStatus::Optimal, Some(60.0)),
        named("x.scen", 5, RowStatus::Optimal, None),
    ];
    let column = |rows: &[Row], show, index: usize| -> Vec<String> {
        let cells = cells(rows, show).into_iter();
        cells.map(|line| line[index].clone()).collect()
    };
    let budgets = ["no limit", "seconds=1", "seconds=60"];
    assert_eq!(column(&rows, Show::Summary, 3), budgets);
    assert_eq!(
        column(&rows, Show::Rows, 5),
        ["seconds=1", "seconds=60", "no limit"]
    );
    assert_eq!(
        column(&rows, Show::Optima, 4),
        ["seconds=1", "seconds=60", "no limit"]
    );
    let curves = success(&rows);
    assert_eq!(curves[2].name, "search, seconds=60");
    rows[1].planner = "cbs".parse().unwrap();
    assert_eq!(column(&rows, Show::Optima, 4), ["search", "cbs", "search"]);
    rows.truncate(1);
    assert_eq!(success(&rows)[0].name, "search");
    assert_eq!(column(&rows, Show::Optima, 4), [""]);
}

#[test]
fn a_plot_has_a_dot_for_a_single_number_and_whole_numbers_at_its_axes() {
    let rows = [named("x.scen", 4, RowStatus::Optimal, None)];
    for (curves, axes) in [
        (success(&rows), Axes::Success),
        (cactus(&rows), Axes::Cactus),
    ] {
        let svg = plot(&curves, axes).unwrap();
        assert_eq!(svg.matches("<circle").count(), 1, "{svg}");
        let texts = svg.split("<text").skip(1);
        let texts = texts.filter_map(|text| text.split(['>', '<']).nth(1).map(str::trim));
        let numbers: Vec<&str> = texts.filter(|text| text.parse::<f64>().is_ok()).collect();
        let mut once = numbers.clone();
        once.sort_unstable();
        once.dedup();
        let twice = usize::from(axes == Axes::Cactus); // 1 task, 1 second
        assert_eq!(numbers.len(), once.len() + twice, "{numbers:?}");
    }
}

#[test]
fn many_curves_look_different_and_their_names_are_beside_the_axes() {
    let curve = |index: usize| Curve {
        name: format!("planner {index}"),
        points: vec![(5.0, 1.0), (500.0, 0.5)],
    };
    let curves: Vec<Curve> = (0..28).map(curve).collect();
    let svg = plot(&curves, Axes::Success).unwrap();
    let first = |attribute: &str| {
        let rest = svg.split_once(attribute).unwrap().1;
        rest.split('"').next().unwrap().parse::<f64>().unwrap()
    };
    assert!(first("<svg width=\"") > 720.0 + 10.0 * 8.0);
    assert!(first("height=\"") >= 28.0 * 20.0);
}

#[test]
fn numbers_that_nobody_has_are_drawn_too() {
    let mut row = row(usize::MAX, RowStatus::Optimal, 1e308);
    for seconds in [1e308, -1.0, 0.0] {
        row.took.cpu_seconds = seconds;
        let rows = [row.clone()];
        assert!(plot(&success(&rows), Axes::Success).is_ok());
        assert!(plot(&cactus(&rows), Axes::Cactus).is_ok());
    }
}
