//! Search by hand: a person chooses the node of the conflict tree, the conflict and the robot
//! that a split names. The worker makes each tree anew from all splits so far.

mod board;
mod column;
mod done;
mod ghosts;
mod run;
mod splits;
mod standing;
mod steps;
mod tally;

use std::rc::Rc;

use giveway_solve::plan::ByHand as Asked;

pub use column::{Branch, ConflictRow, HandColumn, RobotRow, column};
pub use done::TallyRow;
pub use steps::StepRow;

pub(crate) use board::{marks, plan, together};
pub(crate) use ghosts::{above, lines, look, sprout};
pub(crate) use run::HandRun;
pub use splits::Splits;
pub(crate) use standing::{Standing, standing};
pub use standing::{dock, has_splits, is_done, status};
pub(crate) use steps::said;

use super::{Method, What};
use crate::{Draft, State};

/// What is chosen of a search by hand.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ByHand {
    /// Whether a person splits; else the planner's tree is shown.
    pub is_on: bool,
    /// Whether the text of a lesson has the place of the column.
    pub reads: bool,
    /// The splits so far, the first of them first.
    pub(crate) splits: Splits,
    /// Splits that were taken back, the last of them last.
    pub(crate) taken_back: Splits,
    /// The node, by its number.
    pub(crate) node: u64,
    /// Which of its conflicts, by time.
    pub(crate) conflict: usize,
    /// Which of the two robots of that conflict.
    pub(crate) robot: usize,
    /// The scene and the horizon of these splits.
    pub(crate) of: Option<(Rc<Draft>, Option<u32>)>,
}

/// What can happen in a search by hand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum HandAction {
    /// A person splits, or the planner's tree is shown.
    Show(bool),
    /// The text of the lesson is shown, or the column of the search.
    Read(bool),
    /// Chooses a conflict of the node, by its place.
    Conflict(usize),
    /// Chooses the first or the second robot of the conflict.
    Robot(usize),
    /// Splits the node.
    Split,
    /// Takes the last split back.
    TakeBack,
    /// Splits again what was taken back.
    Again,
    /// Takes all splits back.
    Restart,
}

impl State {
    /// Whether a person splits the conflict tree.
    pub fn is_by_hand(&self) -> bool {
        self.inside.by_hand.is_on && self.inside.method == Method::Tree && self.is_inside()
    }

    /// Whether the column of a search by hand has the place of the text of a lesson.
    pub fn covers_lesson(&self) -> bool {
        self.is_by_hand() && self.lesson().is_some() && !self.inside.by_hand.reads
    }

    /// Whether the planner's tree can have the place of a search by hand: in a lesson it comes after
    /// one's own, and not before the plan that it ends with is shown.
    pub fn can_show_planners_tree(&self) -> bool {
        self.lesson()
            .is_none_or(|lesson| is_done(self) && !lesson.hides_plan())
    }

    /// What the worker told last of the search by hand.
    pub(crate) fn hand_run(&self) -> Option<&HandRun> {
        let told = self.looked()?.by_hand.as_ref()?;
        told.as_ref().ok().map(Rc::as_ref)
    }

    /// The same, where it is of the splits and the node that are chosen now.
    pub(crate) fn hand_now(&self) -> Option<&HandRun> {
        self.hand_run()
            .filter(|run| run.asked == asked(&self.inside.by_hand))
    }
}

/// What the worker is asked.
pub(crate) fn asked(hand: &ByHand) -> Asked {
    Asked {
        splits: hand.splits.to_vec(),
        node: hand.node,
    }
}

/// What is to be asked next, where a person splits.
#[inline(never)]
pub(crate) fn wanted(state: &State) -> Option<What> {
    let looked = state.looked();
    let told = looked.and_then(|looked| looked.by_hand.as_ref());
    let asked = asked(&state.inside.by_hand);
    let is_known = match told {
        Some(Ok(run)) => run.asked == asked,
        // It is asked again when a person wants that.
        Some(Err(_)) => true,
        None => false,
    };
    if !is_known {
        return Some(What::ByHand(Box::new(asked)));
    }
    // At the end both are compared.
    let is_done = matches!(standing(state), Some(Standing::Proved { .. }));
    let is_told = looked.is_some_and(|looked| looked.tree.is_some());
    (is_done && !is_told).then_some(What::Tree)
}
