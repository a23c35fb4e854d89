//! What is being done with the plan, and the question that is asked meanwhile.

use std::rc::Rc;

use crate::Asking;
use crate::audit::Audit;
use crate::changing::{Changing, Comparing};
use crate::steering::Steering;

/// What is being done with the plan: one thing at a time.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Activity {
    /// The scene is edited, or its plan watched.
    #[default]
    Editing,
    /// The world changes while the plan runs: the changes are being listed.
    Changing(Rc<Changing>),
    /// New plans after the changes are side by side, or none was found.
    Comparing(Rc<Comparing>),
    /// Agents are led by hand, in a plan of one's own.
    Steering(Rc<Steering>),
    /// A plan of elsewhere is judged.
    Auditing(Rc<Audit>),
}

/// An activity, and the question that was asked about its plan.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mode {
    /// What is being done.
    pub activity: Activity,
    /// The question, until it is closed.
    pub(crate) question: Option<Rc<Asking>>,
}

impl From<Activity> for Mode {
    /// Nothing is asked yet.
    fn from(activity: Activity) -> Self {
        Self {
            activity,
            question: None,
        }
    }
}

impl Mode {
    /// The same activity with a question.
    #[must_use]
    pub(crate) fn with(&self, question: Option<Rc<Asking>>) -> Self {
        Self {
            activity: self.activity.clone(),
            question,
        }
    }

    /// Whether the scene is edited and nothing is asked.
    pub const fn is_editing(&self) -> bool {
        matches!(self.activity, Activity::Editing) && self.question.is_none()
    }

    /// The question that was asked, until it is closed.
    pub const fn asking(&self) -> Option<&Rc<Asking>> {
        self.question.as_ref()
    }

    /// The question, to be changed.
    pub(crate) fn asking_mut(&mut self) -> Option<&mut Asking> {
        self.question.as_mut().map(Rc::make_mut)
    }

    /// The plan of elsewhere, until it is left.
    pub const fn audit(&self) -> Option<&Rc<Audit>> {
        match &self.activity {
            Activity::Auditing(audit) => Some(audit),
            Activity::Editing
            | Activity::Changing(_)
            | Activity::Comparing(_)
            | Activity::Steering(_) => None,
        }
    }

    /// What changes in the world, until that is adopted or left.
    pub fn changing(&self) -> Option<&Rc<Changing>> {
        match &self.activity {
            Activity::Changing(changing) => Some(changing),
            Activity::Comparing(comparing) => Some(&comparing.changing),
            Activity::Editing | Activity::Steering(_) | Activity::Auditing(_) => None,
        }
    }

    /// The new plans after the changes, where they are known.
    pub const fn comparing(&self) -> Option<&Rc<Comparing>> {
        match &self.activity {
            Activity::Comparing(comparing) => Some(comparing),
            Activity::Editing
            | Activity::Changing(_)
            | Activity::Steering(_)
            | Activity::Auditing(_) => None,
        }
    }

    /// The plan of one's own in which agents are led by hand, until it is left.
    pub const fn steering(&self) -> Option<&Rc<Steering>> {
        match &self.activity {
            Activity::Steering(own) => Some(own),
            Activity::Editing
            | Activity::Changing(_)
            | Activity::Comparing(_)
            | Activity::Auditing(_) => None,
        }
    }

    /// Whether another mode holds the same objects, which takes no time to see.
    pub(crate) fn is_same(&self, other: &Self) -> bool {
        let is_same_question = match (&self.question, &other.question) {
            (Some(one), Some(two)) => Rc::ptr_eq(one, two),
            (None, None) => true,
            (Some(_), None) | (None, Some(_)) => false,
        };
        let is_same_activity = match (&self.activity, &other.activity) {
            (Activity::Editing, Activity::Editing) => true,
            (Activity::Changing(one), Activity::Changing(two)) => Rc::ptr_eq(one, two),
            (Activity::Comparing(one), Activity::Comparing(two)) => Rc::ptr_eq(one, two),
            (Activity::Steering(one), Activity::Steering(two)) => Rc::ptr_eq(one, two),
            (Activity::Auditing(one), Activity::Auditing(two)) => Rc::ptr_eq(one, two),
            (
                Activity::Editing
                | Activity::Changing(_)
                | Activity::Comparing(_)
                | Activity::Steering(_)
                | Activity::Auditing(_),
                _,
            ) => false,
        };
        is_same_question && is_same_activity
    }
}
