//! What is given back to a student: each task, how it is judged, and why.

use giveway_model::tr;

use super::csv::plain;
use super::judgement::capitalised;
use super::{Class, Given, Graded, Looking};
use crate::handin::answer_words;

impl Looking {
    /// What can be sent to the student whose work is chosen: the lesson, then each task with how it
    /// is judged, the answer, and why it does not solve the task. It names no other student, and
    /// does not say what the file claims.
    pub fn to_give_back(&self, class: &Class) -> Option<String> {
        let (row, _) = self.task(class)?;
        let given = class.lessons().get(row.file().lesson()?)?;
        let title = plain(&given.lesson.title);
        let mut lines = vec![match row.name() {
            Some(name) => format!("{}: {title}", plain(name)),
            None => title,
        }];
        lines.extend(row.tasks().iter().filter_map(|task| of_task(task, given)));
        Some(lines.join("\n"))
    }
}

/// A task in a line; nothing of a step without one, which a file may speak of.
fn of_task(task: &Graded, given: &Given) -> Option<String> {
    let step = given.lesson.steps.get(task.step)?;
    step.task.as_ref()?;
    let judgement = task.judgement();
    let word = judgement.map_or(tr!("not judged yet"), |judgement| judgement.word());
    let mut line = format!("{}: {word}.", plain(&given.task_words(task.step)));
    let answer = task.work.as_ref().and_then(|work| work.answer.as_ref());
    let reason = judgement.map(|judgement| judgement.reason(step));
    let reason = reason.filter(|reason| !reason.is_empty());
    if let (Some(answer), Some(_)) = (answer, &reason) {
        let answer = answer_words(answer, task.step, &given.lesson);
        line += " ";
        line += &tr!(
            "Your answer: {answer}.",
            answer = plain(answer.trim_end_matches('.'))
        );
    }
    if let Some(reason) = reason {
        line += " ";
        line += &capitalised(&plain(&reason));
    }
    Some(line)
}
