//! The result of a search after its plan was judged: the status, and how far the claim reaches.

use giveway_model::{Costs, Plan};

use crate::{
    Status,
    budget::Stop,
    search::{Aim, Proved},
};

/// A plan and a claim that may be told.
#[derive(Clone, Debug)]
pub(crate) struct Judged {
    pub(crate) plan: Option<(Plan, Costs)>,
    pub(crate) status: Status,
    /// How far the claim reaches; `None` where nothing was settled.
    pub(crate) reach: Option<Proved>,
    /// Why nothing was settled.
    pub(crate) stop: Option<Stop>,
}

impl Judged {
    /// Judges what was found, if anything was. Never trust the solver: a plan
    /// that the judge refuses is no plan, and shows that no claim can be made.
    pub(crate) fn new<T>(
        found: Option<T>,
        aim: &Aim,
        (reach, stop): (Option<Proved>, Option<Stop>),
        judge: impl FnOnce(T) -> Option<(Plan, Costs)>,
    ) -> Self {
        let was_found = found.is_some();
        let plan = found.and_then(judge);
        let stop = if was_found && plan.is_none() {
            Some(Stop::Contradiction)
        } else {
            stop
        };
        let status = match (&plan, stop) {
            (Some(_), None) if *aim == Aim::Best => Status::Optimal,
            (Some(_), _) => Status::Feasible,
            (None, None) => Status::Impossible,
            (None, Some(_)) => Status::Unknown,
        };
        Self {
            plan,
            status,
            reach: reach.filter(|_| stop.is_none()),
            stop,
        }
    }
}
