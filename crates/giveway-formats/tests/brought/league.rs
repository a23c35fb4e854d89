//! Problems and summaries of the League of Robot Runners, and results of a part of a team.

use giveway_formats::{Missing, Refused};
use giveway_model::Cell;

use super::{apart, brought, opened, refused};

const MAP: &str = "type octile\nheight 2\nwidth 3\nmap\n...\n...\n";

#[test]
fn a_problem_names_the_files_that_it_needs() {
    let problem = brought("problem.json");
    assert_eq!(
        apart(&[("problem.json", &problem)]),
        "problem.json is a problem of the League of Robot Runners: open the files that it names together with it: a.map, a.agents, a.tasks."
    );
    let Err(Refused::Missing { what, .. }) = opened(&[("p.json", &problem), ("a.map", MAP)]) else {
        panic!("two files are missing");
    };
    assert_eq!(
        what,
        Missing::Files(vec!["a.agents".to_owned(), "a.tasks".to_owned()])
    );
}

#[test]
fn a_problem_is_read_with_its_files() {
    let problem = r#"{ "mapFile": "maps/a.map", "agentFile": "agents/a.agents", "taskFile": "a.tasks", "teamSize": 2, "revealPeriod": 1 }"#;
    let files = |agents, tasks| {
        [
            ("p.json", problem),
            ("a.map", MAP),
            ("a.agents", agents),
            ("a.tasks", tasks),
        ]
    };
    let combined = opened(&files("3\n0\n2\n4\n", "# tasks\n2\n5,3\n0\n")).unwrap();
    let agents = combined.instance.agents();
    assert_eq!(
        (agents[0].start, agents[1].start),
        (Cell::new(0, 0), Cell::new(2, 0))
    );
    assert_eq!(
        (agents[0].goal, &*agents[0].waypoints),
        (Some(Cell::new(0, 1)), &[Cell::new(2, 1)][..])
    );
    let notes = combined.notes.join(" ");
    assert!(
        notes.contains("further robots of the file (1)") && notes.contains("without end"),
        "{notes}"
    );
    assert!(apart(&files("1\n0\n", "0\n")).contains("a.agents"));
    assert!(apart(&files("2\n0\n9\n", "0\n")).contains("a.agents, line 3, column 1: found \"9\""));
}

#[test]
fn a_summary_has_nothing_to_judge() {
    assert!(refused(&brought("summary.json")).contains("a summary of the League of Robot Runners"));
    assert!(
        refused(r#"{ "teamSize": 3, "sumOfCost": 9, "AllValid": "Yes" }"#).contains("no paths")
    );
}

#[test]
fn starts_beyond_the_team_are_left_out_and_told() {
    let result = |team: u32, paths: &str| {
        format!(
            r#"{{"actionModel": "MAPF", "teamSize": {team}, "start": [[0, 0, "N/A"], [1, 0, "N/A"]], "actualPaths": {paths}}}"#
        )
    };
    let read = |text: &str| {
        opened(&[("r.json", text), ("a.map", MAP)])
            .unwrap()
            .plans
            .remove(0)
    };
    let one = read(&result(1, r#"["R,R"]"#));
    assert_eq!(one.plan.paths.len(), 1);
    assert!(
        one.notes
            .join(" ")
            .contains("further starts (1) are left out"),
        "{:?}",
        one.notes
    );
    assert_eq!(read(&result(1, r#"["R,R", ""]"#)).plan.paths.len(), 1);
    let both = read(&result(1, r#"["R,R", "R,R"]"#));
    assert_eq!(both.plan.paths.len(), 2);
    assert!(
        both.notes.join(" ").contains("all of them are read"),
        "{:?}",
        both.notes
    );
    assert!(refused(&result(2, r#"["R,R"]"#)).contains("one for each start"));
}
