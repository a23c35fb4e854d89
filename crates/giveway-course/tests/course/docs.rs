//! What the documentation of the format says is so.

use giveway_course::lesson::{Tool, read_lesson, write_lesson};

use super::shipped;

const DOCS: &str = include_str!("../../../../docs/lessons.md");

#[test]
fn the_example_of_the_documentation_is_a_lesson() {
    let example = DOCS.split("```json\n").nth(1).unwrap();
    let example = example.split("```").next().unwrap();
    let lesson = read_lesson(example, &shipped::glossary()).unwrap();
    let again = read_lesson(&write_lesson(&lesson), &shipped::glossary());
    assert_eq!(again, Ok(lesson));
}

#[test]
fn every_word_of_the_schema_is_documented() {
    let schema: serde_json::Value =
        serde_json::from_str(giveway_course::lesson::Lesson::schema()).unwrap();
    for definition in ["task", "condition", "quantity"] {
        let kinds = schema["$defs"][definition]["oneOf"].as_array().unwrap();
        for kind in kinds {
            let key = if definition == "task" { "kind" } else { "is" };
            let word = kind["properties"][key]["const"].as_str().unwrap();
            let shown = [format!("`{word}`"), format!("\"is\": \"{word}\"")];
            assert!(shown.iter().any(|shown| DOCS.contains(shown)), "{word}");
        }
    }
    let step = schema["$defs"]["step"]["properties"].as_object().unwrap();
    for key in step.keys() {
        assert!(DOCS.contains(&format!("`{key}`")), "{key}");
    }
    for tool in Tool::ALL {
        let word = serde_json::to_string(&tool).unwrap();
        let word = word.trim_matches('"');
        assert!(DOCS.contains(&format!("`{word}`")), "{word}");
    }
}
