//! One task of one hand-in on its way to a judgement.

use giveway_model::tr;

use super::answers::{Answers, Key};
use super::limits::limited;
use super::{Claim, Judgement, Reason};
use crate::handin::{Answer, Misfit, Shown, Work};
use crate::judge::{Judging, Verdict, begin, conclude};
use crate::lesson::{Lesson, Task, Value};

/// A task of a hand-in.
#[derive(Clone, Debug, PartialEq)]
pub struct Graded {
    /// The step, from 0.
    pub step: usize,
    /// What the file says was done.
    pub work: Option<Work>,
    pub(super) state: State,
}

/// How far its judge is.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum State {
    /// It has not begun.
    Waiting,
    /// It asks the solver.
    Asking(Vec<Key>),
    /// It has judged.
    Judged(Judgement),
}

impl Graded {
    pub(super) const fn new(step: usize, work: Option<Work>) -> Self {
        Self {
            step,
            work,
            state: State::Waiting,
        }
    }

    /// What it is worth; `None` while that is not known.
    pub const fn judgement(&self) -> Option<&Judgement> {
        match &self.state {
            State::Judged(judgement) => Some(judgement),
            State::Waiting | State::Asking(_) => None,
        }
    }

    /// What the file claims of it.
    pub fn claim(&self) -> Claim {
        Claim::of(self.work.as_ref(), self.judgement())
    }

    /// Whether it is judged to be solved.
    pub fn is_solved(&self) -> bool {
        self.judgement().is_some_and(Judgement::is_solved)
    }

    /// How often the person tried, as the file says; 0 where nothing was done.
    pub fn tries(&self) -> u32 {
        self.work.as_ref().map_or(0, |work| work.tries)
    }

    /// Answers to a prediction or a choice that are wrong, the first one included, each
    /// once.
    pub(super) fn wrong(&self, lesson: &Lesson) -> Vec<&Answer> {
        let step = lesson.steps.get(self.step);
        let Some(task) = step.and_then(|step| step.task.as_ref()) else {
            return Vec::new();
        };
        let Some(work) = &self.work else {
            return Vec::new();
        };
        let truth = self
            .judgement()
            .and_then(|judgement| judgement.verdict()?.truth());
        let is_wrong = |answer: &&Answer| is_wrong(answer, task, truth);
        let mut wrong: Vec<&Answer> = work.first.iter().filter(is_wrong).collect();
        let last = work.answer.iter().filter(is_wrong);
        wrong.extend(last.filter(|answer| work.first.as_ref() != Some(answer)));
        wrong
    }

    /// Begins to judge, or judges where all is answered; which question is open, where one
    /// is.
    pub(super) fn step(
        &mut self,
        lesson: &Lesson,
        work: u64,
        answers: &mut Answers,
    ) -> Option<Key> {
        match &self.state {
            State::Waiting => {
                self.state = match self.begin(lesson, work, answers) {
                    Ok(state) => state,
                    Err(Misfit::NoAnswer) => State::Judged(Judgement::NotTried),
                    Err(misfit) => {
                        let reason = Reason::Misfit(misfit);
                        State::Judged(Judgement::NotSolved(reason))
                    }
                };
                None
            }
            State::Asking(keys) => {
                let open = keys.iter().find(|key| answers.open(**key).is_some());
                if let Some(open) = open {
                    return Some(*open);
                }
                let judgement = self.conclude(lesson, keys, answers);
                self.state = State::Judged(judgement);
                None
            }
            State::Judged(_) => None,
        }
    }

    fn begin(&self, lesson: &Lesson, limit: u64, answers: &mut Answers) -> Result<State, Misfit> {
        let work = self.work.as_ref().ok_or(Misfit::NoAnswer)?;
        let shown = Shown::of(work, lesson)?;
        let step = lesson.steps.get(self.step).ok_or(Misfit::NoTask)?;
        let judging = begin(shown.situation(step), &shown.did).ok_or(Misfit::NoTask)?;
        Ok(match judging {
            Judging::Verdict(verdict) => State::Judged(Judgement::by(*verdict)),
            Judging::Ask(requests) => {
                let keys = requests.into_iter();
                let keys = keys.map(|request| answers.key(limited(request, limit)));
                State::Asking(keys.collect())
            }
        })
    }

    fn conclude(&self, lesson: &Lesson, keys: &[Key], answers: &Answers) -> Judgement {
        let responses = match answers.responses(keys) {
            Ok(responses) => responses,
            Err(sentence) => return Judgement::by(Verdict::unknown(sentence)),
        };
        let verdict = self.work.as_ref().and_then(|work| {
            let shown = Shown::of(work, lesson).ok()?;
            let step = lesson.steps.get(self.step)?;
            conclude(shown.situation(step), &shown.did, &responses)
        });
        // It began, so that it can be concluded.
        let unknown = || Verdict::unknown(tr!("The judge could not conclude.").to_owned());
        Judgement::by(verdict.unwrap_or_else(unknown))
    }
}

/// Whether an answer is known to be wrong. What is not decided is not.
fn is_wrong(answer: &Answer, task: &Task, truth: Option<&Value>) -> bool {
    match (answer, task) {
        (Answer::Value { value }, Task::Predict(_)) => truth.is_some_and(|truth| truth != value),
        (Answer::Choice { choice }, Task::Choose(task)) => {
            let choice = task.answers.get(*choice);
            choice.is_some_and(|choice| !choice.right)
        }
        _ => false,
    }
}
