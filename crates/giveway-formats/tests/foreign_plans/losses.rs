//! What the formats of plans cannot hold is named, and a plan that is none of whole
//! steps is refused.

use giveway_formats::{Format, Options, Refused, Source, combine, write};
use giveway_formats::{Loss, Part, losses};
use giveway_model::format::native::{read_instance, read_plan};

const SCENE: &str = r#"{ "giveway": 1, "name": "n", "map": ["..+~~", "....."],
  "rules": { "at_goal": "vanish", "battery_floor": 1 }, "objective": ["moves"],
  "agents": [
    { "name": "A1", "start": [0, 0], "goal": [2, 0], "waypoints": [[1, 0]],
      "battery": { "capacity": 9, "initial": 9 } },
    { "name": "Bob", "start": [0, 1], "goal": [2, 1] } ] }"#;
const PLAN: &str = r#"{ "giveway": 1,
  "paths": { "A1": [[0, 0], [1, 0], [2, 0]], "Bob": [[0, 1], [1, 1], [2, 1]] },
  "charges": { "A1": [2] }, "from": { "Bob": 1 }, "until": { "A1": 4 },
  "knows": 3, "slept": { "A1": [[2, 3]] } }"#;

const PLANS: [Format; 3] = [Format::Tracker, Format::Paths, Format::Result];

#[test]
fn every_loss_is_named() {
    let (instance, plan) = (read_instance(SCENE).unwrap(), read_plan(PLAN).unwrap());
    for format in PLANS {
        let written = write(format, "n", Some(&instance), Some(&plan)).unwrap();
        assert_eq!(
            written.losses,
            [
                "the slow zone (2 cells)",
                "the chargers (1 cell)",
                "the waypoints of 1 robot",
                "the batteries of 1 robot",
                "that robots vanish at their goals",
                "the objective",
                "the names of 1 robot",
                "the charges of 1 robot",
                "the later entry of 1 robot",
                "the removal of 1 robot",
                "which changes the plan takes into account",
                "the sleep of 1 robot before a change",
            ],
            "{format}"
        );
    }
}

#[test]
fn what_a_format_holds_is_no_loss() {
    let (instance, plan) = (read_instance(SCENE).unwrap(), read_plan(PLAN).unwrap());
    let holds = [
        Part::Names,
        Part::Knows,
        Part::Slept,
        Part::Removal,
        Part::SlowZone,
    ];
    let lost = losses(&holds, Some(&instance), Some(&plan));
    assert_eq!(lost.len(), 7, "{lost:?}");
    assert!(lost.iter().all(|loss| loss.part != Part::Knows));
    let joining = Loss {
        part: Part::Joining,
        count: 1,
    };
    assert!(lost.contains(&joining));
    assert_eq!(losses(&[], None, None), []);
}

#[test]
fn an_agent_that_joins_later_waits_where_it_enters() {
    let (instance, plan) = (read_instance(SCENE).unwrap(), read_plan(PLAN).unwrap());
    let written = write(Format::Result, "n", Some(&instance), Some(&plan)).unwrap();
    let text = &written.files[2].1;
    assert!(text.contains("soc=5\nmakespan=3\n"), "{text}");
    assert!(
        text.ends_with("1:(1,0),(0,1),\n2:(2,0),(1,1),\n3:(2,0),(2,1),\n"),
        "{text}"
    );
}

#[test]
fn a_plan_in_transit_is_refused_by_robot_and_time() {
    let instance = read_instance(SCENE).unwrap();
    let plan = PLAN.replace("[1, 1], [2, 1]", "[1, 1], null, [2, 1]");
    let plan = read_plan(&plan).unwrap();
    for format in PLANS {
        let fault = write(format, "n", Some(&instance), Some(&plan)).unwrap_err();
        assert_eq!(fault.found, "Bob between two cells at time 3");
    }
}

#[test]
fn what_is_missing_is_told() {
    let (instance, plan) = (read_instance(SCENE).unwrap(), read_plan(PLAN).unwrap());
    let empty = PLAN.replace("[0, 1], [1, 1], [2, 1]", "");
    let empty = read_plan(&empty).unwrap();
    for format in PLANS {
        let alone = write(format, "n", Some(&instance), None).unwrap_err();
        assert_eq!(alone.found, "an instance");
        let alone = write(format, "n", None, Some(&plan)).unwrap_err();
        assert_eq!(alone.found, "a plan");
        let none = write(format, "n", Some(&instance), Some(&empty)).unwrap_err();
        assert_eq!(none.found, "no path of Bob");
    }
    let jump = read_plan(&PLAN.replace("[1, 0], [2, 0]", "[2, 0]")).unwrap();
    let fault = write(Format::Tracker, "n", Some(&instance), Some(&jump)).unwrap_err();
    assert_eq!(fault.found, "A1 jumping from (0, 0) to (2, 0) at time 1");
}

#[test]
fn cells_off_the_map_come_back_as_the_numbers_that_they_were() {
    let scene = r#"{ "giveway": 1, "map": ["..."], "agents": [
        { "name": "A1", "start": [0, 0], "goal": [2, 0] }] }"#;
    let instance = read_instance(scene).unwrap();
    // A step to (-1, 0), one to the smallest numbers that there are, and back.
    let plan = r#"{ "giveway": 1, "paths": { "A1":
        [[0, 0], [4294967295, 0], [2147483648, 2147483648], [2147483647, 0], [2, 0]] } }"#;
    let plan = read_plan(plan).unwrap();
    for format in [
        Format::Paths,
        Format::Result,
        Format::MultiRobot,
        Format::Mapfw,
    ] {
        let written = write(format, "n", Some(&instance), Some(&plan)).unwrap();
        let files = written.files.iter();
        let sources: Vec<Source<'_>> = files.map(|(name, text)| Source { name, text }).collect();
        let again = combine(&sources, &Options::default()).unwrap();
        assert_eq!(again.plans[0].plan.paths, plan.paths, "{format}");
    }
}

#[test]
fn a_plan_without_robots_is_written_where_that_is_something() {
    let instance = read_instance(r#"{ "giveway": 1, "map": ["."], "agents": [] }"#).unwrap();
    let plan = read_plan(r#"{ "giveway": 1, "paths": {} }"#).unwrap();
    for format in [Format::Paths, Format::Tracker, Format::Asprilo] {
        let error = write(format, "n", Some(&instance), Some(&plan)).unwrap_err();
        assert_eq!(error.found, "a plan without robots", "{format}");
    }
    for format in [
        Format::Result,
        Format::MultiRobot,
        Format::League,
        Format::Mapfw,
    ] {
        assert!(
            write(format, "n", Some(&instance), Some(&plan)).is_ok(),
            "{format}"
        );
    }
}

#[test]
fn a_start_off_the_map_has_its_place_in_the_plan() {
    let map = "type octile\nheight 1\nwidth 3\nmap\n..@\n";
    let cases = [
        (
            "Agent 0: (0,0)->(0,1)->\nAgent 1: (0,2)->(0,1)->\n",
            "line 2, column 1: agents[1].start: found the obstacle (2, 0), expected a free cell",
        ),
        (
            "0:(0,0),(2,0),\n1:(1,0),(1,0),\n",
            "line 1, column 9: agents[1].start: found the obstacle (2, 0), expected a free cell",
        ),
        (
            "agents=2\nstarts=(0,0),(1,0),\ngoals=(1,0),(2,0),\nsolution=\n0:(0,0),(1,0),\n",
            "line 3, column 13: agents[1].goal: found the obstacle (2, 0), expected a free cell",
        ),
        (
            "schedule:\n  agent0:\n    - x: 2\n      y: 0\n      t: 0\n",
            "line 2, column 3: agents[0].start: found the obstacle (2, 0), expected a free cell",
        ),
        (
            "[[[0, 0]],\n [[2, 0]]]",
            "line 2, column 2: [1]: found the obstacle (2, 0), expected a free cell",
        ),
    ];
    for (text, said) in cases {
        let sources = [("m.map", map), ("it", text)].map(|(name, text)| Source { name, text });
        match combine(&sources, &Options::default()) {
            Err(Refused::File { file, faults }) => {
                assert_eq!((&*file, &*faults[0].to_string()), ("it", said));
            }
            other => panic!("{other:?}"),
        }
    }
}
