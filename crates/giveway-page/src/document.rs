//! All that a person made or got and would miss.

use std::rc::Rc;

use giveway_model::{Agent, Plan};
use giveway_proof::Report;
use giveway_solve::SolveAnswer;

use crate::course::World;
use crate::freedom::Freedom;
use crate::front::Front;
use crate::ledger::Ledger;
use crate::order::OrderKnown;
use crate::planners::Runs;
use crate::rules::Pricing;
use crate::{Activity, Answer, Asking, Colours, Draft, Looks, Mode};

/// All that a person made or got and would miss. Undo, what the browser keeps,
/// and links hold whole documents. Its parts are never changed, only replaced, so
/// that a copy of it costs next to nothing.
#[derive(Clone, Debug, PartialEq)]
pub struct Document {
    /// The scene on the board.
    pub draft: Rc<Draft>,
    /// The horizon in time steps: only plans of at most this makespan count;
    /// `None` leaves it to the solver.
    pub within: Option<u32>,
    /// The last answer; it may be of an older draft, see
    /// [`Document::is_stale`].
    pub answer: Option<Rc<Answer>>,
    /// The Pareto front that was found last; it may be of an older draft, see
    /// [`Document::front`].
    pub(crate) found_front: Option<Rc<Front>>,
    /// What planners came to; it may be of an older draft, see [`Runs::of`].
    pub(crate) found_plans: Option<Rc<Runs>>,
    /// What came of checking the proof of an answer; it may be of an older
    /// answer, see [`Document::report`].
    pub(crate) checked: Option<(Rc<Answer>, Rc<Report>)>,
    /// What all best plans have in common; it may be of an older answer, see
    /// [`Document::freedom`].
    pub(crate) found_freedom: Option<Rc<Freedom>>,
    /// What the rules cost; it may be of an older draft, see [`Document::prices`].
    pub(crate) found_prices: Option<Rc<Pricing>>,
    /// Who costs whom; it may be of an older answer, see [`Document::ledger`].
    pub(crate) found_ledger: Option<Rc<Ledger>>,
    /// Who passes a cell after whom; it may be of an older answer, see [`Document::order`].
    pub(crate) found_order: Option<Rc<OrderKnown>>,
    /// The questions that were answered, in the order in which they were asked; a report tells them.
    pub(crate) asked: Rc<Vec<Rc<Asking>>>,
    /// What is being done with the plan.
    pub mode: Mode,
    /// Which look each agent has: its form, and the colour that comes with it.
    pub looks: Looks,
    /// The colour of each look.
    pub colours: Colours,
}

impl Document {
    /// A scene and nothing else yet.
    pub fn new(draft: impl Into<Rc<Draft>>) -> Self {
        Self {
            draft: draft.into(),
            within: None,
            answer: None,
            found_front: None,
            found_plans: None,
            checked: None,
            found_freedom: None,
            found_prices: None,
            found_ledger: None,
            found_order: None,
            asked: Rc::default(),
            mode: Mode::default(),
            looks: Looks::default(),
            colours: Colours::default(),
        }
    }

    /// A scene with an answer to it.
    pub(crate) fn answered(draft: Rc<Draft>, answer: Option<Rc<Answer>>) -> Self {
        Self {
            answer,
            ..Self::new(draft)
        }
    }

    /// Whether the answer is of another draft than the one on the board.
    pub fn is_stale(&self) -> bool {
        self.answer
            .as_ref()
            .is_some_and(|answer| !same(&answer.draft, &self.draft))
    }

    /// The answer, where it is of the draft on the board.
    pub fn fresh_answer(&self) -> Option<&Rc<Answer>> {
        self.answer.as_ref().filter(|_| !self.is_stale())
    }

    /// The last time at which the world changed around the plan of the draft on the
    /// board; `None` where it did not.
    pub(crate) fn changed_last(&self) -> Option<u32> {
        self.fresh_answer()?.changed_last()
    }

    /// The front of the draft on the board, if one was found; not while the
    /// world changes or after it has, which is about one plan.
    pub fn front(&self) -> Option<&Front> {
        let front = self.found_front.as_deref();
        let is_one_world = self.mode.changing().is_none() && self.changed_last().is_none();
        let front = front.filter(|_| is_one_world);
        front.filter(|front| same(&front.draft, &self.draft))
    }

    /// The front that the plan is a point of.
    pub(crate) fn own_front(&self) -> Option<&Front> {
        let answer = self.answer.as_ref()?;
        let front = self.front();
        front.filter(|front| front.place_of(answer).is_some())
    }

    /// What came of checking the proof of the answer, if that was done.
    pub fn report(&self) -> Option<&Report> {
        let (answer, report) = self.checked.as_ref()?;
        let is_of = self.answer.as_ref().is_some_and(|a| Rc::ptr_eq(a, answer));
        is_of.then_some(report)
    }

    /// The answer that is shown: the last one, or a plan of one's own; the other
    /// plan of a question where that takes its place (`is_alone`: there is no
    /// room for two); the one that is previewed where the world changes.
    pub(crate) fn shown(&self, is_alone: bool) -> Option<&Rc<Answer>> {
        let asking = self.mode.asking();
        let other = asking.and_then(|asking| asking.in_place(is_alone));
        match &self.mode.activity {
            Activity::Editing => other.or(self.answer.as_ref()),
            Activity::Changing(changing) => Some(&changing.about),
            // What is asked there is why none was found: that has no other plan.
            Activity::Comparing(comparing) => {
                Some(comparing.preview().unwrap_or(&comparing.changing.about))
            }
            Activity::Steering(own) => Some(other.unwrap_or(&own.answer)),
            Activity::Auditing(audit) if asking.is_some() => {
                Some(other.unwrap_or(&audit.plan.answer))
            }
            Activity::Auditing(audit) => Some(audit.shown(is_alone)),
        }
    }

    /// The world at a time, where it is another than the draft: the world changes
    /// or has changed.
    pub(crate) fn changed(&self, time: u32) -> Option<&World> {
        match &self.mode.activity {
            Activity::Changing(changing) => changing.world_at(time),
            Activity::Comparing(comparing) => comparing.world_at(time),
            Activity::Editing | Activity::Steering(_) | Activity::Auditing(_) => {
                self.fresh_answer()?.world(time)
            }
        }
    }

    /// The document with more proved of its answer. Everything that was about the answer is about
    /// the new one.
    pub(crate) fn with_more_proved(mut self, solved: SolveAnswer) -> Self {
        let Some(before) = self.answer.take() else {
            return self;
        };
        let answer = Rc::new(Answer {
            solved,
            ..(*before).clone()
        });
        let turn = |about: &mut Rc<Answer>| {
            if Rc::ptr_eq(about, &before) {
                *about = Rc::clone(&answer);
            }
        };
        if let Some((about, _)) = &mut self.checked {
            turn(about);
        }
        if let Some(ledger) = &mut self.found_ledger {
            turn(&mut Rc::make_mut(ledger).about);
        }
        if let Some(order) = &mut self.found_order {
            turn(&mut Rc::make_mut(order).about);
        }
        for asking in Rc::make_mut(&mut self.asked) {
            turn(&mut Rc::make_mut(asking).about);
        }
        self.answer = Some(answer);
        self
    }

    /// The agents of the scene.
    pub fn agents(&self) -> &[Agent] {
        self.draft.agents()
    }

    /// The plan of the draft on the board.
    pub fn plan(&self) -> Option<&Plan> {
        self.fresh_answer()?.plan()
    }
}

/// Whether two drafts are equal; the usual case, one draft twice, takes no time.
fn same(a: &Rc<Draft>, b: &Rc<Draft>) -> bool {
    Rc::ptr_eq(a, b) || a == b
}
