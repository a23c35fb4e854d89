//! What a class did with each task: how many solved it, and the most common wrong answers.

use std::collections::BTreeMap;

use super::{Claim, Class, Judgement, Order, Row};
use crate::handin::{Answer, answer_words};
use crate::lesson::{Lesson, Step, Task, Text};

/// How many did what with a task.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Share {
    /// The step, from 0.
    pub step: usize,
    /// Judged to be solved.
    pub solved: usize,
    /// Judged not to be solved, whatever the file says.
    pub not_solved: usize,
    /// Of all, how many files say that it is solved although it is not.
    pub false_claims: usize,
    /// Without an answer.
    pub not_tried: usize,
    /// Not decided with the work that the solver may do.
    pub undecided: usize,
    /// Not judged yet.
    pub open: usize,
}

impl Share {
    /// How many handed the lesson in.
    pub const fn all(&self) -> usize {
        self.solved + self.not_solved + self.not_tried + self.undecided + self.open
    }
}

/// A wrong answer to a prediction or a choice.
#[derive(Clone, Debug, PartialEq)]
pub struct Wrong {
    /// The step, from 0.
    pub step: usize,
    /// The answer.
    pub answer: Answer,
    /// It in words.
    pub words: String,
    /// How many gave it, at first or at last.
    pub count: usize,
    /// What the lesson says to those who give it.
    pub reply: Option<Text>,
}

impl Class {
    /// The share of each task of a lesson, by its place among [`Class::lessons`].
    pub fn shares(&self, lesson: usize) -> Vec<Share> {
        let given = self.lessons().get(lesson);
        let steps = given.into_iter().flat_map(super::Given::tasks);
        let rows = self.rows(lesson, Order::Name);
        let share = |step: usize| {
            let mut share = Share {
                step,
                ..Share::default()
            };
            let tasks = rows.iter().flat_map(Row::tasks);
            for task in tasks.filter(|task| task.step == step) {
                let count = match task.judgement() {
                    Some(Judgement::Solved(_)) => &mut share.solved,
                    Some(Judgement::NotSolved(_)) => &mut share.not_solved,
                    Some(Judgement::NotTried) => &mut share.not_tried,
                    Some(Judgement::Undecided(_)) => &mut share.undecided,
                    None => &mut share.open,
                };
                *count += 1;
                share.false_claims += usize::from(task.claim() == Claim::False);
            }
            share
        };
        steps.map(share).collect()
    }

    /// The wrong answers to predictions and choices of a lesson, in the order of its steps,
    /// of one step the most common first. A first answer counts beside the last one.
    pub fn wrong(&self, lesson: usize) -> Vec<Wrong> {
        let Some(given) = self.lessons().get(lesson) else {
            return Vec::new();
        };
        let own = &*given.lesson;
        let mut counts: BTreeMap<(usize, String), (Answer, usize)> = BTreeMap::new();
        let rows = self.rows(lesson, Order::Name);
        for task in rows.iter().flat_map(Row::tasks) {
            for answer in task.wrong(own) {
                let words = answer_words(answer, task.step, own);
                let entry = counts.entry((task.step, words));
                entry.or_insert_with(|| (answer.clone(), 0)).1 += 1;
            }
        }
        let wrong = |((step, words), (answer, count)): ((usize, String), (Answer, usize))| Wrong {
            reply: reply(own, step, &answer),
            step,
            answer,
            words,
            count,
        };
        let mut all: Vec<Wrong> = counts.into_iter().map(wrong).collect();
        all.sort_by(|one, other| {
            let key = |wrong: &Wrong| (wrong.step, usize::MAX - wrong.count);
            key(one).cmp(&key(other))
        });
        all
    }
}

/// What the lesson says to those who give an answer.
fn reply(lesson: &Lesson, step: usize, answer: &Answer) -> Option<Text> {
    let Step { task, .. } = lesson.steps.get(step)?;
    match (task.as_ref()?, answer) {
        (Task::Predict(task), Answer::Value { value }) => {
            let mut answers = task.answers.iter();
            answers
                .find(|guess| guess.value == *value)
                .map(|guess| guess.reply.clone())
        }
        (Task::Choose(task), Answer::Choice { choice }) => {
            task.answers.get(*choice).map(|choice| choice.reply.clone())
        }
        _ => None,
    }
}
