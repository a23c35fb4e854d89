//! The work of a student that is looked at, and its board.

use giveway_course::grade::{Filed, Given, Graded, Judgement};
use giveway_course::handin::Shown;
use giveway_course::lesson::{Layer, Step};
use giveway_course::port::{Board, BoardPlan, Evidence, Hand};

use super::{BOARD, Collected};

/// A task of a hand-in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::course) struct Chosen {
    /// The file, by its place.
    pub(super) file: usize,
    /// The task, by its place in the file's list.
    pub(super) task: usize,
}

/// A task of a hand-in with all that belongs to it.
pub(super) struct Looked<'a> {
    pub(super) file: &'a Filed,
    pub(super) given: &'a Given,
    pub(super) graded: &'a Graded,
    /// The step; none where the lesson has no such step.
    pub(super) step: Option<&'a Step>,
}

impl Collected {
    /// A task of a hand-in; `None` where there is no such.
    pub(super) fn looked(&self, chosen: Chosen) -> Option<Looked<'_>> {
        let file = self.class.files().get(chosen.file)?;
        let given = self.class.lessons().get(file.lesson()?)?;
        let graded = file.tasks().get(chosen.task)?;
        Some(Looked {
            step: given.lesson.steps.get(graded.step),
            file,
            given,
            graded,
        })
    }

    /// What the board shows of a task: the work, else what the step begins with.
    pub(super) fn board(&self, chosen: Chosen) -> Option<(Board, Option<Evidence>)> {
        let looked = self.looked(chosen)?;
        let lesson = &looked.given.lesson;
        let step = looked.step?;
        let work = looked.graded.work.as_ref();
        let shown = work.and_then(|work| Shown::of(work, lesson).ok());
        let (scene, plan) = match shown {
            Some(shown) => (shown.scene, shown.plan),
            None => (lesson.scene(looked.graded.step)?.clone(), step.plan.clone()),
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
        let verdict = looked.graded.judgement().and_then(Judgement::verdict);
        let evidence = verdict.map(|verdict| verdict.evidence.clone());
        // A better plan is none that the student made.
        let evidence = evidence.filter(|it| !it.is_empty() && it.plan.is_none());
        Some((board, evidence))
    }

    /// All tasks that are not solved, row by row, and the one after what is chosen, or before
    /// it; from one end it goes on at the other.
    pub(super) fn to_look_at(&self, on: bool) -> Option<Chosen> {
        let all = self.all();
        let at = self
            .chosen
            .and_then(|chosen| all.iter().position(|it| *it == chosen));
        let count = all.len();
        let places: Vec<usize> = match (at, on) {
            (Some(at), true) => (1..count).map(|n| (at + n) % count).collect(),
            (Some(at), false) => (1..count).map(|n| (at + count - n) % count).collect(),
            (None, true) => (0..count).collect(),
            (None, false) => (0..count).rev().collect(),
        };
        let places = places.into_iter().filter_map(|place| all.get(place));
        let mut open = places.filter(|chosen| {
            let looked = self.looked(**chosen);
            looked.is_some_and(|it| it.graded.work.is_some() && !it.graded.is_solved())
        });
        open.next().copied()
    }

    /// All tasks of the table, row by row.
    fn all(&self) -> Vec<Chosen> {
        let rows = self.class.rows(self.lesson(), self.order);
        let rows = rows.iter().map(|row| (row.place(), row.tasks().len()));
        rows.flat_map(|(file, tasks)| (0..tasks).map(move |task| Chosen { file, task }))
            .collect()
    }

    /// The lesson whose table is shown, by its place: the first of which there is anything,
    /// where none was chosen.
    pub(super) fn lesson(&self) -> usize {
        let tables = self.class.tables();
        let chosen = tables.iter().find(|lesson| **lesson == self.lesson);
        chosen.or(tables.first()).copied().unwrap_or_default()
    }
}
