//! A question that was asked, and its answer as far as it is known.

mod found;
mod other;

use std::rc::Rc;

use giveway_model::check::Violation;
use giveway_model::{Cell, Objective, Question};
use giveway_proof::Report;
use giveway_solve::Limits;
use giveway_solve::explain::{Class, ExplainAnswer, ExplainRequest, Verdict};

use crate::Answer;
use crate::ask::layers;
use crate::changing::Changing;

pub(crate) use found::Found;
pub use found::found_better;

/// A question with its answer so far.
#[derive(Clone, Debug, PartialEq)]
pub struct Asking {
    /// What the solver was asked.
    pub request: Rc<ExplainRequest>,
    /// The plan that is asked about, or that there is none.
    pub about: Rc<Answer>,
    /// What is known; nothing before the verdict.
    pub told: Option<Rc<ExplainAnswer>>,
    /// The other plan, as the board shows plans.
    pub other: Option<Rc<Answer>>,
    /// The variation that is the other plan, by its place among those of the answer; `None`: the
    /// best other plan that is known.
    pub(crate) chosen: Option<usize>,
    /// Whether the other plan is shown: beside this one, or in its place where there is no room
    /// for two.
    pub shows_other: bool,
    /// The time that was shown before the other plan was opened.
    pub(crate) time_before: Option<u32>,
    /// The fact or the collision that is lit up on the map.
    pub lit: Option<Lit>,
    /// Whether all robots that differ have a row, not only those that lose most.
    pub is_unfolded: bool,
    /// Whether no group of facts is open.
    pub(crate) folds_groups: bool,
    /// What came of checking its proof.
    pub report: Option<Rc<Report>>,
}

/// What is lit up on the map.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Lit {
    /// A thing that would go wrong, by its index.
    Witness(usize),
    /// A fact of the minimal sets, by its index among the facts of all of them.
    Fact(usize),
    /// A group of facts of the first set, by its index.
    Group(usize),
    /// A robot that pays or gains, by its index.
    Robot(usize),
    /// A cell that a sentence names.
    Cell(Cell),
}

impl Asking {
    /// Why there is no way to go on where the world changes.
    pub(crate) fn stuck(changing: &Changing, limits: Limits) -> Self {
        let mut asking = Self::about(&changing.about, Question::Unsolvable, limits);
        let request = Rc::make_mut(&mut asking.request);
        request.changes = Some(changing.changes());
        asking
    }

    /// A question about an answer that was just asked.
    pub(crate) fn about(answer: &Rc<Answer>, question: Question, limits: Limits) -> Self {
        let request = Rc::new(ExplainRequest {
            scene: answer.draft.scene().clone(),
            plan: answer.plan().cloned(),
            changes: answer.course.as_ref().map(|course| course.changes.clone()),
            at: None,
            layers: layers(&question),
            question,
            objective: answer.request.objective.clone(),
            within: answer.request.within,
            proved: answer.proved_best(),
            known: None,
            limits,
        });
        Self::new(request, Rc::clone(answer))
    }

    /// A question that was just asked.
    const fn new(request: Rc<ExplainRequest>, about: Rc<Answer>) -> Self {
        Self {
            request,
            about,
            told: None,
            other: None,
            chosen: None,
            shows_other: false,
            time_before: None,
            lit: None,
            is_unfolded: false,
            folds_groups: false,
            report: None,
        }
    }

    /// The other plan, where it takes the place of this one.
    pub(crate) fn in_place(&self, is_alone: bool) -> Option<&Rc<Answer>> {
        let shows = self.shows_other && is_alone;
        self.other.as_ref().filter(|_| shows)
    }

    /// Whether its repairs can be made: those of a world that has changed are for
    /// that world, not for the scene.
    pub(crate) fn can_be_repaired(&self) -> bool {
        self.about.course.is_none()
    }

    /// The costs by which plans are compared, the most important first.
    pub(crate) fn objective(&self) -> &Objective {
        let asked = self.request.objective.as_ref();
        asked.unwrap_or(&self.about.draft.scene().objective)
    }

    /// The question.
    pub fn question(&self) -> &Question {
        &self.request.question
    }

    /// What would go wrong, or does so in a person's own plan.
    pub(crate) fn violations(&self) -> impl Iterator<Item = (Option<Class>, &Violation)> {
        let told = self.told.as_deref();
        let would = told.into_iter().flat_map(|told| &told.witness);
        let does = told.into_iter().flat_map(|told| &told.violations).flatten();
        let would = would.map(|entry| (entry.class, &entry.violation));
        would.chain(does.map(|violation| (None, violation)))
    }

    /// Takes in what became known. What stands is never taken back: neither parts that a search
    /// before this one found, nor a cheaper other plan.
    pub(crate) fn learn(&mut self, mut told: ExplainAnswer) {
        if let Some(known) = self.told.as_deref() {
            if parts_known(known) > parts_known(&told) {
                return;
            }
            if told.verdict == Verdict::Unknown && self.is_cheaper(known, &told) {
                told.alternative.clone_from(&known.alternative);
                told.costs = known.costs;
                told.deltas.clone_from(&known.deltas);
                told.pays.clone_from(&known.pays);
            }
        }
        let known = self.told.as_deref();
        let is_new =
            known.and_then(|known| known.alternative.as_ref()) != told.alternative.as_ref();
        let chosen = self.variation().cloned();
        self.chosen = chosen.and_then(|chosen| {
            let mut all = told.near.iter().flat_map(|near| &near.variations);
            all.position(|it| *it == chosen)
        });
        if is_new && self.chosen.is_none() {
            self.other = self.best_other(&told);
            self.shows_other &= self.other.is_some();
        }
        self.told = Some(Rc::new(told));
    }

    /// Whether the other plan of the first answer costs less.
    fn is_cheaper(&self, one: &ExplainAnswer, other: &ExplainAnswer) -> bool {
        let value = |answer: &ExplainAnswer| {
            let costs = answer.costs.filter(|_| answer.alternative.is_some())?;
            let objective = self.objective().costs().iter();
            Some(objective.map(|&cost| costs.get(cost)).collect::<Vec<u32>>())
        };
        match (value(one), value(other)) {
            (Some(one), Some(other)) => one < other,
            (one, None) => one.is_some(),
            (None, Some(_)) => false,
        }
    }
}

/// How much stands of an answer: with a verdict all parts that are there; without one, whether what
/// the plan shows and what is near it are there.
fn parts_known(told: &ExplainAnswer) -> (bool, usize) {
    let nearby = usize::from(told.here.is_some()) + usize::from(told.near.is_some());
    match told.verdict {
        Verdict::Unknown => (false, nearby),
        Verdict::Needless | Verdict::Improvable | Verdict::Costly | Verdict::Necessary => {
            (true, usize::MAX - told.pending.len())
        }
    }
}
