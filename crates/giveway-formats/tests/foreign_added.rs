//! Whatever is added to a file of another maker, a key, a line, a column, a fact, is refused or
//! told; it is never passed over in silence. All places of all seeds are tried.

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    clippy::string_slice,
    reason = "a test stops at the first surprise"
)]

#[path = "foreign/noise_seeds.rs"]
mod noise_seeds;

use std::collections::BTreeSet;

use giveway_formats::{Format, Options, Source, combine, read, recognise};
use noise_seeds::{MAP, SCENARIO, SEEDS};

/// All that is said of some files; `None` where they are refused.
fn said(sources: &[Source<'_>]) -> Option<BTreeSet<String>> {
    let combined = combine(sources, &Options::default()).ok()?;
    let of_plans = combined.plans.into_iter().flat_map(|plan| plan.notes);
    Some(combined.notes.into_iter().chain(of_plans).collect())
}

/// The file alone, with a map, and with a map and a scenario.
fn beside(text: &str) -> [Vec<Source<'_>>; 3] {
    let source = |name, text| Source { name, text };
    let (own, map) = (source("it", text), source("m.map", MAP));
    let scenario = source("m.scen", SCENARIO);
    [vec![own], vec![own, map], vec![own, map, scenario]]
}

/// Asserts that the text with something added is refused, or that more is said of it than of
/// the text before.
fn assert_heeded(text: &str, with: &str) -> bool {
    let mut is_tried = false;
    for (before, after) in beside(text).into_iter().zip(beside(with)) {
        let Some(before) = said(&before) else {
            continue;
        };
        is_tried = true;
        if let Some(after) = said(&after) {
            let is_told = after.difference(&before).next().is_some();
            assert!(is_told, "silent:\n{with}\n{after:?}");
        }
    }
    is_tried
}

/// A text at each place behind a mark.
fn behind(text: &str, mark: char, added: impl Fn(&str) -> String) -> Vec<String> {
    let places = text.match_indices(mark);
    let with = |(at, _): (usize, &str)| {
        let end = at + mark.len_utf8();
        let rest = &text[end..];
        format!("{}{}{rest}", &text[..end], added(rest))
    };
    places.map(with).collect()
}

/// A line at each place, indented as the line below it.
fn with_line(text: &str, line: &str) -> Vec<String> {
    let lines: Vec<&str> = text.lines().collect();
    let with = |at: usize| {
        let below = lines.get(at).copied().unwrap_or("");
        let indent = &below[..below.len() - below.trim_start_matches([' ', '-']).len()];
        let indent = " ".repeat(indent.len());
        let mut all: Vec<String> = lines.iter().map(|&line| line.to_owned()).collect();
        all.insert(at, format!("{indent}{line}"));
        all.join("\n") + "\n"
    };
    (0..=lines.len()).map(with).collect()
}

/// A column at the end of each line, one line at a time and in all lines.
fn with_column(text: &str, column: &str) -> Vec<String> {
    let lines: Vec<&str> = text.lines().collect();
    let with = |is_here: &dyn Fn(usize) -> bool| {
        let lines = lines.iter().enumerate();
        let lines = lines.map(|(at, line)| {
            let more = if is_here(at) { column } else { "" };
            format!("{line}{more}\n")
        });
        lines.collect::<String>()
    };
    let one = (0..lines.len()).map(|at| with(&|here| here == at));
    one.chain([with(&|_| true)]).collect()
}

/// A column of a table with quotes: in its first line the name, below each record a value.
fn with_table_column(text: &str) -> String {
    let mut is_quoted = false;
    let mut is_first = true;
    let mut with = String::new();
    for c in text.chars() {
        is_quoted ^= c == '"';
        if c == '\n' && !is_quoted {
            let is_return = with.ends_with('\r');
            with.truncate(with.len() - usize::from(is_return));
            with += if is_first { ",added" } else { ",7" };
            with += if is_return { "\r" } else { "" };
            is_first = false;
        }
        with.push(c);
    }
    with
}

/// The texts with something added, for the format of a seed.
fn added(format: Format, text: &str) -> Vec<String> {
    let is_json = text.starts_with(['{', '[']) && !text.contains(": {dim");
    let key = |rest: &str| {
        let is_empty = rest.trim_start().starts_with('}');
        format!("\"added\": 7{}", if is_empty { "" } else { ", " })
    };
    let plain_key = |rest: &str| {
        let is_empty = rest.trim_start().starts_with('}');
        format!("added: 7{}", if is_empty { "" } else { ", " })
    };
    match format {
        Format::MovingAi => [with_line(text, "added 7"), with_column(text, "\t7")].concat(),
        Format::Paths | Format::ClassProject => {
            [with_line(text, "added 7"), with_column(text, " 7")].concat()
        }
        Format::Grid => with_column(text, " 7"),
        Format::Result => with_line(text, "added=7"),
        Format::Asprilo => [
            "added(7).",
            "init(object(added,1),value(at,(1,1))).",
            "init(object(robot,1),value(added,7)).",
            "occurs(object(robot,1),action(added,()),9).",
            "occurs(object(added,1),action(move,(1,0)),9).",
        ]
        .iter()
        .flat_map(|fact| with_line(text, fact))
        .collect(),
        Format::Tracker if text.contains(',') && !is_json && !text.starts_with("---") => {
            vec![with_table_column(text)]
        }
        Format::Giveway | Format::Tracker | Format::League | Format::Mapfw | Format::MultiRobot
            if is_json =>
        {
            behind(text, '{', key)
        }
        Format::Tracker | Format::MultiRobot if text.contains('{') => behind(text, '{', plain_key),
        Format::Tracker | Format::MultiRobot => with_line(text, "added: 7"),
        Format::Giveway | Format::League | Format::Mapfw => Vec::new(),
    }
}

#[test]
fn nothing_that_is_added_is_unknown_keys_of() {
    let mut tried: Vec<(Format, usize)> = Format::ALL.map(|format| (format, 0)).to_vec();
    for seed in SEEDS {
        let format = recognise(seed).unwrap();
        // Of clingo's output the lines around the answer are its own account.
        if seed.starts_with("clingo version") {
            continue;
        }
        for with in added(format, seed) {
            let is_other = read(&with).is_ok_and(|(other, _)| other != format);
            // A key within the coordinates of a text, or a line within a block of text, makes
            // it another text, which is what it says.
            if is_other || is_within_text(&with) {
                continue;
            }
            if assert_heeded(seed, &with)
                && let Some((_, n)) = tried.iter_mut().find(|(one, _)| *one == format)
            {
                *n += 1;
            }
        }
    }
    let few: Vec<_> = tried.iter().filter(|(_, n)| *n == 0).collect();
    assert!(few.is_empty(), "nothing was tried for {few:?}");
}

/// Whether the line that was added is one of a text in a block of YAML.
fn is_within_text(with: &str) -> bool {
    let Some(block) = with.find("|\n") else {
        return false;
    };
    with.find("added").is_some_and(|at| at > block)
}

#[test]
fn keys_of_a_problem_of_the_league_are_told() {
    let problem =
        r#"{"mapFile": "m.map", "agentFile": "a.agents", "taskFile": "a.tasks", "teamSize": 1}"#;
    let files = |problem: &str| {
        let files = [
            ("p.json", problem),
            ("m.map", MAP),
            ("a.agents", "1\n0\n"),
            ("a.tasks", "1\n3\n"),
        ];
        said(&files.map(|(name, text)| Source { name, text })).unwrap()
    };
    let with = problem.replace('{', r#"{"added": 7, "#);
    let new: Vec<String> = files(&with).difference(&files(problem)).cloned().collect();
    assert!(new.len() == 1 && new.concat().contains("added"), "{new:?}");
}
