//! What tests of several formats need.

use std::path::PathBuf;

use giveway_formats::{
    Combined, ForeignPlan, Format, Missing, Options, Refused, Source, Written, combine,
};
use giveway_model::check::{Rule, check};
use giveway_model::{Fault, Instance};

/// The text of a file of the tests' data.
pub(crate) fn data(path: &str) -> String {
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR"))
        .join("tests/data")
        .join(path);
    std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// Gathers files given as name and text.
pub(crate) fn opened(files: &[(&str, &str)]) -> Result<Combined, Refused> {
    let sources: Vec<Source<'_>> = files
        .iter()
        .map(|&(name, text)| Source { name, text })
        .collect();
    combine(&sources, &Options::default())
}

/// The same for files that were written.
pub(crate) fn reopened(written: &Written) -> Combined {
    let files: Vec<(&str, &str)> = written
        .files
        .iter()
        .map(|(name, text)| (&**name, &**text))
        .collect();
    opened(&files).unwrap_or_else(|error| panic!("{error:?}\n{files:?}"))
}

/// The fault of a text that is refused.
pub(crate) fn refused(text: &str) -> Fault {
    match giveway_formats::read(text) {
        Ok(held) => panic!("{held:?}"),
        Err(faults) => faults[0].clone(),
    }
}

/// The rule, time and agents of every violation.
pub(crate) fn violations(
    instance: &Instance,
    plan: &ForeignPlan,
) -> Vec<(Rule, usize, Vec<String>)> {
    let report = check(instance, &plan.plan);
    report
        .violations
        .into_iter()
        .map(|found| (found.rule, found.time as usize, found.agents))
        .collect()
}

/// Writes, reads and compares the scene (names aside where they are lost) and the plans.
pub(crate) fn comes_back(format: Format, combined: &Combined) -> Written {
    let plan = combined.plans.first().map(|plan| &plan.plan);
    let written = giveway_formats::write(format, "it", Some(&combined.instance), plan)
        .unwrap_or_else(|error| panic!("{error}"));
    let again = reopened(&written);
    assert_eq!(again.instance.grid(), combined.instance.grid());
    assert_eq!(again.instance.agents(), combined.instance.agents());
    let plans = |combined: &Combined| -> Vec<_> {
        combined
            .plans
            .iter()
            .map(|plan| plan.plan.clone())
            .collect()
    };
    assert_eq!(plans(&again), plans(combined));
    written
}

/// What is missing beside a file, and the sentence that asks for it.
pub(crate) fn lacking(name: &str, text: &str) -> (Missing, String) {
    match opened(&[(name, text)]) {
        Err(Refused::Missing { what, sentence, .. }) => (what, sentence),
        other => panic!("{other:?}"),
    }
}
