//! A step that is left before its judge has said anything: the answer still counts.

use giveway_solve::Response;

use super::works::Judged;
use super::{AskNumber, Effect, Judge, Learner};
use crate::judge;

impl Learner {
    /// The step is left. What its judge is at goes on, until something else is asked;
    /// a lesson that is tried leaves no traces.
    pub(super) fn leave(&mut self, effects: &mut Vec<Effect>) {
        match &self.open {
            Some(open) if matches!(open.judge, Judge::Looking(_)) && !open.is_tried() => {
                self.left = Some(Box::new(open.clone()));
            }
            _ => self.forget(effects),
        }
    }

    /// Whether this question is asked about the step that was left.
    pub(super) fn is_of_left(&self, number: AskNumber) -> bool {
        let judge = self.left.as_ref().map(|left| &left.judge);
        matches!(judge, Some(Judge::Looking(looking)) if looking.number == number)
    }

    /// The solver has answered about the step that was left: what was done and
    /// solved is kept, and nothing else happens.
    pub(super) fn answered_left(&mut self, response: Response, effects: &mut Vec<Effect>) {
        let Some(mut left) = self.left.take() else {
            return;
        };
        let Judge::Looking(looking) = &mut left.judge else {
            return;
        };
        looking.responses.push(response);
        if !looking.left.is_empty() {
            let request = Box::new(looking.left.remove(0));
            let number = self.next_number();
            looking.number = number;
            self.left = Some(left);
            effects.push(Effect::Ask { number, request });
            return;
        }
        let responses = std::mem::take(&mut looking.responses);
        let verdict = left
            .situation()
            .and_then(|situation| judge::conclude(situation, &left.did, &responses));
        let Some(verdict) = verdict else {
            return;
        };
        if let Some(work) = left.work() {
            let judged = Judged::by(&verdict);
            self.progress.worked(&left.id, &left.lesson, work, judged);
        }
        if verdict.is_solved() {
            self.progress.solved(&left.id, &left.lesson, left.at);
        }
        effects.push(Effect::Keep(self.progress.clone()));
    }
}
