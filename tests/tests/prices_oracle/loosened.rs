//! The least looser form of a rule, against all numbers from today's on by an exhaustive search.

use giveway_model::constraint::LooserWay;
use giveway_model::format::native;
use giveway_solve::price::{Loosened, PriceRequest};
use giveway_solve::{Request, Response, SilentHost, Status, serve};
use giveway_tests::rules_random::{KINDS, scene_with_rules};
use serde_json::Value;

use super::{optimum, padded, scenes};

/// At most so many numbers are tried beyond those that the solver passed over.
const BEYOND: u32 = 12;

fn loosened(text: &str, rule: u32) -> Option<(Status, Loosened)> {
    let instance = native::read_instance(text).unwrap();
    let request = PriceRequest {
        scene: instance.to_scene(),
        loosen: Some(rule),
        ..PriceRequest::default()
    };
    match serve(&Request::Price(request), &SilentHost) {
        Response::Priced(answer) => Some((answer.status, answer.loosened.unwrap())),
        Response::Refused(_) => None,
        other => panic!("{other:?}"),
    }
}

/// The scene with another number in a rule.
fn with_number(scene: &Value, rule: usize, way: LooserWay, steps: u32) -> String {
    let mut scene = scene.clone();
    let place = &mut scene["constraints"][rule];
    let mut looser: giveway_model::Constraint = serde_json::from_value(place.clone()).unwrap();
    looser.kind = looser
        .kind
        .loosened(way.loosens, way.number(steps))
        .unwrap();
    *place = serde_json::to_value(&looser).unwrap();
    scene.to_string()
}

/// Compares the ways in which a rule of a scene can be loosened; how many help, and how many do
/// not. `None` where that is too large for the oracle.
fn compare(scene: &Value, rule: usize) -> Option<(usize, usize)> {
    let text = scene.to_string();
    let with = optimum(&text, &[])?;
    let (status, told) = loosened(&text, rule as u32)?;
    let what = format!("rule {rule}: {told:?}\n{text}");
    assert_eq!(status == Status::Impossible, with.is_none(), "{what}");
    assert!(told.settled, "{what}");
    let instance = native::read_instance(&text).unwrap();
    let kind = &instance.constraints()[rule].kind;
    // Of times without an end the first number depends on how far is looked.
    let ways = kind.looser_ways(40).into_iter().filter(|way| !way.is_open);
    let (mut helped, mut not) = (0, 0);
    for way in ways {
        let changes = |steps: u32| -> Option<Option<Vec<i64>>> {
            let other = optimum(&with_number(scene, rule, way, steps), &[])?;
            let other = other.map(|it| match &with {
                Some(with) => padded(it, with.len()),
                None => it,
            });
            Some(if other == with { None } else { other })
        };
        let looser = told.looser.iter().find(|it| {
            let is_of_way =
                |steps| kind.loosened(way.loosens, way.number(steps)) == Some(it.rule.kind.clone());
            (1..=way.steps().min(100)).any(is_of_way)
        });
        let Some(looser) = looser else {
            for steps in (1..=way.steps().min(BEYOND)).chain([way.steps()]) {
                assert_eq!(changes(steps)?, None, "{steps} steps, {way:?}, {what}");
            }
            not += 1;
            continue;
        };
        let mut steps = 1;
        let costs = loop {
            if let Some(costs) = changes(steps)? {
                break costs;
            }
            steps += 1;
        };
        let least = kind.loosened(way.loosens, way.number(steps)).unwrap();
        assert_eq!(looser.rule.kind, least, "{way:?}, {what}");
        assert!(looser.least && looser.exact, "{way:?}, {what}");
        let told: Vec<i64> = instance
            .in_force(instance.objective().clone())
            .costs()
            .iter()
            .map(|cost| i64::from(looser.costs[cost]))
            .collect();
        assert_eq!(told, padded(costs, told.len()), "{way:?}, {what}");
        helped += 1;
    }
    Some((helped, not))
}

#[test]
fn the_least_looser_form_is_the_first_that_changes_the_optimum() {
    let (mut helped, mut not) = (0, 0);
    for number in 0..scenes(300) / 10 {
        let kind = |step: u64| KINDS[((number + number / 14 * step) % 14) as usize];
        let kinds = [kind(1), kind(3)];
        let kinds = &kinds[..=(number as usize % 2)];
        let scene = scene_with_rules(191, number, kinds);
        for rule in 0..kinds.len() {
            if let Some((yes, no)) = compare(&scene, rule) {
                helped += yes;
                not += no;
            }
        }
    }
    assert!(helped > 3 && not > 3, "{helped}, {not}");
}
