//! What no tool of a step can do is outside of its task, whatever it is good for.

use giveway_course::judge::{Did, Kind, Outside, Verdict, Why};
use giveway_model::{
    Agent, Assumption, AtGoal, Battery, Cell, Constraint, Objective, Plan, Scene, Units, Zone,
    constraint::{ConstraintKind, Heading},
};
use serde_json::json;

use super::judges::{judged, lesson, painted, scene};

/// Something that is done to a scene.
type Change = fn(&mut Scene);

fn crossing() -> serde_json::Value {
    json!({ "giveway": 1, "name": "crossing", "map": ["#.#", "...", "#.#"],
        "zones": [{ "name": "middle", "rect": [1, 1, 1, 1] }],
        "constraints": [{ "kind": "capacity", "zone": "middle", "most": 1 },
                        { "kind": "depart", "agents": ["A2"], "from": 1 }],
        "agents": [{ "name": "A1", "start": [0, 1], "goal": [2, 1], "battery": { "capacity": 9, "initial": 9 } },
                   { "name": "A2", "start": [1, 2], "goal": [1, 0], "battery": { "capacity": 9, "initial": 9 } }] })
}

fn all_tools() -> serde_json::Value {
    json!({ "tools": ["move", "obstacle", "charger", "slow-zone", "erase", "robot", "goal", "waypoint"] })
}

/// The verdict on a change with all tools at hand.
fn changed(change: Change) -> Verdict {
    let task = json!({ "kind": "paint", "until": { "is": "solvable" } });
    let lesson = lesson(&crossing(), &all_tools(), &task);
    painted(&lesson, change).0
}

fn placed(name: &str) -> Agent {
    Agent {
        battery: Some(Battery {
            capacity: 9,
            initial: 9,
        }),
        ..Agent::new(name, Cell::new(1, 1), Some(Cell::new(0, 1)))
    }
}

#[test]
fn what_no_tool_changes_is_outside() {
    let rules: [(&str, Change); 12] = [
        ("name", |scene| scene.name = "other".into()),
        ("at goal", |scene| scene.rules.at_goal = AtGoal::Vanish),
        ("floor", |scene| scene.rules.battery_floor = 1),
        ("objective", |scene| {
            scene.objective = Objective::new(vec![giveway_model::Cost::Waits]).unwrap();
        }),
        ("assumptions", |scene| {
            scene.assumptions.push(assumption());
        }),
        ("zones", |scene| {
            scene.zones.push(Zone::of("far", vec![Cell::new(0, 1)]));
        }),
        ("no zones", |scene| scene.zones.clear()),
        ("no rules", |scene| scene.constraints.clear()),
        ("a rule off", |scene| scene.constraints[0].off = true),
        ("a rule less", |scene| drop(scene.constraints.remove(1))),
        ("a rule more", |scene| {
            let rule = scene.constraints[1].clone();
            scene.constraints.push(rule);
        }),
        ("units", |scene| scene.units = Some(units())),
    ];
    for (what, change) in rules {
        let verdict = changed(change);
        assert_eq!(verdict.kind, Kind::NotLikeThis, "{what}");
        assert_eq!(verdict.why, Why::Outside(Outside::Rules), "{what}");
    }
    let robots: [(&str, Change); 5] = [
        ("battery", |scene| scene.agents[0].battery = None),
        ("heading", |scene| {
            scene.agents[0].heading = Some(Heading::East);
        }),
        ("a robot that faces", |scene| {
            scene.agents.push(Agent {
                heading: Some(Heading::East),
                ..placed("A3")
            });
        }),
        ("a robot with more", |scene| {
            scene.agents.push(Agent {
                battery: Some(Battery {
                    capacity: 99,
                    initial: 99,
                }),
                ..placed("A3")
            });
        }),
        ("a name", |scene| {
            scene.agents[0].name = "B1".into();
            scene.agents[0].battery = Some(Battery {
                capacity: 8,
                initial: 8,
            });
        }),
    ];
    for (what, change) in robots {
        let verdict = changed(change);
        assert_eq!(verdict.kind, Kind::NotLikeThis, "{what}");
        let is_robot = matches!(verdict.why, Why::Outside(Outside::Robot(_)));
        assert!(is_robot, "{what}: {:?}", verdict.why);
    }
}

/// An obstacle that moves.
fn assumption() -> Assumption {
    Assumption::MovingObstacle {
        name: "cart".into(),
        path: vec![Cell::new(1, 1)],
        closed: false,
    }
}

fn units() -> Units {
    serde_json::from_value(json!({ "cell": 1.0, "step": 1.0 })).unwrap()
}

#[test]
fn what_tools_do_is_allowed() {
    let changes: [(&str, Change); 4] = [
        ("a robot more", |scene| scene.agents.push(placed("A3"))),
        // Its rule goes with it, as on the page.
        ("a robot less", |scene| {
            drop(scene.agents.remove(1));
            drop(scene.constraints.remove(1));
        }),
        ("a goal less", |scene| scene.agents[0].goal = None),
        ("a robot anew", |scene| {
            let mut agent = scene.agents.remove(0);
            agent.start = Cell::new(2, 1);
            agent.goal = Some(Cell::new(0, 1));
            scene.agents.push(agent);
        }),
    ];
    for (what, change) in changes {
        let verdict = changed(change);
        assert_ne!(verdict.kind, Kind::NotLikeThis, "{what}: {:?}", verdict.why);
    }
}

#[test]
fn a_rule_that_names_a_robot_stays_with_it() {
    let verdict = changed(|scene| drop(scene.agents.remove(1)));
    assert_eq!(verdict.kind, Kind::NotLikeThis);
    assert!(matches!(verdict.why, Why::Refused(_)), "{:?}", verdict.why);
    let is_depart = |rule: &Constraint| matches!(rule.kind, ConstraintKind::Depart { .. });
    let scene: Scene = serde_json::from_value(crossing()).unwrap();
    assert!(is_depart(&scene.constraints[1]));
}

#[test]
fn a_board_that_is_edited_counts_for_no_other_task() {
    let predict = json!({ "kind": "predict", "what": { "is": "cost", "cost": "makespan" } });
    let open = scene(&["...", "..."], &[("A1", [0, 0], [2, 0])]);
    let lesson = lesson(&open, &json!({}), &predict);
    let mut board = lesson.steps[0].scene.clone().unwrap();
    board.agents[0].goal = Some(Cell::new(1, 0));
    let guess = Did::Guessed(giveway_course::lesson::Value::Number(1));
    let verdict = judged(&lesson, &board, &guess);
    assert_eq!(verdict.why, Why::Outside(Outside::Robot("A1".into())));
}

/// Where a step has no plan, robots that are not led stand where they start.
#[test]
fn robots_that_are_not_led_stand_still() {
    let lane = scene(
        &["...", "..."],
        &[("A1", [0, 0], [2, 0]), ("A2", [1, 0], [1, 1])],
    );
    let task = json!({ "kind": "lead", "robots": ["A1"], "aim": { "is": "legal" } });
    let lesson = lesson(&lane, &json!({}), &task);
    let board = lesson.steps[0].scene.clone().unwrap();
    let led = |a2: &[[u32; 2]]| {
        let path = |cells: &[[u32; 2]]| -> giveway_model::Path {
            cells.iter().map(|[x, y]| Some(Cell::new(*x, *y))).collect()
        };
        let mut plan = Plan::default();
        let a1 = [[0, 0], [0, 0], [1, 0], [2, 0]];
        plan.paths.insert("A1".into(), path(&a1));
        plan.paths.insert("A2".into(), path(a2));
        judged(&lesson, &board, &Did::Led(plan))
    };
    let verdict = led(&[[1, 0], [1, 1]]);
    assert_eq!(verdict.why, Why::LedAnother("A2".into()));
    assert_eq!(verdict.kind, Kind::NotLikeThis);
    assert_ne!(led(&[[1, 0]]).why, Why::LedAnother("A2".into()));
}
