//! Prices of rules, questions about rules, and reasons with rules in them, against an
//! exhaustive search of joint states and against scenes whose prices were found elsewhere.
//!
//! `GIVEWAY_PRICE_SCENES` sets how many random scenes each test compares.
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "a test that cannot go on ends with a panic"
)]

mod loosened;
mod questions;

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use giveway_model::Instance;
use giveway_model::format::native;
use giveway_solve::price::{Price, PriceAnswer, PriceRequest};
use giveway_solve::{Request, Response, SilentHost, serve};
use giveway_tests::environment;
use giveway_tests::rules_oracle::{Answer, RuleScene, best};
use giveway_tests::rules_random::{KINDS, scene_with_rules};
use serde_json::Value;

/// Joint states that the oracle looks at.
const MOST_STATES: usize = 30_000;

fn scenes(usual: u64) -> u64 {
    environment::number("GIVEWAY_PRICE_SCENES", usual)
}

/// The optimum without some rules; `None` inside where there is no plan, outside where that
/// is too much for the oracle.
#[expect(
    clippy::option_option,
    reason = "no plan is an answer, and none at all where the scene is too large"
)]
fn optimum(text: &str, off: &[usize]) -> Option<Option<Vec<i64>>> {
    match best(&RuleScene::read(text, off), None, MOST_STATES) {
        Answer::Best(costs) => Some(Some(costs)),
        Answer::Impossible => Some(None),
        Answer::Capped => None,
    }
}

fn price(instance: &Instance) -> PriceAnswer {
    let request = PriceRequest {
        scene: instance.to_scene(),
        ..PriceRequest::default()
    };
    match serve(&Request::Price(request), &SilentHost) {
        Response::Priced(answer) => *answer,
        other => panic!("{other:?}"),
    }
}

/// Costs of as many components: a penalty that is not in force is 0.
fn padded(mut costs: Vec<i64>, length: usize) -> Vec<i64> {
    costs.resize(length, 0);
    costs
}

/// Compares the prices of a scene; how many rules of each price it has. `None` where it is
/// too large.
fn compare(text: &str, what: &str) -> Option<Vec<Price>> {
    let instance = native::read_instance(text).unwrap();
    let with = optimum(text, &[])?;
    let answer = price(&instance);
    let objective = answer.objective.costs().to_vec();
    let mut prices = Vec::new();
    for priced in &answer.prices {
        let what = format!("{what}, rule {}: {priced:?}\n{text}", priced.index);
        let without = optimum(text, &[priced.index as usize])?;
        let expected = match (&with, &without) {
            (None, None) => Price::None,
            (None, Some(_)) => Price::Decides,
            (Some(with), Some(without)) if *with == padded(without.clone(), with.len()) => {
                Price::Free
            }
            (Some(_), Some(_)) => Price::Costs,
            (Some(_), None) => panic!("{what}"),
        };
        assert_eq!(priced.price, expected, "{what}");
        assert!(priced.exact, "{what}");
        let told: Vec<i64> = objective
            .iter()
            .filter_map(|cost| priced.without.get(cost))
            .map(|&n| i64::from(n))
            .collect();
        let without = without.map_or(Vec::new(), |it| padded(it, objective.len()));
        assert_eq!(told, without, "{what}");
        if let Some(with) = &with {
            let differences = with.iter().zip(&without).map(|(a, b)| a - b);
            let told = objective.iter().map(|cost| priced.difference[cost]);
            assert!(told.eq(differences), "{what}");
        }
        prices.push(priced.price);
    }
    if with.is_none() && !answer.prices.is_empty() {
        compare_conflict(text, &answer, what)?;
    }
    Some(prices)
}

/// Compares which rules exclude each other, and the fewest to switch off.
fn compare_conflict(text: &str, answer: &PriceAnswer, what: &str) -> Option<()> {
    let rules: Vec<usize> = answer.prices.iter().map(|it| it.index as usize).collect();
    let chosen = |bits: usize| -> BTreeSet<usize> {
        let rules = rules.iter().enumerate();
        let chosen = rules.filter(|(i, _)| bits >> i & 1 == 1);
        chosen.map(|(_, &rule)| rule).collect()
    };
    let mut helps: Vec<BTreeSet<usize>> = Vec::new();
    for bits in 0..1 << rules.len() {
        let off = chosen(bits);
        let list: Vec<usize> = off.iter().copied().collect();
        if optimum(text, &list)?.is_some() {
            helps.push(off);
        }
    }
    let least = helps.iter().map(BTreeSet::len).min();
    let expected: BTreeSet<BTreeSet<usize>> = helps
        .iter()
        .filter(|off| Some(off.len()) == least)
        .cloned()
        .collect();
    let told = answer.switch_off.switch_off.iter();
    let told: BTreeSet<BTreeSet<usize>> = told
        .map(|set| set.iter().map(|&rule| rule as usize).collect())
        .collect();
    let what = format!("{what}: {:?}\n{text}", answer.switch_off);
    assert_eq!(told, expected, "{what}");
    assert!(answer.switch_off.switch_off_settled, "{what}");
    // With all facts in force the rules of the conflict exclude a plan, and none of them can
    // be left out.
    let core = answer.conflict.as_ref().unwrap_or_else(|| panic!("{what}"));
    let own: BTreeSet<usize> = core
        .facts
        .iter()
        .filter_map(|it| it.index)
        .map(|i| i as usize)
        .collect();
    let others = |kept: &BTreeSet<usize>| -> Vec<usize> {
        let rules = rules.iter().copied();
        rules.filter(|rule| !kept.contains(rule)).collect()
    };
    assert_eq!(optimum(text, &others(&own))?, None, "{what}");
    for rule in &own {
        let mut fewer = own.clone();
        fewer.remove(rule);
        assert!(optimum(text, &others(&fewer))?.is_some(), "{what}");
    }
    Some(())
}

#[test]
fn prices_are_differences_of_two_optima() {
    let mut seen = [0; 5];
    for number in 0..scenes(150) {
        let kind = |step: u64| KINDS[((number + number / 14 * step) % 14) as usize];
        let kinds = [kind(1), kind(3), kind(5)];
        let kinds = &kinds[..=(number as usize % 3)];
        let text = scene_with_rules(77, number, kinds).to_string();
        for price in compare(&text, &format!("scene {number}, {kinds:?}")).unwrap_or_default() {
            seen[price as usize] += 1;
        }
    }
    assert!(seen[..4].iter().all(|&n| n > 20), "{seen:?}");
}

#[test]
fn scenes_with_known_prices_have_these() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("data/rules");
    let (mut priced, mut conflicts) = (0, 0);
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let known: Value = serde_json::from_str(&fs::read_to_string(&path).unwrap()).unwrap();
        if known["prices"].is_null() && known["conflicts"].is_null() {
            continue;
        }
        let what = path.display().to_string();
        let instance = native::read_instance(&known["instance"].to_string()).unwrap();
        let answer = serde_json::to_value(price(&instance)).unwrap();
        for (told, known) in answer["prices"]
            .as_array()
            .unwrap()
            .iter()
            .zip(known["prices"].as_array().into_iter().flatten())
        {
            for key in ["index", "kind", "name", "price"] {
                let expected = known.get(key).unwrap_or(&told[key]);
                assert_eq!(&told[key], expected, "{what}: {told}");
            }
            let decided = ["costs", "free", "decides"].contains(&known["price"].as_str().unwrap());
            for (cost, value) in known["without"].as_object().into_iter().flatten() {
                assert!(decided, "{what}");
                assert_eq!(told["without"][cost], *value, "{what}: {told}");
            }
            for (cost, value) in known["difference"].as_object().into_iter().flatten() {
                assert_eq!(told["difference"][cost], *value, "{what}: {told}");
            }
            assert_eq!(told["exact"], true, "{what}: {told}");
            priced += 1;
        }
        if let Some(sets) = known["conflicts"].as_array() {
            let facts = answer["conflict"]["facts"].as_array().into_iter().flatten();
            // There rules go by their names.
            let name = |index: &Value| {
                let rule = &instance.constraints()[index.as_u64().unwrap() as usize];
                Value::from(rule.name.clone())
            };
            let own = facts.filter_map(|fact| fact.get("index"));
            let own: Value = own.map(name).collect();
            assert!(sets.contains(&own), "{what}: {own} of {sets:?}");
            let told = answer["switch_off"].as_array().unwrap().iter();
            let names =
                |set: &Value| -> Value { set.as_array().unwrap().iter().map(name).collect() };
            let told: Value = told.map(names).collect();
            assert_eq!(told, known["switch_off"], "{what}");
            conflicts += 1;
        }
    }
    assert!(priced > 40 && conflicts == 7, "{priced}, {conflicts}");
}
