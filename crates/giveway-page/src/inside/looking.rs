//! What the planners are asked, so that one can look into them: one thing after the
//! other, whenever the worker has nothing else to do.

use std::rc::Rc;

use giveway_solve::plan::{ByHand, PlanRequest, Planner};
use giveway_solve::together::TogetherRequest;
use giveway_solve::trace::Core;
use giveway_solve::{Limits, Request};

use super::{Looked, Method, by_hand, proof};
use crate::{Draft, State};

/// So many robots have few enough orders to try them all.
const ALL_ORDERS: usize = 4;
/// How long `LaCAM` goes on to better plans while it is looked into, in seconds.
const LACAM: f64 = 3.0;
/// How long the robots of a step are looked at, in seconds: the next step waits.
const CLOSER: f64 = 4.0;

/// Something that is asked about the scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Looking {
    /// The scene.
    pub(crate) draft: Rc<Draft>,
    /// The horizon.
    pub(crate) within: Option<u32>,
    /// The time limit, in seconds.
    pub(crate) seconds: u32,
    /// What.
    pub what: What,
}

/// What is asked.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum What {
    /// The tree of CBS.
    Tree,
    /// The tree of CBS of these splits.
    ByHand(Box<ByHand>),
    /// What comes of an order, by names.
    Order(Vec<String>),
    /// Orders until one works.
    Orders,
    /// The steps of PIBT.
    Pibt,
    /// The configurations of `LaCAM`.
    Lacam,
    /// Why the robots of a step cannot all keep their limits.
    Together(Box<Core>),
}

impl Looking {
    pub(crate) fn request(&self) -> Request {
        let scene = self.draft.scene().clone();
        let (planner, order) = match &self.what {
            What::Together(core) => {
                let limits = Limits {
                    seconds: Some(CLOSER.min(f64::from(self.seconds))),
                    ..Limits::default()
                };
                return Request::Together(TogetherRequest {
                    limits,
                    ..TogetherRequest::about(core, scene)
                });
            }
            What::Tree | What::ByHand(_) => (Planner::Cbs, None),
            What::Order(order) => (Planner::Prioritised, Some(order.clone())),
            What::Orders => (Planner::Prioritised, None),
            What::Pibt => (Planner::Pibt, None),
            What::Lacam => (Planner::Lacam, None),
        };
        Request::Plan(PlanRequest {
            within: self.within,
            order,
            by_hand: match &self.what {
                What::ByHand(asked) => Some((**asked).clone()),
                What::Tree
                | What::Order(_)
                | What::Orders
                | What::Pibt
                | What::Lacam
                | What::Together(_) => None,
            },
            trace: true,
            limits: Limits {
                seconds: Some(match self.what {
                    What::Lacam => LACAM.min(f64::from(self.seconds)),
                    What::Tree
                    | What::ByHand(_)
                    | What::Order(_)
                    | What::Orders
                    | What::Pibt
                    | What::Together(_) => f64::from(self.seconds),
                }),
                ..Limits::default()
            },
            ..PlanRequest::new(scene, planner)
        })
    }
}

/// What is to be asked next; `None` where nothing is, or the worker is busy.
pub(crate) fn wanted(state: &State) -> Option<Looking> {
    let document = &state.document;
    let is_ready = document.draft.instance().is_ok() && document.changed_last().is_none();
    if !state.is_inside() || !state.work.is_idle() || !is_ready {
        return None;
    }
    let looked = state.looked();
    let what = match state.inside.method {
        Method::Proof => {
            proof::unknown_core(state).map(|core| What::Together(Box::new(core.clone())))
        }
        Method::Tree if state.inside.by_hand.is_on => by_hand::wanted(state),
        Method::Tree => {
            let is_known = looked.is_some_and(|looked| looked.tree.is_some());
            (!is_known).then_some(What::Tree)
        }
        Method::Orders => next_order(state, looked),
        Method::Pibt => {
            let is_known = looked.is_some_and(|looked| looked.pibt.is_some());
            (!is_known).then_some(What::Pibt)
        }
        Method::Lacam => {
            let is_known = looked.is_some_and(|looked| looked.lacam.is_some());
            (!is_known).then_some(What::Lacam)
        }
    }?;
    Some(Looking {
        draft: Rc::clone(&document.draft),
        within: document.within,
        seconds: state.settings.seconds,
        what,
    })
}

fn next_order(state: &State, looked: Option<&Looked>) -> Option<What> {
    if looked.is_some_and(|looked| looked.failed.is_some()) {
        return None;
    }
    let runs = looked.map_or(&[][..], |looked| looked.orders.as_slice());
    let names = state.document.agents().iter();
    let names: Vec<String> = names.map(|agent| agent.name.clone()).collect();
    if names.len() <= ALL_ORDERS {
        return permutation(&names, runs.len()).map(What::Order);
    }
    if runs.is_empty() {
        return Some(What::Orders);
    }
    // Of many orders not all paths were told.
    let chosen = runs.get(state.inside.order)?;
    (!chosen.is_told()).then(|| What::Order(chosen.told.order.clone()))
}

/// The n-th order of some names, in the order of a dictionary.
fn permutation(names: &[String], n: usize) -> Option<Vec<String>> {
    let mut left: Vec<&String> = names.iter().collect();
    let mut count: usize = (1..=left.len()).product();
    let mut rest = n;
    if left.is_empty() || rest >= count {
        return None;
    }
    let mut order = Vec::new();
    while !left.is_empty() {
        count /= left.len();
        order.push(left.remove(rest / count).clone());
        rest %= count;
    }
    Some(order)
}

/// How many orders all robots of a scene have, where all are tried.
pub(super) fn all_orders(agents: usize) -> Option<usize> {
    (agents <= ALL_ORDERS).then(|| (1..=agents).product())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_order_comes_once() {
        let names = ["a", "b", "c"].map(str::to_owned);
        let orders = (0..6).map(|n| permutation(&names, n).unwrap().concat());
        let orders: Vec<String> = orders.collect();
        assert_eq!(orders, ["abc", "acb", "bac", "bca", "cab", "cba"]);
        assert_eq!(permutation(&names, 6), None);
        assert_eq!(permutation(&[], 0), None);
    }
}
