//! The board that shows a student's work.

use giveway_course::grade::Judgement;
use giveway_course::lesson::Layer;
use giveway_course::port::{Board, BoardPlan, Evidence, Hand};

use super::{BOARD, Collected};

impl Collected {
    /// What the board shows of a task: the work, else what the step begins with.
    pub(super) fn board(&self) -> Option<(Board, Option<Evidence>)> {
        let (row, task) = self.looking.task(&self.class)?;
        let given = self.class.lessons().get(row.file().lesson()?)?;
        let step = given.lesson.steps.get(task.step)?;
        let (scene, plan) = match self.looking.shown(&self.class) {
            Some(shown) => (shown.scene, shown.plan),
            None => (given.lesson.scene(task.step)?.clone(), step.plan.clone()),
        };
        let board = Board {
            number: BOARD,
            scene,
            plan: plan.map_or(BoardPlan::None, BoardPlan::Given),
            changes: step.changes().cloned(),
            time: 0,
            playing: false,
            tools: Vec::new(),
            edits: None,
            cells: None,
            show: vec![Layer::Trails, Layer::Lanes],
            hand: Hand::Looks,
        };
        let verdict = task.judgement().and_then(Judgement::verdict);
        let evidence = verdict.map(|verdict| verdict.evidence.clone());
        // A better plan is none that the student made.
        let evidence = evidence.filter(|it| !it.is_empty() && it.plan.is_none());
        Some((board, evidence))
    }
}
