//! `giveway report`.

use std::fs;
use std::path::Path;

use expect_test::expect_file;

use crate::run::{Folder, WAREHOUSE, WAREHOUSE_PLAN, two_agents};

/// A plan in which the robots swap.
const BROKEN: &str = r#"{ "giveway": 1, "paths": {
  "A1": [[0,0],[0,1],[1,1],[2,1],[3,1]],
  "A2": [[3,0],[2,0],[2,1],[1,1],[0,1]] } }"#;

fn folder() -> Folder {
    Folder::with(&[
        ("warehouse.json", WAREHOUSE),
        ("warehouse.plan.json", WAREHOUSE_PLAN),
    ])
}

/// The texts of the cells of a table in a page, row by row.
fn rows(html: &str, table: &str) -> Vec<Vec<String>> {
    let table = html.split(&format!("<table class=\"{table}\">")).nth(1);
    let body = table.and_then(|table| table.split("</table>").next());
    let body = body
        .and_then(|table| table.split("<tbody>").nth(1))
        .and_then(|rows| rows.split("</tbody>").next())
        .unwrap();
    let text = |cell: &str| {
        let mut inside = false;
        let plain = |c: &char| {
            match c {
                '<' => inside = true,
                '>' => {
                    inside = false;
                    return false;
                }
                _ => {}
            }
            !inside
        };
        cell.chars().filter(plain).collect::<String>()
    };
    let rows = body.split("</tr>").filter(|row| row.contains("<td"));
    rows.map(|row| {
        let cells = row.replace("</th>", "</td>");
        let cells = cells.trim_end_matches("</td>").split("</td>");
        cells.map(text).map(|cell| cell.trim().to_owned()).collect()
    })
    .collect()
}

/// The page tells the same figures: `tests/e2e/report.test.mjs` compares with this file.
#[test]
fn the_best_plan_is_reported_with_its_proof() {
    let folder = folder();
    let run = folder.run("report warehouse.json -o report.html");
    assert_eq!((run.exit, run.out.as_str()), (Some(0), ""), "{}", run.err);
    let html = folder.read("report.html");
    expect_file!["../../../../tests/data/report/warehouse.html"].assert_eq(&html);
    assert!(html.contains("<b>Proved: no plan is better.</b>"));
    assert_eq!(
        rows(&html, "report-costs"),
        [
            ["Last arrival (makespan)", "18", "18"],
            ["Sum of costs", "35", "35"],
            ["Charges", "3", "3"],
            ["Moves", "30", ""],
            ["Waits", "0", ""],
        ]
    );
    let robots = rows(&html, "report-robots");
    let arrivals: Vec<&str> = robots.iter().map(|row| row[4].as_str()).collect();
    let mut sorted = arrivals.clone();
    sorted.sort_unstable();
    assert_eq!(sorted, ["17", "18"]);
    assert!(!html.contains("<script"));
    assert!(!html.contains("http"), "it needs nothing else");
}

/// The page tells the same of these, too.
#[test]
fn many_robots_are_reported() {
    for robots in [16, 200] {
        let scene = Path::new(env!("CARGO_MANIFEST_DIR"))
            .join(format!("../../tests/data/report/rows-{robots}.json"));
        let folder = Folder::with(&[("rows.json", &fs::read_to_string(&scene).unwrap())]);
        let run = folder.run("report rows.json -o report.html");
        assert_eq!((run.exit, run.out.as_str()), (Some(0), ""), "{}", run.err);
        let html = folder.read("report.html");
        assert_eq!(rows(&html, "report-robots").len(), robots);
        expect_file![scene.with_extension("html")].assert_eq(&html);
    }
}

#[test]
fn a_report_tells_who_is_last_and_how_batteries_fare() {
    let folder = folder();
    let html = folder.run("report warehouse.json").out;
    let robots = rows(&html, "report-robots");
    let last = robots.iter().find(|row| row[4] == "18").unwrap();
    assert!(html.contains(&format!("<li>{} arrives last, at 18.</li>", last[0])));
    // Its arrival alone, and what it loses.
    let [alone, delay] = [&last[5], &last[6]].map(|cell| cell.parse::<u32>().unwrap_or(0));
    assert_eq!(alone + delay, 18, "{robots:?}");
    assert!(html.contains(&format!("Alone, {} would arrive at {alone}", last[0])));
    let batteries = rows(&html, "report-batteries");
    let charges = batteries.iter().map(|row| row[6].parse::<u32>().unwrap());
    assert_eq!(charges.sum::<u32>(), 3, "as many as the plan costs");
    for row in &batteries {
        let levels = [2, 3, 5].map(|column| row[column].parse::<i64>().unwrap());
        assert!(levels[1] <= levels[0].min(levels[2]), "the least: {row:?}");
    }
}

#[test]
fn the_link_is_printed_where_the_page_is_known() {
    let folder = folder();
    let run = folder.run("report warehouse.json --address https://example.org/giveway/");
    let link = "<a href=\"https://example.org/giveway/#giveway=1&amp;check=";
    assert!(run.out.contains(link), "{}", run.out);
}

#[test]
fn a_plan_that_is_given_is_compared_with_the_best() {
    let folder = folder();
    let run = folder.run("report warehouse.json warehouse.plan.json");
    assert_eq!(run.exit, Some(0), "{}", run.err);
    assert!(run.out.starts_with("<!doctype html>"));
    assert!(
        run.out.contains("Proved: no plan is better."),
        "{}",
        run.out
    );
}

#[test]
fn tables_are_for_spreadsheets() {
    let folder = folder();
    let line =
        "report warehouse.json warehouse.plan.json -o r.html --csv plan.csv --robots robots.csv";
    assert_eq!(folder.run(line).exit, Some(0));
    let plan = folder.read("plan.csv");
    let mut lines = plan.trim_start_matches('\u{feff}').split("\r\n");
    assert_eq!(lines.next(), Some("Robot,Time,x,y,Level"));
    assert_eq!(lines.next(), Some("A1,0,0,0,10"));
    let times = lines.filter(|line| !line.is_empty()).count();
    // 17 and 18 steps, each robot with the time 0; the first line was read.
    assert_eq!(times, 18 + 19 - 1);
    let robots = folder.read("robots.csv");
    assert_eq!(robots.trim().lines().count(), 3);
}

#[test]
fn a_plan_that_breaks_a_rule_is_said_to() {
    let folder = Folder::with(&[
        ("two.json", two_agents(&[])),
        ("plan.json", BROKEN.to_owned()),
    ]);
    let run = folder.run("report two.json plan.json");
    assert_eq!(run.exit, Some(1), "{}", run.err);
    assert!(!run.out.contains("claim proved"), "{}", run.out);
    assert!(run.out.contains("<section class=\"claim\">"));
}

#[test]
fn changes_are_part_of_the_report() {
    let folder = Folder::with(&[
        (
            "lane.json",
            r#"{ "giveway": 1, "map": ["....", "...."], "agents": [
          { "name": "R1", "start": [0, 0], "goal": [3, 0] },
          { "name": "R2", "start": [0, 1], "goal": [3, 1] } ] }"#,
        ),
        (
            "changes.json",
            r#"{ "giveway": 1, "changes": [
          { "at": 1, "change": "delay-agent", "agent": "R1", "steps": 2 } ] }"#,
        ),
        (
            "plan.json",
            r#"{ "giveway": 1, "paths": {
          "R1": [[0,0],[1,0],[1,0],[1,0],[2,0],[3,0]],
          "R2": [[0,1],[1,1],[2,1],[3,1]] } }"#,
        ),
    ]);
    let run = folder.run("report lane.json plan.json --changes changes.json");
    assert_eq!(run.exit, Some(0), "{}", run.err);
    assert_eq!(
        rows(&run.out, "report-changes"),
        [["1", "R1 breaks down for 2 steps"]]
    );
    let robots = rows(&run.out, "report-robots");
    // Alone it would be broken down, too.
    assert_eq!(robots[0], ["R1", "0, 0", "3, 0", "5", "5", "0", "2", ""]);
    assert!(
        run.out
            .contains("R1 is broken down at (1, 0) between 1 and 3.")
    );
    assert!(run.out.contains("sign-breakdown"));
}

#[test]
fn without_a_plan_there_is_nothing_to_report() {
    let folder = Folder::scene(
        r#"{ "giveway": 1, "map": [".."], "agents": [
          { "name": "A1", "start": [0, 0], "goal": [1, 0] },
          { "name": "A2", "start": [1, 0], "goal": [0, 0] } ] }"#,
    );
    let run = folder.run("report scene.json");
    assert_eq!((run.exit, run.out.as_str()), (Some(1), ""));
    assert!(run.err.contains("There is no plan"), "{}", run.err);
}
