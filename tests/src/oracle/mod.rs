//! The oracle: a slow and readable solver to compare the fast one with.
//!
//! It searches the *joint states* of all agents as a textbook would. One agent
//! has a state (where it is, what it has seen, how full its battery is) and
//! steps from state to state ([`law`], [`lone`]). A joint state is one state of each
//! agent, and a joint step is one step of each, if no two collide ([`joint`]).
//! Each of the five costs of a plan is a sum over its joint steps ([`price`]),
//! so the best plan is a shortest path, and Dijkstra's algorithm finds it
//! ([`search`]). There are finitely many joint states: when all that can be
//! reached are used up without an end, there is no plan at any horizon.
//!
//! Everything here is written from the text of the problem. It shares no code
//! with the solver, nor with the judge of plans: of the model it knows the plain
//! data only. It is meant for maps of some 20 cells and up to three agents.

mod changed;
mod contrast;
mod every;
mod joint;
mod law;
mod leniency;
mod limited;
mod lone;
mod near;
mod price;
mod search;
mod together;
mod trace;
mod world;

use std::collections::BTreeMap;

use giveway_model::{Cell, Cost, Instance, Plan};

use crate::recount;

pub use changed::{Changed, Held, Known, map_after, standing};
pub use contrast::Contrast;
pub use every::{Course, Every, Where, is_legal};
use joint::Joint;
pub use leniency::Leniency;
pub use limited::{AtMost, least_alone, some_plan_keeps};
pub use near::{Distance, least_distance};
use search::{Aim, Limit, Search};
use together::Together;

/// What the oracle knows about the best plan.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// The best plan.
    Best(Point),
    /// There is no plan, or none within the horizon where one was given.
    Impossible,
    /// There were more states than allowed; nothing is known.
    Capped,
}

/// A cost vector that some plan has, in the order of the objective, and such a
/// plan.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Point {
    /// The costs of the objective, in its order.
    pub vector: Vec<u32>,
    /// A plan that costs this.
    pub plan: Plan,
}

/// A question to the oracle.
#[derive(Clone, Copy, Debug)]
pub struct Question<'a> {
    /// The instance, with its objective.
    pub instance: &'a Instance,
    /// Only plans of at most this makespan count; `None` is no horizon.
    pub within: Option<u32>,
    /// How many labels the search may make before it gives up.
    pub cap: usize,
}

impl Question<'_> {
    /// The lexicographically best plan for the objective of the instance.
    pub fn best(&self) -> Verdict {
        first(self.search(Aim::Lexicographic))
    }

    /// The same with some rules left out.
    pub fn best_without(&self, leniency: &Leniency) -> Verdict {
        let joint = Joint::asked(self.instance, None, leniency);
        first(self.search_in(&joint, Aim::Lexicographic, None))
    }

    /// The best of all plans that are as a question asks.
    pub fn best_with(&self, contrast: Contrast) -> Verdict {
        self.best_with_less(contrast, &Leniency::default())
    }

    /// The same with some rules left out.
    pub fn best_with_less(&self, contrast: Contrast, leniency: &Leniency) -> Verdict {
        if let giveway_model::Question::NoVisit { agent: None, at } = contrast.question {
            return self.best_of_any(contrast, *at, leniency);
        }
        let whole = recount::costs(contrast.plan);
        let limit = match contrast.together() {
            Some(Together::Less(cost)) => Some(Limit {
                cost,
                below: whole.get(cost),
            }),
            Some(Together::Before(..)) | None => None,
        };
        if limit.is_some_and(|limit| limit.below == 0) {
            return Verdict::Impossible;
        }
        let joint = Joint::asked(self.instance, Some(contrast), leniency);
        first(self.search_in(&joint, Aim::Lexicographic, limit))
    }

    /// The best of all plans in which some agent is at a cell.
    fn best_of_any(&self, contrast: Contrast, at: Cell, leniency: &Leniency) -> Verdict {
        let mut best = Verdict::Impossible;
        for agent in self.instance.agents() {
            let question = giveway_model::Question::NoVisit {
                agent: Some(agent.name.clone()),
                at,
            };
            let contrast = Contrast {
                question: &question,
                ..contrast
            };
            let one = self.best_with_less(contrast, leniency);
            best = match (best, one) {
                (Verdict::Capped, _) | (_, Verdict::Capped) => Verdict::Capped,
                (Verdict::Impossible, one) => one,
                (Verdict::Best(a), Verdict::Best(b)) if b.vector < a.vector => Verdict::Best(b),
                (best, _) => best,
            };
        }
        best
    }

    /// Every non-dominated cost vector of the objective, in ascending order,
    /// with a plan for each; empty where there is no plan, and `None` where
    /// there were too many states.
    pub fn front(&self) -> Option<Vec<Point>> {
        self.search(Aim::Pareto)
    }

    /// Whether there is a plan that costs at most this, and is as a question asks
    /// where one is given; `None` where there were too many states.
    pub fn exists(&self, most: &BTreeMap<Cost, u32>, contrast: Option<Contrast>) -> Option<bool> {
        let costs: Vec<Cost> = most.keys().copied().collect();
        let joint = Joint::asked(self.instance, contrast, &Leniency::default());
        let front = Search {
            joint: &joint,
            costs: &costs,
            aim: Aim::Pareto,
            within: self.within,
            cap: self.cap,
            limit: None,
        }
        .run()?;
        let keeps = |point: &Point| {
            point
                .vector
                .iter()
                .zip(most)
                .all(|(n, (_, most))| n <= most)
        };
        Some(front.iter().any(keeps))
    }

    fn search(&self, aim: Aim) -> Option<Vec<Point>> {
        self.search_in(&Joint::new(self.instance), aim, None)
    }

    fn search_in(&self, joint: &Joint, aim: Aim, limit: Option<Limit>) -> Option<Vec<Point>> {
        Search {
            joint,
            costs: self.instance.objective().costs(),
            aim,
            within: self.within,
            cap: self.cap,
            limit,
        }
        .run()
    }
}

/// The verdict of a search for one point.
fn first(points: Option<Vec<Point>>) -> Verdict {
    match points {
        None => Verdict::Capped,
        Some(points) => points
            .into_iter()
            .next()
            .map_or(Verdict::Impossible, Verdict::Best),
    }
}

/// The horizon within which claims are made by default: the largest
/// single-agent optimum + 4 (width + height) + 10; `None` where some agent
/// cannot do its task even alone.
pub fn default_horizon(instance: &Instance) -> Option<u32> {
    let joint = Joint::new(instance);
    let grid = instance.grid();
    let longest = joint
        .lone_optima()
        .into_iter()
        .try_fold(0, |longest, optimum| Some(longest.max(optimum?)))?;
    Some(longest + 4 * (grid.width() + grid.height()) + 10)
}

/// Whether the objective makes every claim complete by itself: it begins with
/// makespan or sum-of-costs.
pub fn objective_is_complete(instance: &Instance) -> bool {
    matches!(
        instance.objective().costs().first(),
        Some(Cost::Makespan | Cost::SumOfCosts)
    )
}
