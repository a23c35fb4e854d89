//! A smallest set of agents that alone force an answer, looked for from below.
//!
//! Implicit hitting sets, as for smallest MUSes (Ignatiev et al., 2015). A plan as asked for of
//! some agents shows that each set of agents that forces the answer has one of the others. A
//! smallest set that has one of each such others is tried: it forces the answer, and then no
//! smaller set does; or it has a plan, which `extending` carries over to as many more agents as
//! can be. The agents that find no place beside such plans are those of a bottleneck, so few
//! sets are tried.

use std::collections::BTreeSet;

use giveway_model::{Plan, sorting::set};

mod extending;
mod hitting_set;

pub(crate) use extending::Extending;

use super::{
    causes::Refuted,
    group::{Group, Variant, fit, without},
    group_mus::{Inquiry, Tried},
};
use crate::search::Proved;
use hitting_set::hitting_set;

/// The most agents of a set, those asked about apart: a reason with more is not read.
pub(super) const MOST_AGENTS: usize = 6;
/// Sets that are tried.
const MOST_TRIED: usize = 60;

/// Agents that alone force an answer.
pub(crate) struct ForcingSet {
    /// The agents, by number, those asked about among them.
    pub(crate) agents: BTreeSet<usize>,
    /// Whether no smaller set was left untried.
    pub(crate) is_smallest: bool,
    /// How far there is no plan of them.
    pub(crate) reach: Proved,
    /// Plans of other sets that were found on the way.
    pub(crate) plans: Vec<Plan>,
}

/// A smallest set of agents without a plan as asked for; `None` where none of a size that is
/// looked at has none, or too many sets would have to be tried.
pub(crate) fn smallest_set(
    refuted: &Refuted,
    extending: &mut Extending,
    inquiry: &mut dyn Inquiry,
) -> Option<ForcingSet> {
    let mut growing = Growing {
        refuted,
        corrections: Vec::new(),
        plans: Vec::new(),
        is_smallest: true,
    };
    let asked = set(refuted.asked.iter().copied());
    for plan in extending.known_plans() {
        growing.learn(&asked, &plan, extending, inquiry);
    }
    for _ in 0..MOST_TRIED {
        let added = hitting_set(&growing.corrections, MOST_AGENTS)?;
        let agents: BTreeSet<usize> = asked.union(&added).copied().collect();
        if agents.is_empty() && growing.corrections.is_empty() {
            // Nobody has the plan of nobody; where nobody is asked about, somebody is needed.
            growing.corrections.push(growing.all());
            continue;
        }
        match growing.attempt(&agents, inquiry) {
            Tried::None { reach, .. } => {
                return Some(ForcingSet {
                    agents,
                    is_smallest: growing.is_smallest,
                    reach,
                    plans: growing.plans,
                });
            }
            Tried::Plan(plan) => growing.learn(&agents, &plan, extending, inquiry),
            Tried::Unknown if inquiry.is_over() => return None,
            Tried::Unknown => {
                growing.is_smallest = false;
                growing.correct(&agents);
            }
        }
    }
    None
}

/// The state of the search.
struct Growing<'a> {
    refuted: &'a Refuted<'a>,
    /// Sets of agents: each set that forces the answer has one of each.
    corrections: Vec<BTreeSet<usize>>,
    plans: Vec<Plan>,
    is_smallest: bool,
}

impl Growing<'_> {
    fn all(&self) -> BTreeSet<usize> {
        (0..self.refuted.instance.agents().len()).collect()
    }

    /// The instance with these agents only.
    fn variant(&self, agents: &BTreeSet<usize>) -> Variant {
        only(self.refuted, agents)
    }

    fn attempt(&self, agents: &BTreeSet<usize>, inquiry: &mut dyn Inquiry) -> Tried {
        let variant = self.variant(agents);
        // A set that forces the answer is worth a long search, and a short one before it would be
        // lost.
        let tried = inquiry.search_again(&variant);
        tried.reaching(&variant, self.refuted.reach)
    }

    /// Learns from a plan of some agents, where it is one as asked for.
    fn learn(
        &mut self,
        agents: &BTreeSet<usize>,
        plan: &Plan,
        extending: &mut Extending,
        inquiry: &dyn Inquiry,
    ) {
        let variant = self.variant(agents);
        let plan = fit(plan, &variant.instance);
        if !inquiry.accepts(&variant, &plan) {
            return;
        }
        let (agents, plan) = extending.extend(self.refuted, agents, plan, inquiry);
        self.correct(&agents);
        self.plans.push(plan);
    }

    /// A set that forces the answer has an agent that is none of these.
    fn correct(&mut self, agents: &BTreeSet<usize>) {
        let others: BTreeSet<usize> = self.all().difference(agents).copied().collect();
        self.corrections.push(others);
    }
}

/// The instance with some agents only.
pub(crate) fn only(refuted: &Refuted, agents: &BTreeSet<usize>) -> Variant {
    let left_out = others(refuted, agents);
    without(refuted.instance, &left_out, refuted.deadline)
}

/// All agents but some, as facts.
pub(crate) fn others(refuted: &Refuted, agents: &BTreeSet<usize>) -> BTreeSet<Group> {
    let all = 0..refuted.instance.agents().len();
    set(all.filter(|agent| !agents.contains(agent)).map(Group::Task))
}
