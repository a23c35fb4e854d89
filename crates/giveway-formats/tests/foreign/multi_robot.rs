//! libMultiRobotPlanning: a scenario and schedules, written by hand after what its
//! programs print.

use giveway_formats::{Format, Missing, recognise};
use giveway_model::check::Rule;
use giveway_model::{Cell, Constraint, Cost, Instance, Scene};

use crate::support::{comes_back, lacking, opened, refused, violations};

/// Two robots that pass each other by a pocket at (1, 1).
const SCENARIO: &str = include_str!("../data/plans/small-scenario.yaml");

const SCHEDULE: &str = include_str!("../data/plans/small-schedule.yaml");

/// The second robot waits in the way.
const FAULTY: &str = include_str!("../data/plans/small-faulty-schedule.yaml");

#[test]
fn a_scenario_and_a_schedule_are_read_and_come_back() {
    assert_eq!(recognise(SCENARIO), Ok(Format::MultiRobot));
    assert_eq!(recognise(SCHEDULE), Ok(Format::MultiRobot));
    // The second robot leaves out the times at which it waits, as the planner with
    // safe intervals does; it waits before it moves.
    let read = opened(&[("s.yaml", SCENARIO), ("plan.yaml", SCHEDULE)]).unwrap();
    assert_eq!(read.instance.grid().rows(), ["...", "#.#"]);
    assert_eq!(read.instance.agents()[1].name, "agent1");
    let plan = &read.plans[0];
    assert!(plan.fit.is_perfect(), "{:?}", plan.fit);
    assert_eq!(plan.claimed.sum_of_costs, Some(7));
    assert_eq!(plan.claimed.makespan, Some(4));
    let path = plan.plan.path("agent1");
    let cells = [(2, 0), (2, 0), (1, 0), (0, 0)].map(|cell| Some(Cell::from(cell)));
    assert_eq!(path, cells);
    assert_eq!(violations(&read.instance, plan), []);
    let written = comes_back(Format::MultiRobot, &read);
    assert_eq!(written.losses, ["the objective"]);
}

#[test]
fn a_schedule_is_judged_by_what_its_planners_minimise() {
    let first_cost = |files: &[(&str, &str)]| {
        let read = opened(files).unwrap();
        read.instance.objective().costs()[0]
    };
    let (scenario, schedule) = (("s.yaml", SCENARIO), ("plan.yaml", SCHEDULE));
    assert_eq!(first_cost(&[scenario, schedule]), Cost::SumOfCosts);
    let both = format!("{SCENARIO}{SCHEDULE}");
    assert_eq!(first_cost(&[("both.yaml", &both)]), Cost::SumOfCosts);
    // A scene alone is as any other, and a scene of this project says it itself.
    assert_eq!(first_cost(&[scenario]), Cost::Makespan);
    let own = r##"{"giveway": 1, "map": ["...", "#.#"], "agents": [
        {"name": "a", "start": [0, 0], "goal": [2, 0]},
        {"name": "b", "start": [2, 0], "goal": [0, 0]}]}"##;
    assert_eq!(first_cost(&[("own.json", own), schedule]), Cost::Makespan);
}

#[test]
fn a_faulty_schedule_shows_every_violation() {
    let read = opened(&[("both.yaml", &format!("{SCENARIO}{FAULTY}"))]).unwrap();
    let found = violations(&read.instance, &read.plans[0]);
    let both = || vec!["agent0".to_owned(), "agent1".to_owned()];
    assert_eq!(found, [(Rule::Vertex, 3, both())]);

    let faulty = FAULTY.replace(
        "    - x: 1\n      y: 1\n      t: 2\n    - x: 1\n      y: 0\n      t: 3\n",
        "    - x: 1\n      y: 0\n      t: 2\n    - x: 2\n      y: 1\n      t: 3\n",
    );
    let read = opened(&[("s.yaml", SCENARIO), ("plan.yaml", &faulty)]).unwrap();
    let found = violations(&read.instance, &read.plans[0]);
    let one = || vec!["agent0".to_owned()];
    let expected = [
        (Rule::Move, 2, one()),
        (Rule::Vertex, 2, both()),
        (Rule::Obstacle, 3, one()),
    ];
    assert_eq!(found, expected);
}

#[test]
fn robots_that_may_choose_take_goals_of_their_own() {
    let text = "
map: {dimensions: [3, 1], obstacles: []}
agents:
  - name: a
    start: [0, 0]
    potentialGoals: [[1, 0], [2, 0]]
  - name: b
    start: [1, 0]
    potentialGoals:
      - [1, 0]
";
    let read = opened(&[("s.yaml", text)]).unwrap();
    let goals: Vec<Cell> = read
        .instance
        .agents()
        .iter()
        .filter_map(|it| it.goal)
        .collect();
    assert_eq!(goals, [Cell::new(2, 0), Cell::new(1, 0)]);
    assert!(read.notes[0].starts_with("Robots may choose from several goals."));
}

#[test]
fn names_come_back_whatever_they_are_and_waypoints_are_a_loss() {
    let names = ["null", "a: b", "\"q\\\"", "1", "über\tx", "agent0", "#"];
    let agents: Vec<serde_json::Value> = names
        .iter()
        .enumerate()
        .map(|(i, name)| {
            serde_json::json!({"name": name, "start": [i, 0], "goal": [i, 1], "waypoints": [[0, 1]]})
        })
        .collect();
    let scene: Scene = serde_json::from_value(serde_json::json!({
        "giveway": 1, "map": [".......", "......."], "agents": agents,
    }))
    .unwrap();
    let instance = Instance::new(scene).unwrap();
    let written = giveway_formats::write(Format::MultiRobot, "it", Some(&instance), None).unwrap();
    assert_eq!(written.losses, ["the waypoints of 7 robots"]);
    let read = opened(&[("it.yaml", &written.files[0].1)]).unwrap();
    let read: Vec<&str> = read.instance.agents().iter().map(|it| &*it.name).collect();
    assert_eq!(read, names);
}

#[test]
fn faults_have_their_place_and_keys() {
    let cases = [
        (
            SCENARIO.replace("start: [2, 0]", "start: [2, 1]"),
            "line 7, column 13: agents[1].start: found the obstacle (2, 1), expected a free cell",
        ),
        (
            SCENARIO.replace("goal: [2, 0]", "goal: [2, 7]"),
            "line 2, column 12: agents[0].goal: found (2, 7), expected a cell of the 3 x 2 map",
        ),
        (
            SCENARIO.replace("[3, 2]", "[3, 3000]"),
            "line 9, column 18: map.dimensions: found a map of 3 x 3000 cells, expected 1 to 2048 rows and columns",
        ),
        (
            SCENARIO.replace("[3, 2]", "[3, 3000000000]"),
            "line 9, column 21: map.dimensions[1]: found \"3000000000\", expected a whole number",
        ),
        (
            SCHEDULE.replacen("t: 2", "t: 1", 1),
            "the times up to 1 are there",
        ),
        (
            SCHEDULE.replacen("t: 4", "t: 400000000", 1),
            "found a plan of over 24000000 steps",
        ),
        (
            SCHEDULE.replacen("y: 0", "z: 0", 1),
            "found a state without x, y or t, expected all three",
        ),
        (
            SCHEDULE.replace("agent1", "agent0"),
            "found the agent \"agent0\" again, expected each agent once",
        ),
        ("schedule:\n  agent0: [".to_owned(), "found broken YAML"),
        (
            "map:\n  dimensions: [1, 1]\nagents:\n  - start: [0, 0]\n".to_owned(),
            "agents[0]: found no goal, expected goal or potentialGoals for each agent",
        ),
    ];
    for (text, said) in cases {
        let fault = refused(&text);
        assert!(fault.to_string().contains(said), "{fault}\n{text}");
        assert!(fault.line.is_some() && fault.column.is_some(), "{fault}");
    }
}

#[test]
fn a_solution_alone_asks_for_its_problem() {
    let (what, sentence) = lacking("plan.yaml", SCHEDULE);
    assert_eq!(what, Missing::Problem);
    assert_eq!(
        sentence,
        "plan.yaml is a solution without its problem: open the input file of libMultiRobotPlanning (.yaml), \
         which has the map and the robots, together with it."
    );
}

const NAMED: &str = "map: {dimensions: [2, 2], obstacles: []}\nagents:\n- {name: a, start: [0, 0], goal: [0, 1]}\n\
    - {name: b, start: [1, 0], goal: [1, 1]}\n";

#[test]
fn numbered_keys_mean_the_order_where_the_names_do_not_fit() {
    let scene = NAMED
        .replace("name: a", "name: agent1")
        .replace("name: b", "name: agent0");
    let numbered = |zero: u32, one: u32| {
        let path = |x: u32| format!("[{{t: 0, x: {x}, y: 0}}, {{t: 1, x: {x}, y: 1}}]");
        format!(
            "schedule:\n  agent0: {}\n  agent1: {}\n",
            path(zero),
            path(one)
        )
    };
    // The programs print numbers in the order of the scenario, whatever the names are.
    let by_order = opened(&[("s.yaml", &scene), ("p.yaml", &numbered(0, 1))]).unwrap();
    assert_eq!(violations(&by_order.instance, &by_order.plans[0]), []);
    assert!(by_order.plans[0].notes[0].contains("by their order"));
    let by_name = opened(&[("s.yaml", &scene), ("p.yaml", &numbered(1, 0))]).unwrap();
    assert_eq!(violations(&by_name.instance, &by_name.plans[0]), []);
    assert_eq!(by_name.plans[0].notes, Vec::<String>::new());
}

#[test]
fn names_that_the_scene_does_not_have_are_told() {
    let plan =
        "schedule:\n  b: [{t: 0, x: 1, y: 0}, {t: 1, x: 1, y: 1}]\n  c: [{t: 0, x: 0, y: 0}]\n";
    let read = opened(&[("s.yaml", NAMED), ("p.yaml", plan)]).unwrap();
    let plan = &read.plans[0];
    assert_eq!(
        plan.notes,
        [
            "p.yaml has paths for robots that the scene does not have: c.",
            "p.yaml has no path for a."
        ]
    );
    let found = violations(&read.instance, plan);
    assert!(
        found
            .iter()
            .any(|(rule, _, agents)| (*rule, &agents[..]) == (Rule::Shape, &["a".to_owned()][..]))
    );
}

#[test]
fn aliases_merges_and_tags_are_read_and_bombs_are_refused() {
    let text = "map: {dimensions: &side [2, 2], obstacles: [!!python/tuple [1, 1]]}\n\
        base: &base {start: [0, 0], name: x}\n\
        agents:\n- {<<: *base, name: a, goal: [1, 0]}\n";
    let read = opened(&[("s.yaml", text)]).unwrap();
    assert_eq!(read.instance.grid().rows(), ["..", ".#"]);
    assert_eq!(read.instance.agents()[0].name, "a");
    let json = r#"{"map": {"dimensions": [2, 1], "obstacles": []}, "agents": [{"start": [0, 0], "goal": [1, 0]}]}"#;
    assert_eq!(recognise(json), Ok(Format::MultiRobot));
    let mut bomb = "a0: &a0 [0, 0, 0, 0, 0, 0, 0, 0, 0, 0]\n".to_owned();
    for i in 1..12 {
        let below = vec![format!("*a{}", i - 1); 10].join(", ");
        bomb = bomb + &format!("a{i}: &a{i} [{below}]") + "\n";
    }
    bomb += "map: {dimensions: [2, 2], obstacles: []}\nagents: []\n";
    let fault = refused(&bomb);
    assert_eq!(fault.found, "aliases (*) that stand for too many values");
}

#[test]
fn obstacles_that_move_stay_at_their_last_cell() {
    let text = "map: {dimensions: [3, 1], obstacles: []}\nagents: [{name: a, start: [0, 0], goal: [2, 0]}]\n\
        dynamic_obstacles:\n  cart: [{t: 2, x: 1, y: 0}, {t: 4, x: 2, y: 0}]\n";
    let plan = |times: &str| format!("schedule: {{a: [{times}]}}\n");
    let judged = |times: &str| {
        let read = opened(&[("s.yaml", text), ("p.yaml", &plan(times))]).unwrap();
        violations(&read.instance, &read.plans[0])
    };
    // It is nowhere before its first state, waits between two, and stays at the last.
    let found = judged("{t: 0, x: 0, y: 0}, {t: 1, x: 1, y: 0}, {t: 2, x: 2, y: 0}");
    assert_eq!(found, [(Rule::Constraint, 4, vec!["a".to_owned()])]);
    let found = judged("{t: 0, x: 0, y: 0}, {t: 3, x: 1, y: 0}, {t: 4, x: 2, y: 0}");
    let times: Vec<usize> = found.iter().map(|(_, time, _)| *time).collect();
    assert_eq!(times, [3, 4]);
    let swapped = judged(
        "{t: 0, x: 0, y: 0}, {t: 1, x: 1, y: 0}, {t: 2, x: 2, y: 0}, {t: 4, x: 1, y: 0}, {t: 5, x: 2, y: 0}",
    );
    assert!(
        swapped
            .iter()
            .any(|(rule, time, _)| (*rule, *time) == (Rule::Obstacle, 3)),
        "{swapped:?}"
    );
}

#[test]
fn an_obstacle_that_jumps_is_rules_alone() {
    let text = "map: {dimensions: [3, 1], obstacles: []}\nagents: [{name: a, start: [0, 0], goal: [2, 0]}]\n\
        dynamic_obstacles: {cart: [{t: 1, x: 1, y: 0}, {t: 3, x: 5, y: 0}, {t: 4, x: 1, y: 0}]}\n";
    let read = opened(&[("s.yaml", text)]).unwrap();
    assert_eq!(read.instance.assumptions(), []);
    assert_eq!(read.instance.zones().len(), 1);
    let sentences = read.instance.constraints().iter();
    let sentences: Vec<String> = sentences.map(Constraint::sentence).collect();
    let expected = [
        "No robot in 'cart (1, 0)' from 1 to 2",
        "No robot in 'cart (1, 0)' from 4 on",
    ];
    assert_eq!(sentences, expected);
}

#[test]
fn a_scene_with_assumptions_comes_back_and_is_a_link() {
    let text = "map: {dimensions: [3, 1], obstacles: []}\nagents: [{name: a, start: [0, 0], potentialGoals: [[2, 0]], speed: 2}]\n\
        dynamic_obstacles: {cart: [{t: 0, x: 2, y: 0}, {t: 1, x: 1, y: 0}]}\n";
    let read = opened(&[("s.yaml", text)]).unwrap();
    let scene = read.instance.to_scene();
    assert_eq!(scene.assumptions.len(), 3);
    assert_eq!((scene.zones.len(), scene.constraints.len()), (2, 2));
    assert_eq!(scene.constraints[1].name.as_deref(), Some("cart 2"));
    assert!(
        read.notes
            .iter()
            .any(|note| note.contains("close the cells where cart is"))
    );
    let own = giveway_model::format::native::write_scene(&scene);
    assert_eq!(
        giveway_model::format::native::read_scene(&own),
        Ok(scene.clone())
    );
    let link = giveway_model::format::link::scene::write(&scene);
    let mut linked = Scene::default();
    for part in link.split('&') {
        let (key, value) = part.split_once('=').unwrap();
        if key != "giveway" {
            giveway_model::format::link::scene::read(&mut linked, key, value).unwrap();
        }
    }
    assert_eq!(linked.assumptions, scene.assumptions);
}
