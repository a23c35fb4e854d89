//! Makes a hand-in of what a learner has done.

use std::collections::BTreeMap;

use giveway_model::Version;

use super::bounds::{MAX_NAME, is_plain};
use super::{Answer, Edits, HandIn, OfLesson, Sum, Work};
use crate::judge::{Did, Situation};
use crate::learner::Progress;
use crate::lesson::read::{MAX_STEPS, MAX_TITLE};
use crate::lesson::task::Lead;
use crate::lesson::{Id, Lesson, Task};

/// The most letters of all answers together: with all else, less than a file may hold.
const MAX_ALL: usize = 150_000;

/// What a learner hands in of a lesson: for each task of which an answer is kept that last
/// answer, whether it was taken as solved, and the tries. A name is written on one line,
/// and cut where it is too long; an empty one is none.
///
/// ```
/// use giveway_course::handin::hand_in;
/// use giveway_course::learner::Progress;
/// use giveway_course::lesson::{Glossary, read_lesson};
/// let text = r#"{ "giveway": 1, "title": "T", "minutes": 4, "about": "A sentence.",
///   "steps": [{ "title": "One", "text": ["A sentence."],
///               "scene": { "giveway": 1, "map": ["."], "agents": [] } }] }"#;
/// let lesson = read_lesson(text, &Glossary::default()).unwrap();
/// let made = hand_in(&Progress::default(), &"t".parse().unwrap(), &lesson, " Ada ");
/// assert_eq!(made.name.as_deref(), Some("Ada"));
/// assert!(made.tasks.is_empty());
/// ```
pub fn hand_in(progress: &Progress, id: &Id, lesson: &Lesson, name: &str) -> HandIn {
    let has_task = |work: &Work| {
        let step = lesson.steps.get(work.step);
        step.is_some_and(|step| step.task.is_some()) && work.step < MAX_STEPS
    };
    let mut tasks = progress.works(id, lesson);
    tasks.retain(has_task);
    fit(&mut tasks);
    HandIn {
        giveway: Version,
        hand_in: OfLesson {
            lesson: id.clone(),
            title: line(&lesson.title, MAX_TITLE).unwrap_or_else(|| id.to_string()),
            sum: Sum::of(lesson),
        },
        name: line(name, MAX_NAME),
        tasks,
    }
}

/// A text on one line, without what is not read as it is written; `None` where nothing
/// is left.
fn line(text: &str, most: usize) -> Option<String> {
    let plain = |c: &char| is_plain(*c) || c.is_whitespace();
    let plain: String = text.chars().filter(plain).collect();
    let words: Vec<&str> = plain.split_whitespace().collect();
    let cut: String = words.join(" ").chars().take(most).collect();
    let cut = cut.trim();
    (!cut.is_empty()).then(|| cut.to_owned())
}

/// Leaves out the longest answers where a file would be too long.
fn fit(tasks: &mut [Work]) {
    let letters = Work::letters;
    while tasks.iter().map(letters).sum::<usize>() > MAX_ALL {
        let Some(longest) = tasks.iter_mut().max_by_key(|work| letters(work)) else {
            return;
        };
        *longest = Work {
            step: longest.step,
            tries: longest.tries,
            ..Work::default()
        };
    }
}

/// What was done for the task of a step, as it is kept and handed in; `None` where nothing
/// was done that counts.
pub(crate) fn work_of(
    lesson: &Lesson,
    step: usize,
    situation: Situation<'_>,
    did: &Did,
) -> Option<Work> {
    let own = lesson.scene(step)?;
    let Situation { start, scene, .. } = situation;
    let task = situation.step.task.as_ref()?;
    let answer = answer(task, situation, did)?;
    let board = match &answer {
        Answer::Edits(_) => Edits::between(own, start),
        _ => Edits::between(own, scene),
    };
    Some(Work {
        step,
        board,
        answer: Some(answer),
        ..Work::default()
    })
}

fn answer(task: &Task, situation: Situation<'_>, did: &Did) -> Option<Answer> {
    let answer = match did {
        Did::Edits => {
            let edits = Edits::between(situation.start, situation.scene);
            if edits.is_empty() {
                return None;
            }
            Answer::Edits(edits)
        }
        Did::Led(plan) => {
            let Task::Lead(Lead { robots, .. }) = task else {
                return None;
            };
            let is_led = |name: &String| robots.contains(name);
            let paths = plan.paths.iter().filter(|(name, _)| is_led(name));
            let charges = plan.charges.iter();
            let charges = charges.filter(|(name, times)| is_led(name) && !times.is_empty());
            let owned = |(name, it): (&String, &Vec<u32>)| (name.clone(), it.clone());
            Answer::Paths {
                paths: paths
                    .map(|(name, path)| (name.clone(), path.clone()))
                    .collect(),
                charges: charges.map(owned).collect::<BTreeMap<_, _>>(),
            }
        }
        Did::Guessed(value) => Answer::Value {
            value: value.clone(),
        },
        Did::Revealed => Answer::Shown {},
        Did::Marked(marks) => Answer::Marks {
            marks: marks.clone(),
        },
        Did::Chose(choice) => Answer::Choice { choice: *choice },
        Did::Ordered(order) => Answer::Order {
            order: order.clone(),
        },
        Did::NoOrder => Answer::NoOrder {},
        Did::Went(method) => Answer::Method { method: *method },
    };
    answer.is_for(task).then_some(answer)
}
