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
    for_ever::{self, ForEver, NoPlan, Proved},
    incumbent::Incumbent,
    latest::LatestArrivals,
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

/// How a search for the closest plan ended.
pub(crate) enum ClosestEnd {
    /// With a plan.
    Plan(ClosestPlan),
    /// No plan keeps the limits; how far that is proved, if it is.
    NoPlan(Option<Proved>),
}

impl ClosestEnd {
    /// The plan, if there is one.
    pub(crate) fn plan(self) -> Option<ClosestPlan> {
        match self {
            Self::Plan(plan) => Some(plan),
            Self::NoPlan(_) => None,
        }
    }
}

/// The proof that no plan within the limits is closer. Only the search for the
/// closest one makes it, when it has come to its end.
#[derive(Clone, Copy, Debug)]
pub(super) struct NoneCloser(());

/// The fixed input of a search for the closest plan.
#[derive(Clone, Copy)]
pub(crate) struct ClosestInput<'a> {
    /// The plan to be close to, agent by agent.
    pub(crate) before: &'a [GivenWalk],
    pub(crate) bounded: &'a Bounded,
    /// The latest arrivals in plans within the limits, where a proof leaves such.
    pub(crate) latest: Option<&'a LatestArrivals>,
}

/// The closest plan within the limits, or that there is none.
///
/// # Errors
/// When the budget is spent before there is any.
pub(crate) fn closest(
    problem: &Problem,
    given: ClosestInput,
    extent: Extent,
    budget: &Rc<Budget>,
) -> Result<ClosestEnd, Stop> {
    let ClosestInput {
        before, bounded, ..
    } = given;
    let objective = giveway_model::Objective::default();
    let latest = bounded.horizon.latest();
    let mut incumbent = Incumbent::new(objective, latest, bounded.limits.clone(), &|_, _| {});
    let walks: Vec<Walk> = before.iter().map(|it| it.walk.clone()).collect();
    let subject = Subject {
        problem,
        walks: &walks,
        bounded,
    };
    let mut search = Search::new(subject, Keeping::Hard, &mut incumbent, Rc::clone(budget));
    let agents = problem.agents();
    for agent in 0..agents {
        if let Some(latest) = given.latest {
            search.lower_cap(agent, latest.of(agent));
        }
    }
    let mut near = Near {
        problem,
        before,
        search,
        traces: (0..agents).map(|_| None).collect(),
        written: vec![WrittenClauses::default(); agents],
        differs: BTreeMap::new(),
    };
    let shown = match near.find(bounded)? {
        FewAgents::Found(shown) => shown,
        FewAgents::NoPlan(proved) => return Ok(ClosestEnd::NoPlan(proved)),
    };
    let mut close = near.read();
    if extent == Extent::Agents {
        close.proved = near.reach(Some(shown));
        return Ok(ClosestEnd::Plan(close));
    }
    let shown = match near.few_entries(&mut close) {
        Ok(shown) => shown,
        Err(Stop::Contradiction) => return Err(Stop::Contradiction),
        Err(_) => None, // what was found until then is only better
    };
    close.proved = near.reach(shown);
    Ok(ClosestEnd::Plan(close))
}

/// Whether there is a plan, and that none has fewer agents that do something else.
enum FewAgents {
    Found(NoneCloser),
    /// How far it is proved that there is none, if it is.
    NoPlan(Option<Proved>),
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
    /// Finds a plan in which as few agents as can be do something else.
    fn find(&mut self, bounded: &Bounded) -> Result<FewAgents, Stop> {
        if let Some(too_low) = self.search.keep_limits(bounded)? {
            return Ok(self.no_plan(Some(too_low.into())));
        }
        let softs = self.begin(bounded)?;
        match self.few_agents(softs)? {
            Ok(shown) => Ok(FewAgents::Found(shown)),
            Err(core) if self.is_exact() => {
                let reason = for_ever::impossible(&self.search, bounded, &core)?;
                Ok(self.no_plan(reason))
            }
            Err(_) => Ok(FewAgents::NoPlan(None)),
        }
    }

    /// There is no plan: up to the horizon, or at every one for a reason.
    fn no_plan(&self, reason: Option<ForEver<NoPlan>>) -> FewAgents {
        FewAgents::NoPlan(Some(Proved::new(reason, self.search.latest())))
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
