//! Plans of elsewhere: what a file's plan is on this scene, whether it is legal,
//! and how good it is.
//!
//! The plan stays as it was written, whatever it breaks. What our own search
//! finds is kept beside it and never takes its place unasked.

pub(crate) mod conflicts;
mod dropped;
mod facts;
mod gap;
mod own;
pub(crate) mod report;
mod rows;
mod seen;
mod verdict;
mod words;

use std::rc::Rc;

use giveway_formats::Conventions;
use giveway_model::{Objective, Scene};

use crate::files::Opened;
use crate::lesson::Lesson;
use crate::{Answer, Draft, State};

pub use conflicts::{Conflicts, conflicts};
pub use dropped::Dropped;
pub(crate) use dropped::unproved;
pub use facts::{Choice, Compared, Facts, PlanRow, facts};
pub(crate) use facts::{Told, told};
pub use own::question;
pub use rows::{CostRow, Fact, ViolationRow};
pub use seen::{ahead, bursts_of};
pub use verdict::Verdict;
pub(crate) use words::{badge, sentence};

/// What a person does with a plan of elsewhere.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AuditAction {
    /// Asks how good the plan on the board is.
    Begin,
    /// Shows a broken rule, by its index: its time and its place.
    Show(usize),
    /// Shows the next broken rule of the robot that is selected, else of all.
    Next,
    /// Looks for a legal plan, or for a better one.
    Find,
    /// Shows another plan beside this one, or no longer.
    Compare(bool),
    /// Where there is no room for two: shows the other plan, or this one again.
    ShowOther(bool),
    /// The other plan becomes the plan of the scene.
    Take,
    /// Another plan of the same files is looked at.
    Choose(usize),
    /// Reads the files again by other conventions.
    ReadAs(Conventions),
    /// Leaves the audit; a legal plan stays.
    Leave,
}

/// A plan of elsewhere on the board, and what is known of it.
#[derive(Clone, Debug, PartialEq)]
pub struct Audit {
    /// The plan that is looked at.
    pub plan: Rc<Dropped>,
    /// All plans of the files, in their order; that one is among them.
    pub plans: Vec<Rc<Dropped>>,
    /// What our own search knows: bounds, and a plan if it found one.
    pub ours: Option<Rc<Answer>>,
    /// What is shown beside it.
    pub beside: Beside,
    /// What a person should know about the scene, each a sentence.
    pub notes: Vec<String>,
    /// The files, to be read again by other conventions; the browser does not
    /// keep them.
    pub files: Rc<Vec<Opened>>,
}

/// What is shown beside the plan.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Beside {
    /// Nothing.
    #[default]
    Nothing,
    /// Another plan; where there is no room for two, this one goes on being shown.
    Other,
    /// Another plan, which takes the place of this one where there is no room.
    InPlace,
}

impl Audit {
    /// The audit of the first of some plans; `None` where there is none.
    pub(crate) fn new(
        plans: Vec<Rc<Dropped>>,
        notes: Vec<String>,
        files: Rc<Vec<Opened>>,
    ) -> Option<Self> {
        Some(Self {
            plan: Rc::clone(plans.first()?),
            plans,
            ours: None,
            beside: Beside::Nothing,
            notes,
            files,
        })
    }

    /// The same plans judged on another draft of the scene, in which only rules or costs are
    /// others; `None` where more is, or the draft is no valid scene.
    pub(crate) fn on(&self, draft: &Rc<Draft>) -> Option<Self> {
        let (old, new) = (self.plan.answer.draft.scene(), draft.scene());
        let same = Scene {
            rules: new.rules,
            objective: new.objective.clone(),
            ..old.clone()
        };
        if same != *new {
            return None;
        }
        let judged = self.plans.iter();
        let judged = judged.map(|plan| Dropped::new(draft, plan.file.clone()).map(Rc::new));
        let plans = judged.collect::<Option<Vec<_>>>()?;
        let mut plan_of = self.plans.iter().zip(&plans);
        let chosen = plan_of.find(|(old, _)| Rc::ptr_eq(old, &self.plan));
        let plan = Rc::clone(chosen.map_or(plans.first()?, |(_, plan)| plan));
        Some(Self {
            plan,
            plans,
            ours: None,
            beside: Beside::Nothing,
            notes: self.notes.clone(),
            files: Rc::clone(&self.files),
        })
    }

    /// The objective of the scene.
    pub(crate) fn objective(&self) -> &Objective {
        &self.plan.answer.draft.scene().objective
    }

    /// The plan that this one can be compared with: another one of the files,
    /// else ours where that is another plan.
    pub fn other(&self) -> Option<&Rc<Answer>> {
        let is_other = |plan: &&Rc<Dropped>| !Rc::ptr_eq(plan, &self.plan);
        let dropped = self.plans.iter().find(is_other).map(|plan| &plan.answer);
        dropped.or_else(|| self.better())
    }

    /// Our plan, where it is better, or legal and this one is not.
    pub fn better(&self) -> Option<&Rc<Answer>> {
        let ours = self.ours.as_ref().filter(|ours| ours.plan().is_some())?;
        if !self.plan.is_legal() {
            return Some(ours);
        }
        let costs = |answer: &Answer| {
            let costs = answer.solved.costs?;
            let objective = self.objective().costs().iter();
            Some(objective.map(|&cost| costs.get(cost)).collect::<Vec<_>>())
        };
        let is_less = costs(ours)? < costs(&self.plan.answer)?;
        is_less.then_some(ours)
    }

    /// The plan that is shown: this one; the other one where that takes its place.
    pub(crate) fn shown(&self, is_alone: bool) -> &Rc<Answer> {
        let is_other = self.beside == Beside::InPlace && is_alone;
        let other = is_other.then(|| self.other()).flatten();
        other.unwrap_or(&self.plan.answer)
    }
}

impl State {
    /// The plan of elsewhere that is on the board, until it is left or the scene
    /// is another one.
    pub fn audit(&self) -> Option<&Rc<Audit>> {
        self.document.mode.audit()
    }

    /// The audit whose plan is the one on the board, not another one in its place.
    pub(crate) fn audited(&self) -> Option<&Rc<Audit>> {
        let audit = self.audit()?;
        if self.lesson().is_some_and(Lesson::hides_conflicts) {
            return None;
        }
        let is_this = self
            .shown()
            .is_some_and(|shown| Rc::ptr_eq(shown, &audit.plan.answer));
        is_this.then_some(audit)
    }
}
