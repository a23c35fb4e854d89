//! From a lesson back to a draft.

use giveway_model::Question;
use giveway_model::question::to_words;
use serde_json::Value;

use super::{ANSWERS, Draft, PLAN, StepDraft, Words, YES};
use crate::lesson::{Lesson, Step};

impl Draft {
    /// The draft of a lesson.
    pub fn of(lesson: &Lesson) -> Self {
        let mut draft = Self::default();
        let Lesson {
            title,
            minutes,
            about,
            hides_answers,
            ..
        } = lesson;
        let mut word = |name: &str, word: String| draft.words.insert(name.to_owned(), word);
        word("title", title.clone());
        word("minutes", minutes.to_string());
        word("about", about.to_string());
        if *hides_answers {
            word("hides-answers", YES.to_owned());
        }
        draft.steps = lesson.steps.iter().map(step).collect();
        draft.mend();
        draft
    }
}

fn step(step: &Step) -> StepDraft {
    let mut draft = StepDraft {
        scene: step.scene.clone(),
        plan: step.plan.clone(),
        ..StepDraft::default()
    };
    let plan = match (&step.plan, step.solved) {
        (Some(_), _) => "given",
        (None, true) => "best",
        (None, false) => "none",
    };
    draft.words.insert(PLAN.to_owned(), plan.to_owned());
    let bare = Step {
        scene: None,
        plan: None,
        solved: false,
        ..step.clone()
    };
    // Texts, numbers and lists of them always have a JSON form.
    let whole = serde_json::to_value(&bare).unwrap_or_default();
    flat("", &whole, &mut draft.words);
    draft
}

/// Writes what is at a place into the fields that are there.
fn flat(place: &str, value: &Value, words: &mut Words) {
    let key = place.rsplit(['.', ']']).next().unwrap_or_default();
    let text = match (key, value) {
        ("question", question) => {
            let question = serde_json::from_value::<Question>(question.clone());
            question.map_or_else(|_| String::new(), |question| to_words(&question))
        }
        ("changes", changes) => serde_json::to_string(changes).unwrap_or_default(),
        ("text", Value::Array(paragraphs)) => joined(paragraphs, "\n\n"),
        ("cells", Value::Array(cells)) => {
            let cells: Vec<String> = cells.iter().map(cell).collect();
            cells.join(" ")
        }
        ("value" | "cell", Value::Array(_)) => cell(value),
        (_, Value::Object(object)) => {
            for (key, value) in object {
                let place = match place {
                    "" => key.clone(),
                    place => format!("{place}.{key}"),
                };
                flat(&place, value, words);
            }
            return;
        }
        (_, Value::Array(list)) => {
            let is_pair = place.ends_with("costs") && !place.contains("what");
            if place == ANSWERS || place == "hints" || is_pair {
                for (index, value) in list.iter().enumerate() {
                    flat(&format!("{place}[{index}]"), value, words);
                }
            }
            if place == ANSWERS {
                list.len().to_string()
            } else {
                joined(list, "\n")
            }
        }
        (_, Value::Bool(true)) => YES.to_owned(),
        (_, Value::Number(number)) => number.to_string(),
        (_, Value::String(text)) => text.clone(),
        (_, Value::Bool(false) | Value::Null) => return,
    };
    words.insert(place.to_owned(), text);
}

fn joined(list: &[Value], by: &str) -> String {
    let texts: Vec<&str> = list.iter().filter_map(Value::as_str).collect();
    texts.join(by)
}

fn cell(cell: &Value) -> String {
    let numbers = cell.as_array().into_iter().flatten();
    let numbers: Vec<String> = numbers.map(Value::to_string).collect();
    numbers.join(",")
}
