//! Relations between answers to scenes with rules of their own, with more agents than the
//! oracle can look at; and the default horizon of the scenes with known answers.
//!
//! All answers of a relation are about the plans of one horizon. A scene that needs too many
//! conflicts is passed over, which few may be. `GIVEWAY_RULE_RELATIONS` sets how many random
//! scenes each test looks at.
#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    clippy::panic,
    reason = "a test that cannot go on ends with a panic"
)]

use std::fs;
use std::path::Path;

use giveway_model::check::check;
use giveway_model::format::native;
use giveway_model::{Instance, Plan};
use giveway_planners::budget::Unlimited;
use giveway_planners::problem::Problem;
use giveway_solve::price::{Price, PriceRequest};
use giveway_solve::{Limits, Request, Response, SilentHost, Status, serve};
use giveway_tests::rules_random::{KINDS, crowd_with_rules};
use giveway_tests::{ask, environment};
use serde_json::{Value, json};

/// The horizon, in time steps: enough for most of the scenes.
const WITHIN: u32 = 24;
/// The scenes of the usual run.
const USUAL: u64 = 56;
/// Conflicts of the SAT solver for one answer.
const CONFLICTS: u64 = 20_000;

/// Holds a relation against random scenes with two rules. It is given the number and the
/// scene, and returns whether it said something; `None` where an answer took too long.
/// About how many of [`USUAL`] scenes it said something.
fn check_each(seed: u64, relation: impl Fn(u64, &Value) -> Option<bool>) -> u64 {
    let count = environment::number("GIVEWAY_RULE_RELATIONS", USUAL);
    let (mut answered, mut said) = (0, 0);
    for number in 0..count {
        let kind = |step: u64| KINDS[((number + number / 14 * step) % 14) as usize];
        let scene = crowd_with_rules(seed, number, &[kind(1), kind(3)]);
        if let Some(is_about) = relation(number, &scene) {
            answered += 1;
            said += u64::from(is_about);
        }
    }
    println!("{said} of {answered} answered of {count} scenes");
    assert!(answered * 10 >= count * 9, "only {answered} were answered");
    said * USUAL / count
}

/// The best plan and its costs, in the order of the objective in force.
type Best = Option<(Plan, Vec<u32>)>;

/// The best plan of a scene; `None` outside where it took too long.
fn best(scene: &Value) -> Option<Best> {
    let instance = read(scene);
    let answer = ask::best_within_conflicts(&instance, Some(WITHIN), CONFLICTS);
    match answer.status {
        Status::Optimal => {
            let plan = answer.plan.unwrap();
            let report = check(&instance, &plan);
            assert_eq!(report.violations, [], "{scene}");
            assert_eq!(report.costs, answer.costs, "{scene}");
            let objective = instance.in_force(instance.objective().clone());
            Some(Some((plan, answer.costs.unwrap().vector(&objective))))
        }
        Status::Impossible => Some(None),
        Status::Feasible | Status::Unknown => {
            assert!(answer.stats.conflicts >= CONFLICTS, "{answer:?}: {scene}");
            None
        }
    }
}

/// The optimum as a value that can be compared: impossible is the largest, and a penalty
/// that is not in force is 0.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Optimum {
    Plan(Vec<u32>),
    None,
}

fn of_best(best: Best) -> Optimum {
    best.map_or(Optimum::None, |(_, mut costs)| {
        costs.resize(6, 0);
        Optimum::Plan(costs)
    })
}

fn optimum(scene: &Value) -> Option<Optimum> {
    best(scene).map(of_best)
}

fn read(scene: &Value) -> Instance {
    native::read_instance(&scene.to_string()).unwrap_or_else(|fault| panic!("{fault:?}: {scene}"))
}

/// The scene with a rule switched off.
fn without(scene: &Value, rule: usize) -> Value {
    let mut scene = scene.clone();
    scene["constraints"][rule]["off"] = json!(true);
    scene
}

fn rules(scene: &Value) -> &Vec<Value> {
    scene["constraints"].as_array().unwrap()
}

#[test]
fn switching_a_rule_off_never_makes_a_plan_dearer() {
    let cheaper = check_each(1, |number, scene| {
        let rule = number as usize % 2;
        let off = optimum(&without(scene, rule))?;
        let on = optimum(scene)?;
        assert!(
            off <= on,
            "{on:?}, and {off:?} without rule {rule}: {scene}"
        );
        Some(off < on)
    });
    assert!(cheaper > 8, "{cheaper}");
}

#[test]
fn a_price_is_the_difference_of_two_answers() {
    let dear = check_each(2, |_, scene| {
        let request = PriceRequest {
            scene: native::read_scene(&scene.to_string()).unwrap(),
            within: Some(WITHIN),
            limits: Limits {
                conflicts: Some(10 * CONFLICTS),
                ..Limits::default()
            },
            ..PriceRequest::default()
        };
        let Response::Priced(answer) = serve(&Request::Price(request), &SilentHost) else {
            panic!("{scene}")
        };
        let with = optimum(scene)?;
        let mut is_dear = false;
        for priced in &answer.prices {
            if !priced.exact {
                return None;
            }
            let off = optimum(&without(scene, priced.index as usize))?;
            let expected = match (&with, &off) {
                (Optimum::None, Optimum::None) => Price::None,
                (Optimum::None, Optimum::Plan(_)) => Price::Decides,
                (Optimum::Plan(with), Optimum::Plan(off)) if with == off => Price::Free,
                (Optimum::Plan(_), Optimum::Plan(_)) => Price::Costs,
                (Optimum::Plan(_), Optimum::None) => panic!("{scene}"),
            };
            assert_eq!(priced.price, expected, "{priced:?}: {scene}");
            if let (Optimum::Plan(with), Optimum::Plan(off)) = (&with, &off) {
                let told = answer.objective.costs().iter();
                let told = told.map(|cost| priced.difference[cost]);
                let differences = with.iter().zip(off);
                let mut differences = differences.map(|(&a, &b)| i64::from(a) - i64::from(b));
                for told in told {
                    assert_eq!(Some(told), differences.next(), "{priced:?}: {scene}");
                }
            }
            is_dear |= priced.price == Price::Costs;
        }
        Some(is_dear)
    });
    assert!(dear > 8, "{dear}");
}

#[test]
fn a_capacity_of_nobody_is_a_closed_zone() {
    let said = check_each(3, |_, scene| {
        let (mut capacity, mut closed) = (scene.clone(), scene.clone());
        let mut found = false;
        for (i, rule) in rules(scene).iter().enumerate() {
            if ["capacity", "closed"].contains(&rule["kind"].as_str().unwrap()) {
                found = true;
                capacity["constraints"][i]["kind"] = json!("capacity");
                capacity["constraints"][i]["most"] = json!(0);
                closed["constraints"][i]["kind"] = json!("closed");
                let rule = closed["constraints"][i].as_object_mut().unwrap();
                rule.remove("most");
            }
        }
        if !found {
            return Some(false);
        }
        assert_eq!(optimum(&capacity)?, optimum(&closed)?, "{scene}");
        Some(true)
    });
    assert!(said > 5, "{said}");
}

#[test]
fn a_longer_gap_keeps_a_shorter_one() {
    let said = check_each(4, |number, scene| {
        let mut last: Option<Optimum> = None;
        let mut grows = false;
        for steps in 1..=4 {
            let mut scene = scene.clone();
            scene["constraints"][number as usize % 2] = json!({ "kind": "gap", "steps": steps });
            let (plan, now) = match best(&scene)? {
                Some((plan, costs)) => (Some(plan), of_best(Some((Plan::default(), costs)))),
                None => (None, Optimum::None),
            };
            // The plan keeps all shorter gaps.
            for shorter in 1..=steps {
                scene["constraints"][number as usize % 2]["steps"] = json!(shorter);
                let report = plan.as_ref().map(|plan| check(&read(&scene), plan));
                assert!(report.is_none_or(|report| report.is_valid()), "{scene}");
            }
            if let Some(last) = last {
                assert!(
                    last <= now,
                    "{last:?}, {now:?} for a gap of {steps}: {scene}"
                );
                grows |= last < now;
            }
            last = Some(now);
        }
        Some(grows)
    });
    assert!(said > 4, "{said}");
}

/// The free cells of a scene.
fn free_cells(scene: &Value) -> Vec<[usize; 2]> {
    let rows = scene["map"].as_array().unwrap().iter().enumerate();
    let cells = rows.flat_map(|(y, row)| {
        let row = row.as_str().unwrap().chars().enumerate();
        row.filter(|&(_, c)| c != '#').map(move |(x, _)| [x, y])
    });
    cells.collect()
}

#[test]
fn opposed_lanes_close_an_edge() {
    let said = check_each(5, |number, scene| {
        // A cell that nothing names, all of whose edges are closed, is an obstacle.
        let cells = free_cells(scene);
        let named = ["agents", "zones", "constraints"].map(|key| scene[key].to_string());
        let is_spare = |[x, y]: &&[usize; 2]| {
            let text = format!("[{x},{y}]");
            named.iter().all(|named| !named.contains(&text))
        };
        let spare: Vec<[usize; 2]> = cells.iter().filter(is_spare).copied().collect();
        let Some(&[x, y]) = spare.get(number as usize % spare.len().max(1)) else {
            return Some(false);
        };
        let (mut walled, mut closed) = (scene.clone(), scene.clone());
        let row = walled["map"][y].as_str().unwrap();
        let row: String = row
            .chars()
            .enumerate()
            .map(|(i, c)| if i == x { '#' } else { c })
            .collect();
        walled["map"][y] = json!(row);
        let lanes = closed["constraints"].as_array_mut().unwrap();
        for other in cells {
            if other[0].abs_diff(x) + other[1].abs_diff(y) == 1 {
                lanes.push(json!({ "kind": "one-way", "lane": [other, [x, y]] }));
                lanes.push(json!({ "kind": "one-way", "lane": [[x, y], other] }));
            }
        }
        assert_eq!(optimum(&walled)?, optimum(&closed)?, "{closed}");
        Some(true)
    });
    assert!(said > 20, "{said}");
}

/// Replaces each string that is a name by another one, wherever it stands.
fn renamed(value: &Value, names: &dyn Fn(&str) -> Option<String>) -> Value {
    match value {
        Value::String(text) => json!(names(text).unwrap_or_else(|| text.clone())),
        Value::Array(list) => list.iter().map(|it| renamed(it, names)).collect(),
        Value::Object(object) => {
            let entries = object.iter();
            let entries = entries.map(|(key, it)| (key.clone(), renamed(it, names)));
            Value::Object(entries.collect())
        }
        other => other.clone(),
    }
}

#[test]
fn other_names_change_nothing() {
    let said = check_each(6, |_, scene| {
        let name = |text: &str| {
            let digits = text.strip_prefix(['A']).or(text.strip_prefix("zone "))?;
            let number: u32 = digits.parse().ok()?;
            Some(format!("{} {text}", 9 - number))
        };
        let mut other = renamed(scene, &name);
        for i in 0..rules(scene).len() {
            other["constraints"][i]["name"] = json!(format!("rule {}", 9 - i));
        }
        assert_ne!(scene["agents"], other["agents"]);
        assert_eq!(optimum(scene)?, optimum(&other)?, "{scene}");
        Some(true)
    });
    assert!(said > 40, "{said}");
}

#[test]
fn a_rule_that_the_best_plan_keeps_anyway_is_free() {
    let said = check_each(7, |number, scene| {
        let rule = number as usize % 2;
        let off = without(scene, rule);
        let Some((plan, costs)) = best(&off)? else {
            return Some(false);
        };
        let instance = read(scene);
        let report = check(&instance, &plan);
        let objective = instance.in_force(instance.objective().clone());
        let mut with = report.costs.map(|costs| costs.vector(&objective));
        if let Some(vector) = &mut with {
            vector.resize(6, 0);
        }
        let off = of_best(Some((plan, costs)));
        if !report.is_valid() || with.map(Optimum::Plan) != Some(off.clone()) {
            return Some(false);
        }
        assert_eq!(optimum(scene)?, off, "rule {rule}: {scene}");
        Some(true)
    });
    assert!(said > 4, "{said}");
}

#[test]
fn the_order_of_the_rules_changes_nothing() {
    let said = check_each(8, |_, scene| {
        let mut other = scene.clone();
        for key in ["constraints", "zones"] {
            other[key].as_array_mut().unwrap().reverse();
        }
        assert_eq!(optimum(scene)?, optimum(&other)?, "{scene}");
        Some(*scene != other)
    });
    assert!(said > 40, "{said}");
}

#[test]
fn the_default_horizon_is_that_of_the_known_answers() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("data/rules");
    let mut seen = 0;
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let known: Value = serde_json::from_str(&fs::read_to_string(&path).unwrap()).unwrap();
        let Some(expected) = known.get("horizon") else {
            continue;
        };
        let instance = read(&known["instance"]);
        let problem = Problem::new(&instance, &Unlimited::default());
        let horizon = problem.map(|it| it.default_horizon(instance.grid())).ok();
        assert_eq!(json!(horizon), *expected, "{}", path.display());
        seen += 1;
    }
    assert!(seen > 50, "{seen}");
}
