//! Tells the project's own JSON files apart: an instance, a plan, changes, or the result of a command with
//! the plan within it.

use std::collections::BTreeMap;

use serde::Deserialize;
use serde_json::value::RawValue;

use super::locate::Fields;
use super::native;
use super::text::without_mark;
use crate::change::Changes;
use crate::{Fault, Instance, Plan, Question, tr, tr_later};

/// The content of a text.
#[derive(Clone, Debug, PartialEq)]
pub enum Own {
    /// An instance, checked.
    Scene(Box<Instance>),
    /// A plan, by itself or in a result, with what a person should know of it.
    Plan(Plan, Vec<String>),
    /// The changes while a plan runs.
    Changes(Changes),
    /// A result that has no plan: what it says, a sentence.
    NoPlan(String),
    /// The answer to a question: the question, and the plan in the answer, if there is one.
    Asked(Box<Question>, Option<Plan>),
}

/// The objects of the format that are read, by the keys that only they have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Shape {
    Scene,
    Plan,
    Changes,
    Asked,
    /// A result with a plan in it.
    Result,
    /// A result without one.
    Other(&'static str),
}

impl Shape {
    fn of(text: &str) -> Self {
        let Ok(fields) = serde_json::from_str::<Fields<'_>>(text) else {
            return Self::Scene;
        };
        let has = |key| fields.has(key);
        if has("map") {
            Self::Scene
        } else if has("question") && has("verdict") {
            Self::Asked
        } else if has("paths") {
            Self::Plan
        } else if has("legal") {
            Self::Other(tr!("the result of an audit"))
        } else if has("valid") {
            Self::Other(tr!("the result of a check"))
        } else if has("deltas") {
            Self::Other(tr!("a comparison of two plans"))
        } else if has("title") && has("steps") {
            Self::Other(tr!("a lesson"))
        } else if has("events") && has("left_out") {
            Self::Other(tr!("the record of a search"))
        } else if has("regions") && has("passes") {
            Self::Other(tr!("an account of who meets whom"))
        } else if ["status", "methods", "planner", "front"]
            .into_iter()
            .any(has)
        {
            Self::Result
        } else if has("changes") {
            Self::Changes
        } else {
            Self::Scene
        }
    }
}

/// Reads a text, whatever of these it holds.
///
/// # Errors
/// As the readers of [`native`]; also when a result has no plan. Each fault has a line
/// and a column.
///
/// ```
/// use giveway_model::format::own::{Own, read};
/// let result = r#"{ "giveway": 1, "status": "optimal", "plan": { "giveway": 1, "paths": {} } }"#;
/// assert!(matches!(read(result), Ok(Own::Plan(..))));
/// ```
pub fn read(text: &str) -> Result<Own, Vec<Fault>> {
    let text = without_mark(text);
    let one = |fault: Fault| vec![fault];
    match Shape::of(text) {
        Shape::Scene => native::read_instance(text).map(|instance| Own::Scene(Box::new(instance))),
        Shape::Plan => native::read_plan(text)
            .map(|plan| Own::Plan(plan, Vec::new()))
            .map_err(one),
        Shape::Changes => native::read_changes(text).map(Own::Changes).map_err(one),
        Shape::Asked => asked(text).map_err(one),
        Shape::Result => of_result(text).map_err(one),
        Shape::Other(found) => Err(vec![
            Fault::at(
                "",
                found,
                tr_later!("an instance, a plan, changes, or a result with a plan"),
            )
            .in_text(1, 1),
        ]),
    }
}

/// Whether a text holds a plan, by itself or in a result, by a look at its keys.
pub fn has_plan(text: &str) -> bool {
    matches!(
        Shape::of(without_mark(text)),
        Shape::Plan | Shape::Result | Shape::Asked
    )
}

/// The parts of results that are looked at.
#[derive(Deserialize)]
struct Parts<'a> {
    #[serde(borrow, default)]
    plan: Option<&'a RawValue>,
    #[serde(borrow, default)]
    alternative: Option<&'a RawValue>,
    #[serde(borrow, default)]
    question: Option<&'a RawValue>,
    #[serde(borrow, default)]
    status: Option<&'a str>,
    #[serde(borrow, default)]
    methods: BTreeMap<String, Point<'a>>,
    #[serde(default)]
    adopted: Option<String>,
    #[serde(borrow, default)]
    front: Vec<Point<'a>>,
}

#[derive(Deserialize)]
struct Point<'a> {
    #[serde(borrow, default)]
    plan: Option<&'a RawValue>,
}

/// The plan within a result: of a solve its own, of `change` the adopted one, of a front
/// the first.
fn of_result(text: &str) -> Result<Own, Fault> {
    let result: Parts<'_> = super::json::read(text)?;
    let mut notes = Vec::new();
    let adopted = result.adopted.as_ref();
    let (plan, place) = if result.plan.is_some() {
        (result.plan, "plan".to_owned())
    } else if let Some(method) = adopted {
        notes.push(tr!("The plan is the one that was adopted after the change, found by {method}. What changed stands in the file of the changes.", method));
        let method = result.methods.get(method);
        (method.and_then(|method| method.plan), "adopted".to_owned())
    } else {
        let n = result.front.len();
        if n > 1 {
            notes.push(tr!("The plan is the first of {n} on the front.", n));
        }
        (
            result.front.iter().find_map(|point| point.plan),
            "plan".to_owned(),
        )
    };
    let Some(plan) = plan else {
        return match result.status {
            Some("impossible") => Ok(Own::NoPlan(
                tr!("It is a result that says that there is no plan (impossible).").to_owned(),
            )),
            Some("unknown") => Ok(Own::NoPlan(
                tr!("It is a result without a plan: none was found (unknown).").to_owned(),
            )),
            Some(_) | None => Err(without_plan(&place)),
        };
    };
    native::read_plan(&in_its_place(text, plan.get())).map(|plan| Own::Plan(plan, notes))
}

fn asked(text: &str) -> Result<Own, Fault> {
    let result: Parts<'_> = super::json::read(text)?;
    let question = result.question.ok_or_else(|| without_plan("question"))?;
    let question = super::json::read(&in_its_place(text, question.get()))?;
    let plan = result.plan.or(result.alternative);
    let plan = plan.map(|plan| native::read_plan(&in_its_place(text, plan.get())));
    Ok(Own::Asked(Box::new(question), plan.transpose()?))
}

fn without_plan(place: &str) -> Fault {
    Fault::at(
        place,
        tr_later!("a result without a plan"),
        tr_later!("a plan"),
    )
    .in_text(1, 1)
}

/// The part of a text, with as many lines and columns before it as in the whole, so that
/// faults name the place in the file.
fn in_its_place(whole: &str, part: &str) -> String {
    let before = part.as_ptr().addr().saturating_sub(whole.as_ptr().addr());
    let before = whole.get(..before).unwrap_or_default();
    let blanks = before.chars().map(|c| if c == '\n' { '\n' } else { ' ' });
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
        let told = read(r#"{ "status": "impossible", "plan": null }"#).unwrap();
        assert!(matches!(told, Own::NoPlan(sentence) if sentence.contains("no plan")));
        let faults = read(r#"{ "status": "optimal", "plan": null }"#).unwrap_err();
        assert!(
            faults[0]
                .to_string()
                .ends_with("plan: found a result without a plan, expected a plan")
        );
    }
}
