//! Whatever is done to files that people bring (cut, damaged, encoded anew, lines swapped, keys
//! added), the outcome is an answer, a refusal with its place, or a loss that is told.
//!
//! `GIVEWAY_RANDOM_TEXTS` says how many texts are tried (4,000; with `GIVEWAY_LONG=1`
//! a million), `GIVEWAY_RANDOM_SEED` which ones.

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    clippy::string_slice,
    clippy::indexing_slicing,
    reason = "a test stops at the first surprise"
)]

#[path = "foreign/dice.rs"]
mod dice;
#[path = "foreign/noise_seeds.rs"]
mod noise_seeds;

use std::path::PathBuf;

use dice::Dice;
use giveway_formats::{Combined, Format, Held, Options, Refused, Source, combine, read, recognise};
use giveway_model::Fault;
use giveway_model::format::{decode, read_text};
use noise_seeds::{MAP, SCENARIO, SEEDS};

fn number(name: &str) -> Option<usize> {
    std::env::var(name).ok()?.parse().ok()
}

/// The bytes of all small files that the tests have.
fn files() -> Vec<Vec<u8>> {
    let data = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tests/data");
    let mut paths: Vec<PathBuf> = ["brought", "plans", "asprilo"]
        .iter()
        .flat_map(|folder| std::fs::read_dir(data.join(folder)).unwrap())
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.extension().is_none_or(|ending| ending != "md"))
        .collect();
    paths.sort();
    let files = paths.iter().map(|path| std::fs::read(path).unwrap());
    files.filter(|bytes| bytes.len() < 5_000).collect()
}

fn assert_placed(fault: &Fault, text: &str) {
    let is_placed = fault.line.is_some() && fault.column.is_some();
    assert!(is_placed, "{fault}\n{text}");
    assert!(
        !fault.found.is_empty() && !fault.expected.is_empty(),
        "{fault:?}\n{text}"
    );
    assert!(fault.to_string().chars().count() < 500, "{fault}");
}

/// Reads bytes as every door does, and combines them with a map and a scenario.
fn outcome(bytes: &[u8]) -> Option<Combined> {
    let text = match read_text(bytes) {
        Ok(text) => text,
        Err(fault) => {
            assert_placed(&fault, "bytes");
            return None;
        }
    };
    if let Err(faults) = read(&text) {
        assert!(!faults.is_empty());
        for fault in &faults {
            assert_placed(fault, &text);
        }
        return None;
    }
    let own = Source {
        name: "it",
        text: &text,
    };
    let map = Source {
        name: "m.map",
        text: MAP,
    };
    let scenario = Source {
        name: "m.scen",
        text: SCENARIO,
    };
    let mut found = None;
    for sources in [vec![own], vec![own, map], vec![own, map, scenario]] {
        match combine(&sources, &Options::default()) {
            Ok(combined) => found = found.or(Some(combined)),
            Err(Refused::File { faults, .. }) => assert!(!faults.is_empty()),
            Err(Refused::Missing { sentence, .. } | Refused::Apart(sentence)) => {
                assert!(sentence.len() > 10, "{sentence}");
            }
        }
    }
    found
}

/// Encodes a text in one of the ways that are read.
fn encoded(text: &str, way: usize) -> Vec<u8> {
    let marked = if way.is_multiple_of(2) {
        format!("\u{feff}{text}")
    } else {
        text.to_owned()
    };
    match way {
        0 | 1 => marked.into_bytes(),
        2 | 3 => marked.encode_utf16().flat_map(u16::to_le_bytes).collect(),
        _ => marked.encode_utf16().flat_map(u16::to_be_bytes).collect(),
    }
}

/// Swaps two lines.
fn swapped(text: &str, dice: &mut Dice) -> String {
    let mut lines: Vec<&str> = text.split_inclusive('\n').collect();
    let (one, other) = (dice.below(lines.len()), dice.below(lines.len()));
    if !lines.is_empty() {
        lines.swap(one, other);
    }
    lines.concat()
}

/// Adds a key to one of the objects of a JSON text.
fn with_key(text: &str, dice: &mut Dice) -> Option<(String, bool)> {
    let objects: Vec<usize> = text.match_indices('{').map(|(at, _)| at).collect();
    let which = dice.below(objects.len());
    let at = *objects.get(which)?;
    let rest = text[at + 1..].trim_start();
    let comma = if rest.starts_with('}') { "" } else { "," };
    let with = format!("{}\"added\": 7{comma}{}", &text[..=at], &text[at + 1..]);
    Some((with, which == 0))
}

#[test]
fn what_is_done_to_a_file_is_answered_refused_or_told() {
    let long = number("GIVEWAY_LONG").is_some_and(|long| long > 0);
    let all = number("GIVEWAY_RANDOM_TEXTS").unwrap_or(if long { 1_000_000 } else { 4_000 });
    let mut dice = Dice::new(number("GIVEWAY_RANDOM_SEED").unwrap_or(1) as u64);
    let mut seeds = files();
    seeds.extend(SEEDS.iter().map(|seed| seed.as_bytes().to_vec()));
    let texts: Vec<String> = seeds
        .iter()
        .map(|seed| read_text(seed).unwrap().into_owned())
        .collect();
    let groups = [texts.iter().map(String::as_str).collect::<Vec<&str>>()];
    for _ in 0..all {
        let bytes = &seeds[dice.below(seeds.len())];
        let text = read_text(bytes).unwrap().into_owned();
        match dice.below(5) {
            0 => drop(outcome(&bytes[..dice.below(bytes.len())])),
            4 => drop(outcome(dice.text(&groups).as_bytes())),
            1 => drop(outcome(swapped(&text, &mut dice).as_bytes())),
            2 => {
                let way = dice.below(6);
                let again = encoded(&text, way);
                assert_eq!(decode(&again).unwrap().0, text, "encoding {way}");
                let cut = &again[..dice.below(again.len())];
                drop(outcome(cut));
            }
            _ => key_added(&text, &mut dice),
        }
    }
}

/// A key that nobody knows is refused, or told, or stands where it changes nothing.
fn key_added(text: &str, dice: &mut Dice) {
    if !text.trim_start().starts_with('{') {
        return;
    }
    let Some((with, is_top)) = with_key(text, dice) else {
        return;
    };
    let before = read(text).map(|(format, held)| {
        (
            format,
            matches!(held, Held::OwnPlan(_, notes) if notes.is_empty()),
        )
    });
    let after = outcome(with.as_bytes());
    match (before, recognise(&with)) {
        // Its own instances, plans and changes have no unknown keys; results of the
        // command may have new ones, which change nothing of the plan within.
        (Ok((Format::Giveway, _)), Ok(_))
            if !text.contains("\"status\"") && !text.contains("\"methods\"") =>
        {
            assert!(read(&with).is_err(), "{with}");
        }
        (Ok((Format::League, _)), Ok(Format::League)) if is_top && text.contains("actualPaths") => {
            let notes = after.map(|combined| {
                combined
                    .plans
                    .into_iter()
                    .flat_map(|plan| plan.notes)
                    .collect::<Vec<_>>()
            });
            if let Some(notes) = notes {
                assert!(notes.join(" ").contains("added"), "{notes:?}\n{with}");
            }
        }
        _ => {}
    }
}

#[test]
fn every_file_is_read_or_refused_whole() {
    for bytes in files() {
        outcome(&bytes);
    }
}
