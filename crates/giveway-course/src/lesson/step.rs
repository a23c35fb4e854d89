//! A step of a lesson: a text, a board, and at most one task.

use giveway_model::change::{Changes, What};
use giveway_model::{Agent, Cell, Plan, Scene, object_only};
use serde::{Deserialize, Serialize};

use super::{Layer, Quantity, Task, Text, Tool, id};

/// A step.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(
    remote = "Self",
    default,
    deny_unknown_fields,
    rename_all = "kebab-case"
)]
pub struct Step {
    /// What it is called.
    pub title: String,
    /// A few short paragraphs.
    pub text: Vec<Text>,
    /// The scene; where it is left out, the board stays as it is.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub scene: Option<Scene>,
    /// The plan, legal or not.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub plan: Option<Plan>,
    /// Instead of a plan: the solver finds and proves the best one, and the page
    /// shows it.
    #[serde(skip_serializing_if = "is_false")]
    pub solved: bool,
    /// The time shown first.
    #[serde(skip_serializing_if = "is_zero")]
    pub time: u32,
    /// Whether the plan plays at once.
    #[serde(skip_serializing_if = "is_false")]
    pub playing: bool,
    /// The tools that are live.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub tools: Vec<Tool>,
    /// The most edits; not limited where it is left out.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub edits: Option<u32>,
    /// The cells that may be changed; all where it is left out.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cells: Option<Vec<Cell>>,
    /// What is shown beside the map; nothing where it is left out.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub show: Vec<Layer>,
    /// What there is to do.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub task: Option<Task>,
    /// Hints, one after the other; the last is the answer.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub hints: Vec<Text>,
    /// What is said once the task is solved: why it is so.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub reason: Option<Text>,
}

object_only!(Step);

impl Step {
    /// The hash of all that the step says and shows.
    pub(crate) fn hash(&self) -> u64 {
        // Texts, numbers and lists of them always have a JSON form.
        id::hash(&serde_json::to_string(self).unwrap_or_default())
    }

    /// What changes while the plan of the step runs: its task is about that.
    pub fn changes(&self) -> Option<&Changes> {
        match self.task.as_ref()? {
            Task::Change(task) => Some(&task.changes),
            Task::Predict(task) => match &task.what {
                Quantity::Changed { changes, .. } => Some(changes),
                _ => None,
            },
            _ => None,
        }
    }

    /// The robots that join then, in their order.
    pub fn joining(&self) -> impl Iterator<Item = &Agent> {
        let changes = self.changes().into_iter();
        let changes = changes.flat_map(|changes| &changes.changes);
        changes.filter_map(|change| match &change.what {
            What::AddAgent { agent } => Some(agent),
            _ => None,
        })
    }
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "as serde calls it")]
const fn is_false(value: &bool) -> bool {
    !*value
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "as serde calls it")]
const fn is_zero(value: &u32) -> bool {
    *value == 0
}
