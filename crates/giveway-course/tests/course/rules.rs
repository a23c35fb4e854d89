//! Rules and delays in tasks: what they cost, which one leaves no plan, who is first, who
//! loses because of whom. The real solver tells.

use giveway_course::author::Draft;
use giveway_course::author::check::{Finding, LessonCheck, Problem, Subject};
use giveway_course::judge::words::said;
use giveway_course::judge::{Did, Judging, Situation, Verdict, Why, begin, conclude};
use giveway_course::lesson::{Step, Value, read_lesson};
use giveway_model::{Plan, Scene};
use giveway_solve::{SilentHost, serve};
use serde_json::{Value as Json, json};

use super::checked::{lesson, run, share};
use super::shipped;

/// Two robots one behind the other in a corridor.
fn row(rules: &Json) -> Json {
    json!({ "giveway": 1, "map": ["....."], "constraints": rules, "agents": [
        { "name": "A1", "start": [1, 0], "goal": [4, 0] },
        { "name": "A2", "start": [0, 0], "goal": [3, 0] }] })
}

fn gap(steps: u32) -> Json {
    json!({ "kind": "gap", "steps": steps })
}

fn judged(step: &Step, scene: &Scene, did: &Did) -> Verdict {
    let start = step.scene.as_ref().unwrap();
    let situation = Situation { step, start, scene };
    match begin(situation, did).unwrap() {
        Judging::Verdict(verdict) => *verdict,
        Judging::Ask(requests) => {
            let responses: Vec<_> = requests.iter().map(|r| serve(r, &SilentHost)).collect();
            conclude(situation, did, &responses).unwrap()
        }
    }
}

/// What is asked of a scene, perhaps with a plan, and told to who wants no guess.
fn told(scene: &Json, plan: Option<Json>, what: &Json) -> Why {
    let mut step = json!({ "title": "T", "text": ["T."], "scene": scene,
        "task": { "kind": "predict", "say": "What?", "what": what }, "reason": "So." });
    if let Some(paths) = plan {
        step["plan"] = json!({ "giveway": 1, "paths": paths });
    }
    let step: Step = serde_json::from_value(step).unwrap();
    let scene = step.scene.clone().unwrap();
    judged(&step, &scene, &Did::Revealed).why
}

fn number(number: u32) -> Why {
    Why::Revealed(Value::Number(number))
}

fn robot(name: &str) -> Why {
    Why::Revealed(Value::Robot(name.into()))
}

#[test]
fn a_rule_costs_what_the_best_plan_costs_more() {
    let price = |rules: Json| told(&row(&rules), None, &json!({ "is": "price", "rule": 0 }));
    assert_eq!(price(json!([gap(1)])), number(1));
    assert_eq!(price(json!([gap(2)])), number(2));
    // Beside a rule that asks for more it costs nothing.
    assert_eq!(price(json!([gap(1), gap(2)])), number(0));
    // Where there is no plan, there is no price.
    let late = json!({ "kind": "arrive", "agents": ["A1"], "by": 1 });
    assert_eq!(price(json!([late])), Why::NoPlan);
}

#[test]
fn one_rule_may_leave_no_plan() {
    let late = |by: u32| json!({ "kind": "arrive", "agents": ["A1"], "by": by });
    let decides = |rules: Json| told(&row(&rules), None, &json!({ "is": "decides" }));
    let second = Why::Revealed(Value::Rule { rule: 1 });
    assert_eq!(decides(json!([gap(1), late(2)])), second);
    // A rule that is off is none.
    let mut off = late(2);
    off["off"] = json!(true);
    assert_eq!(decides(json!([off, late(2)])), second);
    // Either of two would have to go; then neither is the one.
    assert_eq!(decides(json!([late(2), late(1)])), Why::Unclear);
    assert!(matches!(decides(json!([gap(1)])), Why::Plan(_)));
}

#[test]
fn who_is_first_is_so_in_every_best_plan() {
    let first = |x: u32| {
        told(
            &row(&json!([])),
            None,
            &json!({ "is": "first-at", "cell": [x, 0] }),
        )
    };
    assert_eq!(first(2), robot("A1"));
    // A2 stands there from the start.
    assert_eq!(first(0), robot("A2"));
    let crossing = json!({ "giveway": 1, "map": ["#.#", "...", "#.#"], "agents": [
        { "name": "A1", "start": [0, 1], "goal": [2, 1] },
        { "name": "A2", "start": [1, 2], "goal": [1, 0] }] });
    let middle = json!({ "is": "first-at", "cell": [1, 1] });
    assert_eq!(told(&crossing, None, &middle), Why::Differs);
}

#[test]
fn steps_are_lost_because_of_somebody() {
    // A3 meets A1 and A2 in a corridor with a bay, and loses two steps.
    let scene = json!({ "giveway": 1, "map": ["####.####", "........."], "agents": [
        { "name": "A1", "start": [0, 1], "goal": [8, 1] },
        { "name": "A2", "start": [7, 1], "goal": [0, 1] },
        { "name": "A3", "start": [8, 1], "goal": [1, 1] }] });
    let lesson = shipped::lesson("who-costs-whom");
    let plan = lesson.steps[1].plan.as_ref().unwrap();
    let paths = serde_json::to_value(&plan.paths).unwrap();
    let ask = |what: Json| told(&scene, Some(paths.clone()), &what);
    let delay = |robot: &str, because: Option<&str>| {
        ask(json!({ "is": "delay", "robot": robot, "because": because }))
    };
    assert_eq!(delay("A3", None), number(2));
    assert_eq!(delay("A3", Some("A1")), number(1));
    assert_eq!(delay("A2", Some("A3")), number(0));
    // One and a half steps are no whole number.
    assert_eq!(delay("A1", Some("A2")), Why::Unclear);
    assert_eq!(ask(json!({ "is": "loses-most" })), robot("A1"));
    assert_eq!(ask(json!({ "is": "costs-most" })), robot("A1"));
    // Without a plan there is no ledger.
    let most = json!({ "is": "loses-most" });
    assert_eq!(told(&scene, None, &most), Why::Untouched);
    // Two that lose as much: none loses most.
    let idle = json!({ "A1": [[1, 0], [1, 0], [2, 0], [3, 0], [4, 0]],
                       "A2": [[0, 0], [0, 0], [1, 0], [2, 0], [3, 0]] });
    assert_eq!(told(&row(&json!([])), Some(idle), &most), Why::Unclear);
}

#[test]
fn claims_are_about_prices_and_about_one_rule() {
    let paths =
        json!({ "A1": [[1, 0], [2, 0], [3, 0], [4, 0]], "A2": [[0, 0], [1, 0], [2, 0], [3, 0]] });
    let late = json!({ "kind": "arrive", "agents": ["A1"], "by": 3 });
    let step = json!({ "title": "T", "text": ["T."], "scene": row(&json!([late, gap(1)])),
        "plan": { "giveway": 1, "paths": paths },
        "task": { "kind": "choose", "say": "What?", "answers": [
            { "text": "Broken.", "reply": "1", "right": true, "claim": { "is": "broken", "rule": 1 } },
            { "text": "Broken.", "reply": "2", "claim": { "is": "broken", "rule": 0 } },
            { "text": "Costs 1.", "reply": "3", "right": true,
              "claim": { "is": "price", "rule": 1, "compare": "=", "value": 1 } },
            { "text": "Free.", "reply": "4",
              "claim": { "is": "price", "rule": 1, "compare": "<=", "value": 0 } }] } });
    let step: Step = serde_json::from_value(step).unwrap();
    let scene = step.scene.clone().unwrap();
    for answer in 0..4 {
        let verdict = judged(&step, &scene, &Did::Chose(answer));
        assert_eq!(verdict.why, Why::Reply(answer));
        assert_eq!(verdict.is_solved(), answer % 2 == 0, "{answer}");
    }
}

#[test]
fn a_price_is_told_with_both_plans() {
    let mut start = row(&json!([gap(1)]));
    start["map"] = json!([".....", "#####"]);
    let step: Step = serde_json::from_value(json!({
        "title": "T", "text": ["T."], "scene": start, "tools": ["obstacle"],
        "task": { "kind": "paint", "say": "Do.",
                  "until": { "is": "price", "rule": 0, "compare": "=", "value": 0 } } }))
    .unwrap();
    let painted = |row: &str| {
        let mut scene = step.scene.clone().unwrap();
        scene.map[1] = row.to_owned();
        judged(&step, &scene, &Did::Edits)
    };
    let dear = painted("####.");
    let words = "rule 1 costs 1: the best makespan is 4 with it, and 3 without it.";
    assert!(!dear.is_solved());
    assert_eq!(said(&dear, &step).text.plain(), words);
    let without = dear.evidence.without.unwrap();
    let price = without.price.unwrap();
    assert_eq!((without.rule, price.with, price.without), (0, 4, 3));
    let last = |plan: &Plan| plan.path("A2").len() - 1;
    assert_eq!(last(&without.plan), 3);
    assert_eq!(last(&dear.evidence.plan.unwrap()), 4);
}

#[test]
fn what_is_asked_of_rules_must_be_there() {
    let faults = |what: &Json| {
        let text = json!({ "giveway": 1, "title": "T", "minutes": 4, "about": "A sentence.", "steps": [
            { "title": "A", "text": ["Say."], "scene": row(&json!([gap(1), { "kind": "gap", "steps": 2, "off": true }])),
              "task": { "kind": "predict", "say": "What?", "what": what }, "reason": "So." }] });
        match read_lesson(&text.to_string(), &shipped::glossary()) {
            Ok(_) => Vec::new(),
            Err(faults) => faults.into_iter().map(|fault| fault.place).collect(),
        }
    };
    let none: [&str; 0] = [];
    assert_eq!(faults(&json!({ "is": "price", "rule": 0 })), none);
    let at = "steps[0].task.what";
    // The second is off, and there is no third.
    for rule in [1, 2] {
        assert_eq!(
            faults(&json!({ "is": "price", "rule": rule })),
            [format!("{at}.rule")]
        );
    }
    assert_eq!(
        faults(&json!({ "is": "first-at", "cell": [9, 9] })),
        [format!("{at}.cell")]
    );
    let unknown = json!({ "is": "delay", "robot": "A9", "because": "A8" });
    let found = faults(&unknown);
    for place in [
        format!("{at}.robot"),
        format!("{at}.because"),
        "steps[0].plan".to_owned(),
    ] {
        assert!(found.contains(&place), "{place}: {found:?}");
    }
}

#[test]
fn the_check_of_a_task_tells_what_has_no_one_answer() {
    let found = |scene: &Json, what: Json| {
        let task = json!({ "kind": "predict", "what": what });
        let lesson = lesson(scene, &json!({}), &task);
        let mut check = LessonCheck::default();
        run(&mut check, share(&lesson, false));
        check.of(&Subject::all(&lesson).remove(0)).unwrap().clone()
    };
    let late = json!({ "kind": "arrive", "agents": ["A1"], "by": 2 });
    let decides = json!({ "is": "decides" });
    let one = row(&json!([gap(1), late]));
    assert_eq!(found(&one, decides.clone()), Finding::Passed);
    let both = row(&json!([late, late]));
    assert_eq!(
        found(&both, decides.clone()),
        Finding::Failed(Problem::Unclear)
    );
    let some = row(&json!([gap(1)]));
    assert_eq!(found(&some, decides), Finding::Failed(Problem::SomePlan));
}

#[test]
fn they_are_written_in_the_form_and_read_back() {
    let text = json!({ "giveway": 1, "title": "T", "minutes": 4, "about": "A sentence.", "steps": [
        { "title": "A", "text": ["Say."], "scene": row(&json!([gap(1), gap(2)])),
          "task": { "kind": "predict", "say": "Which?", "what": { "is": "decides" }, "answers": [
              { "value": { "rule": 0 }, "text": "The first.", "reply": "No." },
              { "value": { "rule": 1 }, "text": "The second.", "reply": "Yes." }] }, "reason": "So." },
        { "title": "B", "text": ["Say."],
          "task": { "kind": "predict", "say": "Who?", "what": { "is": "first-at", "cell": [2, 0] } }, "reason": "So." },
        { "title": "C", "text": ["Say."],
          "task": { "kind": "predict", "say": "What?", "what": { "is": "price", "rule": 1 } }, "reason": "So." },
        { "title": "D", "text": ["Say."],
          "plan": { "giveway": 1, "paths": { "A1": [[1, 0], [2, 0], [3, 0], [4, 0]], "A2": [[0, 0], [1, 0], [2, 0], [3, 0]] } },
          "task": { "kind": "predict", "say": "What?", "what": { "is": "delay", "robot": "A1", "because": "A2" } },
          "reason": "So." },
        { "title": "E", "text": ["Paint."], "tools": ["obstacle"],
          "task": { "kind": "paint", "say": "Do.", "until": { "is": "price", "rule": 0, "compare": ">=", "value": 2 } },
          "hints": ["Think."], "reason": "So." }] });
    let lesson = read_lesson(&text.to_string(), &shipped::glossary()).unwrap();
    let again = Draft::of(&lesson).look(&shipped::glossary());
    assert_eq!(again.whole().map_err(<[_]>::to_vec), Ok(&lesson));
}
