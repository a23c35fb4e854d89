//! The table of a class for spreadsheets: a row for each student and task.

use giveway_model::csv::{table, text};
use giveway_model::tr;

use super::{Class, Given, Graded, Judgement, Order, Row};
use crate::handin::{answer_words, is_plain};
use crate::lesson::{Lesson, Step};

/// The table: name, lesson, task, judged, said, tries, answer, reason, file. Files that are
/// not judged stand at its end with their reason. No cell is a formula.
pub fn csv(class: &Class, order: Order) -> String {
    let head = [
        tr!("a column" => "name"),
        tr!("a column" => "lesson"),
        tr!("a column" => "task"),
        tr!("a column" => "judged"),
        tr!("a column" => "said"),
        tr!("a column" => "tries"),
        tr!("a column" => "answer"),
        tr!("a column" => "reason"),
        tr!("a column" => "file"),
    ];
    let mut rows = vec![head.map(str::to_owned).to_vec()];
    for lesson in class.tables() {
        let Some(given) = class.lessons().get(lesson) else {
            continue;
        };
        for row in class.rows(lesson, order) {
            let tasks = row.tasks().iter();
            rows.extend(tasks.map(|task| of_task(row, task, given)));
        }
    }
    for file in class.files() {
        if let Some(unread) = file.unread() {
            let mut row = vec![String::new(); 7];
            row.push(cell(&unread.words()));
            row.push(cell(&file.file));
            rows.push(row);
        }
    }
    table(rows)
}

/// What a file says of a task: `solved`, `not solved`, or nothing.
pub(super) fn said(task: &Graded) -> &'static str {
    match &task.work {
        Some(work) if work.solved => tr!("solved"),
        Some(_) => tr!("not solved"),
        None => "",
    }
}

/// How a task is judged, in a word or two.
pub(super) fn judged(task: &Graded) -> &'static str {
    task.judgement()
        .map_or_else(|| tr!("not judged yet"), Judgement::word)
}

/// The last answer to a task in words.
pub(super) fn answered(task: &Graded, lesson: &Lesson) -> String {
    let answer = task.work.as_ref().and_then(|work| work.answer.as_ref());
    let words = answer.map(|answer| answer_words(answer, task.step, lesson));
    plain(&words.unwrap_or_default())
}

/// Why a task is not solved, as a sentence.
pub(super) fn reason(task: &Graded, lesson: &Lesson) -> String {
    let none = Step::default();
    let step = lesson.steps.get(task.step).unwrap_or(&none);
    let reason = task.judgement().map(|judgement| judgement.reason(step));
    plain(&reason.unwrap_or_default())
}

/// A text that comes from a file, without what is not read as it is written.
pub(super) fn plain(text: &str) -> String {
    let plain = |c: char| if is_plain(c) { c } else { ' ' };
    text.chars().map(plain).collect()
}

fn cell(words: &str) -> String {
    text(&plain(words))
}

fn of_task(row: Row<'_>, task: &Graded, given: &Given) -> Vec<String> {
    let lesson = &given.lesson;
    vec![
        cell(row.name().unwrap_or_default()),
        cell(&lesson.title),
        cell(&given.task_words(task.step)),
        judged(task).to_owned(),
        said(task).to_owned(),
        task.tries().to_string(),
        cell(&answered(task, lesson)),
        cell(&reason(task, lesson)),
        cell(&row.file().file),
    ]
}
