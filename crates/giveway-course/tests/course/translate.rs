//! A lesson in other words: what is found is taken, what does not fit stays.

use giveway_course::learner::{Action, Learner, reduce};
use giveway_course::lesson::{Lesson, Text, keys, translated};
use std::rc::Rc;

use super::reading::texts;
use super::shipped;

#[test]
fn every_text_of_a_lesson_has_a_key() {
    for (name, lesson) in shipped::lessons() {
        let keys = keys(&lesson);
        for text in lesson.steps.iter().flat_map(texts) {
            assert!(keys.contains(&text.to_string()), "{name}: {text}");
        }
        assert_eq!(keys[0], lesson.title);
        assert_eq!(translated(&lesson, |_| None), lesson);
    }
}

#[test]
fn a_term_is_another_word_than_a_button() {
    let glossary = translated(&shipped::glossary(), |key| match key {
        "a term\u{4}Makespan" => Some("Spanne"),
        "other words for a term\u{4}makespans" => Some("Spannen, Gesamtdauer"),
        "Makespan" => Some("another meaning"),
        _ => None,
    });
    let term = glossary.get(&"makespan".parse().unwrap()).unwrap();
    assert_eq!(term.name, "Spanne");
    assert_eq!(term.also, ["Spannen", "Gesamtdauer"]);
}

#[test]
fn a_text_that_names_something_else_stays_in_english() {
    let english: Text = "[A1](robot:A1) and [A2](robot:A2) meet.".parse().unwrap();
    let other = |text: &'static str| translated(&english, |_| Some(text));
    let turned = "[A2](robot:A2) trifft [A1](robot:A1).";
    assert_eq!(other(turned).to_string(), turned);
    for wrong in [
        "[A1](robot:A1) trifft [A1](robot:A1).",
        "[A1](robot:A1) trifft A2.",
        "[A1](robot:A1), [A2](robot:A2), [A3](robot:A3)",
        "[A1](robot:A1) [A2",
    ] {
        assert_eq!(other(wrong), english, "{wrong}");
    }
}

#[test]
fn an_open_lesson_goes_on_in_other_words() {
    let id = "room-to-pass".parse().unwrap();
    let lesson = Rc::new(shipped::lesson("room-to-pass"));
    let open = Action::Open {
        id,
        lesson: Rc::clone(&lesson),
        at: Some(3),
    };
    let (learner, _) = reduce(Learner::default(), open);
    let (learner, _) = reduce(learner, Action::Hint);
    let reword = |name: &str| Action::Reword {
        id: name.parse().unwrap(),
        lesson: Rc::new(Lesson {
            title: "Platz".into(),
            ..(*lesson).clone()
        }),
    };
    let (other, effects) = reduce(learner.clone(), reword("batteries"));
    assert_eq!((other, effects), (learner.clone(), Vec::new()));
    let (worded, effects) = reduce(learner.clone(), reword("room-to-pass"));
    let (was, is) = (learner.open.unwrap(), worded.open.unwrap());
    assert_eq!(is.lesson.title, "Platz");
    assert_eq!((is.index(), is.hints()), (3, was.hints()));
    assert_eq!((is.scene(), is.judge()), (was.scene(), was.judge()));
    assert!(effects.is_empty());
}
