//! Whether another plan is what a question contrasts the plan with.

use super::Question;
use crate::{Instance, Plan};

/// Whether the counterfactual of a question about `plan` holds in `other`.
///
/// Both plans are taken to be valid. Times are those of `other`, with its own
/// arrivals. `None` where the question has no counterfactual (`unsolvable`,
/// `plan`), or an agent that it names has no path.
///
/// ```
/// use giveway_model::{Cell, Question, format::native, question::holds};
/// let instance = native::read_instance(r#"{ "giveway": 1, "map": ["..."],
///     "agents": [{ "name": "A1", "start": [0, 0], "goal": [2, 0] }] }"#).unwrap();
/// let slow = native::read_plan(
///     r#"{ "giveway": 1, "paths": { "A1": [[0, 0], [1, 0], [1, 0], [2, 0]] } }"#).unwrap();
/// let fast = native::read_plan(
///     r#"{ "giveway": 1, "paths": { "A1": [[0, 0], [1, 0], [2, 0]] } }"#).unwrap();
/// let why = Question::Wait {
///     agent: "A1".into(), at: Some(Cell::new(1, 0)), from: None, to: None, at_least: None,
/// };
/// assert_eq!(holds(&why, &instance, &slow, &fast), Some(true));
/// assert_eq!(holds(&why, &instance, &slow, &slow), Some(false));
/// ```
pub fn holds(question: &Question, instance: &Instance, plan: &Plan, other: &Plan) -> Option<bool> {
    question.contrast(instance, plan)?.holds(instance, other)
}
