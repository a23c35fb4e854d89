//! `giveway solve`.

use expect_test::expect;
use serde_json::json;

use crate::run::{EMPTY_MAP, EMPTY_SCEN, Folder, SCENARIO_1, SCENARIO_6, WAREHOUSE};

#[test]
fn the_warehouse_whatever_the_order() {
    let folder = Folder::scene(WAREHOUSE);
    for objective in [
        "makespan,sum-of-costs,charges",
        "sum-of-costs,makespan,charges",
        "charges,sum-of-costs,makespan",
        "charges, makespan",
    ] {
        let objective = objective.replace(' ', "");
        let answer = folder
            .run(&format!(
                "solve scene.json --format json --objective {objective}"
            ))
            .json();
        assert_eq!(answer["status"], "optimal", "{objective}");
        assert_eq!(answer["complete"], true, "{objective}");
        assert_eq!(answer["within"], json!(null), "{objective}");
        for (cost, value) in [("makespan", 18), ("sum-of-costs", 35), ("charges", 3)] {
            assert_eq!(answer["costs"][cost], value, "{objective}");
        }
    }
}

#[test]
fn json_has_the_specified_keys() {
    let answer = Folder::scene(SCENARIO_1)
        .run("solve scene.json --format json")
        .json();
    let keys = |value: &serde_json::Value| -> Vec<String> {
        let mut keys: Vec<String> = value.as_object().unwrap().keys().cloned().collect();
        keys.sort();
        keys
    };
    assert_eq!(
        keys(&answer),
        [
            "bounds", "complete", "costs", "ended", "giveway", "plan", "stats", "status", "within"
        ]
    );
    assert_eq!(
        keys(&answer["bounds"]),
        ["charges", "makespan", "sum-of-costs"]
    );
    assert_eq!(
        keys(&answer["costs"]),
        ["charges", "makespan", "moves", "sum-of-costs", "waits"]
    );
    assert_eq!(
        keys(&answer["stats"]),
        [
            "clauses",
            "conflicts",
            "cpu_seconds",
            "solver_calls",
            "variables",
            "work"
        ]
    );
}

#[test]
fn a_limit_of_work_ends_at_the_same_place_and_says_so() {
    let folder = Folder::scene(WAREHOUSE);
    let run = || {
        folder
            .run("solve scene.json --format json --work-limit 900")
            .json()
    };
    let (one, two) = (run(), run());
    assert_eq!(one["ended"], "work", "{one}");
    assert_eq!(one["reason"], "The work limit was reached.");
    assert_eq!(
        [&one["plan"], &one["stats"]["work"]],
        [&two["plan"], &two["stats"]["work"]]
    );
    let whole = folder.run("solve scene.json --format json --work-limit 100000000");
    let whole = whole.json();
    assert_eq!([&whole["ended"], &whole["status"]], ["proof", "optimal"]);
}

#[test]
fn the_answer_passes_its_own_check() {
    let folder = Folder::scene(WAREHOUSE);
    let answer = folder.run("solve scene.json --format json");
    let run = folder.run_with("check scene.json -", answer.answer());
    assert!(
        run.answer()
            .contains("Valid: makespan 18, sum of costs 35, 3 charges")
    );
}

#[test]
fn text_is_for_people() {
    let run = Folder::scene(WAREHOUSE).run("solve scene.json");
    // What may differ from one good solver to another is left out: the plan and the work.
    let lines: Vec<&str> = run.answer().lines().take(17).collect();
    expect![[r#"
        warehouse: 10 x 3 cells, 2 robots

        Optimal: makespan 18, sum of costs 35, 3 charges.
        No plan is better, no matter how many steps you allow.

        cost             value   proved at least
        makespan            18                18
        sum of costs        35                35
        charges              3                 3
        moves               30                 -
        waits                0                 -

           0   1   2   3   4   5   6   7   8   9
         0 .Ab .   ~a' ~   ~   ~b' ~   ~a' .   .
         1 .   ### ### .   ### ### .   ### ### .
         2 .   .b' .   +   .a' .   +   .   .   .Ba
          # obstacle, ~ slow zone, + charger, A start, a goal, a' waypoint"#]]
    .assert_eq(&lines.join("\n"));
}

#[test]
fn within_17_there_is_none() {
    let run = Folder::scene(WAREHOUSE).run("solve scene.json --within 17");
    assert!(
        run.answer().contains("No plan within makespan 17"),
        "{}",
        run.out
    );
}

#[test]
fn impossible_is_an_answer() {
    let run = Folder::scene(SCENARIO_6).run("solve scene.json");
    assert!(
        run.answer()
            .contains("No plan exists, no matter how many steps you allow"),
        "{}",
        run.out
    );
}

#[test]
fn a_front_has_its_points_in_the_order_of_the_first_cost() {
    let folder = Folder::scene(WAREHOUSE);
    let line = "solve scene.json --pareto --objective makespan,charges";
    let answer = folder.run(&format!("{line} --format json")).json();
    assert_eq!(answer["status"], "optimal");
    let front: Vec<_> = answer["front"]
        .as_array()
        .unwrap()
        .iter()
        .map(|point| (&point["costs"]["makespan"], &point["costs"]["charges"]))
        .collect();
    assert_eq!(front, [(&json!(18), &json!(3))]);
    let run = folder.run(line);
    assert!(run.answer().contains("Pareto front: 1 plan"), "{}", run.out);
}

#[test]
fn a_scenario_is_solved() {
    let folder = Folder::with(&[("empty-8-8.map", EMPTY_MAP), ("few.scen", EMPTY_SCEN)]);
    let answer = folder
        .run("solve few.scen --format json --objective sum-of-costs")
        .json();
    assert_eq!(answer["status"], "optimal");
    let all = folder.run("solve few.scen --agents 2 --format json").json();
    assert_eq!(all["plan"]["paths"].as_object().unwrap().len(), 2);
}

#[test]
fn a_budget_of_nothing_ends_in_an_honest_answer() {
    let run = Folder::scene(WAREHOUSE).run("solve scene.json --time-limit 0.000001 --format json");
    let answer: serde_json::Value = serde_json::from_str(&run.out).unwrap();
    let expected = match answer["status"].as_str().unwrap() {
        "unknown" => 3,
        "feasible" => 0,
        other => panic!("{other} without any time"),
    };
    assert_eq!(run.exit, Some(expected));
}

#[test]
fn no_colour_without_a_terminal_and_no_progress() {
    let run = Folder::scene(WAREHOUSE).run("solve scene.json");
    assert!(!run.answer().contains('\u{1b}'));
}

#[test]
fn two_runs_give_one_plan() {
    let folder = Folder::scene(WAREHOUSE);
    let plan = || folder.run("solve scene.json --format json").json()["plan"].clone();
    assert_eq!(plan(), plan());
}

/// Long names are cut where those of a fleet are alike, and never read the same.
#[test]
fn long_names_are_told_apart_in_the_table() {
    for (names, expect) in [
        (
            ["Transporter_in_hall_East_01", "Transporter_in_hall_East_02"],
            ["Transpo…_East_01", "Transpo…_East_02"],
        ),
        (
            [
                "hall_01_Transporter_of_pallets",
                "hall_02_Transporter_of_pallets",
            ],
            ["hall_01…_pallets", "hall_02…_pallets"],
        ),
        (
            [
                "Transporter_in_hall_1_of_the_depot",
                "Transporter_in_hall_2_of_the_depot",
            ],
            ["Transp…e_depot·1", "Transp…e_depot·2"],
        ),
    ] {
        let scene = format!(
            r#"{{ "giveway": 1, "map": [".."], "agents": [
                {{ "name": "{}", "start": [0, 0], "goal": [0, 0] }},
                {{ "name": "{}", "start": [1, 0], "goal": [1, 0] }} ] }}"#,
            names[0], names[1]
        );
        let run = Folder::scene(scene).run("solve scene.json");
        for label in expect {
            assert!(run.out.contains(label), "{label} in {}", run.out);
        }
    }
}

/// A name that is written from right to left turns nothing round beside it.
#[test]
fn names_from_right_to_left_are_isolated() {
    let scene = "{ \"giveway\": 1, \"map\": [\".#.\"], \"agents\": [ \
        { \"name\": \"\u{5e8}\u{5d1} 1\", \"start\": [0, 0], \"goal\": [2, 0] } ] }";
    let run = Folder::scene(scene).run("solve scene.json");
    let isolated = "\u{2068}\u{5e8}\u{5d1} 1\u{2069}";
    assert!(run.out.contains(isolated), "{:?}", run.out);
}
