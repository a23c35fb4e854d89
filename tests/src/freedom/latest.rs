//! The latest arrivals that a proof leaves, against the arrivals of all best plans.

use giveway_model::Instance;
use giveway_solve::{
    Host, Progress, ProvedBest, Request, Response, SolveRequest, Status, Thresholds, serve,
};

use super::{CAP, all_best, limited};
use crate::oracle::{Question, Verdict};

/// What came of a comparison.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Latest {
    /// No best plan has a later arrival.
    Agreed {
        /// For how many agents the proof says how late they may be.
        said: usize,
        /// For how many of these some best plan is as late.
        exact: usize,
    },
    /// A best plan has a later one.
    Differ(String),
    /// The oracle cannot say, or there is no plan.
    TooLarge,
}

/// Takes each scene for a large floor, so that nothing is exhausted.
struct AsLarge;

impl Host for AsLarge {
    fn wall_seconds(&self) -> f64 {
        0.0
    }

    fn progress(&self, _: &Progress) {}

    fn thresholds(&self) -> Thresholds {
        Thresholds {
            few_agents: 0,
            ..Thresholds::default()
        }
    }
}

/// Compares the latest arrivals of a proof with those of all best plans.
pub fn compare_latest(instance: &Instance, within: Option<u32>) -> Latest {
    let within = limited(instance, within);
    let question = Question {
        instance,
        within,
        cap: CAP,
    };
    let Verdict::Best(best) = question.best() else {
        return Latest::TooLarge;
    };
    match all_best(instance, within, &best.vector) {
        Some((every, _)) => left(instance, within, |agent| every.latest_arrival(agent)),
        None => Latest::TooLarge,
    }
}

/// Compares the latest arrivals of a proof with these, each of an agent in any best plan.
pub(super) fn left(
    instance: &Instance,
    within: Option<u32>,
    latest: impl Fn(usize) -> u32,
) -> Latest {
    let request = Request::Solve(SolveRequest {
        scene: instance.to_scene(),
        within,
        trace: true,
        ..SolveRequest::default()
    });
    let solved = match serve(&request, &AsLarge) {
        Response::Solved(solved) if solved.status == Status::Optimal => solved,
        other => return Latest::Differ(format!("expected a best plan, got {other:?}")),
    };
    let proved = ProvedBest::by_search(&solved);
    let (mut said, mut exact) = (0, 0);
    for agent in 0..instance.agents().len() {
        let Some(left) = proved.latest_arrival(agent) else {
            continue;
        };
        let latest = latest(agent);
        if latest > left {
            return Latest::Differ(format!("agent {agent} may arrive at {latest}, not {left}"));
        }
        said += 1;
        exact += usize::from(latest == left);
    }
    Latest::Agreed { said, exact }
}
