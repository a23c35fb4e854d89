//! Comparisons of a few rows.

use giveway_model::{Cost, Costs};

use super::*;
use crate::table::{Show, Written, write};
use crate::{Clock, Failure, PlannerSpec, Task};

/// The row of a planner on an instance.
fn row(instance: &str, agents: usize, planner: &str, status: RowStatus) -> Row {
    let method: Method = planner.to_owned().try_into().unwrap();
    let spec = PlannerSpec {
        name: planner.to_owned(),
        command: "x {map} {out}".to_owned(),
        about: Some("version <2>".to_owned()),
    };
    let is_command = matches!(method, Method::Command(_));
    let task = Task {
        instance: instance.to_owned(),
        agents: Some(agents),
        objective: Some("sum-of-costs,makespan".parse().unwrap()),
        planner: method,
        command: Some(spec).filter(|_| is_command),
        limits: giveway_solve::Limits {
            seconds: Some(60.0),
            memory_bytes: Some(4_000_000_000),
            ..giveway_solve::Limits::default()
        },
        clock: Clock::Cpu,
        certificate: None,
    };
    let mut row = Row::bare(&task, status, None);
    row.map = Some("maze".to_owned());
    row
}

/// One that ended with a plan of this cost after so many seconds.
fn solved(instance: &str, agents: usize, planner: &str, cost: u32, seconds: f64) -> Row {
    let is_search = planner == "search";
    let status = if is_search {
        RowStatus::Optimal
    } else {
        RowStatus::Feasible
    };
    let mut row = row(instance, agents, planner, status);
    row.costs = Some(Costs {
        sum_of_costs: cost,
        ..Costs::default()
    });
    row.took.cpu_seconds = seconds;
    row.complete = is_search;
    if is_search {
        row.bounds.insert(Cost::SumOfCosts, cost);
    }
    row
}

fn failed(instance: &str, agents: usize, planner: &str, failure: Failure, reason: &str) -> Row {
    Row {
        failure: Some(failure),
        reason: Some(reason.to_owned()),
        ..row(instance, agents, planner, RowStatus::Failed)
    }
}

/// Two instances of five robots, two of ten: one of these has only a bound, one is not run.
fn rows() -> Vec<Row> {
    let mut open = row("b.scen", 10, "search", RowStatus::Unknown);
    open.bounds.insert(Cost::SumOfCosts, 200);
    vec![
        solved("a.scen", 5, "search", 100, 0.1),
        solved("b.scen", 5, "search", 100, 0.2),
        solved("a.scen", 10, "search", 200, 3.0),
        open,
        solved("a.scen", 5, "mine", 100, 1.0),
        solved("b.scen", 5, "mine", 103, 2.0),
        failed("a.scen", 10, "mine", Failure::Illegal, "A1 and A2 swap"),
        solved("b.scen", 10, "mine", 201, 9.0),
        solved("a.scen", 5, "yours", 150, 0.5),
        failed("b.scen", 5, "yours", Failure::Crashed, "exit 1 after 2 s"),
        failed("a.scen", 10, "yours", Failure::Crashed, "exit 2 after 3 s"),
    ]
}

fn csv(rows: &[Row]) -> Vec<String> {
    let text = write(rows, Show::Planners, Written::Csv).unwrap();
    text.lines().map(str::to_owned).collect()
}

#[test]
fn planners_stand_beside_what_is_proved() {
    let lines = csv(&rows());
    assert_eq!(
        lines[0],
        "cost,planner,about,legal plans,of,half within s,9 of 10 within s,at the best,\
         median gap %,largest gap %,crashed,time,memory,illegal,wrong cost,not run"
    );
    assert_eq!(
        lines[1],
        "sum of costs,search,,3,4,0.10,0.10,3,0,0,0,1,0,0,0,0"
    );
    assert_eq!(
        lines[2],
        "sum of costs,mine,version <2>,3,4,1.00,1.00,1,0,3.0,0,0,0,1,0,0"
    );
    assert_eq!(
        lines[3],
        "sum of costs,yours,version <2>,1,4,0.50,0.50,0,50.0,50.0,2,0,0,0,0,1"
    );
    assert_eq!(lines.len(), 4);
}

#[test]
fn sentences_tell_what_is_proved_and_the_first_failures() {
    let text = write(&rows(), Show::Planners, Written::Markdown).unwrap();
    for expected in [
        "4 instances: 1 map, 5 to 10 robots. Sum of costs. 60 CPU s and 4 GB for each.",
        "3 of 4 are proved best. A gap is the cost of a legal plan over what is proved, rounded up.",
        "For 1 other only a bound is proved",
        "of the 1 instance that all planners solved",
        "- crashed: yours, b.scen, 5 robots: exit 1 after 2 s\n",
        "- illegal: mine, a.scen, 10 robots: A1 and A2 swap\n",
    ] {
        assert!(text.contains(expected), "{expected}\n{text}");
    }
    assert!(!text.contains("exit 2"), "only the first");
}

#[test]
fn lines_end_where_fewer_than_half_are_solved() {
    let comparison = &comparisons(&rows())[0];
    let points = |name: &str| {
        let line = comparison
            .lines
            .iter()
            .find(|line| line.name == name)
            .unwrap();
        let points = line.by_agents.iter();
        points
            .map(|(agents, gap)| (*agents, gap.to_string()))
            .collect::<Vec<_>>()
    };
    assert_eq!(
        points("search"),
        [(5, "0".to_owned()), (10, "0".to_owned())]
    );
    assert_eq!(
        points("mine"),
        [(5, "3.0".to_owned()), (10, "0.5".to_owned())]
    );
    assert_eq!(points("yours"), [(5, "50.0".to_owned())]);
}

#[test]
fn what_is_proved_within_a_horizon_stays_out_and_impossible_instances_too() {
    let mut rows = rows();
    rows[0].within = Some(30);
    rows[0].complete = false;
    rows[2] = row("a.scen", 10, "search", RowStatus::Impossible);
    rows[2].complete = true;
    let text = write(&rows, Show::Planners, Written::Markdown).unwrap();
    for expected in [
        "1 of 3 are proved best.",
        "Of 1 nothing is proved: their plans have no gap here.",
        "1 more has no plan, which is proved, and has no part in this.",
    ] {
        assert!(
            text.replace("1 of 3 is", "1 of 3 are").contains(expected),
            "{expected}\n{text}"
        );
    }
    let lines = csv(&rows);
    assert!(
        lines[1].starts_with("sum of costs,search,,1,3,"),
        "{}",
        lines[1]
    );
}

#[test]
fn a_plan_below_a_proof_is_told() {
    let mut rows = rows();
    rows.push(solved("a.scen", 5, "lucky", 99, 1.0));
    for to in [Written::Markdown, Written::Html] {
        let text = write(&rows, Show::Planners, to).unwrap();
        let expected = "a.scen, 5 robots: the plan of lucky costs 99, and at least 100 was proved.";
        assert!(text.contains(expected), "{text}");
    }
}

#[test]
fn the_page_is_one_file_without_scripts_and_names_are_no_markup() {
    let mut rows = rows();
    rows.push(failed(
        "<i>.scen",
        5,
        "mine",
        Failure::WrongCost,
        "says <b>",
    ));
    let html = write(&rows, Show::Planners, Written::Html).unwrap();
    assert!(html.starts_with("<!doctype html>") && html.contains("version &lt;2&gt;"));
    for never in [
        "<script", "http://", "https://", "url(", "<i>.scen", "says <b>",
    ] {
        assert!(
            !html
                .replace("http://www.w3.org/2000/svg", "")
                .contains(never),
            "{never}"
        );
    }
    let svg = write(&rows, Show::Planners, Written::Svg).unwrap();
    let document = roxmltree::Document::parse(&svg).unwrap();
    let names = document
        .descendants()
        .filter(|node| node.attribute("font-weight").is_some());
    let names: Vec<&str> = names.filter_map(|node| node.text()).collect();
    // Of three instances of five robots yours solved one.
    assert_eq!(names, ["search", "mine", "yours", "search", "mine"]);
}

#[test]
fn budgets_and_objectives_are_told_apart() {
    let mut rows = rows();
    let mut longer = solved("a.scen", 5, "mine", 100, 1.0);
    longer.task = longer.task.replace("cpu-seconds=60", "cpu-seconds=90");
    rows.push(longer);
    let mut other = row("a.scen", 5, "mine", RowStatus::Failed);
    other.objective = Some("makespan".parse().unwrap());
    rows.push(other);
    let lines = csv(&rows);
    assert!(
        lines[1].starts_with("makespan,\"mine, command="),
        "{}",
        lines[1]
    );
    let mine = lines
        .iter()
        .filter(|line| line.contains("\"mine, command="));
    assert_eq!(mine.count(), 3);
}

#[test]
fn nothing_but_planners_of_this_project_is_compared_too() {
    let rows = [
        solved("a.scen", 5, "search", 100, 0.1),
        solved("a.scen", 5, "lacam", 120, 0.1),
    ];
    let lines = csv(&rows);
    assert!(
        lines[2].contains("lacam,,1,1,0.10,0.10,0,20.0,20.0"),
        "{}",
        lines[2]
    );
    for to in [Written::Html, Written::Svg, Written::Markdown] {
        write(&rows, Show::Planners, to).unwrap();
        write(&rows[..1], Show::Planners, to).unwrap();
    }
}
