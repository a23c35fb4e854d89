//! Pairs of edits of which neither helps alone.
//!
//! The first edit comes from the first set of facts that excludes a plan, the second
//! from a set that does so after the first edit: no other pair can help.

use std::collections::BTreeSet;

use giveway_model::Instance;

use super::{
    super::{
        answer::Edit,
        edits::edited,
        group::{Group, has_slow_edge, without},
        group_mus::group_mus,
    },
    candidate::Candidate,
    search::RepairSearch,
};

/// The most pairs that are tried.
const MOST_PAIRS: usize = 400;

impl RepairSearch<'_> {
    /// Tries the pairs whose first edit is one of the singles, all of which were tried.
    pub(super) fn try_pairs(&mut self, singles: &[Candidate]) {
        let mut cores = self.broken.cores.clone();
        let mut pairs = BTreeSet::new();
        for first in singles {
            if self.tried.outcomes.get(first) != Some(&Some(false)) {
                continue;
            }
            let after = self.after(first);
            let Some(core) = self.core_after(first, &after, &mut cores) else {
                self.exhaustive = false;
                continue;
            };
            // A slow zone that becomes normal is no mere relaxation.
            self.exhaustive &= core.contains(&Group::Slow) || !has_slow_edge(after.instance.grid());
            for second in self.candidates(&after.instance, &core) {
                if second == *first || self.leaves_nobody(first, &second) {
                    continue;
                }
                match self.try_alone(&second) {
                    Some(false) => {}
                    Some(true) | None => continue,
                }
                let pair = (first.min(&second).clone(), first.max(&second).clone());
                if pairs.contains(&pair) {
                    continue;
                }
                if pairs.len() == MOST_PAIRS {
                    self.exhaustive = false;
                    return;
                }
                self.attempt(&[&pair.0, &pair.1]);
                pairs.insert(pair);
            }
        }
    }

    /// Whether two edits leave out all agents: that repairs nothing.
    fn leaves_nobody(&self, first: &Candidate, second: &Candidate) -> bool {
        let leaves = |edit: &Candidate| matches!(edit, Candidate::Edit(Edit::LeaveOut { .. }));
        leaves(first) && leaves(second) && self.broken.instance.agents().len() <= 2
    }

    fn after(&self, edit: &Candidate) -> After {
        let broken = self.broken;
        let mut after = After {
            instance: broken.instance.clone(),
            left_out: BTreeSet::new(),
            within: broken.within,
        };
        match edit {
            // So that the numbers of the other agents stay.
            Candidate::Edit(Edit::LeaveOut { agent }) => {
                let number = after
                    .instance
                    .agents()
                    .iter()
                    .position(|a| a.name == *agent);
                after.left_out.extend(number.map(Group::Task));
            }
            Candidate::Deadline => after.within = None,
            edit => {
                let edits: Vec<Edit> = edit.strongest(broken.instance).into_iter().collect();
                after.instance = edited(broken.instance, &edits, None, broken.whole).instance;
            }
        }
        after
    }

    /// A set of facts that excludes a plan after an edit: one of those that are known,
    /// where the edit weakens none of its facts, else a new one.
    fn core_after(
        &mut self,
        edit: &Candidate,
        after: &After,
        cores: &mut Vec<Vec<Group>>,
    ) -> Option<Vec<Group>> {
        let broken = self.broken;
        let weakens = |&fact: &Group| edit.weakens(fact, broken.instance);
        if let Some(core) = cores.iter().find(|core| !core.iter().any(weakens)) {
            return Some(core.clone());
        }
        let (instance, left_out) = (&after.instance, &after.left_out);
        let variant = without(instance, left_out, after.within);
        let refuted = self.solver.search(&variant);
        let (asked, within) = (broken.asked, after.within);
        let core = group_mus(
            instance,
            asked,
            within,
            left_out,
            refuted,
            &mut *self.solver,
        )?;
        // It holds of the instance as it is, too, unless the edit changed a fact of it.
        if !core.groups.iter().any(weakens) {
            cores.push(core.groups.clone());
        }
        Some(core.groups)
    }
}

/// The instance after an edit, with agents by their numbers before it.
struct After {
    instance: Instance,
    left_out: BTreeSet<Group>,
    within: Option<u32>,
}
