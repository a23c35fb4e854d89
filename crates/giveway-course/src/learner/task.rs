//! What is done for a task, and what the judges make of it.

use giveway_solve::Request;

use super::works::Judged;
use super::{AskNumber, Effect, Judge, Learner, Looking, Proof};
use crate::judge::{self, Did, Judging, Verdict, Why};
use crate::lesson::Task;
use crate::port::ToPage;

impl Learner {
    /// Something was done for the task: it is judged, and what was asked before is of
    /// no more use.
    pub(super) fn did(&mut self, did: Did, effects: &mut Vec<Effect>) {
        self.forget(effects);
        let Some(open) = &mut self.open else {
            return;
        };
        if !open
            .step()
            .and_then(|step| step.task.as_ref())
            .is_some_and(|task| is_for(task, &did))
        {
            return;
        }
        open.did = did;
        if matches!(open.did, Did::Edits | Did::Led(_)) && !open.has_done() {
            open.judge = Judge::Waiting;
            return;
        }
        open.attempts = open.attempts.saturating_add(1);
        self.keep_work(Judged::Not);
        let Some(open) = &mut self.open else {
            return;
        };
        let judging = open
            .situation()
            .and_then(|situation| judge::begin(situation, &open.did));
        match judging {
            None => open.judge = Judge::Waiting,
            Some(Judging::Verdict(verdict)) => self.settle(verdict, effects),
            Some(Judging::Ask(requests)) => self.ask(requests, effects),
        }
    }

    fn ask(&mut self, requests: Vec<Request>, effects: &mut Vec<Effect>) {
        let number = self.next_ask();
        let Some(open) = &mut self.open else {
            return;
        };
        let mut requests = requests.into_iter();
        let Some(first) = requests.next() else {
            return self.conclude(effects);
        };
        open.judge = Judge::Looking(Looking {
            number,
            left: requests.collect(),
            responses: Vec::new(),
        });
        let request = Box::new(first);
        effects.push(Effect::Ask { number, request });
    }

    /// All is answered.
    pub(super) fn conclude(&mut self, effects: &mut Vec<Effect>) {
        let Some(open) = &mut self.open else {
            return;
        };
        let responses = match std::mem::take(&mut open.judge) {
            Judge::Looking(looking) => looking.responses,
            Judge::Waiting | Judge::Said(_) => Vec::new(),
        };
        let verdict = open
            .situation()
            .and_then(|situation| judge::conclude(situation, &open.did, &responses));
        if let Some(verdict) = verdict {
            self.settle(Box::new(verdict), effects);
        }
    }

    /// What was done is kept, so that it can be handed in; a lesson that is tried leaves no
    /// traces.
    fn keep_work(&mut self, judged: Judged) {
        let Some(open) = self.open.as_ref().filter(|open| !open.is_tried()) else {
            return;
        };
        if let Some(work) = open.work() {
            self.progress.worked(&open.id, &open.lesson, work, judged);
        }
    }

    /// What a verdict makes of an answer. A robot that is led on after a rule was broken makes no
    /// other try.
    fn judged(&self, verdict: &Verdict) -> Judged {
        let is_broken = |verdict: &Verdict| matches!(verdict.why, Why::Broken(_));
        let before = self.open.as_ref().and_then(|open| open.judge.verdict());
        let is_led = self
            .open
            .as_ref()
            .is_some_and(|open| matches!(open.did, Did::Led(_)));
        if is_led && is_broken(verdict) && before.is_some_and(is_broken) {
            return Judged::Part;
        }
        Judged::by(verdict)
    }

    fn settle(&mut self, mut verdict: Box<Verdict>, effects: &mut Vec<Effect>) {
        let judged = self.judged(&verdict);
        self.keep_work(judged);
        let Some(open) = &mut self.open else {
            return;
        };
        if open.lesson.hides_answers {
            verdict.keep_quiet();
        }
        // What was predicted is shown at once, right or not.
        if matches!(verdict.why, Why::Guessed { .. } | Why::Revealed(_))
            && verdict.evidence.has_plan()
        {
            let evidence = Box::new(verdict.evidence.clone());
            effects.push(Effect::Page(ToPage::Show(evidence)));
            effects.push(Effect::Page(ToPage::Play));
        }
        if verdict.is_solved() {
            if !verdict.seal.is_empty() {
                effects.push(Effect::Page(ToPage::Seal(verdict.seal.clone())));
            }
            if !open.is_tried() {
                self.progress.solved(&open.id, &open.lesson, open.at);
            }
            effects.push(Effect::FocusNext);
        }
        if !open.is_tried() && judged != Judged::Part {
            effects.push(Effect::Keep(self.progress.clone()));
        }
        open.judge = Judge::Said(verdict);
    }

    pub(super) fn failed(
        &mut self,
        number: AskNumber,
        sentence: String,
        effects: &mut Vec<Effect>,
    ) {
        if self.is_of_left(number) {
            self.left = None;
            return;
        }
        self.proved(number, None);
        let is_asked = self.open.as_ref().is_some_and(
            |open| matches!(&open.judge, Judge::Looking(looking) if looking.number == number),
        );
        if is_asked {
            let verdict = Verdict::unknown(sentence);
            self.settle(Box::new(verdict), effects);
        }
    }

    pub(super) fn show(&mut self, effects: &mut Vec<Effect>) {
        let verdict = self.open.as_ref().and_then(|open| open.judge.verdict());
        let evidence = verdict.map(|verdict| verdict.evidence.clone());
        if let Some(evidence) = evidence.filter(|evidence| !evidence.is_empty()) {
            effects.push(Effect::Page(ToPage::Show(Box::new(evidence))));
        }
    }

    pub(super) fn take_back(&mut self, effects: &mut Vec<Effect>) {
        let Some(open) = &mut self.open else {
            return;
        };
        if open.pointed.take().is_some() {
            return;
        }
        match &mut open.did {
            Did::Edits | Did::Led(_) => effects.push(Effect::Page(ToPage::TakeBack)),
            Did::Marked(marks) => {
                let mut marks = std::mem::take(marks);
                marks.pop();
                self.did(Did::Marked(marks), effects);
            }
            _ => {
                open.did = Did::default();
                open.judge = Judge::Waiting;
                self.forget(effects);
            }
        }
    }

    /// What the solver is at is of no more use.
    pub(super) fn forget(&mut self, effects: &mut Vec<Effect>) {
        let Some(open) = &mut self.open else {
            return;
        };
        let is_looking = matches!(open.judge, Judge::Looking(_));
        let is_proving = matches!(open.proof, Proof::Asked(_));
        if is_looking {
            open.judge = Judge::Waiting;
        }
        if is_proving {
            open.proof = Proof::Unasked;
        }
        if is_looking || is_proving {
            effects.push(Effect::Forget);
        }
    }
}

/// Whether something is what a kind of task asks for.
const fn is_for(task: &Task, did: &Did) -> bool {
    matches!(
        (task, did),
        (Task::Paint(_), Did::Edits)
            | (Task::Lead(_), Did::Led(_))
            | (Task::Predict(_), Did::Guessed(_) | Did::Revealed)
            | (Task::Spot(_), Did::Marked(_))
            | (Task::Choose(_), Did::Chose(_))
            | (Task::Order(_), Did::Ordered(_) | Did::NoOrder)
            | (Task::Change(_), Did::Went(_))
    )
}
