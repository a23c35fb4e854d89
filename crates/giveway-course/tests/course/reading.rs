//! Lessons are easy to read: short sentences, in every text of theirs.

use giveway_course::lesson::{Lesson, Step, Task, Text};

use super::shipped;

/// The most words of a sentence, on the mean of a lesson.
const MEAN: f64 = 14.0;
/// The most words of any sentence.
const LONGEST: usize = 26;

/// All texts of a step.
pub(crate) fn texts(step: &Step) -> Vec<&Text> {
    let mut texts: Vec<&Text> = step.text.iter().collect();
    if let Some(task) = &step.task {
        texts.push(task.say());
        match task {
            Task::Predict(task) => {
                texts.extend(
                    task.answers
                        .iter()
                        .flat_map(|guess| [&guess.text, &guess.reply]),
                );
            }
            Task::Choose(task) => {
                texts.extend(
                    task.answers
                        .iter()
                        .flat_map(|choice| [&choice.text, &choice.reply]),
                );
            }
            _ => {}
        }
    }
    texts.extend(&step.hints);
    texts.extend(&step.reason);
    texts
}

fn sentences(lesson: &Lesson) -> Vec<String> {
    let texts = lesson.steps.iter().flat_map(texts).chain([&lesson.about]);
    let mut sentences = Vec::new();
    for text in texts {
        let plain = text.plain();
        let parts = plain.split_inclusive(['.', '?', '!', ':']);
        let parts = parts
            .map(str::trim)
            .filter(|part| part.contains(char::is_alphabetic));
        sentences.extend(parts.map(str::to_owned));
    }
    sentences
}

fn words(sentence: &str) -> usize {
    sentence.split_whitespace().count()
}

#[test]
fn sentences_are_short() {
    for (name, lesson) in shipped::lessons() {
        let sentences = sentences(&lesson);
        let total: usize = sentences.iter().map(|sentence| words(sentence)).sum();
        let mean = total as f64 / sentences.len() as f64;
        assert!(mean <= MEAN, "{name}: {mean:.1} words a sentence");
        for sentence in &sentences {
            assert!(words(sentence) <= LONGEST, "{name}: {sentence}");
        }
    }
}

#[test]
fn people_read_of_robots_and_plans() {
    for (name, lesson) in shipped::lessons() {
        for sentence in sentences(&lesson) {
            let lower = sentence.to_lowercase();
            for word in [
                "agent",
                "solution",
                "timestep",
                "time step",
                "obviously",
                "simply",
            ] {
                assert!(!lower.contains(word), "{name}: \"{word}\" in: {sentence}");
            }
        }
    }
}

#[test]
fn texts_are_short() {
    for (name, lesson) in shipped::lessons() {
        for (index, step) in lesson.steps.iter().enumerate() {
            let count: usize = step.text.iter().map(|text| words(&text.plain())).sum();
            assert!(count <= 90, "{name}, step {index}: {count} words");
        }
    }
}
