//! Minimal sets on a large floor: only agents that alone exclude a plan, and shelf blocks as a
//! whole.

use std::collections::BTreeMap;

use giveway_model::sorting::sort_by_key;

use super::{
    CoreFound, Tried,
    shrinking::{Shrinking, turn},
};
use crate::explain::{
    causes::Refuted,
    group::{Group, groups},
    growing::{ForcingSet, others},
    shelves::shelf_blocks,
};

/// Each obstacle is tried where no more are left.
const FEW_OBSTACLES: usize = 24;

impl Shrinking<'_> {
    /// Leaves out all agents but those that alone exclude a plan.
    pub(super) fn begin_with(&mut self, refuted: &Refuted, forcing: ForcingSet) {
        self.left_out = others(refuted, &forcing.agents);
        self.reach = forcing.reach;
        self.plans = forcing.plans;
        if forcing.is_smallest {
            let asked = refuted.asked;
            let needed = forcing.agents.iter().filter(|agent| !asked.contains(agent));
            let needed: Vec<Group> = needed.copied().map(Group::Task).collect();
            self.kept.extend(&needed);
            self.shown.extend(&needed);
        }
    }

    /// Leaves out what can be left out, obstacles by whole shelf blocks: a large floor has too
    /// many to try each. Where few are left, each is tried. What brief searches do not decide is
    /// tried once more.
    pub(super) fn minimal_units(mut self, asked: &[usize]) -> CoreFound {
        let mut all = groups(self.instance, asked, self.deadline.is_some());
        // (Without slow zones a plan of what was left out before may be none.)
        sort_by_key(&mut all, |&group| (group != Group::Slow, turn(group)));
        let mut has_large = false;
        let mut obstacles_done = false;
        self.is_brief = true;
        for group in all {
            if !self.matters(group) {
                continue;
            }
            if !matches!(group, Group::Obstacle(_)) {
                self.leave_out_unit(&[group]);
            } else if !obstacles_done {
                obstacles_done = true;
                has_large = self.leave_out_blocks();
            }
        }
        self.is_brief = false;
        if !has_large {
            // (Without slow zones a plan of what was left out before may be none.)
            let is_open = |group: &&Group| **group != Group::Slow && !self.shown.contains(*group);
            let open: Vec<Group> = self.kept.iter().filter(is_open).copied().collect();
            for group in open {
                self.kept.remove(&group);
                if self.matters(group) {
                    self.leave_out_unit(&[group]);
                }
            }
        }
        let kept: Vec<Group> = self.kept.iter().copied().collect();
        let minimal = !has_large && kept.iter().all(|group| self.shown.contains(group));
        CoreFound {
            groups: kept,
            minimal,
            reach: self.reach,
            helps: BTreeMap::new(),
            prices: BTreeMap::new(),
            needed: self.shown,
            is_of_another: false,
            further: Vec::new(),
        }
    }

    /// Leaves out facts together, or keeps them all; remembers where that is needed for sure.
    fn leave_out_unit(&mut self, unit: &[Group]) {
        let mut less = self.left_out.clone();
        less.extend(unit);
        match self.attempt(&less) {
            Tried::None { reach, .. } => {
                self.left_out = less;
                self.reach = reach;
            }
            Tried::Plan(_) => {
                self.kept.extend(unit);
                self.shown.extend(unit);
            }
            Tried::Unknown => self.kept.extend(unit),
        }
    }

    /// Leaves out whole shelf blocks, those far from the agents first; true where some are left
    /// of which not each obstacle was tried.
    fn leave_out_blocks(&mut self) -> bool {
        let mut blocks: BTreeMap<usize, Vec<Group>> = BTreeMap::new();
        for (cell, block) in shelf_blocks(self.instance.grid()) {
            let obstacle = Group::Obstacle(cell);
            if self.matters(obstacle) {
                blocks.entry(block).or_default().push(obstacle);
            }
        }
        let mut obstacles: Vec<Group> = blocks.values().flatten().copied().collect();
        if self.leave_out(&obstacles) {
            return false;
        }
        self.sort_by_distance(&mut obstacles);
        let place = |block: &Vec<Group>| {
            let last = obstacles.iter().rposition(|it| block.contains(it));
            last.unwrap_or_default()
        };
        let mut all: Vec<Vec<Group>> = blocks.into_values().collect();
        sort_by_key(&mut all, place);
        let mut blocks = Vec::new();
        self.leave_out_halves(&all, true, &mut blocks);
        let is_small = blocks.iter().map(Vec::len).sum::<usize>() <= FEW_OBSTACLES;
        for block in &blocks {
            if is_small {
                for &obstacle in block {
                    self.leave_out_unit(&[obstacle]);
                }
            } else {
                self.leave_out_unit(block);
            }
        }
        !is_small && blocks.iter().any(|block| block.len() > 1)
    }

    /// Leaves out as many of the blocks as can be, and says which are left. Where it is `known`
    /// that not all can be left out, that is not tried.
    fn leave_out_halves(&mut self, blocks: &[Vec<Group>], known: bool, left: &mut Vec<Vec<Group>>) {
        let all: Vec<Group> = blocks.iter().flatten().copied().collect();
        if all.is_empty() || (!known && self.leave_out(&all)) {
            return;
        }
        if let [one] = blocks {
            left.push(one.clone());
            return;
        }
        let (first, second) = blocks.split_at(blocks.len() / 2);
        self.leave_out_halves(first, false, left);
        self.leave_out_halves(second, false, left);
    }
}
