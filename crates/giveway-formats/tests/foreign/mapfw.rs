//! mapfw.nl and mapf.nl: small benchmarks, written by hand after what the public
//! clients read and send.

use giveway_formats::{Format, Held, Missing, read, recognise};
use giveway_model::Cell;
use giveway_model::check::Rule;
use serde_json::{Value, json};

use crate::support::{comes_back, lacking, opened, refused, violations};

/// A problem; the server writes sides as texts, too.
fn problem() -> Value {
    serde_json::from_str(include_str!("../data/plans/small-mapfw.json")).unwrap()
}

const SOLUTION: &str = include_str!("../data/plans/small-mapfw-solution.json");

#[test]
fn a_problem_and_its_solution_are_read_and_come_back() {
    let text = problem().to_string();
    assert_eq!(recognise(&text), Ok(Format::Mapfw));
    assert_eq!(recognise(SOLUTION), Ok(Format::Mapfw));
    let read = opened(&[("a.json", &text), ("a-solution.json", SOLUTION)]).unwrap();
    assert_eq!(read.instance.grid().rows(), ["....", ".##.", "...."]);
    let agents = read.instance.agents();
    assert_eq!(agents[0].waypoints, [Cell::new(1, 0), Cell::new(0, 1)]);
    assert_eq!(agents[1].goal, Some(Cell::new(0, 2)));
    assert!(read.plans[0].fit.is_perfect());
    assert_eq!(violations(&read.instance, &read.plans[0]), []);
    let written = comes_back(Format::Mapfw, &read);
    assert_eq!(written.losses, ["the objective"]);
}

#[test]
fn a_faulty_solution_shows_every_violation() {
    let mut both = problem();
    both["solution"] = json!([
        [[0, 0], [1, 0], [1, 1], [2, 0], [3, 0]],
        [[3, 2], [3, 1], [3, 0], [3, 0], [3, 0]]
    ]);
    let read = opened(&[("a.json", &both.to_string())]).unwrap();
    let found = violations(&read.instance, &read.plans[0]);
    let one = || vec!["A1".to_owned()];
    let both = || vec!["A1".to_owned(), "A2".to_owned()];
    assert!(found.contains(&(Rule::Obstacle, 2, one())), "{found:?}");
    assert!(found.contains(&(Rule::Move, 2, one())), "{found:?}");
    assert!(found.contains(&(Rule::Vertex, 4, both())), "{found:?}");
    assert!(found.contains(&(Rule::Waypoint, 4, one())), "{found:?}");
    let goal = (Rule::Goal, 4, vec!["A2".to_owned()]);
    assert!(found.contains(&goal), "{found:?}");
    assert_eq!(found.len(), 5, "{found:?}");
}

#[test]
fn of_a_download_the_first_problem_is_read() {
    let inner = problem().to_string();
    let download = json!({
        "attempt": 7, "timeout": 60000,
        "problems": [{"id": 1, "problem": inner}, {"id": 2, "problem": "{}"}],
    });
    let read = opened(&[("a.json", &download.to_string())]).unwrap();
    assert_eq!(read.instance.agents().len(), 2);
    assert_eq!(read.notes, ["The file has 2 problems; the first is read."]);

    let broken = json!({"problems": [{"id": 1, "problem": inner.replace("[3,2]", "[3,9]")}]});
    assert_eq!(
        refused(&broken.to_string()).to_string(),
        "line 1, column 32: problems[0].problem.starts[1]: found (3, 9), expected a cell of the grid"
    );
}

#[test]
fn a_robot_of_a_colour_takes_a_goal_of_its_colour() {
    let mark = |x: u32, y: u32, color: u32| json!({"x": x, "y": y, "color": color});
    let text = json!({
        "grid": [[0, 0, 0]], "width": 3, "height": 1,
        "starts": [mark(0, 0, 1), mark(1, 0, 2)],
        "goals": [mark(2, 0, 2), mark(1, 0, 1)],
    });
    let read = opened(&[("a.json", &text.to_string())]).unwrap();
    let goals: Vec<Cell> = read
        .instance
        .agents()
        .iter()
        .filter_map(|it| it.goal)
        .collect();
    assert_eq!(goals, [Cell::new(1, 0), Cell::new(2, 0)]);
    let paths = r#"{"solutions": [{"solution": {"paths": [{"route": [{"x": 0, "y": 0}, {"x": 1, "y": 0}]},
        {"route": [{"x": 1, "y": 0}, {"x": 2, "y": 0}]}]}}]}"#;
    let read = opened(&[("a.json", &text.to_string()), ("b.json", paths)]).unwrap();
    assert_eq!(violations(&read.instance, &read.plans[0]), []);
}

#[test]
fn paths_may_stand_alone() {
    let Ok((Format::Mapfw, Held::Plan(plan))) = read("[[[0, 0], [1, 0]], [[2, 2]]]") else {
        panic!("a plan")
    };
    assert_eq!(plan.agents.len(), 2);
}

#[test]
fn faults_have_their_place_and_keys() {
    let changed = |key: &str, value: Value| {
        let mut problem = problem();
        problem[key] = value;
        let lines: Vec<String> = problem
            .as_object()
            .unwrap()
            .iter()
            .map(|(key, value)| format!("\"{key}\": {value}"))
            .collect();
        format!("{{\n{}\n}}", lines.join(",\n"))
    };
    // Keys are in the order of the alphabet: goals, grid, height, starts, waypoints, width.
    let cases = [
        (
            changed("grid", json!([[0, 0, 0, 0], [0, 1, 5, 0], [0, 0, 0, 0]])),
            "line 3, column 25: grid[1][2]: found 5, expected 0 or 1",
        ),
        (
            changed("grid", json!([[0, 0, 0, 0], [0], [0, 0, 0, 0]])),
            "line 3, column 20: grid[1]: found a row of 1 cell, expected 4, as in the first row",
        ),
        (
            changed("height", json!(5)),
            "line 4, column 11: height: found 5, expected 3, as in the grid",
        ),
        (
            changed("goals", json!([[3, 0]])),
            "line 2, column 10: goals: found 1 entries, expected 2, one for each start",
        ),
        (
            changed("starts", json!([[0, 0], [1, 1]])),
            "line 5, column 18: starts[1]: found the wall (1, 1), expected a free cell",
        ),
        (
            changed("starts", json!([[0, 0], [0, 0]])),
            "line 5, column 18: starts[1]: found (0, 0), which starts[0] is, too, expected a cell of its own",
        ),
        (
            changed("starts", json!([[0, 0], [0, 1, 2]])),
            "line 5, column 18: starts[1]: found a list of 3, expected a cell [x, y]",
        ),
        (
            changed("waypoints", json!([[[7, 7]], []])),
            "line 6, column 16: waypoints[0][0]: found (7, 7), expected a cell of the grid",
        ),
    ];
    for (text, said) in cases {
        assert_eq!(refused(&text).to_string(), said, "{text}");
    }
    let wide = vec![0; 3000];
    assert_eq!(
        refused(&changed("grid", json!([wide]))).to_string(),
        "line 3, column 9: grid: found a grid of 3000 x 1 cells, expected 1 to 2048 rows and columns"
    );
}

#[test]
fn a_solution_alone_asks_for_its_problem() {
    let (what, sentence) = lacking("a-solution.json", SOLUTION);
    assert_eq!(what, Missing::Problem);
    assert_eq!(
        sentence,
        "a-solution.json is a solution without its problem: open the benchmark of mapfw.nl (.json), \
         which has the map and the robots, together with it."
    );
}

#[test]
fn the_ends_of_a_plan_decide_goals_of_a_colour_and_unknown_keys_are_told() {
    let problem = r#"{"grid": [[0, 0, 0], [0, 0, 0]], "speed": [1, 1],
        "starts": [{"x": 0, "y": 0, "color": 1}, {"x": 2, "y": 0, "color": 1}],
        "goals": [{"x": 2, "y": 1, "color": 1}, {"x": 0, "y": 1, "color": 1}]}"#;
    let plan = "[[[0, 0], [0, 1]], [[2, 0], [2, 1]]]";
    let read = opened(&[("p.json", problem), ("s.json", plan)]).unwrap();
    assert_eq!(violations(&read.instance, &read.plans[0]), []);
    assert!(
        read.notes
            .iter()
            .any(|note| note.contains("where the paths in s.json end"))
    );
    assert!(
        read.notes.iter().any(|note| note.contains("speed")),
        "{:?}",
        read.notes
    );
    // An end that is no goal of its colour decides nothing.
    let elsewhere = "[[[0, 0], [1, 0]], [[2, 0], [2, 1]]]";
    let read = opened(&[("p.json", problem), ("s.json", elsewhere)]).unwrap();
    assert_eq!(
        read.instance.agents()[1].goal,
        Some(giveway_model::Cell::new(2, 1))
    );
    assert!(!violations(&read.instance, &read.plans[0]).is_empty());
}
