//! From a check and an action to the next check, and what must be done outside.

use std::rc::Rc;

use giveway_solve::Response;

use super::examine::examine;
use super::{Action, Effect, Finding, LessonCheck, Problem, Run, Standing, Subject};
use crate::learner::AskNumber;
use crate::lesson::Lesson;

/// The most tasks of which something is kept.
const MOST: usize = 100;

/// What becomes of a check, and what must be done outside, in this order.
#[must_use]
pub fn reduce(mut check: LessonCheck, action: Action) -> (LessonCheck, Vec<Effect>) {
    let mut effects = Vec::new();
    match action {
        Action::Share { lesson, anyway } => check.share(lesson, anyway, &mut effects),
        Action::Cancel => check.cancel(&mut effects),
        Action::Solved(subject) => check.solved(*subject),
        Action::Answered { number, response } => check.answered(number, *response, &mut effects),
        Action::Failed { number, sentence } => {
            if check.is_asked(number) {
                check.found(Finding::Unknown(Some(sentence)));
                check.go_on(&mut effects);
            }
        }
    }
    (check, effects)
}

impl LessonCheck {
    /// What is wrong stays so; what is not known is checked again.
    fn share(&mut self, lesson: Rc<Lesson>, anyway: bool, effects: &mut Vec<Effect>) {
        self.cancel(effects);
        if anyway && self.standing(&lesson) == Standing::Unknown {
            effects.push(Effect::Share(lesson));
            return;
        }
        let is_left =
            |subject: &Subject| matches!(self.of(subject), None | Some(Finding::Unknown(_)));
        let mut left = Subject::all(&lesson);
        left.retain(is_left);
        left.reverse();
        self.run = Some(Run {
            count: left.len(),
            lesson,
            left,
            answers: Vec::new(),
        });
        self.go_on(effects);
    }

    fn cancel(&mut self, effects: &mut Vec<Effect>) {
        if self.run.take().is_some() {
            effects.push(Effect::Forget);
        }
    }

    fn solved(&mut self, subject: Subject) {
        let unsolved = Finding::Failed(Problem::Unsolved);
        for (known, finding) in &mut self.known {
            if *known == subject && *finding == unsolved {
                *finding = Finding::Passed;
            }
        }
        push(&mut self.tried, subject);
    }

    fn answered(&mut self, number: AskNumber, response: Response, effects: &mut Vec<Effect>) {
        if self.is_asked(number)
            && let Some(run) = &mut self.run
        {
            run.answers.push(response);
            self.go_on(effects);
        }
    }

    fn is_asked(&self, number: AskNumber) -> bool {
        self.run.is_some() && self.asked == number
    }

    /// Keeps what was found for the task that is checked now, and turns to the next one.
    fn found(&mut self, finding: Finding) {
        let Some(run) = &mut self.run else {
            return;
        };
        run.answers.clear();
        if let Some(subject) = run.left.pop() {
            self.known.retain(|(other, _)| *other != subject);
            push(&mut self.known, (subject, finding));
        }
    }

    /// Checks as far as the answers reach.
    fn go_on(&mut self, effects: &mut Vec<Effect>) {
        while let Some(run) = &self.run {
            let Some(subject) = run.left.last() else {
                let lesson = Rc::clone(&run.lesson);
                self.run = None;
                if self.standing(&lesson) == Standing::Passed {
                    effects.push(Effect::Share(lesson));
                }
                return;
            };
            let is_tried = self.tried.contains(subject);
            match examine(subject, is_tried, &run.answers) {
                Ok(finding) => self.found(finding),
                Err(request) => {
                    let number = AskNumber(self.asked.0.wrapping_add(1));
                    self.asked = number;
                    effects.push(Effect::Ask { number, request });
                    return;
                }
            }
        }
    }
}

fn push<T>(list: &mut Vec<T>, one: T) {
    if list.len() >= MOST {
        list.remove(0);
    }
    list.push(one);
}
