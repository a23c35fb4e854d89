//! No file of another planner makes a reader panic, however it is damaged; each
//! fault has a line and a column; and what is read can be combined, written and
//! read again.
//!
//! The seeds are the samples of every format and every small file in `data/asprilo`
//! and `data/plans`; each format has as many turns as every other.
//! `GIVEWAY_RANDOM_TEXTS` says how many texts are tried (20,000; with
//! `GIVEWAY_LONG=1` ten million), `GIVEWAY_RANDOM_SEED` which ones.

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    clippy::print_stdout,
    clippy::string_slice,
    clippy::indexing_slicing,
    reason = "a test stops at the first surprise, and a long one tells how far it is"
)]

#[path = "foreign/dice.rs"]
mod dice;
#[path = "foreign/noise_seeds.rs"]
mod noise_seeds;

use std::collections::BTreeMap;
use std::path::PathBuf;

use dice::Dice;
use giveway_formats::{
    Combined, Format, Held, MAX_STEPS, Options, Refused, Source, Walk, combine, read, recognise,
    write,
};
use giveway_model::Fault;
use noise_seeds::{MAP, SCENARIO, SEEDS};

fn number(name: &str) -> Option<u64> {
    let value = std::env::var(name).ok()?;
    Some(
        value
            .parse()
            .unwrap_or_else(|_| panic!("{name} is {value:?}")),
    )
}

/// The text of every small file of a folder of the tests' data, in order.
fn files(folder: &str) -> Vec<String> {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR"))
        .join("tests/data")
        .join(folder);
    let mut paths: Vec<PathBuf> = std::fs::read_dir(&folder)
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .collect();
    paths.sort();
    let texts = paths
        .iter()
        .filter_map(|path| std::fs::read_to_string(path).ok());
    texts.filter(|text| text.len() < 3_000).collect()
}

/// The seeds of each format.
fn groups(more: &[String]) -> BTreeMap<Format, Vec<&str>> {
    let mut groups: BTreeMap<Format, Vec<&str>> = BTreeMap::new();
    for seed in SEEDS.iter().copied().chain(more.iter().map(String::as_str)) {
        if let Ok((format, _)) = read(seed) {
            groups.entry(format).or_default().push(seed);
        }
    }
    groups
}

fn assert_placed(fault: &Fault, text: &str) {
    assert!(
        fault.line.is_some() && fault.column.is_some(),
        "{fault}\n{text}"
    );
    let sentence = fault.to_string();
    assert!(sentence.chars().count() < 400, "{sentence}");
    assert!(!sentence.contains(['\n', '\r']), "{sentence}");
}

fn steps(held: &Held) -> usize {
    let (Held::Plan(plan) | Held::Both(_, _, plan)) = held else {
        return 0;
    };
    let walks = plan.agents.iter().map(|agent| match &agent.walk {
        Walk::Cells(cells) => cells.len(),
        Walk::Moves(moves) | Walk::Fixed(moves) => moves.len(),
        Walk::Turns(_, actions) => actions.len(),
    });
    walks.sum()
}

/// Reads a text, combines it with a map and a scenario, and writes what comes out;
/// whether it is read.
fn try_all(text: &str) -> bool {
    let held = match read(text) {
        Ok((_, held)) => held,
        Err(faults) => {
            assert!(!faults.is_empty(), "{text}");
            for fault in &faults {
                assert_placed(fault, text);
            }
            return false;
        }
    };
    let steps = steps(&held);
    assert!(steps <= MAX_STEPS, "{text}");
    if steps > 2_000 {
        return true;
    }
    let source = |name, text| Source { name, text };
    let (own, map, scenario) = (
        source("it", text),
        source("m.map", MAP),
        source("m.scen", SCENARIO),
    );
    for sources in [vec![own], vec![own, map], vec![own, map, scenario]] {
        match combine(&sources, &Options::default()) {
            Ok(combined) => write_all(&combined),
            Err(Refused::File { file, faults }) => {
                // A line of a scenario is a place, and so is a whole scenario that does
                // not fit the plan.
                let is_scenario = matches!(held, Held::Scenario(_)) || file == "m.scen";
                for fault in faults.iter().filter(|_| !is_scenario) {
                    assert_placed(fault, text);
                }
            }
            Err(_) => {}
        }
    }
    true
}

/// Writes a scene and its plan in every format that can hold them, and reads that.
fn write_all(combined: &Combined) {
    let plan = combined.plans.first().map(|plan| &plan.plan);
    for format in Format::ALL {
        let Ok(written) = write(format, "it", Some(&combined.instance), plan) else {
            continue;
        };
        for (name, text) in &written.files {
            let found = read(text).map(|(format, _)| format);
            assert!(found.is_ok(), "{name}: {found:?}\n{text}");
        }
    }
}

#[test]
fn every_format_has_seeds_that_are_read() {
    for seed in SEEDS {
        if let Err(faults) = read(seed) {
            panic!("{faults:?}\n{seed}");
        }
    }
    let groups = groups(&[]);
    for format in Format::ALL {
        let seeds = groups.get(&format).map_or(0, Vec::len);
        assert!(seeds > 1, "{format} has {seeds} seeds");
    }
}

#[test]
fn damaged_files_are_read_without_a_panic() {
    let long = if number("GIVEWAY_LONG").is_some_and(|long| long > 0) {
        10_000_000
    } else {
        20_000
    };
    let all = number("GIVEWAY_RANDOM_TEXTS").unwrap_or(long);
    let more = [files("plans"), files("asprilo")].concat();
    let groups: Vec<Vec<&str>> = groups(&more).into_values().collect();
    let mut dice = Dice::new(number("GIVEWAY_RANDOM_SEED").unwrap_or(1));
    // Of each format: texts that were taken for it, and how many of them were read.
    let mut seen: BTreeMap<Format, (u64, u64)> = BTreeMap::new();
    for i in 1..=all {
        let text = dice.text(&groups);
        let format = recognise(&text);
        let is_read = try_all(&text);
        if let Ok(format) = format {
            let (tried, read) = seen.entry(format).or_default();
            *tried += 1;
            *read += u64::from(is_read);
        }
        if i % 100_000 == 0 {
            println!("{i} texts");
        }
    }
    println!("{seen:?}");
    for format in Format::ALL {
        let (tried, read) = seen.get(&format).copied().unwrap_or_default();
        let enough = all / 200;
        assert!(
            read >= enough && tried - read >= enough,
            "{format}: {read} of {tried} texts were read, of {all}"
        );
    }
}
