//! Scene files with damaged zones and rules: the reader refuses each with a place, or what
//! it reads is written and read back as the same scene.
//!
//! `GIVEWAY_RULE_NOISE` sets how many files are damaged, `GIVEWAY_RANDOM_SEED` which.
#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    clippy::panic,
    reason = "a test that cannot go on ends with a panic"
)]

use giveway_model::format::native;
use giveway_model::{Constraint, Fault, Instance};
use giveway_tests::environment;

use giveway_tests::rules_random::{KINDS, scene_with_rules};
use rand::seq::IndexedRandom;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use serde_json::{Map, Value, json};

/// Values as JSON that are put in the place of others; some are of the right type.
const VALUES: [&str; 36] = [
    "null",
    "true",
    "\"\"",
    "\"A0\"",
    "\"zone 0\"",
    "\"gap\"",
    "\"arrive\"",
    "\"north\"",
    "\"\\n\"",
    "-1",
    "-0.0",
    "0",
    "1",
    "2",
    "3.0",
    "0.5",
    "1e400",
    "1e2",
    "1000000",
    "1000001",
    "4294967295",
    "4294967296",
    "9007199254740993",
    "18446744073709551616",
    "[]",
    "{}",
    "[0]",
    "[0, 0]",
    "[[0, 0]]",
    "[[0, 0], [1, 0]]",
    "[[0, 0], [0, 0]]",
    "[0, 0, 0, 0]",
    "[1, 1, 0, 0]",
    "[\"A0\", \"A0\"]",
    "[null]",
    "{ \"agent\": \"A0\", \"cell\": [0, 0] }",
];

/// All keys of zones and rules, and one that nothing has.
const KEYS: [&str; 24] = [
    "kind", "zone", "most", "from", "to", "lane", "steps", "distance", "agent", "cells", "cell",
    "stay", "by", "weight", "first", "second", "quarter", "agents", "name", "off", "rect",
    "heading", "zones", "flavour",
];

/// Stands for a text in a value until it is written.
fn raw(text: &str) -> Value {
    json!(format!("@raw {text}@"))
}

/// A value as JSON, raw texts as they are.
fn written(value: &Value) -> String {
    let mut text = value.to_string();
    while let Some(begin) = text.find("\"@raw ") {
        let inner = begin + "\"@raw ".len();
        let end = inner + text[inner..].find("@\"").unwrap();
        // The text stands in a string of JSON.
        let quoted = format!("\"{}\"", &text[inner..end]);
        let plain: String = serde_json::from_str(&quoted).unwrap();
        text.replace_range(begin..end + 2, &plain);
    }
    text
}

/// Damages something in a value.
fn damage(random: &mut ChaCha8Rng, value: &mut Value) {
    let goes_in = random.random_bool(0.8);
    match value {
        Value::Array(list) if goes_in && !list.is_empty() => {
            let i = random.random_range(0..list.len());
            match random.random_range(0..10) {
                0 => list.push(list[i].clone()),
                1 => drop(list.remove(i)),
                2 => list.reverse(),
                _ => damage(random, &mut list[i]),
            }
        }
        Value::Object(object) if goes_in && !object.is_empty() => {
            let keys: Vec<String> = object.keys().cloned().collect();
            let key = keys.choose(random).unwrap();
            match random.random_range(0..10) {
                0 => drop(object.remove(key)),
                1 => rename(random, object, key),
                2 => {
                    let new = *KEYS.choose(random).unwrap();
                    object.insert(new.to_owned(), raw(VALUES.choose(random).unwrap()));
                }
                3 => {
                    let other = keys.choose(random).unwrap();
                    let (a, b) = (object[key].clone(), object[other].clone());
                    object.insert(key.clone(), b);
                    object.insert(other.clone(), a);
                }
                4 => {
                    // The same key twice.
                    let twice = format!("{}, {}: {}", object[key], json!(key), object[key]);
                    object.insert(key.clone(), raw(&twice));
                }
                _ => damage(random, object.get_mut(key).unwrap()),
            }
        }
        _ => {
            // Often something of the same type, so that the text can be read.
            let is_alike = |text: &&str| match serde_json::from_str::<Value>(text) {
                Ok(other) => match value {
                    Value::Number(_) => other.is_u64(),
                    Value::String(_) => other.is_string(),
                    _ => false,
                },
                Err(_) => false,
            };
            let alike: Vec<&str> = VALUES.into_iter().filter(|text| is_alike(text)).collect();
            let keeps_type = random.random_bool(0.7);
            let text = alike.choose(random).filter(|_| keeps_type);
            *value = raw(text.unwrap_or(&VALUES[random.random_range(0..VALUES.len())]));
        }
    }
}

fn rename(random: &mut ChaCha8Rng, object: &mut Map<String, Value>, key: &str) {
    let value = object.remove(key).unwrap();
    let new = *KEYS.choose(random).unwrap();
    object.insert(new.to_owned(), value);
}

/// A file with two rules, its zones or rules damaged once or twice.
fn damaged(seed: u64, number: u64) -> String {
    let kind = |step: u64| KINDS[((number + number / 14 * step) % 14) as usize];
    let mut scene = scene_with_rules(seed, number % 500, &[kind(1), kind(3)]);
    let random = &mut ChaCha8Rng::seed_from_u64(seed);
    random.set_stream(number);
    for _ in 0..random.random_range(1..=2) {
        let key = *["zones", "constraints", "constraints"]
            .choose(random)
            .unwrap();
        damage(random, &mut scene[key]);
    }
    written(&scene)
}

fn assert_told(fault: &Fault, text: &str) {
    let told = fault.to_string();
    assert!(
        fault.line.is_some() && fault.column.is_some(),
        "{told}: {text}"
    );
    assert!(told.chars().count() < 400, "{told}: {text}");
    assert!(!told.contains(['\n', '\r']), "{told}: {text}");
}

/// Whether a rule is read from its own sentence, but for what words do not say.
fn is_read_from_words(rule: &Constraint) -> bool {
    let read = Constraint::from_words(&rule.sentence());
    read.is_ok_and(|read| read.sentence() == rule.sentence())
}

#[test]
fn a_damaged_file_is_refused_or_read_as_it_is_written() {
    let seed = environment::number("GIVEWAY_RANDOM_SEED", 91);
    let (mut refused, mut faulty, mut valid) = (0, 0, 0);
    for number in 0..environment::number("GIVEWAY_RULE_NOISE", 6000) {
        let text = damaged(seed, number);
        let scene = match native::read_scene(&text) {
            Ok(scene) => scene,
            Err(fault) => {
                assert_told(&fault, &text);
                refused += 1;
                continue;
            }
        };
        let again = serde_json::to_string(&scene).unwrap();
        assert_eq!(native::read_scene(&again).as_ref(), Ok(&scene), "{text}");
        match native::read_instance(&text) {
            Ok(instance) => {
                valid += 1;
                assert_eq!(Instance::new(instance.to_scene()).as_ref(), Ok(&instance));
                for rule in instance.constraints() {
                    assert!(is_read_from_words(rule), "{}: {text}", rule.sentence());
                }
            }
            Err(faults) => {
                faulty += 1;
                assert!(!faults.is_empty(), "{text}");
                for fault in &faults {
                    assert!(!fault.place.is_empty(), "{fault}: {text}");
                    assert_told(fault, &text);
                }
            }
        }
    }
    println!("{refused} unreadable, {faulty} with faults, {valid} valid");
    assert!(refused > 600 && faulty > 200 && valid > 300);
}
