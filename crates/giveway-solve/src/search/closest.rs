//! Of all plans as good as the best, one that is close to a given plan.
//!
//! First as few agents as can be do something else ([`agents`]); then as few
//! entries as can be differ ([`entries`]). What either needs of the agents inside
//! the SAT solver is written by [`clauses`], as their MDDs grow.

mod agents;
mod clauses;
mod enter;
mod entries;

use std::collections::BTreeMap;
use std::rc::Rc;

use super::{
    aim::Bounded,
    deadlines::Keeping,
    for_ever::{self, Proved},
    incumbent::Incumbent,
    stage::{Search, Subject},
};
use crate::{
    budget::{Budget, Stop},
    encode::collisions::AgentId,
    problem::Problem,
    sat::Lit,
    single::{Mask, Place},
    walk::Walk,
};
use agents::AsBefore;
use clauses::WrittenClauses;

/// The measure of closeness.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Extent {
    /// The number of agents that do something else.
    Agents,
    /// Then the number of entries that differ.
    Entries,
}

/// The walk of one agent in the given plan; empty where the agent is not in it.
#[derive(Clone, Debug)]
pub(crate) struct GivenWalk {
    pub(crate) walk: Walk,
    pub(crate) charges: Vec<u32>,
}

/// A plan close to the given one.
pub(crate) struct ClosestPlan {
    pub(crate) walks: Vec<Walk>,
    /// Agents that do as before, charges included.
    pub(crate) same: Vec<bool>,
    /// How far it is proved that none is closer, if it is.
    pub(crate) proved: Option<Proved>,
}

/// The proof that no plan within the limits is closer. Only the search for the
/// closest one makes it, when it has come to its end.
#[derive(Clone, Copy, Debug)]
pub(super) struct NoneCloser(());

/// The closest plan within the limits, which the best plan meets; `None` where
/// the budget ran out before any was found.
///
/// # Errors
/// When the budget is spent before there is any.
pub(crate) fn closest(
    problem: &Problem,
    before: &[GivenWalk],
    bounded: &Bounded,
    extent: Extent,
    budget: &Rc<Budget>,
) -> Result<Option<ClosestPlan>, Stop> {
    let objective = giveway_model::Objective::default();
    let latest = bounded.horizon.latest();
    let mut incumbent = Incumbent::new(objective, latest, bounded.limits.clone(), &|_, _| {});
    let walks: Vec<Walk> = before.iter().map(|it| it.walk.clone()).collect();
    let subject = Subject {
        problem,
        walks: &walks,
        bounded,
    };
    let search = Search::new(subject, Keeping::Hard, &mut incumbent, Rc::clone(budget));
    let agents = problem.agents();
    let mut near = Near {
        problem,
        before,
        search,
        traces: (0..agents).map(|_| None).collect(),
        written: vec![WrittenClauses::default(); agents],
        differs: BTreeMap::new(),
    };
    let Some(shown) = near.find(bounded)? else {
        return Ok(None);
    };
    let mut close = near.read();
    if extent == Extent::Agents {
        close.proved = near.reach(Some(shown));
        return Ok(Some(close));
    }
    let shown = match near.few_entries(&mut close) {
        Ok(shown) => shown,
        Err(Stop::Contradiction) => return Err(Stop::Contradiction),
        Err(_) => None, // what was found until then is only better
    };
    close.proved = near.reach(shown);
    Ok(Some(close))
}

/// The given walk of an inside agent, as nodes of its MDD.
struct Trace {
    nodes: Vec<(Place, Mask)>,
    /// It does as before.
    same: Lit,
}

struct Near<'p, 'h> {
    problem: &'p Problem,
    before: &'p [GivenWalk],
    search: Search<'p, 'h, 'p>,
    traces: Vec<Option<Trace>>,
    written: Vec<WrittenClauses>,
    /// "Its entry at this time differs", of inside agents, once they count.
    differs: BTreeMap<AgentId, Vec<Lit>>,
}

impl Near<'_, '_> {
    /// Finds a plan in which as few agents as can be do something else; `None`
    /// where there is none.
    fn find(&mut self, bounded: &Bounded) -> Result<Option<NoneCloser>, Stop> {
        if self.search.keep_limits(bounded)?.is_some() {
            return Ok(None);
        }
        let softs = self.begin(bounded)?;
        self.few_agents(softs)
    }

    /// The plan of the last model.
    fn read(&mut self) -> ClosestPlan {
        self.search.team.read();
        let team = &self.search.team;
        let same = self.traces.iter().enumerate().map(|(agent, trace)| {
            let held = trace.as_ref().map(|trace| team.is_true(trace.same));
            held.unwrap_or(!team.is_inside(agent))
        });
        ClosestPlan {
            same: same.collect(),
            walks: team.walks.clone(),
            proved: None,
        }
    }

    /// How far what was found is proved, where it is.
    fn reach(&self, shown: Option<NoneCloser>) -> Option<Proved> {
        let shown = shown.filter(|_| self.is_exact())?;
        Some(for_ever::none_closer(&self.search, shown))
    }

    /// Whether the clauses represent every plan. Where agents vanish, they leave out plans in which an agent
    /// reaches its goal, leaves it and comes back.
    fn is_exact(&self) -> bool {
        let insiders = self.search.team.insiders();
        insiders.into_iter().all(|agent| {
            self.problem.rests(agent) || self.search.cap(agent) < self.problem.optima[agent] + 2
        })
    }
}
