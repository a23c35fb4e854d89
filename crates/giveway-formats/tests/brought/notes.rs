//! What a file says beyond its plan, or leaves out, is told or refused.

use giveway_formats::{Combined, Format, Options, Source, combine, write};
use giveway_model::{Assumption, AtGoal, check::check};

use super::{apart, brought, opened, refused};

const MAP: &str = "type octile\nheight 2\nwidth 3\nmap\n...\n...\n";
const SCENARIO: &str = "version 1\n0\ta.map\t3\t2\t0\t0\t2\t0\t2\n";
const PATHS: &str = "Agent 0: (0,0)->(0,1)->(0,2)->\n";

/// What is said of a plan on the map.
fn notes(name: &str, text: &str) -> String {
    let combined = opened(&[("a.map", MAP), ("a.scen", SCENARIO), (name, text)]).unwrap();
    combined.plans[0].notes.join("\n")
}

#[test]
fn a_team_beyond_the_starts_is_refused() {
    let result =
        r#"{"actionModel": "MAPF", "teamSize": 3, "start": [[0, 0, "N/A"]], "actualPaths": ["R"]}"#;
    assert_eq!(
        refused(result),
        "line 1, column 37: teamSize: found 3, expected 1, as there are starts: the robots of the team"
    );
}

#[test]
fn times_without_a_state_are_told() {
    let schedule = |times: [u32; 3]| {
        let [a, b, c] = times;
        format!(
            "schedule:\n  A1:\n    - x: 0\n      y: 0\n      t: {a}\n    - x: 1\n      y: 0\n      t: {b}\n    - x: 2\n      y: 0\n      t: {c}\n"
        )
    };
    let said = "The schedule has no state at some times of A1: until the next state they are taken to wait.";
    for (times, is_told) in [([0, 1, 2], false), ([0, 1, 4], true), ([1, 2, 3], true)] {
        let notes = notes("a.yaml", &schedule(times));
        assert_eq!(notes.contains(said), is_told, "{times:?}: {notes}");
        // To the letter what the library prints, and in another style.
        let other = schedule(times).replace("schedule:", "schedule: # all");
        assert_eq!(notes, self::notes("a.yaml", &other));
    }
}

#[test]
fn robots_that_the_instance_does_not_have_do_not_act() {
    let world = "init(object(node,1),value(at,(1,1))). init(object(node,2),value(at,(2,1))).\n\
        init(object(robot,1),value(at,(1,1))).\n";
    let plan = "occurs(object(robot,1),action(move,(1,0)),1). occurs(object(robot,7),action(move,(1,0)),1).\n";
    assert_eq!(
        apart(&[("w.lp", world), ("p.lp", plan)]),
        "p.lp has actions of robots that the scene does not have: A7. Open the instance that the plan was made for."
    );
    // Also where no robot fits.
    let other = "occurs(object(robot,7),action(move,(1,0)),1).\n";
    assert!(apart(&[("w.lp", world), ("p.lp", other)]).contains("A7"));
}

#[test]
fn a_plan_for_a_map_of_another_name_says_so() {
    let result =
        |map: &str| format!("agents=1\nmap_file={map}\nsolution=\n0:(0,0),\n1:(1,0),\n2:(2,0),\n");
    let table = |map: &str| format!("map_name,agents,solution_plan\n{map},1,rr\n");
    let said = "is made for the map b.map; a.map is used for it.";
    for (name, is_told) in [
        ("b.map", true),
        ("maps/b.map", true),
        ("a.map", false),
        ("maps/a.map", false),
    ] {
        assert_eq!(notes("r.txt", &result(name)).contains(said), is_told);
        assert_eq!(notes("t.csv", &table(name)).contains(said), is_told);
    }
    assert!(notes("t.csv", &table("b")).contains("the map b; a.map is used"));
}

#[test]
fn waits_that_are_cut_where_robots_vanish_are_told() {
    let waits = "Agent 0: (0,0)->(0,1)->(0,2)->(0,2)->(0,2)->\n";
    let read = |at_goal| {
        let sources = [("a.map", MAP), ("a.scen", SCENARIO), ("p.txt", waits)];
        let sources = sources.map(|(name, text)| Source { name, text });
        let options = Options {
            at_goal: Some(at_goal),
            ..Options::default()
        };
        combine(&sources, &options).unwrap().plans[0]
            .notes
            .join(" ")
    };
    let said = "Waits at the goal at the end of 1 path are left out";
    assert!(read(AtGoal::Vanish).contains(said));
    assert!(!read(AtGoal::Stay).contains(said));
}

#[test]
fn keys_and_columns_that_are_not_read_are_told() {
    let said = "Keys of the plan's file that are not heeded: speed.";
    let tracker = [
        (
            "t.csv",
            "agents,speed,solution_date,solution_plan\n1,2,2020,rr\n",
        ),
        (
            "t.json",
            r#"{"agents": 1, "speed": 2, "solution_plan": "rr"}"#,
        ),
        (
            "t.json",
            r#"[{"agents": 1, "speed": 2, "solution_plan": ["rr"]}]"#,
        ),
        ("t.yaml", "agents: 1\nspeed: 2\nsolution_plan: rr\n"),
    ];
    for (name, text) in tracker {
        assert!(notes(name, text).contains(said), "{text}");
        let without = text.replace("speed", "comment");
        assert!(!notes(name, &without).contains("not heeded"), "{without}");
    }
    let upload = r#"{"solutions": [{"problem": 1, "speed": 2, "solution": [[[0, 0], [1, 0], [2, 0]]]}], "robots": 1}"#;
    let said = notes("u.json", upload);
    assert!(said.contains("robots and solutions.speed"), "{said}");
    let problem = r#"{\"grid\": [[0, 0]], \"starts\": [[0, 0]], \"goals\": [[1, 0]]}"#;
    let download = format!(r#"{{"problems": [{{"id": 1, "speed": 2, "problem": "{problem}"}}]}}"#);
    let read = opened(&[("d.json", &download)]).unwrap();
    let key = "problems.speed".to_owned();
    assert_eq!(
        read.instance.assumptions(),
        [Assumption::UnknownKey { key }]
    );
    let state =
        "schedule: {A1: [{t: 0, x: 0, y: 0, z: 1}, {t: 1, x: 1, y: 0}, {t: 2, x: 2, y: 0}]}";
    assert!(notes("s.yaml", state).contains("schedule.z"));
}

#[test]
fn a_scenario_without_its_version_is_read_and_told() {
    let bare = SCENARIO.replace("version 1\n", "");
    for files in [
        vec![("a.map", MAP), ("a.scen", &*bare)],
        vec![("a.map", MAP), ("a.scen", &*bare), ("p.txt", PATHS)],
    ] {
        let combined = opened(&files).unwrap();
        assert_eq!(combined.instance.agents().len(), 1);
        let notes = combined.notes.join(" ");
        assert!(notes.contains("no line \"version 1\""), "{notes}");
    }
    let whole = opened(&[("a.map", MAP), ("a.scen", SCENARIO)]).unwrap();
    assert!(whole.notes.is_empty(), "{:?}", whole.notes);
    // What is none stays none.
    assert!(refused("0\ta.map\t3\t2\t0\t0\t2\t0\n").contains("a.map"));
}

#[test]
fn paths_in_another_order_are_read_by_their_numbers() {
    let two = "version 1\n0\ta.map\t3\t2\t0\t0\t2\t0\t2\n0\ta.map\t3\t2\t0\t1\t2\t1\t2\n";
    let paths = "Agent 1: (1,0)->(1,1)->(1,2)->\nAgent 0: (0,0)->(0,1)->(0,2)->\n";
    let read = opened(&[("a.map", MAP), ("a.scen", two), ("p.txt", paths)]).unwrap();
    assert!(check(&read.instance, &read.plans[0].plan).is_valid());
    assert!(read.plans[0].notes[0].contains("not in order"));
    assert!(refused("Agent 1: (0,0)->\nAgent 1: (0,1)->\n").contains("a second path of robot 1"));
}

#[test]
fn grids_with_grounds_of_ours_and_with_blanks_are_read() {
    let rows = |combined: &Combined| combined.instance.grid().rows();
    let own = opened(&[("g.txt", "a~+A\n.#*.\n")]).unwrap();
    assert_eq!(rows(&own), [".~+.", ".#*."]);
    assert!(own.notes.join(" ").contains("~ is the slow zone"));
    let maze = opened(&[("m.txt", "#####\n#a A#\n# # #\n#   #\n## ##\n")]).unwrap();
    assert_eq!(rows(&maze), ["#####", "#...#", "#.#.#", "#...#", "##.##"]);
    assert!(maze.notes.join(" ").contains("Blanks in the grid"));
    assert_eq!(maze.instance.agents().len(), 1);
    // Rows that an editor cut at their ends are filled up.
    let open = opened(&[("o.txt", "#\n#  #\n#\n####\n")]).unwrap();
    assert_eq!(rows(&open), ["#...", "#..#", "#...", "####"]);
    // Blanks that only stand between cells are none.
    for (spaced, cells) in [
        ("# # #\n# # #\n", 3),
        ("a # A\n# . #\n", 3),
        ("#\t#\n#\t#\n", 2),
    ] {
        let read = opened(&[("s.txt", spaced)]).unwrap();
        assert_eq!(rows(&read)[0].len(), cells, "{spaced}");
    }
}

#[test]
fn tables_as_a_spreadsheet_saves_them_are_read() {
    let table = "map_name,agents,solution_plan\r\na,1,\"r\nr\"\r\n";
    let two = "version 1\n0\ta.map\t3\t2\t0\t0\t1\t0\t1\n0\ta.map\t3\t2\t0\t1\t1\t1\t1\n";
    let read = |text: &str| {
        let text = text
            .replace(",1,", ",2,")
            .replace(";1;", ";2;")
            .replace("\t1\t", "\t2\t");
        let read = opened(&[("a.map", MAP), ("a.scen", two), ("t.csv", &text)]).unwrap();
        assert!(
            check(&read.instance, &read.plans[0].plan).is_valid(),
            "{text}"
        );
    };
    read(table);
    read(&table.replace(',', ";"));
    read(&table.replace(',', "\t"));
    read(&format!("sep=;\r\n{}", table.replace(',', ";")));
    // Each line one value, its own quotes doubled.
    read("\"map_name,agents,solution_plan\"\r\n\"a,1,\"\"r\nr\"\"\"\r\n");
}

#[test]
fn a_result_without_a_plan_opens_its_scene_and_says_what_it_is() {
    let scene = brought("lane.json");
    let result = r#"{ "giveway": 1, "status": "impossible", "plan": null }"#;
    let read = opened(&[("lane.json", &scene), ("r.json", result)]).unwrap();
    assert!(read.plans.is_empty());
    assert_eq!(
        read.notes,
        ["r.json: It is a result that says that there is no plan (impossible)."]
    );
    assert!(apart(&[("r.json", result)]).contains("there is no plan (impossible)"));
    let unknown = result.replace("impossible", "unknown");
    assert!(apart(&[("r.json", &unknown)]).contains("none was found (unknown)"));
}

#[test]
fn obstacles_that_move_are_written_and_read_again() {
    let input = "map: {dimensions: [3, 2], obstacles: []}\nagents: [{name: a, start: [0, 0], goal: [2, 0]}]\n\
        dynamic_obstacles: {cart: [{t: 2, x: 0, y: 1}, {t: 4, x: 1, y: 1}], \"a: b\": [{t: 0, x: 2, y: 1}, {t: 1, x: 1, y: 1}, {t: 2, x: 3, y: 1}]}\n";
    let read = opened(&[("i.yaml", input)]).unwrap();
    assert_eq!(read.instance.assumptions().len(), 2);
    assert_eq!(read.instance.constraints().len(), 4);
    let written = write(Format::MultiRobot, "it", Some(&read.instance), None).unwrap();
    assert_eq!(written.losses, Vec::<String>::new());
    let again = opened(&[("it.yaml", &written.files[0].1)]).unwrap();
    assert_eq!(again.instance, read.instance);
}

#[test]
fn the_map_of_a_benchmark_keeps_its_name_in_a_table() {
    let scenario = SCENARIO.replace("a.map", "room-3-2.map");
    let files = [
        ("room-3-2.map", MAP),
        ("room-3-2-random-4.scen", &*scenario),
        ("p.txt", PATHS),
    ];
    let read = opened(&files).unwrap();
    let plan = Some(&read.plans[0].plan);
    let written = write(Format::Tracker, "p", Some(&read.instance), plan).unwrap();
    let table = written
        .files
        .iter()
        .find(|(name, _)| name == "p-tracker.csv");
    assert!(
        table.unwrap().1.contains("\n\"room-3-2\",random,4,1,"),
        "{written:?}"
    );
}
