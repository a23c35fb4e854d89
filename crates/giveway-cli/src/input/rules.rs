//! Rules that are given on the command line, in words or as JSON.

use std::path::Path;

use giveway_model::{Constraint, Instance};

use super::Source;
use crate::failure::Failure;

/// The instance with one more rule, and a note that says so.
///
/// # Errors
/// Where the text is no rule, or does not fit the instance.
pub(super) fn with_rule(instance: &Instance, text: &str) -> Result<(Instance, String), Failure> {
    let usage = |sentence: String| Failure::Usage(format!("--constraint: {sentence}"));
    let rule = read(text).map_err(usage)?;
    let note = format!("Rule: {} (--constraint).", rule.sentence());
    let mut scene = instance.to_scene();
    let place = format!("constraints[{}]", scene.constraints.len());
    scene.constraints.push(rule);
    let with = Instance::new(scene).map_err(|faults| {
        let mut sentences = faults.into_iter().map(|mut fault| {
            fault.place = fault.place.replacen(&place, "", 1);
            fault.place = fault.place.trim_start_matches('.').to_owned();
            fault.to_string()
        });
        let first = sentences.next().unwrap_or_default();
        usage(first.trim_end_matches('.').to_owned())
    })?;
    Ok((with, note))
}

/// A rule in words, or as a JSON object; an error is a sentence without its full stop.
fn read(text: &str) -> Result<Constraint, String> {
    if text.trim_start().starts_with('{') {
        let read: Result<Constraint, _> = serde_json::from_str(text);
        return read.map_err(|error| error.to_string());
    }
    Constraint::from_words(text)
        .map_err(|fault| format!("found {}, expected {}", fault.found, fault.expected))
}

/// A rule in a file of its own, in words or as a JSON object.
///
/// # Errors
/// Where the file cannot be read, or is no rule.
pub(crate) fn rule_of_file(path: &Path) -> Result<Constraint, Failure> {
    let source = Source::read(path)?;
    read(&source.text).map_err(|sentence| Failure::Usage(format!("{}: {sentence}", source.name)))
}
