//! Deletion with blocks, class by class (Junker, 2004), and the minimality check.

use std::collections::{BTreeMap, BTreeSet};

use giveway_model::{
    Cell, Instance, Plan,
    sorting::{set, sort, sort_by_key},
};

use super::{CoreFound, Inquiry, Tried};
use crate::{
    explain::{
        causes::Refuted,
        group::{Group, Variant, fit, groups, without},
    },
    search::Proved,
};

/// The latest plans of other variants that are tried before any search.
const KNOWN: usize = 12;

/// When the class of a fact is tried: without agents everything else is quickly tried.
pub(super) const fn turn(group: Group) -> u8 {
    match group {
        Group::Task(_) => 0,
        Group::Waypoint(..) => 1,
        Group::Battery(_) => 2,
        Group::Floor => 3,
        Group::Obstacle(_) => 4,
        Group::Collision(..) => 5,
        Group::Stay(_) => 6,
        Group::Slow => 7,
        Group::Deadline => 8,
        Group::Breakdown(..) => 9,
        Group::Constraint(_) => 10,
    }
}

/// A set of facts from which more and more are left out.
pub(super) struct Shrinking<'a> {
    pub(super) instance: &'a Instance,
    pub(super) deadline: Option<u32>,
    inquiry: &'a mut dyn Inquiry,
    pub(super) left_out: BTreeSet<Group>,
    pub(super) kept: BTreeSet<Group>,
    /// Facts that are needed for sure, alone or with all of their shelf block.
    pub(super) shown: BTreeSet<Group>,
    /// Plans that some variant had.
    pub(super) plans: Vec<Plan>,
    /// How far the whole instance is refuted: no set is smaller because it reaches less far.
    claim: Proved,
    /// How far the last refutation reaches.
    pub(super) reach: Proved,
    /// Whether searches are brief: on a large floor few of them decide much.
    pub(super) is_brief: bool,
}

impl<'a> Shrinking<'a> {
    pub(super) fn new(refuted: &Refuted<'a>, inquiry: &'a mut dyn Inquiry) -> Self {
        Self {
            instance: refuted.instance,
            deadline: refuted.deadline,
            inquiry,
            left_out: BTreeSet::new(),
            kept: BTreeSet::new(),
            shown: BTreeSet::new(),
            plans: Vec::new(),
            claim: refuted.reach,
            reach: refuted.reach,
            is_brief: false,
        }
    }

    /// Leaves out all that can be left out, class by class.
    pub(super) fn minimal_set(mut self, asked: &[usize]) -> CoreFound {
        let all = groups(self.instance, asked, self.deadline.is_some());
        let mut turns: Vec<u8> = all.iter().copied().map(turn).collect();
        sort(&mut turns);
        turns.dedup();
        for now in turns {
            let mut class: Vec<Group> = all.iter().copied().filter(|&g| turn(g) == now).collect();
            class.retain(|&group| self.matters(group));
            self.sort_by_distance(&mut class);
            self.shrink(&class, false);
        }
        let minimal = self.check_minimality();
        CoreFound {
            groups: self.kept.iter().copied().collect(),
            minimal,
            reach: self.reach,
            helps: BTreeMap::new(),
            prices: BTreeMap::new(),
            needed: BTreeSet::new(),
            is_of_another: false,
            further: Vec::new(),
        }
    }

    /// Leaves out all rules of the scene's own that can be left out.
    pub(super) fn shrink_rules(&mut self) {
        let rules = self.instance.rules_in_effect().into_iter();
        let mut rules: Vec<Group> = rules.map(Group::Constraint).collect();
        rules.retain(|&rule| self.matters(rule));
        self.shrink(&rules, false);
    }

    /// The rules of the scene's own that could not be left out.
    pub(super) fn kept_rules(&self) -> BTreeSet<usize> {
        let kept = self.kept.iter();
        set(kept.filter_map(|group| match group {
            Group::Constraint(rule) => Some(*rule),
            _ => None,
        }))
    }

    /// Leaves out as many of some facts as can be; agents only if all of the
    /// facts can be left out, or once the others were tried.
    pub(super) fn avoid(&mut self, facts: &[Group]) {
        if facts.is_empty() || self.leave_out(facts) {
            return;
        }
        let is_task = |group: &Group| matches!(group, Group::Task(_));
        let (tasks, others): (Vec<Group>, Vec<Group>) = facts.iter().partition(|g| is_task(g));
        self.shrink(&others, false);
        self.shrink(&tasks, false);
    }

    /// Tries to leave out all agents at once but those that clash.
    pub(super) fn leave_out_strangers(&mut self, all: &[Group], clash: &[String]) {
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
    pub(super) fn matters(&self, group: Group) -> bool {
        let gone = |&a: &usize| self.left_out.contains(&Group::Task(a));
        let tried = self.left_out.contains(&group) || self.kept.contains(&group);
        !tried && !group.agents().iter().any(gone)
    }

    /// Obstacles far from the agents first: they matter least.
    pub(super) fn sort_by_distance(&self, obstacles: &mut [Group]) {
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
        // If the needed fact is not in the first half, it is in the second.
        self.shrink(second, !needed) || needed
    }

    /// Leaves facts out if there is still no plan without them.
    pub(super) fn leave_out(&mut self, block: &[Group]) -> bool {
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

    /// The same with more work, where that of one of many searches is not enough.
    fn attempt_again(&mut self, left_out: &BTreeSet<Group>) -> Tried {
        let first = self.attempt(left_out);
        if !matches!(first, Tried::Unknown) || self.inquiry.is_over() {
            return first;
        }
        let variant = without(self.instance, left_out, self.deadline);
        let tried = self.inquiry.search_again(&variant);
        let tried = tried.reaching(&variant, self.claim);
        if let Tried::Plan(plan) = &tried {
            self.plans.push(plan.clone());
        }
        tried
    }

    pub(super) fn attempt(&mut self, left_out: &BTreeSet<Group>) -> Tried {
        if self.inquiry.is_over() {
            return Tried::Unknown;
        }
        let variant = without(self.instance, left_out, self.deadline);
        if let Some(plan) = self.known(&variant) {
            return Tried::Plan(plan);
        }
        let tried = if self.is_brief {
            self.inquiry.search_briefly(&variant)
        } else {
            self.inquiry.search(&variant)
        };
        let tried = tried.reaching(&variant, self.claim);
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
            .map(|plan| fit(plan, &variant.instance));
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
            match self.attempt_again(&less) {
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
