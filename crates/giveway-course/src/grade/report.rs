//! The table of a class for programs.

use giveway_model::Version;
use serde::Serialize;

use super::csv::{answered, plain, reason};
use super::{Claim, Class, Given, Graded, Judgement, Order, Row, Share, Wrong};
use crate::handin::Sum;
use crate::lesson::Id;

/// The judgements of a class, as JSON has them. Tasks and steps are counted from 1, as on the
/// page.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Report {
    giveway: Version,
    /// How many files say of a task that it is solved, which is not so.
    false_claims: usize,
    /// How many tasks are not decided, or not judged.
    undecided: usize,
    lessons: Vec<OfLesson>,
    /// Files that are not judged.
    unread: Vec<NotRead>,
}

#[derive(Clone, Debug, PartialEq, Serialize)]
struct OfLesson {
    lesson: Id,
    title: String,
    sum: Sum,
    tasks: Vec<OfTask>,
    wrong: Vec<WrongAnswer>,
    students: Vec<OfStudent>,
}

#[derive(Clone, Debug, PartialEq, Serialize)]
struct OfTask {
    task: usize,
    step: usize,
    title: String,
    kind: &'static str,
    solved: usize,
    not_solved: usize,
    not_tried: usize,
    undecided: usize,
    false_claims: usize,
}

#[derive(Clone, Debug, PartialEq, Serialize)]
struct WrongAnswer {
    step: usize,
    answer: String,
    count: usize,
    #[serde(skip_serializing_if = "Option::is_none")]
    reply: Option<String>,
}

#[derive(Clone, Debug, PartialEq, Serialize)]
struct OfStudent {
    #[serde(skip_serializing_if = "Option::is_none")]
    name: Option<String>,
    file: String,
    /// How many files bear the name; the latest of them is judged.
    files: usize,
    solved: usize,
    tasks: Vec<Work>,
}

#[derive(Clone, Debug, PartialEq, Serialize)]
struct Work {
    step: usize,
    judged: &'static str,
    said_solved: bool,
    false_claim: bool,
    tries: u32,
    #[serde(skip_serializing_if = "String::is_empty")]
    answer: String,
    #[serde(skip_serializing_if = "String::is_empty")]
    reason: String,
}

#[derive(Clone, Debug, PartialEq, Serialize)]
struct NotRead {
    file: String,
    reason: String,
}

impl Report {
    /// The report of a class as far as it is judged.
    pub fn of(class: &Class, order: Order) -> Self {
        let tables = class.tables().into_iter();
        let lessons = tables.filter_map(|lesson| {
            let given = class.lessons().get(lesson)?;
            Some(of_lesson(class, lesson, given, order))
        });
        let lessons: Vec<OfLesson> = lessons.collect();
        let tasks = lessons.iter().flat_map(|lesson| &lesson.tasks);
        let unread = class.files().iter().filter_map(|file| {
            Some(NotRead {
                file: plain(&file.file),
                reason: plain(&file.unread()?.words()),
            })
        });
        Self {
            giveway: Version,
            false_claims: class.false_claims(),
            undecided: tasks.map(|task| task.undecided).sum(),
            unread: unread.collect(),
            lessons,
        }
    }
}

fn of_lesson(class: &Class, lesson: usize, given: &Given, order: Order) -> OfLesson {
    let task = |share: Share| {
        let step = given.lesson.steps.get(share.step);
        let task = step.and_then(|step| step.task.as_ref());
        OfTask {
            task: given.number(share.step).unwrap_or_default(),
            step: share.step + 1,
            title: step.map_or_else(String::new, |step| step.title.clone()),
            kind: task.map_or("", |task| task.kind()),
            solved: share.solved,
            not_solved: share.not_solved,
            not_tried: share.not_tried,
            undecided: share.undecided + share.open,
            false_claims: share.false_claims,
        }
    };
    let wrong = |wrong: Wrong| WrongAnswer {
        step: wrong.step + 1,
        answer: plain(&wrong.words),
        count: wrong.count,
        reply: wrong.reply.map(|reply| reply.plain()),
    };
    let rows = class.rows(lesson, order).into_iter();
    OfLesson {
        lesson: given.id.clone(),
        title: given.lesson.title.clone(),
        sum: given.sum,
        tasks: class.shares(lesson).into_iter().map(task).collect(),
        wrong: class.wrong(lesson).into_iter().map(wrong).collect(),
        students: rows.map(|row| of_student(row, given)).collect(),
    }
}

fn of_student(row: Row<'_>, given: &Given) -> OfStudent {
    OfStudent {
        name: row.name().map(plain),
        file: plain(&row.file().file),
        files: row.files().len(),
        solved: row.solved(),
        tasks: row.tasks().iter().map(|task| work(task, given)).collect(),
    }
}

fn work(task: &Graded, given: &Given) -> Work {
    Work {
        step: task.step + 1,
        judged: match task.judgement() {
            Some(Judgement::Solved(_)) => "solved",
            Some(Judgement::NotSolved(_)) => "not-solved",
            Some(Judgement::NotTried) => "not-tried",
            Some(Judgement::Undecided(_)) => "undecided",
            None => "not-judged",
        },
        said_solved: task.work.as_ref().is_some_and(|work| work.solved),
        false_claim: task.claim() == Claim::False,
        tries: task.tries(),
        answer: answered(task, &given.lesson),
        reason: reason(task, &given.lesson),
    }
}
