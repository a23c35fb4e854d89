//! What the worker told of a search by hand.

use std::rc::Rc;

use giveway_model::Costs;
use giveway_solve::Reach;
use giveway_solve::plan::{ByHand as Asked, ConflictChoice, NodeChoices, PlanEnd, SplitMade, Went};

use crate::inside::TreeRun;

/// A tree by hand.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct HandRun {
    /// The splits that it is of, and the node whose conflicts it tells.
    pub(crate) asked: Asked,
    /// The tree.
    pub(crate) tree: TreeRun,
    /// The splits, each with what the planner's rule would have split there.
    pub(crate) splits: Vec<SplitMade>,
    /// What can be split at the node; `None` where that is not open.
    pub(crate) choices: Option<NodeChoices>,
    /// How far the claim reaches that the plan is best; `None` while it is not proved.
    pub(crate) proved: Option<Reach>,
    /// The makespan up to which all branches are dead ends.
    pub(crate) exhausted: Option<u32>,
    /// The costs of the cheapest plan so far.
    pub(crate) costs: Option<Costs>,
}

impl HandRun {
    /// What came of a request; `ended` is the sentence where there is no tree.
    pub(crate) fn new(
        asked: &Asked,
        told: Result<(Went, String), String>,
        (end, costs): (Option<&PlanEnd>, Option<Costs>),
    ) -> Result<Rc<Self>, String> {
        let (went, ended) = told?;
        let Went::CbsByHand {
            nodes,
            splits,
            choices,
        } = went
        else {
            return Err(ended);
        };
        Ok(Rc::new(Self {
            asked: asked.clone(),
            tree: TreeRun::of(nodes, 0, ended),
            splits,
            choices,
            proved: match end {
                Some(PlanEnd::Best { reach }) => Some(*reach),
                _ => None,
            },
            exhausted: match end {
                Some(PlanEnd::Horizon { within }) => Some(*within),
                _ => None,
            },
            costs,
        }))
    }

    /// A conflict of the node that can be split.
    pub(crate) fn choice(&self, conflict: usize) -> Option<&ConflictChoice> {
        self.choices.as_ref()?.conflicts.get(conflict)
    }
}
