//! The tree of CBS by hand: a person says which node is split, at which of its conflicts, and
//! which agent the split names.
//!
//! Walks, conflicts and splits are those of the planner. A node stays as it was made: there is
//! no bypass. What was split last can be taken back.

mod choice;
mod standing;
#[cfg(test)]
mod tests;
mod told;

pub use choice::{Branch, Choice, HandError};
pub use standing::Standing;

use super::{
    Cardinality, CbsCost, Conflict, Constraint, Party, arrived,
    choice::{cardinality, choose},
    node::Node,
};
use crate::{
    budget::{Budget, MemoryUse, Stop},
    problem::Problem,
    walk::Walk,
};

/// More splits than this are not made by hand.
pub const MOST_SPLITS: usize = 200;

/// A tree that a person splits.
///
/// ```
/// use giveway_model::{Agent, Cell, Instance, Scene};
/// use giveway_planners::{
///     budget::Unlimited,
///     cbs::{CbsCost, Party, by_hand::{Choice, Hand, Standing}},
///     problem::Problem,
/// };
/// let agent = |name: &str, start, goal| Agent {
///     name: name.to_owned(), start, goal: Some(goal), waypoints: Vec::new(), battery: None, heading: None,
/// };
/// let scene = Scene {
///     map: ["#.#", "...", "#.#"].map(str::to_owned).to_vec(),
///     agents: vec![
///         agent("A", Cell::new(0, 1), Cell::new(2, 1)),
///         agent("B", Cell::new(1, 0), Cell::new(1, 2)),
///     ],
///     ..Scene::default()
/// };
/// let budget = Unlimited::default();
/// let problem = Problem::new(&Instance::new(scene).unwrap(), &budget).ok().unwrap();
/// let mut hand = Hand::new(&problem, CbsCost::SumOfCosts, 30, &budget).unwrap();
/// // Both are in the middle at time 1. The split names B.
/// assert_eq!(hand.conflicts(0).len(), 1);
/// hand.split(Choice { node: 0, conflict: 0, party: Party::Second }, &budget).unwrap();
/// assert!(matches!(hand.standing(), Standing::Proved { cost: 5, .. }));
/// ```
pub struct Hand<'p> {
    problem: &'p Problem,
    aim: CbsCost,
    horizon: u32,
    /// By number; each split adds two.
    nodes: Vec<HandNode>,
    splits: Vec<Choice>,
}

/// A node, whatever became of it.
struct HandNode {
    parent: Option<usize>,
    constraint: Option<Constraint>,
    /// `None`: some agent has no walk that keeps its constraints.
    node: Option<Node>,
    /// The cost of its walks, and its conflicts by time.
    cost: Option<u32>,
    conflicts: Vec<Conflict>,
    is_split: bool,
    _held: Option<MemoryUse>,
}

impl<'p> Hand<'p> {
    /// The root alone: each agent on a shortest walk. No walk is longer than the horizon, in
    /// time steps.
    ///
    /// # Errors
    /// When the budget is spent.
    pub fn new(
        problem: &'p Problem,
        aim: CbsCost,
        horizon: u32,
        budget: &dyn Budget,
    ) -> Result<Self, Stop> {
        budget.check()?;
        let root = Node::root(problem, horizon, budget)?;
        let mut hand = Self {
            problem,
            aim,
            horizon,
            nodes: Vec::new(),
            splits: Vec::new(),
        };
        hand.add(root, None, budget);
        Ok(hand)
    }

    fn add(
        &mut self,
        node: Option<Node>,
        from: Option<(usize, Constraint)>,
        budget: &dyn Budget,
    ) -> usize {
        let mut conflicts = node
            .as_ref()
            .map_or_else(Vec::new, |node| node.conflicts.clone());
        conflicts.sort_by_key(|one| (one.kind.time(), one.first.min(one.second), one.kind));
        self.nodes.push(HandNode {
            parent: from.map(|(parent, _)| parent),
            constraint: from.map(|(_, constraint)| constraint),
            cost: node.as_ref().map(|node| self.cost(node)),
            _held: node.as_ref().map(|node| budget.hold(node.bytes())),
            node,
            conflicts,
            is_split: false,
        });
        self.nodes.len() - 1
    }

    fn cost(&self, node: &Node) -> u32 {
        self.aim.of_arrivals(self.problem, node.arrivals())
    }

    /// No walk is longer than this, in time steps.
    pub const fn horizon(&self) -> u32 {
        self.horizon
    }

    /// The nodes so far, dead ends among them.
    pub fn count(&self) -> usize {
        self.nodes.len()
    }

    /// The splits so far, the first of them first.
    pub fn splits(&self) -> &[Choice] {
        &self.splits
    }

    /// The nodes that can be split: they have walks, and these have conflicts.
    pub fn open(&self) -> impl Iterator<Item = usize> + '_ {
        let nodes = self.nodes.iter().enumerate();
        nodes
            .filter(|(_, node)| node.is_open())
            .map(|(number, _)| number)
    }

    /// The conflicts of the walks of a node, by time; none of a node that is not there.
    pub fn conflicts(&self, node: usize) -> &[Conflict] {
        self.nodes.get(node).map_or(&[], |node| &node.conflicts)
    }

    /// What the rule of the planner splits a node on: of the most cardinal conflicts the first,
    /// naming its first agent. `None` where the node has no conflict.
    pub fn rule(&self, node: usize) -> Option<Choice> {
        let walks = self.nodes.get(node)?.node.as_ref()?;
        let (chosen, _) = choose(self.problem, &walks.conflicts, &walks.ways)?;
        let conflict = self.conflicts(node).iter().position(|one| one == chosen)?;
        Some(Choice {
            node,
            conflict,
            party: Party::First,
        })
    }

    /// The two branches that a split would make, at a node that is open or was split.
    ///
    /// # Errors
    /// When there is no such node or conflict, or the budget is spent.
    pub fn preview(&self, choice: Choice, budget: &dyn Budget) -> Result<[Branch; 2], HandError> {
        let [one, other] = self.children(choice, budget)?;
        let branch = |(constraint, child): (Constraint, Option<Node>)| Branch {
            constraint,
            cost: child.as_ref().map(|child| self.cost(child)),
            conflicts: child.map_or(0, |child| child.conflicts.len()),
        };
        Ok([branch(one), branch(other)])
    }

    /// Splits an open node; the numbers of its two branches.
    ///
    /// # Errors
    /// When there is no such node or conflict, the node is not open, there are
    /// [`MOST_SPLITS`], or the budget is spent.
    pub fn split(&mut self, choice: Choice, budget: &dyn Budget) -> Result<[usize; 2], HandError> {
        if self.splits.len() >= MOST_SPLITS {
            return Err(HandError::Full);
        }
        if !self.nodes.get(choice.node).is_some_and(HandNode::is_open) {
            return Err(HandError::NotOpen);
        }
        let children = self.children(choice, budget)?;
        if let Some(node) = self.nodes.get_mut(choice.node) {
            node.is_split = true;
        }
        self.splits.push(choice);
        Ok(children
            .map(|(constraint, child)| self.add(child, Some((choice.node, constraint)), budget)))
    }

    /// Takes back what was split last, and tells it; `None` where nothing was.
    pub fn take_back(&mut self) -> Option<Choice> {
        let last = self.splits.pop()?;
        // The branches of the last split have no branches of their own.
        self.nodes.truncate(self.nodes.len().saturating_sub(2));
        if let Some(node) = self.nodes.get_mut(last.node) {
            node.is_split = false;
        }
        Some(last)
    }

    fn children(
        &self,
        choice: Choice,
        budget: &dyn Budget,
    ) -> Result<[(Constraint, Option<Node>); 2], HandError> {
        budget.check()?;
        let Some((own, node)) = self
            .nodes
            .get(choice.node)
            .and_then(|own| Some((own, own.node.as_ref()?)))
        else {
            return Err(HandError::NotOpen);
        };
        let conflict = own.conflicts.get(choice.conflict);
        let conflict = conflict.ok_or(HandError::NoConflict {
            of: own.conflicts.len(),
        })?;
        let [one, other] = conflict.split_naming(choice.party);
        let child = |constraint| node.child(self.problem, constraint, self.horizon, budget);
        Ok([(one, child(one)?), (other, child(other)?)])
    }

    /// The walks of a node up to their arrivals; `None` where it has none.
    pub fn walks(&self, node: usize) -> Option<Vec<Walk>> {
        let node = self.nodes.get(node)?.node.as_ref()?;
        let ways = node.ways.iter().enumerate();
        Some(
            ways.map(|(agent, way)| arrived(self.problem, agent, &way.walk))
                .collect(),
        )
    }

    /// How many of the agents of a conflict of a node have no walk as short without it.
    pub fn cardinality(&self, node: usize, conflict: usize) -> Option<Cardinality> {
        let own = self.nodes.get(node)?;
        let conflict = own.conflicts.get(conflict)?;
        let ways = &own.node.as_ref()?.ways;
        Some(cardinality(self.problem, conflict, ways))
    }
}

impl HandNode {
    fn is_open(&self) -> bool {
        self.cost.is_some() && !self.is_split && !self.conflicts.is_empty()
    }

    /// The cost of a plan: of walks without a conflict.
    fn plan(&self) -> Option<u32> {
        self.cost.filter(|_| self.conflicts.is_empty())
    }
}
