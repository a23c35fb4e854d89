//! Refuses a text of no known format, and says what it probably is.

use serde::de::IgnoredAny;

use giveway_model::format::locate::Fields;
use giveway_model::format::text::shorten;
use giveway_model::words::Later;
use giveway_model::{Fault, tr, tr_later};

/// How texts of other kinds begin.
const BEGINNINGS: &[(&str, Later)] = &[
    ("<!doctype", tr_later!("a web page (HTML)")),
    ("<html", tr_later!("a web page (HTML)")),
    ("<svg", tr_later!("a picture (SVG)")),
    ("<?xml", tr_later!("a file in XML")),
    ("<", tr_later!("a file in XML or HTML")),
    ("https:", tr_later!("a link that is none of this page")),
    ("http:", tr_later!("a link that is none of this page")),
    ("p cnf", tr_later!("a formula in DIMACS")),
    ("c ", tr_later!("a formula in DIMACS")),
    (
        "p2",
        tr_later!("a picture (PGM), such as the map of a ROS robot"),
    ),
    ("p1", tr_later!("a picture (PBM)")),
    ("#!/", tr_later!("a program")),
    ("#include", tr_later!("a program")),
    ("import ", tr_later!("a program")),
    ("from ", tr_later!("a program")),
    ("def ", tr_later!("a program")),
    ("{\\rtf", tr_later!("a document (RTF)")),
    ("-----begin", tr_later!("a key or a certificate")),
];

/// JSON of other kinds, by keys that it has.
const KEYS: &[(&[&str], Later)] = &[
    (&["type", "features"], tr_later!("a map in GeoJSON")),
    (&["type", "coordinates"], tr_later!("a map in GeoJSON")),
    (
        &["tilewidth", "layers"],
        tr_later!("a map of the editor Tiled"),
    ),
    (&["nbformat", "cells"], tr_later!("a notebook (Jupyter)")),
    (
        &["dependencies"],
        tr_later!("a description of a package (package.json)"),
    ),
    (
        &["name", "version", "scripts"],
        tr_later!("a description of a package (package.json)"),
    ),
    (
        &["Solver", "Call"],
        tr_later!("clingo's output in JSON: print it without --outf=2"),
    ),
    (&["$schema", "$defs"], tr_later!("a JSON Schema")),
];

/// The refusal of a text that no reader takes: what it probably is, and what is read instead.
pub(super) fn refusal(text: &str) -> Fault {
    let start = text.trim_start();
    if start.is_empty() {
        return Fault::at("", tr!("an empty file"), expected()).in_text(1, 1);
    }
    let small: String = start
        .chars()
        .take(20)
        .collect::<String>()
        .to_ascii_lowercase();
    let known = BEGINNINGS
        .iter()
        .find(|(begin, _)| small.starts_with(begin));
    let first = start.lines().next().unwrap_or("");
    let found = match known {
        Some((_, kind)) => kind.text().to_owned(),
        None if is_ros(text) => {
            let found = tr!(
                "the description of a ROS map: its picture becomes a map with . for free pixels and @ for others, a row a line"
            );
            found.to_owned()
        }
        None if is_table(text) => {
            let columns = shorten(first);
            tr!("a table (CSV) with the columns \"{columns}\"", columns)
        }
        None if is_log(text) => tr!("a log, \"{line}\"", line = shorten(first)),
        None => format!("\"{}\"", shorten(start)),
    };
    Fault::at("", found, expected()).in_text(1, 1)
}

fn expected() -> String {
    tr!("a map, a scenario, an instance or a plan of a known format").to_owned()
}

/// The refusal of JSON of another kind; `None` where it is JSON of no kind that is
/// known here, or no JSON at all.
pub(super) fn other_json(text: &str) -> Option<Fault> {
    if text.contains("\"giveway\"") {
        return None;
    }
    if text.trim_start().starts_with('[') {
        serde_json::from_str::<Vec<IgnoredAny>>(text).ok()?;
        return Some(Fault::at("", tr!("a list in JSON"), expected()).in_text(1, 1));
    }
    let keys: Fields<'_> = serde_json::from_str(text).ok()?;
    if [
        "map", "agents", "paths", "changes", "plan", "methods", "front",
    ]
    .iter()
    .any(|own| keys.has(own))
    {
        return None;
    }
    let has = |all: &[&str]| all.iter().all(|key| keys.has(key));
    let known = KEYS.iter().find(|(all, _)| has(all));
    let found = match known {
        Some((_, kind)) => kind.text().to_owned(),
        None if keys.names().next().is_none() => tr!("an empty object in JSON").to_owned(),
        None => {
            let names = keys.names().take(4).collect::<Vec<_>>().join(", ");
            tr!(
                "JSON of another kind, with the keys {names}",
                names = shorten(&names)
            )
        }
    };
    Some(Fault::at("", found, expected()).in_text(1, 1))
}

/// The description that lies beside the picture of a map of ROS.
fn is_ros(text: &str) -> bool {
    let has = |key: &str| text.lines().any(|line| line.starts_with(key));
    has("image:") && has("resolution:")
}

/// Whether the first lines have equally many columns, at least two, and the first
/// line has no numbers.
fn is_table(text: &str) -> bool {
    let columns = |line: &str, comma: char| line.split(comma).count();
    let mut lines = text.lines();
    let Some(first) = lines.next() else {
        return false;
    };
    let comma = [',', ';', '\t']
        .into_iter()
        .find(|comma| first.contains(*comma));
    let Some(comma) = comma else { return false };
    let rows: Vec<&str> = lines
        .filter(|line| !line.trim().is_empty())
        .take(3)
        .collect();
    !rows.is_empty()
        && rows
            .iter()
            .all(|row| columns(row, comma) == columns(first, comma))
}

/// Whether the first line begins with a time or a level.
fn is_log(text: &str) -> bool {
    let first = text.lines().next().unwrap_or("");
    let head: String = first.chars().take(40).collect();
    let has_time = head.bytes().filter(|byte| *byte == b':').count() >= 2
        && head.bytes().filter(u8::is_ascii_digit).count() >= 6;
    has_time
        || ["[INFO", "INFO", "DEBUG", "WARN", "ERROR"]
            .iter()
            .any(|level| head.starts_with(level))
}
