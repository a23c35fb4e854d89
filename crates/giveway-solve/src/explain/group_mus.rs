//! Facts that alone make it impossible, minimal by inclusion.
//!
//! Facts are left out class by class, in halves of a class, as long as there is
//! still no plan (deletion with blocks, after Junker, 2004). In the
//! end every fact that is left is looked at again: with only the other facts of the
//! set a plan must be at hand. (Facts outside of the set may still exclude one, see
//! `causes.rs`.) That last look matters, since a slow zone that becomes normal is
//! no mere relaxation: an agent half way along a slow edge is in nobody's way.

use std::collections::{BTreeMap, BTreeSet};

use giveway_model::{Instance, Plan};

mod floor;
mod shrinking;

use super::{
    answer::{Core, Fact, Helps},
    causes::Refuted,
    fact_groups::{FactPrice, Prices, fact_groups},
    group::{Group, Variant, groups, has_slow_edge},
    growing::ForcingSet,
};
use crate::search::Proved;
use shrinking::Shrinking;

/// The result of trying a variant.
#[derive(Clone, Debug)]
pub(crate) enum Tried {
    /// There is no plan: how far that reaches, and of which agents it is known.
    None { reach: Proved, clash: Vec<String> },
    /// There is one.
    Plan(Plan),
    /// The budget ran out.
    Unknown,
}

impl Tried {
    /// The same result, but "no plan" becomes unknown where it reaches less far than the claim that it
    /// supports. A deadline that a person set is part of the question itself.
    pub(crate) fn reaching(self, variant: &Variant, claim: Proved) -> Self {
        match self {
            Self::None { reach, .. } if variant.within.is_none() && !reach.covers(claim) => {
                Self::Unknown
            }
            tried @ (Self::None { .. } | Self::Plan(_) | Self::Unknown) => tried,
        }
    }
}

/// A question to which the answer is "no plan" for the instance as it is.
pub(crate) trait Inquiry {
    /// Looks for a plan.
    fn search(&mut self, variant: &Variant) -> Tried;
    /// Looks for a plan with a small part of that work.
    fn search_briefly(&mut self, variant: &Variant) -> Tried;
    /// Looks for a plan once more, with several times the work.
    fn search_again(&mut self, variant: &Variant) -> Tried;
    /// Looks for a plan with all of the budget that is left.
    fn search_longer(&mut self, variant: &Variant) -> Tried;
    /// Whether a plan, known from another variant, is one here.
    fn accepts(&self, variant: &Variant, plan: &Plan) -> bool;
    /// Whether the budget is spent: then no variant needs to be made.
    fn is_over(&self) -> bool;
}

/// Facts that alone exclude a plan.
pub(crate) struct CoreFound {
    /// The facts.
    pub(crate) groups: Vec<Group>,
    /// Whether each of them was shown to be needed in the set.
    pub(crate) minimal: bool,
    /// How far they exclude one.
    pub(crate) reach: Proved,
    /// Which of them help when they alone are left out, as far as was tried.
    pub(crate) helps: BTreeMap<Group, Helps>,
    /// What the whole instance costs without some of them, each alone.
    pub(crate) prices: Prices,
    /// Facts that are needed: with only the others of the set, or only those outside of their
    /// shelf block, there is a plan.
    pub(crate) needed: BTreeSet<Group>,
    /// Whether an agent of which the set says nothing could do what is asked for: then a plan
    /// of the whole instance without a fact may be none of the set.
    pub(crate) is_of_another: bool,
    /// Further sets.
    pub(crate) further: Vec<Self>,
}

impl CoreFound {
    /// The facts of which it is known that leaving out one alone helps.
    pub(crate) fn helping(&self) -> Vec<Group> {
        let helps = |fact: &&Group| self.helps.get(fact) == Some(&Helps::Yes);
        self.groups.iter().filter(helps).copied().collect()
    }

    /// The facts for people.
    pub(crate) fn core(&self, instance: &Instance, within: Option<u32>) -> Core {
        let facts = self.groups.iter().map(|group| Fact {
            helps: self.helps.get(group).copied().unwrap_or_default(),
            ..group.fact(instance, within)
        });
        let further = self.further.iter();
        let mut core = Core {
            facts: facts.collect(),
            groups: Vec::new(),
            prices: self.fact_prices(),
            minimal: self.minimal || self.groups.iter().all(|it| self.helps_in_set(instance, it)),
            reach: self.reach.into(),
            further: further.map(|core| core.core(instance, within)).collect(),
        };
        core.groups = fact_groups(instance, self, &core);
        core
    }

    /// What the whole instance costs without a fact, by the place of the fact.
    fn fact_prices(&self) -> Vec<FactPrice> {
        let places = (0..).zip(&self.groups);
        let priced = places.filter_map(|(fact, group)| {
            let &(costs, proved) = self.prices.get(group)?;
            Some(FactPrice {
                fact,
                costs,
                proved,
            })
        });
        priced.collect()
    }

    /// Whether a fact is known to be needed in the set, alone or with all of its shelf block.
    pub(crate) fn is_needed(&self, instance: &Instance, fact: &Group) -> bool {
        self.minimal || self.needed.contains(fact) || self.helps_in_set(instance, fact)
    }

    /// Whether a plan of the whole instance without a fact is also one of the set without it. (It
    /// may not be where the set has no slow zones, or where an agent outside of it does what is
    /// asked for.)
    fn helps_in_set(&self, instance: &Instance, fact: &Group) -> bool {
        let is_slow = || self.groups.contains(&Group::Slow) || !has_slow_edge(instance.grid());
        let helps = self.helps.get(fact) == Some(&Helps::Yes);
        helps && !self.is_of_another && is_slow()
    }

    /// The facts of this set, then those of the further ones.
    pub(crate) fn sets(&self) -> impl Iterator<Item = &[Group]> {
        let further = self.further.iter().map(|core| core.groups.as_slice());
        std::iter::once(self.groups.as_slice()).chain(further)
    }
}

/// Facts that exclude a plan, where the instance has none without the facts that
/// are `left_out` (up to a horizon). The agents `asked` about are never left out.
pub(crate) fn group_mus(
    instance: &Instance,
    asked: &[usize],
    deadline: Option<u32>,
    left_out: &BTreeSet<Group>,
    refuted: Tried,
    inquiry: &mut dyn Inquiry,
) -> Option<CoreFound> {
    let Tried::None { reach, clash } = refuted else {
        return None;
    };
    let refuted = Refuted {
        instance,
        asked,
        deadline,
        reach,
    };
    let mut shrinking = Shrinking::new(&refuted, inquiry);
    shrinking.left_out.clone_from(left_out);
    shrinking.leave_out_strangers(&groups(instance, asked, deadline.is_some()), &clash);
    Some(shrinking.minimal_set(asked))
}

/// The same where rules of the scene's own are tried before all other facts: with all of
/// these in force, none of the rules of the set can be left out.
pub(crate) fn group_mus_of_rules(
    refuted: &Refuted,
    left_out: &BTreeSet<Group>,
    clash: &[String],
    inquiry: &mut dyn Inquiry,
) -> CoreFound {
    let mut shrinking = Shrinking::new(refuted, inquiry);
    shrinking.left_out.clone_from(left_out);
    shrinking.shrink_rules();
    let all = groups(refuted.instance, refuted.asked, refuted.deadline.is_some());
    shrinking.leave_out_strangers(&all, clash);
    shrinking.minimal_set(refuted.asked)
}

/// The same of agents that alone exclude a plan. Of many obstacles whole shelf blocks are left
/// out or kept.
pub(crate) fn group_mus_of_agents(
    refuted: &Refuted,
    forcing: ForcingSet,
    inquiry: &mut dyn Inquiry,
) -> CoreFound {
    let mut shrinking = Shrinking::new(refuted, inquiry);
    shrinking.begin_with(refuted, forcing);
    shrinking.minimal_units(refuted.asked)
}

/// The rules of the scene's own in such a set, by their numbers.
pub(crate) fn rules_mus(
    refuted: &Refuted,
    left_out: &BTreeSet<Group>,
    inquiry: &mut dyn Inquiry,
) -> BTreeSet<usize> {
    let mut shrinking = Shrinking::new(refuted, inquiry);
    shrinking.left_out.clone_from(left_out);
    shrinking.shrink_rules();
    shrinking.kept_rules()
}

/// Another set of such facts, with as few of some facts in it as can be.
pub(crate) fn group_mus_avoiding(
    refuted: &Refuted,
    avoided: &[Group],
    inquiry: &mut dyn Inquiry,
) -> CoreFound {
    let mut shrinking = Shrinking::new(refuted, inquiry);
    shrinking.avoid(avoided);
    shrinking.minimal_set(refuted.asked)
}
