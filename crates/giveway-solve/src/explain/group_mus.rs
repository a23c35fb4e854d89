//! Facts that alone make it impossible, minimal by inclusion.
//!
//! Facts are left out class by class, in halves of a class, as long as there is
//! still no plan (deletion with blocks, after Junker, 2004). In the
//! end every fact that is left is looked at again: with only the other facts of the
//! set a plan must be at hand. (Facts outside of the set may still exclude one, see
//! `causes.rs`.) That last look matters, since a slow zone that becomes normal is
//! no mere relaxation: an agent half way along a slow edge is in nobody's way.

use std::collections::{BTreeMap, BTreeSet};

use giveway_model::{Cell, Instance, Plan};

use super::{
    answer::{Core, Fact, FactKind, Helps},
    causes::Refuted,
    group::{Group, Variant, groups, without},
};
use crate::search::Proved;
use giveway_model::sorting::sort_by_key;

/// The latest plans of other variants that are tried before any search.
const KNOWN: usize = 12;

/// What was found out about a variant.
#[derive(Clone, Debug)]
pub(crate) enum Tried {
    /// There is no plan: how far that reaches, and of which agents it is known.
    None { reach: Proved, clash: Vec<String> },
    /// There is one.
    Plan(Plan),
    /// The budget ran out.
    Unknown,
}

/// A question to which the answer is "no plan" for the instance as it is.
pub(crate) trait Inquiry {
    /// Looks for a plan.
    fn search(&mut self, variant: &Variant) -> Tried;
    /// Looks for a plan with all of the budget that is left.
    fn search_longer(&mut self, variant: &Variant) -> Tried;
    /// Whether a plan, known from another variant, is one here.
    fn accepts(&self, variant: &Variant, plan: &Plan) -> bool;
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
    /// Further sets.
    pub(crate) further: Vec<Self>,
}

impl CoreFound {
    /// The facts for people.
    pub(crate) fn core(&self, instance: &Instance, within: Option<u32>) -> Core {
        let facts = self.groups.iter().map(|group| Fact {
            helps: self.helps.get(group).copied().unwrap_or_default(),
            ..group.fact(instance, within)
        });
        let further = self.further.iter();
        Core {
            facts: facts.collect(),
            minimal: self.minimal,
            reach: self.reach.into(),
            further: further.map(|core| core.core(instance, within)).collect(),
        }
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

struct Shrinking<'a> {
    instance: &'a Instance,
    deadline: Option<u32>,
    inquiry: &'a mut dyn Inquiry,
    left_out: BTreeSet<Group>,
    kept: BTreeSet<Group>,
    /// Plans that some variant had.
    plans: Vec<Plan>,
    /// How far the last refutation reaches.
    reach: Proved,
}

impl<'a> Shrinking<'a> {
    fn new(refuted: &Refuted<'a>, inquiry: &'a mut dyn Inquiry) -> Self {
        Self {
            instance: refuted.instance,
            deadline: refuted.deadline,
            inquiry,
            left_out: BTreeSet::new(),
            kept: BTreeSet::new(),
            plans: Vec::new(),
            reach: refuted.reach,
        }
    }

    /// Leaves out all that can be left out, class by class.
    fn minimal_set(mut self, asked: &[usize]) -> CoreFound {
        let all = groups(self.instance, asked, self.deadline.is_some());
        for kind in [
            FactKind::Task,
            FactKind::Waypoint,
            FactKind::Battery,
            FactKind::Floor,
            FactKind::Obstacle,
            FactKind::Collision,
            FactKind::Stay,
            FactKind::Slow,
            FactKind::Deadline,
            FactKind::Breakdown,
        ] {
            let mut class: Vec<Group> = all.iter().copied().filter(|p| p.kind() == kind).collect();
            class.retain(|&group| self.matters(group));
            if kind == FactKind::Obstacle {
                self.sort_by_distance(&mut class);
            }
            self.shrink(&class, false);
        }
        let minimal = self.check_minimality();
        CoreFound {
            groups: self.kept.iter().copied().collect(),
            minimal,
            reach: self.reach,
            helps: BTreeMap::new(),
            further: Vec::new(),
        }
    }

    /// Leaves out as many of some facts as can be; agents only if all of the
    /// facts can be left out, or once the others were tried.
    fn avoid(&mut self, facts: &[Group]) {
        if facts.is_empty() || self.leave_out(facts) {
            return;
        }
        let is_task = |group: &Group| group.kind() == FactKind::Task;
        let (tasks, others): (Vec<Group>, Vec<Group>) = facts.iter().partition(|g| is_task(g));
        self.shrink(&others, false);
        self.shrink(&tasks, false);
    }

    /// Tries to leave out all agents at once but those that clash.
    fn leave_out_strangers(&mut self, all: &[Group], clash: &[String]) {
        if clash.is_empty() {
            return;
        }
        let clashes = |&a: &usize| {
            let agent = self.instance.agents().get(a);
            agent.is_some_and(|agent| clash.contains(&agent.name))
        };
        let strangers: Vec<Group> = all
            .iter()
            .copied()
            .filter(|group| matches!(group, Group::Task(a) if !clashes(a)))
            .collect();
        if !strangers.is_empty() {
            self.leave_out(&strangers);
        }
    }

    /// Whether a fact is still to be tried: it says nothing where its agent is gone.
    fn matters(&self, group: Group) -> bool {
        let gone = |&a: &usize| self.left_out.contains(&Group::Task(a));
        let tried = self.left_out.contains(&group) || self.kept.contains(&group);
        !tried && !group.agents().iter().any(gone)
    }

    /// Obstacles far from the agents first: they matter least.
    fn sort_by_distance(&self, obstacles: &mut [Group]) {
        let agents = self.instance.agents().iter().enumerate();
        let cells: Vec<Cell> = agents
            .filter(|&(a, _)| !self.left_out.contains(&Group::Task(a)))
            .flat_map(|(_, agent)| {
                let ends = [Some(agent.start), agent.goal];
                let waypoints = agent.waypoints.iter().copied();
                waypoints.chain(ends.into_iter().flatten())
            })
            .collect();
        let distance = |group: &Group| match group {
            Group::Obstacle(o) => {
                let to = |c: &Cell| o.x.abs_diff(c.x) + o.y.abs_diff(c.y);
                cells.iter().map(to).min().unwrap_or(0)
            }
            _ => 0,
        };
        sort_by_key(obstacles, |group| std::cmp::Reverse(distance(group)));
    }

    /// Leaves out what can be left out of a block; true if something of it is
    /// needed. Where it is `known` that not all of it can be left out, that is
    /// not tried.
    fn shrink(&mut self, block: &[Group], known: bool) -> bool {
        if block.is_empty() || (!known && self.leave_out(block)) {
            return false;
        }
        if let [one] = block {
            self.kept.insert(*one);
            return true;
        }
        let (first, second) = block.split_at(block.len() / 2);
        let needed = self.shrink(first, false);
        // What is needed lies in the second half if it is not in the first.
        self.shrink(second, !needed) || needed
    }

    /// Leaves facts out if there is still no plan without them.
    fn leave_out(&mut self, block: &[Group]) -> bool {
        let mut less = self.left_out.clone();
        less.extend(block);
        match self.attempt(&less) {
            Tried::None { reach, .. } => {
                self.left_out = less;
                self.reach = reach;
                true
            }
            _ => false,
        }
    }

    fn attempt(&mut self, left_out: &BTreeSet<Group>) -> Tried {
        let variant = without(self.instance, left_out, self.deadline);
        if let Some(plan) = self.known(&variant) {
            return Tried::Plan(plan);
        }
        let tried = self.inquiry.search(&variant);
        if let Tried::Plan(plan) = &tried {
            self.plans.push(plan.clone());
        }
        tried
    }

    /// A plan of some variant that is one here, too.
    fn known(&self, variant: &Variant) -> Option<Plan> {
        let fits = self
            .plans
            .iter()
            .rev()
            .take(KNOWN)
            .map(|plan| super::group::fit(plan, &variant.instance));
        let mut fits = fits.filter(|plan| self.inquiry.accepts(variant, plan));
        fits.next()
    }

    /// Looks at every fact that is kept: true where all are needed for sure.
    fn check_minimality(&mut self) -> bool {
        let mut minimal = true;
        let mut next = 0;
        let kept: Vec<Group> = self.kept.iter().copied().collect();
        while let Some(&group) = kept.get(next) {
            next += 1;
            if !self.kept.contains(&group) {
                continue;
            }
            let mut less = self.left_out.clone();
            less.insert(group);
            match self.attempt(&less) {
                Tried::Plan(_) => {}
                Tried::Unknown => minimal = false,
                Tried::None { reach, .. } => {
                    // With it gone, others may be needed no longer.
                    self.left_out = less;
                    self.reach = reach;
                    self.kept.remove(&group);
                    minimal = true;
                    next = 0;
                }
            }
        }
        minimal
    }
}
