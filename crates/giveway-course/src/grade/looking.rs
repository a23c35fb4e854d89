//! Looking at a class: which table is shown, and which student's work stands on the board.

use giveway_model::tr;

use super::csv::plain;
use super::judgement::capitalised;
use super::{Claim, Class, Graded, Order, Row};
use crate::handin::{Shown, answer_words};
use crate::lesson::Step;

/// What of a class is looked at.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Looking {
    /// The lesson, by its place among [`Class::lessons`].
    pub lesson: usize,
    /// The order of the rows.
    pub order: Order,
    /// The cell of the table that is chosen.
    pub chosen: Option<Chosen>,
}

/// A cell of the table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Chosen {
    /// The file, by its place among [`Class::files`].
    pub file: usize,
    /// The step, from 0.
    pub step: usize,
}

/// Something that is done at the table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LookAction {
    /// The table of another lesson.
    Lesson(usize),
    /// Another order.
    Order(Order),
    /// A cell is chosen, or none any more.
    Choose(Option<Chosen>),
    /// To the next cell to look at, or the one before (`false`); from the last to the first.
    LookAt(bool),
}

/// What is said of the cell that is chosen.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LookedAt {
    /// How it is judged against what its file says: `Says solved, is not`.
    pub head: String,
    /// Who did it.
    pub who: String,
    /// What was done, in words; empty where nothing was.
    pub answer: String,
    /// Why it is not solved; empty where it is.
    pub reason: String,
}

impl Looking {
    /// What is looked at after something is done.
    #[must_use]
    pub fn reduce(mut self, action: LookAction, class: &Class) -> Self {
        match action {
            LookAction::Lesson(lesson) if lesson != self.lesson => {
                self.lesson = lesson;
                self.chosen = None;
            }
            LookAction::Lesson(_) => {}
            LookAction::Order(order) => self.order = order,
            LookAction::Choose(chosen) => self.chosen = chosen,
            LookAction::LookAt(forward) => {
                let all = self.to_look_at(class);
                let count = all.len();
                let now = all.iter().position(|it| Some(*it) == self.chosen);
                let next = match (now, forward) {
                    (Some(place), true) => (place + 1).checked_rem(count),
                    (Some(place), false) => (place + count).checked_sub(1).map(|it| it % count),
                    (None, true) => Some(0),
                    (None, false) => count.checked_sub(1),
                };
                self.chosen = next
                    .and_then(|place| all.get(place).copied())
                    .or(self.chosen);
            }
        }
        self
    }

    /// The cells to look at: answers that do not solve their task, in the order of the rows.
    pub fn to_look_at(&self, class: &Class) -> Vec<Chosen> {
        let rows = class.rows(self.lesson, self.order);
        let cells = rows.iter().flat_map(|row| {
            let tasks = row.tasks().iter();
            let open = tasks.filter(|task| task.work.is_some() && !task.is_solved());
            open.map(|task| Chosen {
                file: row.place(),
                step: task.step,
            })
        });
        cells.collect()
    }

    /// The task that is chosen, with its row.
    pub fn task<'a>(&self, class: &'a Class) -> Option<(Row<'a>, &'a Graded)> {
        let chosen = self.chosen?;
        let row = class.row(chosen.file)?;
        let mut tasks = row.tasks().iter();
        let task = tasks.find(|task| task.step == chosen.step)?;
        Some((row, task))
    }

    /// The board and the plan of the task that is chosen; `None` where nothing fits the
    /// lesson.
    pub fn shown(&self, class: &Class) -> Option<Shown> {
        let (row, task) = self.task(class)?;
        let given = class.lessons().get(row.file().lesson()?)?;
        Shown::of(task.work.as_ref()?, &given.lesson).ok()
    }

    /// What is said of the task that is chosen.
    pub fn said(&self, class: &Class) -> Option<LookedAt> {
        let (row, task) = self.task(class)?;
        let given = class.lessons().get(row.file().lesson()?)?;
        let answer = task.work.as_ref().and_then(|work| work.answer.as_ref());
        let words = answer.map(|it| answer_words(it, task.step, &given.lesson));
        let none = Step::default();
        let step = given.lesson.steps.get(task.step).unwrap_or(&none);
        let reason = task.judgement().map(|judgement| judgement.reason(step));
        Some(LookedAt {
            head: head(task),
            who: plain(row.title()),
            answer: plain(&words.unwrap_or_default()),
            reason: plain(&reason.unwrap_or_default()),
        })
    }
}

/// How a task is judged against what its file says.
fn head(task: &Graded) -> String {
    match (task.claim(), task.judgement()) {
        (Claim::False, _) => tr!("Says solved, is not").to_owned(),
        (_, Some(judgement)) => capitalised(judgement.word()),
        (_, None) => tr!("Not judged yet").to_owned(),
    }
}
