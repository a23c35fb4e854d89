//! A plan from its own object, or from the result of `solve` or `change`.

use std::path::Path;

use giveway_formats::{Held, read};
use giveway_model::format::{native, own};
use giveway_model::{Fault, Instance, Plan};

use super::{Kind, Source, foreign};
use crate::{
    args::Common,
    failure::Failure,
    output::{Said, stream},
};

/// Reads a plan for an instance; its notes are added to what is said.
///
/// # Errors
/// When the file is no plan and no result with one, or does not fit the instance.
pub(crate) fn plan(
    path: &Path,
    instance: &Instance,
    common: &Common,
    said: &mut Said,
) -> Result<Plan, Failure> {
    let (plan, notes) = noted(path, instance, common, said)?;
    said.add(notes);
    Ok(plan)
}

/// The same for a plan that comes with its changes: the result of `change` need not say
/// that they are in another file.
///
/// # Errors
/// As [`plan`].
pub(crate) fn plan_over_time(
    path: &Path,
    instance: &Instance,
    common: &Common,
    said: &mut Said,
) -> Result<Plan, Failure> {
    noted(path, instance, common, said).map(|(plan, _)| plan)
}

fn noted(
    path: &Path,
    instance: &Instance,
    common: &Common,
    said: &mut Said,
) -> Result<(Plan, Vec<String>), Failure> {
    let source = Source::read(path)?;
    match Kind::of(&source) {
        Kind::Foreign => {
            let plan = foreign::plan_for(instance, &source, common, said)?;
            Ok((plan, Vec::new()))
        }
        _ => plan_and_notes(&source),
    }
}

/// The plan in a text of the project's own; its notes are told on standard error unless
/// `quiet`.
///
/// # Errors
/// As [`plan`].
pub(crate) fn plan_in(source: &Source, common: &Common) -> Result<Plan, Failure> {
    let (plan, notes) = plan_and_notes(source)?;
    for note in notes.iter().filter(|_| !common.quiet) {
        stream::note(&format!("note: {note}"));
    }
    Ok(plan)
}

fn plan_and_notes(source: &Source) -> Result<(Plan, Vec<String>), Failure> {
    let plan = match Kind::of(source) {
        Kind::Scenario => Err(vec![Fault::at("", "a scenario", "a plan")]),
        Kind::Map => Err(vec![Fault::at("", "a map", "a plan")]),
        Kind::Foreign | Kind::Native => match read(&source.text) {
            Ok((_, Held::OwnPlan(plan, notes))) => {
                return Ok((plan, notes.into_iter().chain(source.note.clone()).collect()));
            }
            Ok((_, Held::NoPlan(sentence))) => {
                let found = sentence.trim_end_matches('.').replacen("It is ", "", 1);
                Err(vec![Fault::at("", found, "a plan").in_text(1, 1)])
            }
            Ok((_, Held::Asked(_))) => {
                let found = "the answer to a question, which has no plan";
                let expected = "a plan, such as the one that was asked about";
                Err(vec![Fault::at("", found, expected).in_text(1, 1)])
            }
            // What is no plan is named by the reader of one.
            Ok(_) => native::read_plan(&source.text).map_err(|fault| vec![fault]),
            Err(faults) => Err(faults),
        },
    };
    let plan = plan.map_err(|faults| source.faults(faults))?;
    Ok((plan, Vec::new()))
}

/// Whether a text of the project's own holds a plan, by itself or in a result, or would
/// hold one if it were not wrong.
pub(crate) fn is_plan(source: &Source) -> bool {
    own::has_plan(&source.text)
}
