//! The check before a lesson is shared: the solver tries each task, in a worker of its own.

use giveway_course::author::ToDo;
use giveway_course::author::check::{
    Action, Effect, Finding, Standing, Subject, reduce, sentence, to_do,
};
use giveway_course::learner::{self, Open};
use giveway_model::tr;
use yew::prelude::*;

use super::{Author, AuthorMsg, share};
use crate::icon;
use crate::turning::turning;

/// The most findings that are told at once; the list has all of them.
const TOLD: usize = 3;

/// Hears what the solver answers.
pub(super) fn hear(send: &Callback<AuthorMsg>) -> Callback<learner::Action> {
    let send = send.clone();
    Callback::from(move |action| {
        let action = match action {
            learner::Action::Answered { number, response } => Action::Answered { number, response },
            learner::Action::Failed { number, sentence } => Action::Failed { number, sentence },
            _ => return,
        };
        send.emit(AuthorMsg::Check(action));
    })
}

impl Author {
    /// Something happens to the check.
    pub(super) fn check(&mut self, action: Action) {
        let was_running = self.check.progress().is_some();
        let is_cancelled = action == Action::Cancel;
        let is_asked = matches!(action, Action::Share { .. });
        let (check, effects) = reduce(std::mem::take(&mut self.check), action);
        self.check = check;
        let mut is_shared = false;
        for effect in effects {
            match effect {
                Effect::Ask { number, request } => self.checker.ask(number, *request),
                Effect::Forget => self.checker.end(),
                Effect::Share(lesson) => {
                    is_shared = true;
                    share::copy(&lesson, self.send.reform(AuthorMsg::Told));
                }
            }
        }
        if self.check.progress().is_some() || !(was_running || is_asked) {
            return;
        }
        self.checker.end();
        self.told = if is_shared {
            String::new()
        } else if is_cancelled {
            tr!("The check was cancelled. Nothing was shared.").to_owned()
        } else {
            let why = self.checked().to_do().into_iter().take(TOLD);
            let why: Vec<String> = why.map(|line| line.text).collect();
            tr!("Not shared yet. {why}", why = why.join(" "))
        };
    }

    /// What is known of the tasks, where the lesson is whole.
    fn standing(&self) -> Standing {
        let lesson = self.looked.as_ref().and_then(|looked| looked.whole().ok());
        lesson.map_or(Standing::Unchecked, |lesson| self.check.standing(lesson))
    }

    /// A task of the lesson that is tried was judged.
    pub(in crate::course) fn tried(&mut self, open: &Open) {
        if open.is_tried() && open.is_solved() {
            let subject = open.step().and_then(|step| Subject::of(step, open.start()));
            if let Some(subject) = subject {
                self.check(Action::Solved(Box::new(subject)));
            }
        }
    }

    /// What the check says, for the editor.
    pub(super) fn checked(&self) -> Checked {
        let steps = 0..self.draft.steps().len();
        let looked = self.looked.as_ref();
        let found = |step| self.check.of(&looked?.subject(step)?).cloned();
        Checked {
            progress: self.check.progress(),
            findings: steps.map(found).collect(),
            is_unknown: self.standing() == Standing::Unknown,
        }
    }
}

/// What the check says.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Checked {
    /// Which task is checked now, and how many there are.
    progress: Option<(usize, usize)>,
    /// What was found, step by step.
    findings: Vec<Option<Finding>>,
    /// Whether nothing is wrong, but the solver does not know about some tasks.
    is_unknown: bool,
}

impl Checked {
    fn sentence(&self, step: usize) -> Option<String> {
        sentence(self.findings.get(step)?.as_ref()?)
    }

    /// Whether the task of a step has not passed.
    pub(super) fn is_wrong(&self, step: usize) -> bool {
        self.sentence(step).is_some()
    }

    /// Whether a task has not passed.
    pub(super) fn has_wrong(&self) -> bool {
        (0..self.findings.len()).any(|step| self.is_wrong(step))
    }

    /// The lines for the list of all that is still to do.
    pub(super) fn to_do(&self) -> Vec<ToDo> {
        to_do(&self.findings)
    }

    /// What was found, beside the task of a step.
    pub(super) fn beside(&self, step: usize) -> Html {
        html! { if let Some(said) = self.sentence(step) { <span class="wrong"><span>{ said }</span></span> } }
    }

    /// How far the check is.
    pub(super) fn progress(&self) -> Option<String> {
        let (number, count) = self.progress?;
        Some(tr!(
            "Checking task {number} of {count}\u{2026}",
            number,
            count
        ))
    }

    /// The buttons that share the lesson, or cancel the check.
    pub(super) fn buttons(&self, send: &Callback<AuthorMsg>) -> Html {
        let button = |name: &'static str, icon: &'static str, msg: AuthorMsg| {
            let onclick = send.reform(move |_: MouseEvent| msg.clone());
            turning(
                "outline",
                name,
                html! { <>{ icon::show(icon) }<span>{ name }</span></> },
                onclick,
            )
        };
        let is_running = self.progress.is_some();
        html! {
            <>
                if self.is_unknown && !is_running { { button(tr!("Copy link anyway"), "warning", AuthorMsg::Copy { anyway: true }) } }
                { if is_running {
                    button(tr!("Cancel"), "cancel", AuthorMsg::Check(Action::Cancel))
                } else {
                    button(tr!("Copy link"), "share", AuthorMsg::Copy { anyway: false })
                } }
            </>
        }
    }
}
