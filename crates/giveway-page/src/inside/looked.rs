//! What was found out about a scene: the tree of CBS, what came of orders, and how planners of
//! crowds went.

use std::collections::BTreeMap;
use std::rc::Rc;

use giveway_model::{Costs, Path, Plan};
use giveway_solve::plan::{NodeFate, OrderTried, PlanAnswer, TreeNode, Went, words};
use giveway_solve::together::TogetherAnswer;
use giveway_solve::trace::Core;

use super::by_hand::HandRun;
use super::crowd::{LacamRun, PibtRun};
use super::looking::{Looking, What};
use crate::{Document, Draft};

/// So many steps are remembered whose robots were looked at.
const MOST_CLOSER: usize = 40;

/// What the worker told.
pub(crate) enum Told {
    /// Of a planner.
    Planned(Box<PlanAnswer>),
    /// Of the robots of a step.
    Together(Box<TogetherAnswer>),
    /// Nothing, and why, as a sentence.
    Not(String),
}

/// What was found out about a scene.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Looked {
    draft: Rc<Draft>,
    within: Option<u32>,
    /// The tree of CBS, or why there is none, as a sentence.
    pub(crate) tree: Option<Result<Rc<TreeRun>, String>>,
    /// The tree of CBS by hand, or why there is none, as a sentence.
    pub(crate) by_hand: Option<Result<Rc<HandRun>, String>>,
    /// The steps of PIBT, or why there are none, as a sentence.
    pub(crate) pibt: Option<Result<Rc<PibtRun>, String>>,
    /// The configurations of `LaCAM`, or why there are none, as a sentence.
    pub(crate) lacam: Option<Result<Rc<LacamRun>, String>>,
    /// What came of orders.
    pub(crate) orders: Vec<OrderRun>,
    /// What was found out about the robots of steps, the last of them.
    closer: Vec<(Core, Result<Rc<TogetherAnswer>, String>)>,
    /// Why no more orders are tried, as a sentence.
    pub(crate) failed: Option<String>,
}

/// The tree of CBS.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct TreeRun {
    /// The nodes by number, the first of them.
    pub(crate) nodes: Vec<TreeNode>,
    /// How many more there were.
    pub(crate) left_out: u64,
    /// The nodes that were opened, in turn.
    pub(crate) opened: Vec<u64>,
    /// The children of each node that was split.
    pub(crate) children: BTreeMap<u64, Vec<u64>>,
    /// How it ended, in a sentence.
    pub(crate) ended: String,
}

/// What came of an order.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct OrderRun {
    pub(crate) told: OrderTried,
    /// The costs of the plan, where it is known.
    pub(crate) costs: Option<Costs>,
}

impl OrderRun {
    /// Whether its paths were told.
    pub(crate) fn is_told(&self) -> bool {
        let mut planned = self.told.planned.iter();
        planned.all(|planned| !planned.path.is_empty())
    }
}

impl Looked {
    pub(crate) fn is_of(&self, document: &Document) -> bool {
        Rc::ptr_eq(&self.draft, &document.draft) && self.within == document.within
    }

    /// What is known with an answer more; `answer` is why there is none.
    pub(crate) fn with(before: Option<&Self>, looking: &Looking, answer: Told) -> Self {
        let is_same = |looked: &&Self| {
            Rc::ptr_eq(&looked.draft, &looking.draft) && looked.within == looking.within
        };
        let mut looked = before.filter(is_same).cloned().unwrap_or_else(|| Self {
            draft: Rc::clone(&looking.draft),
            within: looking.within,
            tree: None,
            by_hand: None,
            pibt: None,
            lacam: None,
            orders: Vec::new(),
            closer: Vec::new(),
            failed: None,
        });
        if let What::Together(core) = &looking.what {
            looked.look_closer((**core).clone(), answer);
            return looked;
        }
        let (plan, costs, ended, told) = match answer {
            Told::Planned(mut answer) => (
                answer.plan.take(),
                answer.costs,
                Some(answer.ended.clone()),
                went(*answer),
            ),
            Told::Not(why) => (None, None, None, Err(why)),
            // The answer to another request.
            Told::Together(_) => return looked,
        };
        match (&looking.what, told) {
            (What::Tree, told) => {
                looked.tree = Some(told.and_then(|(went, ended)| TreeRun::new(went, ended)));
            }
            (What::ByHand(asked), told) => {
                looked.by_hand = Some(HandRun::new(asked, told, (ended.as_ref(), costs)));
            }
            (What::Pibt, told) => {
                let run = told.and_then(|(went, ended)| PibtRun::new(went, (plan, costs), ended));
                looked.pibt = Some(run);
            }
            (What::Lacam, told) => {
                let agents = looking.draft.agents();
                let run = told.and_then(|(went, ended)| LacamRun::new(went, agents, costs, ended));
                looked.lacam = Some(run);
            }
            (_, Err(why)) => looked.failed = Some(why),
            (what, Ok((Went::Prioritised { orders }, _))) => {
                looked.add(what, orders, costs);
            }
            (_, Ok((_, ended))) => looked.failed = Some(ended),
        }
        looked
    }

    fn add(&mut self, what: &What, orders: Vec<OrderTried>, costs: Option<Costs>) {
        for told in orders {
            let costs = costs.filter(|_| told.stuck.is_none());
            let run = OrderRun { told, costs };
            let same = |other: &&mut OrderRun| other.told.order == run.told.order;
            match self.orders.iter_mut().find(same) {
                Some(known) if matches!(what, What::Order(_)) => *known = run,
                Some(_) => {}
                None => self.orders.push(run),
            }
        }
    }

    fn look_closer(&mut self, core: Core, answer: Told) {
        let told = match answer {
            Told::Together(answer) => Ok(Rc::from(answer)),
            Told::Not(why) => Err(why),
            Told::Planned(_) => return,
        };
        self.closer.retain(|(other, _)| *other != core);
        self.closer.insert(0, (core, told));
        self.closer.truncate(MOST_CLOSER);
    }

    /// What was found out about the robots of a step; `None` where that was not asked.
    pub(crate) fn closer(&self, core: &Core) -> Option<&Result<Rc<TogetherAnswer>, String>> {
        let mut closer = self.closer.iter();
        closer
            .find(|(other, _)| other == core)
            .map(|(_, told)| told)
    }

    /// The same without what was not answered.
    pub(crate) fn again(&self) -> Self {
        Self {
            tree: self.tree.clone().filter(Result::is_ok),
            by_hand: self.by_hand.clone().filter(Result::is_ok),
            pibt: self.pibt.clone().filter(Result::is_ok),
            lacam: self.lacam.clone().filter(Result::is_ok),
            closer: self
                .closer
                .iter()
                .filter(|(_, told)| told.is_ok())
                .cloned()
                .collect(),
            failed: None,
            ..self.clone()
        }
    }
}

/// How it went, and how it ended in a sentence; or only the latter.
fn went(answer: PlanAnswer) -> Result<(Went, String), String> {
    let ended = words::headline(&answer).to_string();
    match answer.trace {
        Some(trace) => Ok((trace.went, ended)),
        None => Err(ended),
    }
}

impl TreeRun {
    fn new(went: Went, ended: String) -> Result<Rc<Self>, String> {
        let Went::Cbs { nodes, left_out } = went else {
            return Err(ended);
        };
        Ok(Rc::new(Self::of(nodes, left_out, ended)))
    }

    /// The tree of some nodes; so many more are left out.
    pub(crate) fn of(nodes: Vec<TreeNode>, left_out: u64, ended: String) -> Self {
        let mut turns = BTreeMap::new();
        let mut children: BTreeMap<u64, Vec<u64>> = BTreeMap::new();
        for node in &nodes {
            if let NodeFate::Split { turn, .. } | NodeFate::Best { turn, .. } = node.fate {
                turns.insert(turn, node.id);
            }
            if let Some(parent) = node.parent {
                children.entry(parent).or_default().push(node.id);
            }
        }
        Self {
            opened: turns.into_values().collect(),
            nodes,
            left_out,
            children,
            ended,
        }
    }

    pub(crate) fn node(&self, id: u64) -> Option<&TreeNode> {
        self.nodes.get(usize::try_from(id).ok()?)
    }

    /// The nodes from a node up to the root, itself first.
    pub(crate) fn lineage(&self, id: u64) -> Vec<&TreeNode> {
        let parent = |node: &&TreeNode| self.node(node.parent?);
        std::iter::successors(self.node(id), parent).collect()
    }

    pub(crate) fn children(&self, id: u64) -> &[u64] {
        self.children.get(&id).map_or(&[], Vec::as_slice)
    }

    /// The paths of a node: its own, else those of the nearest ancestor.
    pub(crate) fn plan(&self, id: u64) -> Plan {
        let mut plan = Plan::default();
        let own = |node: &&TreeNode| node.cost.is_some();
        for node in self.lineage(id).iter().filter(|node| own(node)) {
            for (name, path) in &node.paths {
                let paths: &mut BTreeMap<String, Path> = &mut plan.paths;
                paths.entry(name.clone()).or_insert_with(|| path.clone());
            }
        }
        plan
    }

    /// Whether a node leads to the best plan.
    pub(crate) fn leads_to_best(&self, id: u64) -> bool {
        let best = self.opened.last().and_then(|&last| self.node(last));
        let best = best.filter(|node| matches!(node.fate, NodeFate::Best { .. }));
        best.is_some_and(|best| self.lineage(best.id).iter().any(|node| node.id == id))
    }
}
