//! Planners of the textbook, run on the scene on the board, side by side with the
//! search for the best plan.

mod rows;
mod words;

use std::rc::Rc;

use giveway_solve::plan::{PlanAnswer, PlanEnd, PlanStats, Planner};
use giveway_solve::{Reach, Reason, SolveAnswer, Stats, Status};

use crate::{Answer, Document, Draft};

pub use rows::{Place, Proved, Row, RowPlan, Table, table};
pub use words::{BEST, BEST_PROMISE, promise};
pub(crate) use words::{claim, sentence};

/// Who planned.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum By {
    /// The search for the best plan.
    Search,
    /// A planner of the textbook.
    Planner(Planner),
}

/// What a planner came to.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum End {
    /// A plan, which is a plan of the document like any other.
    Plan(Rc<Answer>),
    /// None, and why, as a sentence.
    Nothing(String),
}

/// One planner on the scene.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Run {
    pub(crate) planner: Planner,
    pub(crate) end: End,
    /// The work that it took; `None` where it was stopped before it told.
    pub(crate) stats: Option<PlanStats>,
}

/// Who planned on a scene, and what they came to: the last run of each.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Runs {
    draft: Rc<Draft>,
    within: Option<u32>,
    /// The last answer of the search for the best plan.
    search: Option<Rc<Answer>>,
    /// Those of planners, in the order in which lists show them.
    planned: Vec<Run>,
}

impl Runs {
    /// The runs on the scene of a document; those on another scene are dropped.
    pub(crate) fn of(document: &Document) -> Self {
        let mut runs = Self::fresh(document).cloned().unwrap_or_else(|| Self {
            draft: Rc::clone(&document.draft),
            within: document.within,
            search: None,
            planned: Vec::new(),
        });
        // Only the search proves that much.
        let proved = document.fresh_answer().filter(|answer| {
            let is_final = matches!(answer.solved.status, Status::Optimal | Status::Impossible);
            is_final && answer.by.is_none() && answer.course.is_none()
        });
        if proved.is_some() {
            runs.search = proved.cloned();
        }
        runs
    }

    /// The runs that a document holds, where they are on its scene; none where the world
    /// has changed around its plan, which no planner knows.
    pub(crate) fn fresh(document: &Document) -> Option<&Self> {
        if document.changed_last().is_some() {
            return None;
        }
        let runs = document.found_plans.as_deref()?;
        let is_same = Rc::ptr_eq(&runs.draft, &document.draft) || runs.draft == document.draft;
        (is_same && runs.within == document.within).then_some(runs)
    }

    /// With an answer of the search.
    pub(crate) fn with_search(document: &Document, answer: &Rc<Answer>) -> Rc<Self> {
        let search = Some(Rc::clone(answer));
        let runs = Self::of(document);
        Rc::new(Self { search, ..runs })
    }

    /// With a run, in the place of the last one of the same planner.
    pub(crate) fn with(document: &Document, run: Run) -> Rc<Self> {
        let mut runs = Self::of(document);
        runs.planned.retain(|other| other.planner != run.planner);
        runs.planned.push(run);
        runs.planned.sort_by_key(|run| run.planner);
        Rc::new(runs)
    }

    /// The plan of one of them.
    pub(crate) fn plan(&self, by: By) -> Option<&Rc<Answer>> {
        let answer = match by {
            By::Search => self.search.as_ref(),
            By::Planner(planner) => {
                let run = self.planned.iter().find(|run| run.planner == planner);
                match &run?.end {
                    End::Plan(answer) => Some(answer),
                    End::Nothing(_) => None,
                }
            }
        };
        answer.filter(|answer| answer.plan().is_some())
    }
}

/// What is proved of the first cost of every plan of a scene, whoever proved it: no plan has less.
/// It belongs to the scene, and stands beside the plan of any planner. `None` where nothing is
/// proved.
pub(crate) fn least(document: &Document) -> Option<u32> {
    let &first = document.draft.scene().objective.costs().first()?;
    let runs = Runs::fresh(document)?;
    let planned = runs.planned.iter().filter_map(|run| match &run.end {
        End::Plan(answer) => Some(answer),
        End::Nothing(_) => None,
    });
    // What holds up to a makespan alone is no bound of all plans.
    let is_of_all = |answer: &&Rc<Answer>| match &answer.solved.reason {
        Some(Reason::LeastWithin { .. }) => false,
        Some(_) | None => answer.by.is_some() || answer.solved.reach.is_complete(),
    };
    let known = runs.search.iter().chain(planned).filter(is_of_all);
    known
        .filter_map(|answer| answer.solved.bounds.get(&first).copied())
        .max()
}

/// The plan of a planner as an answer; `None` without one.
///
/// Optimal is what no plan can better in any cost: so only where the objective is
/// the one cost that the planner proved. Otherwise what is proved stands in the
/// bounds alone.
pub(crate) fn solved(told: &PlanAnswer) -> Option<SolveAnswer> {
    let plan = told.plan.clone()?;
    let is_single = told.objective.costs().len() == 1;
    let best = match told.ended {
        PlanEnd::Best { reach } if is_single && reach.is_complete() => Some(reach),
        _ => None,
    };
    Some(SolveAnswer {
        giveway: told.giveway,
        status: if best.is_some() {
            Status::Optimal
        } else {
            Status::Feasible
        },
        costs: told.costs,
        bounds: told.bounds.clone(),
        reach: best.unwrap_or_default(),
        ended: None,
        reason: match &told.ended {
            PlanEnd::Stopped { reason } => Some(reason.clone()),
            PlanEnd::Best { reach } => least_within(told, *reach),
            PlanEnd::Found
            | PlanEnd::NoOrderWorks { .. }
            | PlanEnd::Horizon { .. }
            | PlanEnd::Refused { .. }
            | PlanEnd::Alone { .. } => None,
        },
        plan: Some(plan),
        stats: Stats {
            cpu_seconds: told.stats.cpu_seconds,
            ..Stats::default()
        },
        trace: None,
    })
}

/// That no plan up to a makespan has less of the first cost.
fn least_within(told: &PlanAnswer, reach: Reach) -> Option<Reason> {
    let (&cost, within) = (told.objective.costs().first()?, reach.within()?);
    Some(Reason::LeastWithin { cost, within })
}
