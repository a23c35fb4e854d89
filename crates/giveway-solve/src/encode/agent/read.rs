//! The agent's walk in a model of its clauses.

use super::MddEncoding;
use crate::{
    sat::Lit,
    single::{Place, Task},
};

impl MddEncoding {
    /// The places of the agent at each time up to its arrival, in a model.
    pub(crate) fn walk(&self, task: &Task, is_true: impl Fn(Lit) -> bool) -> Vec<Place> {
        let mut walk = self.read(task, is_true);
        // A model may call it arrived later than it is.
        while task.ends_with_rest(&walk) {
            walk.pop();
        }
        walk
    }

    fn read(&self, task: &Task, is_true: impl Fn(Lit) -> bool) -> Vec<Place> {
        let mut walk = Vec::new();
        let mut id = 0;
        loop {
            let node = self.mdd.node(id);
            walk.push(node.place);
            let resting = match node.place {
                Place::At(v) => self.rest(v, node.time + 1),
                Place::Along(_) => None,
            };
            let ends = if self.stays {
                resting.is_none_or(&is_true)
            } else {
                self.leaves(id).is_none_or(&is_true)
            };
            if self.is_end(node, task) && ends {
                return walk;
            }
            let written = self.written[id as usize] as usize;
            let next = node.steps.iter().take(written).find_map(|step| {
                let to = self.mdd.find(node.time + 1, step.place, step.mask)?;
                is_true(self.nodes[to as usize]).then_some(to)
            });
            match next {
                Some(to) => id = to,
                None => return walk, // no model of the clauses: the checker will say so
            }
        }
    }
}
