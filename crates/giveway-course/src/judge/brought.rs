//! Boards that come from the steps before.
//!
//! A step without a scene and a plan of its own goes on with the board as it was edited.
//! Whoever judges later has only that board: it counts where the tools of the steps
//! before can make it of the lesson's own scene.

use giveway_model::Scene;

use super::{Situation, Why, edits};
use crate::lesson::{Lesson, Step};

/// Why a board is none with which a step can begin.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Outsider {
    /// There is no such step.
    NoStep,
    /// The step has a scene or a plan of its own, or the board is no instance, or a robot
    /// is missing that the step may name.
    Own,
    /// The steps before do not allow it.
    Edits(Why),
}

/// Whether a step can begin with a board that the steps before may have left.
///
/// # Errors
/// Why it cannot.
pub(crate) fn may_bring(lesson: &Lesson, step: usize, board: &Scene) -> Result<(), Outsider> {
    let start = lesson.scene(step).ok_or(Outsider::NoStep)?;
    if board == start {
        return Ok(());
    }
    if !lesson.goes_on_with(step, board) {
        return Err(Outsider::Own);
    }
    let steps = lesson.steps.get(..step).ok_or(Outsider::NoStep)?;
    let own = steps.iter().rposition(|step| step.scene.is_some());
    let before = steps.get(own.unwrap_or(0)..).unwrap_or_default();
    let together = together(before);
    let situation = Situation {
        step: &together,
        start,
        scene: board,
    };
    edits::allowed(situation).map(drop).map_err(Outsider::Edits)
}

/// A step with all that some steps allow: their tools, their edits, their cells.
fn together(steps: &[Step]) -> Step {
    let edited = || steps.iter().filter(|step| !step.tools.is_empty());
    let mut edits = edited().map(|step| step.edits);
    let mut cells = edited().map(|step| step.cells.as_ref());
    Step {
        tools: edited().flat_map(|step| step.tools.clone()).collect(),
        edits: edits.try_fold(0_u32, |sum, edits| Some(sum.saturating_add(edits?))),
        cells: cells.try_fold(Vec::new(), |mut all, cells| {
            all.extend(cells?);
            Some(all)
        }),
        ..Step::default()
    }
}
