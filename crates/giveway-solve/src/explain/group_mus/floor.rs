//! The first steps on a large floor: only agents that alone exclude a plan, then whole shelf
//! blocks.

use std::collections::BTreeMap;

use giveway_model::sorting::sort_by_key;

use super::shrinking::Shrinking;
use crate::explain::{
    causes::Refuted,
    group::Group,
    growing::{ForcingSet, others},
    shelves::shelf_blocks,
};

impl Shrinking<'_> {
    /// Leaves out all agents but those that alone exclude a plan.
    pub(super) fn begin_with(&mut self, refuted: &Refuted, forcing: ForcingSet) {
        self.left_out = others(refuted, &forcing.agents);
        self.reach = forcing.reach;
        self.plans = forcing.plans;
        if forcing.is_smallest {
            let asked = refuted.asked;
            let needed = forcing.agents.iter().filter(|agent| !asked.contains(agent));
            self.kept.extend(needed.copied().map(Group::Task));
        }
    }

    /// Leaves out whole shelf blocks, those far from the agents first.
    pub(super) fn leave_out_blocks(&mut self) {
        let mut blocks: BTreeMap<usize, Vec<Group>> = BTreeMap::new();
        for (cell, block) in shelf_blocks(self.instance.grid()) {
            let obstacle = Group::Obstacle(cell);
            if self.matters(obstacle) {
                blocks.entry(block).or_default().push(obstacle);
            }
        }
        let mut obstacles: Vec<Group> = blocks.values().flatten().copied().collect();
        if self.leave_out(&obstacles) {
            return;
        }
        self.sort_by_distance(&mut obstacles);
        let place = |block: &Vec<Group>| {
            let last = obstacles.iter().rposition(|it| block.contains(it));
            last.unwrap_or_default()
        };
        let mut blocks: Vec<Vec<Group>> = blocks.into_values().collect();
        sort_by_key(&mut blocks, place);
        for block in blocks {
            self.leave_out(&block);
        }
    }
}
