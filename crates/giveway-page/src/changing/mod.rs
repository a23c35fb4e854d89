//! The world changes while a plan runs: what a person lists, the world with it,
//! and what the methods make of it.
//!
//! The past is frozen: it can be looked at, and every change is one of the time
//! at which the world changes.

mod breakdown;
mod columns;
mod compared;
mod entries;
mod facts;
mod list;
mod listed;
mod meets;
mod offers;
mod stopped;
mod travelled;

use std::rc::Rc;

use giveway_model::change::{Change, Changes, ConstraintRef, History, What};
use giveway_model::{Fault, Version};
use giveway_solve::Limits;
use giveway_solve::change::{ChangeRequest, Method};

use crate::course::World;
use crate::{Answer, Draft, Settings, State};

pub use breakdown::{Blank, Breakdown, Filled, Piece};
pub use columns::{Column, CostChange, Fix, Group, columns, fixes};
pub use compared::{Comparing, Tried};
pub(crate) use entries::in_words;
pub(crate) use facts::count;
pub use facts::{Facts, Listed, Past, facts, fate, history};
pub(crate) use meets::inside;
pub use offers::{Offers, offers};
pub use stopped::Stopped;
pub(crate) use stopped::{stopped, stopped_in_words};
pub(crate) use travelled::travelled;

/// The world changes at a time, and this is how.
#[derive(Clone, Debug, PartialEq)]
pub struct Changing {
    /// The time, in steps.
    pub at: u32,
    /// The plan that runs.
    pub about: Rc<Answer>,
    /// What changes, in the order in which it was listed.
    pub list: Vec<What>,
    /// The world from that time on.
    pub world: World,
    /// The world before, over time.
    history: Rc<History>,
}

/// The methods to try.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Choice {
    /// Whether old agents keep their cells.
    pub revise: bool,
    /// Whether old agents keep near their paths.
    pub tunnel: bool,
    /// How near, in steps.
    pub width: u32,
    /// Whether everyone plans freely.
    pub replan: bool,
}

/// The robots that have broken down for good up to the time shown, and stay where they are.
pub fn broken_down_for_good(state: &State) -> Vec<Stopped> {
    let changed = |answer: &Rc<Answer>| answer.course.is_some();
    if state.document.mode.changing().is_some() || state.shown().is_some_and(changed) {
        stopped::of_changes(state)
    } else {
        Vec::new()
    }
}

/// The widest tunnel that can be chosen, in steps.
pub const WIDEST: u32 = 99;

impl Default for Choice {
    fn default() -> Self {
        Self {
            revise: true,
            tunnel: true,
            width: 1,
            replan: true,
        }
    }
}

impl Choice {
    /// The methods, the closest to the old plan first.
    ///
    /// ```
    /// use giveway_page::changing::Choice;
    /// let names: Vec<String> = Choice::default().methods().iter().map(ToString::to_string).collect();
    /// assert_eq!(names, ["revise", "tunnel=1", "replan"]);
    /// ```
    pub fn methods(self) -> Vec<Method> {
        let all = [
            (self.revise, Method::Revise),
            (self.tunnel, Method::Tunnel(self.width)),
            (self.replan, Method::Replan),
        ];
        all.into_iter()
            .filter_map(|(on, method)| on.then_some(method))
            .collect()
    }
}

impl Changing {
    /// Nothing changes yet, at a time of a plan; `None` where the answer is none,
    /// or where the world has changed then or later already.
    pub(crate) fn begin(about: &Rc<Answer>, at: u32) -> Option<Self> {
        about.plan()?;
        if about.changed_last().is_some_and(|last| at <= last) {
            return None;
        }
        let history = match &about.course {
            Some(course) => course.history.clone(),
            None => History::new(about.draft.instance().ok()?),
        };
        Some(Self {
            at,
            about: Rc::clone(about),
            list: Vec::new(),
            world: World::of(&history, about.draft.scene(), at),
            history: Rc::new(history),
        })
    }

    /// Changes of a file, at the first of their times, around a plan that does not know of
    /// them; `None` where there is none, or where what is at that time is settled.
    ///
    /// # Errors
    /// How they contradict the world.
    pub(crate) fn of_file(
        about: &Rc<Answer>,
        changes: &Changes,
    ) -> Result<Option<Self>, Vec<Fault>> {
        let by_time = changes.by_time();
        let Some((at, first)) = by_time.first() else {
            return Ok(None);
        };
        let list = first.iter().map(|(_, change)| change.what.clone());
        let begun = Self::begin(about, *at);
        begun.map(|begun| begun.with(list.collect())).transpose()
    }

    /// The same with another list of changes.
    ///
    /// # Errors
    /// How they contradict the world.
    pub(crate) fn with(&self, list: Vec<What>) -> Result<Self, Vec<Fault>> {
        let changes: Vec<Change> = list.iter().map(|what| self.change(what)).collect();
        let numbered: Vec<(usize, &Change)> = changes.iter().enumerate().collect();
        let mut after = History::clone(&self.history);
        if let (Some(plan), false) = (self.about.plan(), list.is_empty()) {
            after.apply(self.at, &numbered, plan)?;
        }
        Ok(Self {
            list,
            world: World::of(&after, self.about.draft.scene(), self.at),
            ..self.clone()
        })
    }

    /// Whether a rule of the scene, by its index, is removed from now on.
    pub(crate) fn removes_rule(&self, rule: usize) -> bool {
        self.list.iter().any(|what| {
            matches!(what, What::RemoveConstraint { constraint: ConstraintRef::Index(of) } if *of as usize == rule)
        })
    }

    fn change(&self, what: &What) -> Change {
        Change {
            at: self.at,
            what: what.clone(),
        }
    }

    /// What is listed.
    pub(crate) fn listed(&self) -> Changes {
        Changes {
            giveway: Version,
            changes: self.list.iter().map(|what| self.change(what)).collect(),
        }
    }

    /// All that changed before, and what is listed.
    pub(crate) fn changes(&self) -> Changes {
        let course = self.about.course.as_deref();
        let before = course.map_or(&[][..], |course| &course.changes.changes);
        let listed = self.listed().changes;
        Changes {
            giveway: Version,
            changes: before.iter().cloned().chain(listed).collect(),
        }
    }

    /// What the solver is asked.
    pub(crate) fn request(
        &self,
        settings: &Settings,
        within: Option<u32>,
    ) -> Option<ChangeRequest> {
        Some(ChangeRequest {
            scene: self.about.draft.scene().clone(),
            plan: self.about.plan()?.clone(),
            changes: self.changes(),
            since: Some(self.at),
            methods: settings.methods.methods(),
            objective: self.about.request.objective.clone(),
            within,
            limits: Limits {
                seconds: Some(f64::from(settings.seconds)),
                ..Limits::default()
            },
        })
    }

    /// The world at a time, where it is another than the draft: what comes later
    /// than the change is not known before a method has answered.
    pub(crate) fn world_at(&self, time: u32) -> Option<&World> {
        if time < self.at {
            return self.about.world(time);
        }
        Some(&self.world)
    }

    /// The draft of the world from the change on.
    pub fn draft(&self) -> &Rc<Draft> {
        &self.world.draft
    }

    /// The agent of a name that was used by nobody yet.
    pub(crate) fn fresh_name(&self) -> String {
        crate::edit::fresh_name(self.world.draft.scene())
    }
}
