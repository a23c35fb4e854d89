//! A question that was asked, and its answer as far as it is known.

use std::rc::Rc;

use giveway_model::check::Violation;
use giveway_model::{Cost, Objective, Question};
use giveway_proof::Report;
use giveway_solve::explain::{Class, ExplainAnswer, ExplainRequest};
use giveway_solve::{Limits, Reason, SolveAnswer, Stats, Status};

use crate::Answer;
use crate::changing::Changing;

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
    /// Whether the other plan is shown: beside this one, or in its place where there is no room
    /// for two.
    pub shows_other: bool,
    /// The time that was shown before the other plan was opened.
    pub(crate) time_before: Option<u32>,
    /// The fact or the collision that is lit up on the map.
    pub lit: Option<Lit>,
    /// Whether all robots that differ have a row, not only those that lose most.
    pub is_unfolded: bool,
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
    /// A robot that pays or gains, by its index.
    Robot(usize),
}

/// Questions.
#[derive(Clone, Debug, PartialEq)]
pub enum AskAction {
    /// Ask a question about the plan that is shown.
    Ask(Question),
    /// Ask the question again whose answer was cut off.
    Again,
    /// Leave the question.
    Close,
    /// Show the other plan, or this one again.
    ShowOther(bool),
    /// Light something of the answer up on the map.
    Light(Option<Lit>),
    /// Give each robot that differs a row.
    Unfold,
    /// Make the other plan the plan.
    TakeOther,
    /// Make the edits of a repair, by its index.
    TakeRepair(usize),
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
            question,
            objective: answer.request.objective.clone(),
            within: answer.request.within,
            layers: Vec::new(),
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
            shows_other: false,
            time_before: None,
            lit: None,
            is_unfolded: false,
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

    /// Takes in what became known.
    pub(crate) fn learn(&mut self, told: ExplainAnswer) {
        let plan = |answer: &ExplainAnswer| answer.alternative.clone();
        if self.told.as_deref().and_then(plan) != told.alternative {
            self.other = self.plan_of(&told);
            self.shows_other &= self.other.is_some();
        }
        self.told = Some(Rc::new(told));
    }

    /// The other plan, with what is known of it: it is as good as proved where
    /// it costs what a proved plan costs, or as little as is proved of all plans.
    fn plan_of(&self, told: &ExplainAnswer) -> Option<Rc<Answer>> {
        let (plan, costs) = (told.alternative.clone()?, told.costs?);
        let solved = &self.about.solved;
        let is_equal = told.deltas.values().all(|&delta| delta == 0);
        let objective = self.objective();
        let is_least = |cost: &Cost| solved.bounds.get(cost) == Some(&costs.get(*cost));
        let is_least = objective.costs().iter().all(is_least);
        let status = match solved.status {
            Status::Optimal if is_equal => Status::Optimal,
            _ if is_least => Status::Optimal,
            _ => Status::Feasible,
        };
        let answer = SolveAnswer {
            status,
            costs: Some(costs),
            plan: Some(plan),
            ended: None,
            // It was asked for, not searched for: where the best plan is known, this is not it.
            reason: (solved.status == Status::Optimal && status == Status::Feasible)
                .then_some(Reason::Beaten),
            stats: Stats::default(),
            ..solved.clone()
        };
        let (draft, request) = (Rc::clone(&self.about.draft), Rc::clone(&self.about.request));
        let answer = match self.about.course.as_deref() {
            None => Answer::new(draft, request, answer),
            Some(course) => {
                let (changes, steps) = (course.changes.clone(), course.steps.clone());
                Answer::over_time(draft, request, answer, changes, steps).ok()?
            }
        };
        Some(Rc::new(answer))
    }
}
