//! The plan on the board is older than a rule: where it breaks rules that came after it.

use std::rc::Rc;

use giveway_model::Scene;
use giveway_model::check::{Violation, check};
use giveway_model::words::and;
use giveway_model::{sorting::set, tr};

use super::{broken, ranges};
use crate::{Answer, Document, Draft, State};

/// A rule of more letters is not in the sentence: the board would move for it.
const LONGEST_SAID: usize = 50;

/// At most so many stretches of time are told.
const STRETCHES: usize = 2;

/// What a stale plan breaks of the rules of the scene as it is now.
#[derive(Clone, Debug)]
pub(crate) struct Outdated {
    draft: Rc<Draft>,
    answer: Rc<Answer>,
    /// What is against rules of the scene's own, by time; nothing where more than rules has changed.
    pub(super) violations: Vec<Violation>,
    /// Whether nothing but rules has changed since.
    has_other_rules_only: bool,
}

/// What is known of that. It follows from the document, so it makes no difference between states.
#[derive(Clone, Debug, Default)]
pub(crate) struct Known(Option<Rc<Outdated>>);

impl PartialEq for Known {
    fn eq(&self, _: &Self) -> bool {
        true
    }
}

impl Known {
    /// What is known of a document.
    fn of(&self, document: &Document) -> Option<&Outdated> {
        self.0.as_deref().filter(|it| it.is_of(document))
    }

    /// Looks again where the document is another one.
    pub(crate) fn keep_to(&mut self, document: &Document) {
        if self.of(document).is_none() {
            self.0 = Outdated::of(document).map(Rc::new);
        }
    }
}

/// What the stale plan on the board breaks.
pub(super) fn of(state: &State) -> Option<&Outdated> {
    let known = state.view.rules.outdated.of(&state.document);
    known.filter(|_| state.shows_stale())
}

impl Outdated {
    /// Of a document with a stale plan.
    pub(crate) fn of(document: &Document) -> Option<Self> {
        let answer = document.answer.as_ref().filter(|_| document.is_stale())?;
        Some(Self {
            draft: Rc::clone(&document.draft),
            answer: Rc::clone(answer),
            violations: violations(document, answer),
            has_other_rules_only: has_other_rules_only(document, answer),
        })
    }

    /// Whether it is about what is on the board.
    fn is_of(&self, document: &Document) -> bool {
        let answer = document.answer.as_ref();
        let is_it = answer.is_some_and(|answer| Rc::ptr_eq(answer, &self.answer));
        is_it && Rc::ptr_eq(&self.draft, &document.draft) && document.is_stale()
    }

    /// The first time at which a rule is broken.
    pub(crate) fn first_time(&self) -> Option<u32> {
        self.violations.iter().map(|violation| violation.time).min()
    }
}

/// The answer whose plan a rule can be judged by: that of the scene as it is, or a stale one where
/// only rules have changed since.
pub(super) fn judged_by(state: &State) -> Option<&Answer> {
    let stale = || of(state).filter(|it| it.has_other_rules_only);
    let fresh = state.document.fresh_answer().map(Rc::as_ref);
    fresh.or_else(|| stale().map(|it| it.answer.as_ref()))
}

fn has_other_rules_only(document: &Document, answer: &Answer) -> bool {
    let (scene, before) = (document.draft.scene(), answer.draft.scene());
    let rest = Scene {
        zones: before.zones.clone(),
        constraints: before.constraints.clone(),
        ..scene.clone()
    };
    rest == *before && answer.course.is_none()
}

fn violations(document: &Document, answer: &Answer) -> Vec<Violation> {
    let (Some(plan), Ok(instance)) = (answer.plan(), document.draft.instance()) else {
        return Vec::new();
    };
    if !has_other_rules_only(document, answer) {
        return Vec::new();
    }
    let all = check(instance, plan).violations.into_iter();
    all.filter(|violation| violation.broken.is_some()).collect()
}

/// What breaks a rule of the scene, by its index: `broken from 3 to 4 by A1`; nothing where the plan
/// on the board keeps it.
pub(super) fn told(state: &State, rule: usize) -> Option<String> {
    let of_it = |violation: &&Violation| {
        let of = violation.broken.as_ref();
        of.is_some_and(|of| of.index as usize == rule)
    };
    let own: Vec<&Violation> = broken(state).filter(of_it).collect();
    let times: Vec<u32> = set(own.iter().map(|violation| violation.time))
        .into_iter()
        .collect();
    let names = set(own
        .iter()
        .flat_map(|violation| violation.agents.iter().cloned()));
    let names: Vec<String> = names.into_iter().collect();
    (!own.is_empty()).then(|| {
        let (when, who) = (ranges(&times, STRETCHES), and(&names));
        tr!("a rule" => "broken {when} by {who}", when, who)
    })
}

/// That the plan on the board breaks a rule that is newer, as a sentence.
pub(crate) fn sentence(state: &State) -> Option<String> {
    let first = of(state)?.violations.first()?.broken.as_ref()?.index as usize;
    let scene = state.document.draft.scene();
    let rule = scene.constraints.get(first)?.called_among(&scene.agents);
    if rule.chars().count() > LONGEST_SAID {
        // It is red in the list and on the board.
        return Some(
            tr!("This plan breaks a rule that came after it, shown in red. Solve again.")
                .to_owned(),
        );
    }
    Some(tr!(
        "This plan breaks a rule that came after it: {rule}. Solve again.",
        rule
    ))
}
