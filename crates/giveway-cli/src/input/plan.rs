//! A plan from its own object, or from the result of `solve` or `change`.

use std::collections::BTreeMap;
use std::path::Path;

use giveway_model::{Fault, Instance, Plan, format::native};
use serde::Deserialize;
use serde_json::value::RawValue;

use super::{Kind, Source, foreign};
use crate::{args::Common, failure::Failure};

/// Reads a plan for an instance; how one of another format was read is told on
/// standard error unless `quiet`.
///
/// # Errors
/// When the file is no plan and no result with one, or does not fit the instance.
pub(crate) fn plan(path: &Path, instance: &Instance, common: &Common) -> Result<Plan, Failure> {
    let source = Source::read(path)?;
    match Kind::of(&source) {
        Kind::Foreign => foreign::plan_for(instance, &source, common),
        _ => plan_in(&source),
    }
}

/// The text of a result cut down to its plan, with as many lines before it, so that
/// it is read as a plan is; any other text as it is.
///
/// # Errors
/// When it is a result without a plan.
pub(crate) fn bare(source: Source) -> Result<Source, Failure> {
    if Kind::of(&source) != Kind::Answer {
        return Ok(source);
    }
    match plan_text(&source.text) {
        Ok(text) => Ok(Source { text, ..source }),
        Err(fault) => Err(source.fault(fault)),
    }
}

/// The plan in a text.
///
/// # Errors
/// As [`plan`].
pub(crate) fn plan_in(source: &Source) -> Result<Plan, Failure> {
    let plan = match Kind::of(source) {
        Kind::Answer => read_answer(&source.text),
        Kind::Scenario => Err(Fault::at("", "a scenario", "a plan")),
        Kind::Map => Err(Fault::at("", "a map", "a plan")),
        Kind::Foreign | Kind::Plan | Kind::Scene => native::read_plan(&source.text),
    };
    plan.map_err(|fault| source.fault(fault))
}

fn read_answer(text: &str) -> Result<Plan, Fault> {
    native::read_plan(&plan_text(text)?)
}

/// The plan within a result: of `solve` its own, of `change` the adopted one.
fn plan_text(text: &str) -> Result<String, Fault> {
    #[derive(Deserialize)]
    struct Answer<'a> {
        #[serde(borrow, default)]
        plan: Option<&'a RawValue>,
        #[serde(borrow, default)]
        methods: BTreeMap<String, One<'a>>,
        #[serde(default)]
        adopted: Option<String>,
    }
    #[derive(Deserialize)]
    struct One<'a> {
        #[serde(borrow, default)]
        plan: Option<&'a RawValue>,
    }
    let plan = serde_json::from_str::<Answer>(text)
        .ok()
        .and_then(|answer| {
            let adopted = answer
                .adopted
                .and_then(|name| answer.methods.get(&name)?.plan);
            answer.plan.or(adopted)
        })
        .filter(|plan| plan.get() != "null")
        .ok_or_else(|| Fault::at("plan", "a result without a plan", "a plan"))?;
    Ok(in_its_place(text, plan.get()))
}

/// The part of a text, with as many lines and columns before it as in the
/// whole, so that faults name the place in the file.
fn in_its_place(whole: &str, part: &str) -> String {
    let before = (part.as_ptr() as usize).saturating_sub(whole.as_ptr() as usize);
    let blanks = whole
        .get(..before)
        .unwrap_or_default()
        .chars()
        .map(|c| if c == '\n' { '\n' } else { ' ' });
    blanks.chain(part.chars()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_plan_keeps_its_place_in_the_result() {
        let whole = "{\n  \"plan\": [1]}";
        let part = whole.get(12..15).unwrap();
        assert_eq!(part, "[1]");
        assert_eq!(in_its_place(whole, part), " \n          [1]");
    }

    #[test]
    fn a_result_without_a_plan_is_no_plan() {
        let fault = read_answer(r#"{ "status": "impossible", "plan": null }"#).unwrap_err();
        assert_eq!(
            fault.to_string(),
            "plan: found a result without a plan, expected a plan"
        );
    }
}
