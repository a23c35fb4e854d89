//! What all best plans have in common with the one on the board, laid
//! over it.

mod cells;
mod column;
mod lanes;
mod lines;
mod part;
mod signs;
mod words;

use std::rc::Rc;

use giveway_course::lesson::Layer;
use giveway_model::{Cell, check, tr};
use giveway_solve::freedom::{Closed, Farthest, FreedomAnswer, FreedomRequest, PlanCount};
use giveway_solve::{Limits, SolveAnswer, Stats, Status};

use crate::{Answer, Document, Draft, State, Task};

pub use cells::{Number, Weight, notes, numbers, pressed};
pub use column::{CellRow, Cells, Column, Late, Other, Row, Section, Ways, column};
pub use lanes::{LaneMarks, Marked, lane, late};
pub use lines::{Lines, lines};
pub use part::{Part, part};
pub(crate) use signs::signs;
pub use words::{TITLE, doing};
pub(crate) use words::{refusal, such_plans};

/// What a person does with it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FreedomAction {
    /// Lays it over the plan, or takes it away.
    Show(bool),
    /// The same to learn about what is selected, which stays selected.
    Ask,
    /// Looks for what is still open.
    GoOn,
    /// Shows the best plan that is farthest from this one, or no longer.
    ShowOther(bool),
    /// Closes a cell for a look.
    Close(Cell),
    /// Opens it again.
    Open,
}

/// What all best plans have in common with one of them, as far as it is known.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Freedom {
    /// The plan that it is about.
    pub(crate) about: Rc<Answer>,
    /// What the solver was asked last.
    pub(crate) request: Rc<FreedomRequest>,
    /// What is known.
    pub(crate) told: Option<Rc<FreedomAnswer>>,
    /// The best plan that is farthest from this one, as the board shows plans.
    pub(crate) other: Option<Rc<Answer>>,
}

/// What is laid over the plan. It is shown where it is of the plan on the board.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Overlay {
    pub(crate) is_on: bool,
    pub(crate) shows_other: bool,
    pub(crate) closed: Option<Rc<ClosedCell>>,
}

/// A cell that is closed for a look.
#[derive(Clone, Debug, PartialEq)]
pub struct ClosedCell {
    /// The cell.
    pub cell: Cell,
    /// What that comes to, as a sentence.
    pub sentence: String,
    /// The scene in which it is closed.
    pub(crate) draft: Rc<Draft>,
    /// The best plan while it was open.
    pub(crate) before: Rc<Answer>,
    /// Whether it is still to be found out what must be so.
    pub(crate) goes_on: bool,
}

impl ClosedCell {
    /// `(5, 2) is closed`.
    pub fn title(&self) -> String {
        tr!("{cell} is closed", cell = crate::words::at(self.cell))
    }
}

impl Freedom {
    /// A request about a plan that is proved to be a best one; `None` without a plan.
    pub(crate) fn about(answer: &Rc<Answer>, limits: Limits) -> Option<Self> {
        let request = Rc::new(FreedomRequest {
            scene: answer.draft.scene().clone(),
            plan: Some(answer.plan()?.clone()),
            objective: answer.request.objective.clone(),
            within: answer.request.within,
            proved: answer.proved_best(),
            parts: Vec::new(),
            count: None,
            limits,
        });
        Some(Self {
            about: Rc::clone(answer),
            request,
            told: None,
            other: None,
        })
    }

    /// The same, to look for what is still open.
    pub(crate) fn going_on(&self, limits: Limits) -> Self {
        let pending = self.told.as_ref().map(|told| told.pending.clone());
        let request = FreedomRequest {
            parts: pending.unwrap_or_default(),
            limits,
            ..(*self.request).clone()
        };
        Self {
            request: Rc::new(request),
            ..self.clone()
        }
    }

    /// Takes in what became known. What was known before stays.
    pub(crate) fn learn(&mut self, mut told: FreedomAnswer) {
        if let Some(before) = &self.told {
            told.backbone = told.backbone.or_else(|| before.backbone.clone());
            told.slack = told.slack.or_else(|| before.slack.clone());
            told.plans = told.plans.or_else(|| before.plans.clone());
            told.farthest = told.farthest.or_else(|| before.farthest.clone());
            match (&mut told.critical, &before.critical) {
                (Some(cells), Some(known)) => {
                    for (cell, known) in cells.iter_mut().zip(known) {
                        if cell.closed.is_open() && !known.closed.is_open() {
                            cell.closed.clone_from(&known.closed);
                        }
                    }
                }
                (None, known) => told.critical.clone_from(known),
                (Some(_), None) => {}
            }
        }
        if let (None, Some(Farthest::Found { plan, .. })) = (&self.other, &told.farthest) {
            self.other = self.as_good(plan);
        }
        self.told = Some(Rc::new(told));
    }

    /// Another best plan, as the board shows plans.
    fn as_good(&self, plan: &giveway_model::Plan) -> Option<Rc<Answer>> {
        let about = &self.about;
        let costs = check::costs(about.draft.instance().ok()?, plan)?;
        let solved = SolveAnswer {
            costs: Some(costs),
            plan: Some(plan.clone()),
            stats: Stats::default(),
            ..about.solved.clone()
        };
        let (draft, request) = (Rc::clone(&about.draft), Rc::clone(&about.request));
        Some(Rc::new(Answer::new(draft, request, solved)))
    }

    /// The robots, by their indices.
    fn names(&self) -> impl Iterator<Item = (usize, &str)> {
        let agents = self.about.draft.agents().iter().enumerate();
        agents.map(|(index, agent)| (index, agent.name.as_str()))
    }

    /// How many best plans there are, as far as they are counted.
    pub(crate) fn count(&self) -> Option<PlanCount> {
        Some(self.told.as_ref()?.plans.as_ref()?.number)
    }

    /// What closing a cell comes to, where that is known and costs something that
    /// could be looked at: nobody starts there, nor must visit it.
    fn closed(&self, cell: Cell) -> Option<&Closed> {
        let mut cells = self.told.as_ref()?.critical.iter().flatten();
        let closed = &cells.find(|it| it.cell == cell)?.closed;
        cells::matters(closed).then_some(closed)
    }
}

impl Document {
    /// What all best plans share, where it is of the plan that there is.
    pub(crate) fn freedom(&self) -> Option<&Rc<Freedom>> {
        let found = self.found_freedom.as_ref()?;
        let is_of = Rc::ptr_eq(&found.about, self.fresh_answer()?);
        is_of.then_some(found)
    }
}

/// What closing a cell comes to, as a sentence; `None` where it cannot be closed for a
/// look.
pub(crate) fn closing(state: &State, cell: Cell) -> Option<String> {
    let freedom = state.freedom()?;
    let closed = freedom.closed(cell)?;
    let outcome = words::outcome(freedom.told.as_deref()?, closed)?;
    let reach = words::reach(closed).map_or_else(String::new, |reach| format!(" {reach}"));
    Some(format!(
        "{}.{reach}",
        giveway_model::words::capital(&outcome)
    ))
}

/// Whether it can be laid over the plan.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Chip {
    /// It cannot, and why.
    Off(&'static str),
    /// It can.
    Ready,
    /// It is.
    On,
}

/// Whether it is offered at all: a step of a lesson may do without it.
pub fn is_offered(state: &State) -> bool {
    let mut lesson = state.lesson().into_iter();
    lesson.all(|lesson| lesson.shows(Layer::Freedom))
}

/// Whether what must be so can be laid over the plan.
pub fn chip(state: &State) -> Chip {
    if state.freedom().is_some() {
        return Chip::On;
    }
    refusal(state).map_or(Chip::Ready, Chip::Off)
}

impl State {
    /// What all best plans share, where that is laid over the plan; the board has other things to
    /// show while one looks into how the plan was found.
    pub(crate) fn freedom(&self) -> Option<&Rc<Freedom>> {
        // Asked of every lane: nothing is compared where nothing is laid over the plan.
        let is_editing = self.document.mode.is_editing();
        let is_hidden = self.is_inside() || self.hides_answers();
        let is_on = self.view.overlay.is_on && is_editing && !is_hidden;
        if is_on { self.document.freedom() } else { None }
    }

    /// Whether it is laid over the plan, and what every best plan has is known: then
    /// that takes the place of the trails.
    pub fn is_laid_over(&self) -> bool {
        let told = self.freedom().and_then(|freedom| freedom.told.as_ref());
        told.is_some_and(|told| told.backbone.is_some())
    }

    /// Whether more of it is being looked for.
    pub(crate) fn is_counting(&self) -> bool {
        matches!(self.work.task(), Some(Task::Freedom(_)))
    }

    /// The best plan that is farthest from this one, where that is shown.
    pub(crate) fn farthest(&self) -> Option<&Rc<Answer>> {
        let freedom = self.freedom()?;
        let other = freedom.other.as_ref();
        other.filter(|_| self.view.overlay.shows_other)
    }

    /// The cell that is closed for a look.
    pub fn closed_cell(&self) -> Option<&ClosedCell> {
        let closed = self.view.overlay.closed.as_deref();
        closed.filter(|closed| Rc::ptr_eq(&closed.draft, &self.document.draft))
    }
}

/// What is claimed of the plan beside.
pub fn claim(state: &State) -> Option<&'static str> {
    if state.farthest().is_some() {
        Some(tr!("as good"))
    } else {
        state.open_before().map(|_| tr!("while the cell was open"))
    }
}

/// Whether nothing is left to look for.
pub(crate) fn is_done(told: &FreedomAnswer) -> bool {
    told.status == Status::Optimal && told.pending.is_empty()
}

/// Whether a plan is proved to be a best one in one world.
fn is_best(answer: &Answer) -> bool {
    answer.solved.status == Status::Optimal && answer.plan().is_some() && answer.course.is_none()
}
