//! `giveway solve --planner`.

use expect_test::expect;
use serde_json::{Value, json};

use crate::audit::fits;
use crate::run::{Folder, WAREHOUSE, two_agents};

const PLANNERS: [&str; 5] = ["prioritised", "cbs", "pibt", "lacam", "lns"];

/// The answer as JSON, which must fit the schema.
fn planned(folder: &Folder, line: &str) -> (Option<i32>, Value) {
    let run = folder.run(&format!("solve scene.json --format json --planner {line}"));
    assert_eq!(run.err, "");
    let answer = serde_json::from_str(&run.out).unwrap();
    fits("planResult", &answer);
    (run.exit, answer)
}

#[test]
fn each_plans_and_tells_how_it_went() {
    let folder = Folder::scene(two_agents(&[]));
    for planner in PLANNERS {
        let (exit, answer) = planned(&folder, &format!("{planner} --trace trace.json"));
        assert_eq!((exit, &answer["planner"]), (Some(0), &json!(planner)));
        assert_eq!(answer.get("trace"), None, "it is in a file of its own");
        let run = folder.run_with("check scene.json -", &answer.to_string());
        assert!(run.answer().contains("Valid"), "{planner}: {}", run.out);
        let trace = serde_json::from_str(&folder.read("trace.json")).unwrap();
        fits("planTrace", &trace);
        assert_eq!(trace["planner"], planner);
    }
}

#[test]
fn only_cbs_says_best() {
    let folder = Folder::scene(two_agents(&[]));
    for planner in PLANNERS {
        let (_, answer) = planned(&folder, &format!("{planner} --objective sum-of-costs"));
        let (how, bound) = (
            &answer["ended"]["how"],
            answer["bounds"].get("sum-of-costs"),
        );
        if planner == "cbs" {
            assert_eq!(
                (how, bound),
                (&json!("best"), Some(&answer["costs"]["sum-of-costs"]))
            );
        } else {
            assert_eq!((how, bound), (&json!("found"), None), "{planner}");
        }
    }
}

#[test]
fn text_is_for_people() {
    let folder = Folder::scene(two_agents(&[]));
    let run = folder.run("solve scene.json --planner cbs --objective sum-of-costs");
    let lines: Vec<&str> = run.answer().lines().take(11).collect();
    expect![[r#"
        two: 4 x 2 cells, 2 robots

        Best plan: sum of costs 10.
        No plan has a smaller sum of costs, no matter how many steps you allow.

        cost             value   proved at least
        sum of costs        10                10
        makespan             6                 -
        charges              0                 -
        moves                8                 -
        waits                2                 -
    "#]]
    .assert_eq(&(lines.join("\n") + "\n"));
    let work = run.answer().lines().last().unwrap();
    assert!(
        work.starts_with("CBS: ") && work.ends_with("nodes of the constraint tree"),
        "{work}"
    );
}

/// The scene and the tree of the documentation.
#[test]
fn the_tree_that_the_documentation_explains_is_that_of_its_scene() {
    let text = include_str!("../../../../docs/planners.md");
    let blocks: Vec<&str> = text.split("```json\n").skip(1).collect();
    let [scene, tree, ..] = blocks.as_slice() else {
        panic!("{} blocks of JSON", blocks.len());
    };
    let block = |text: &str| text.split_once("```").unwrap().0.to_owned();
    let folder = Folder::scene(block(scene));
    planned(&folder, "cbs --trace tree.json");
    let mut written: Value = serde_json::from_str(&folder.read("tree.json")).unwrap();
    for node in written["nodes"].as_array_mut().unwrap() {
        // The documentation leaves them out; a dead node has none.
        assert_eq!(
            node["fate"] == "dead",
            node.as_object_mut().unwrap().remove("paths").is_none()
        );
    }
    let explained: Value = serde_json::from_str(&block(tree)).unwrap();
    assert_eq!(written, explained);
}

#[test]
fn what_a_planner_cannot_do_it_says() {
    let folder = Folder::scene(WAREHOUSE);
    for planner in ["pibt", "lacam"] {
        let (exit, answer) = planned(&folder, planner);
        assert_eq!(
            (exit, &answer["ended"]["how"]),
            (Some(3), &json!("refused"))
        );
        assert_eq!(answer["plan"], json!(null));
    }
    for planner in ["prioritised", "cbs", "lns"] {
        let (exit, answer) = planned(&folder, planner);
        assert_eq!(exit, Some(0), "{planner}: {answer}");
    }
}

#[test]
fn an_order_that_does_not_work_is_no_proof() {
    let scene = two_agents(&[
        ("\"..#.\", \"....\"", "\"....\", \"####\""),
        ("[3, 1]", "[3, 0]"),
        ("[0, 1]", "[0, 0]"),
    ]);
    let folder = Folder::scene(scene);
    let (exit, answer) = planned(&folder, "prioritised --order A2,A1");
    let ended = json!({
        "how": "no-order-works",
        "tried": 1,
        "within": 37,
        "stuck": { "agent": "A1", "around": ["A2"] }
    });
    assert_eq!((exit, &answer["ended"]), (Some(3), &ended));
    let (exit, answer) = planned(&folder, "cbs --time-limit 0.2 --within 60");
    assert_eq!(
        (exit, &answer["ended"]["how"]),
        (Some(3), &json!("stopped"))
    );
}

#[test]
fn options_that_do_not_fit_are_refused() {
    let folder = Folder::scene(two_agents(&[]));
    for (line, said) in [
        (
            "--planner best",
            "expected prioritised, cbs, pibt, lacam or lns",
        ),
        ("--planner cbs --pareto", "cannot be used with"),
        ("--planner cbs --proof folder", "cannot be used with"),
        ("--trace trace.json --pareto", "cannot be used with"),
        ("--order A1", "--planner"),
        ("--planner cbs --order A1", "expected it for prioritised"),
        ("--planner prioritised --order A9", "the name of a robot"),
    ] {
        let run = folder.run(&format!("solve scene.json {line}"));
        assert_eq!(run.exit, Some(2), "{line}: {}", run.err);
        assert!(run.err.contains(said), "{line}: {}", run.err);
    }
}
