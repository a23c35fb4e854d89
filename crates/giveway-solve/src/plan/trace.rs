//! How a planner went, with names and cells instead of numbers.

use borsh::{BorshDeserialize, BorshSerialize};
use giveway_model::{Cell, Version};
use giveway_planners::{
    AgentId,
    cbs::{Cardinality, Conflict, Constraint, Fate, Kind, Rule, Tree},
    planner::Trace,
    prioritised::{Attempt, Stuck},
    problem::Problem,
    terrain::Vertex,
};
use serde::{Deserialize, Serialize};

use super::StuckAgent;

/// How a planner went.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
pub struct PlanTrace {
    /// The format's version.
    pub giveway: Version,
    /// What happened.
    #[serde(flatten)]
    pub went: Went,
}

/// What happened, by planner.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
#[serde(tag = "planner", rename_all = "kebab-case")]
pub enum Went {
    /// The orders that were tried.
    Prioritised {
        /// One after the other, the first of them.
        orders: Vec<OrderTried>,
    },
    /// The constraint tree.
    Cbs {
        /// The nodes by number, the first of them.
        nodes: Vec<TreeNode>,
        /// How many more there were.
        left_out: u64,
    },
}

/// One order of prioritised planning.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
pub struct OrderTried {
    /// The agents.
    pub order: Vec<String>,
    /// Those that got a path, in this order.
    pub planned: Vec<PlannedAgent>,
    /// The one that did not; `null` where the order works.
    pub stuck: Option<StuckAgent>,
}

/// An agent that got a path.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
pub struct PlannedAgent {
    /// Who.
    pub agent: String,
    /// When it arrives.
    pub arrival: u32,
    /// When it would arrive alone.
    pub alone: u32,
    /// Where it arrives later than alone: whom it had to avoid.
    pub around: Vec<String>,
}

/// A node of the constraint tree.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
pub struct TreeNode {
    /// Its number.
    pub id: u64,
    /// The number of its parent; `null` for the root.
    pub parent: Option<u64>,
    /// What it asks beside what its parent does.
    pub constraint: Option<ToldConstraint>,
    /// The cost of its paths: no plan that keeps its constraints costs less. `null`
    /// where an agent cannot keep them.
    pub cost: Option<u32>,
    /// How many conflicts its paths have.
    pub conflicts: u64,
    /// What became of it.
    #[serde(flatten)]
    pub fate: NodeFate,
}

/// What became of a node.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
#[serde(tag = "fate", rename_all = "kebab-case")]
pub enum NodeFate {
    /// It was not taken out of the open list.
    Open,
    /// An agent cannot keep its constraints.
    Dead,
    /// It was taken out and split at a conflict.
    Split {
        /// As the n-th, from 0.
        turn: u64,
        /// The conflict.
        conflict: ToldConflict,
        /// How often it took the paths of a child that cost no more (bypass).
        bypassed: u32,
    },
    /// It is the answer.
    Best {
        /// As the n-th, from 0.
        turn: u64,
        /// How often it took the paths of a child that cost no more (bypass).
        bypassed: u32,
    },
}

/// A constraint. A positive one (at, along, arrive by) also keeps all others away.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
#[serde(tag = "rule", rename_all = "kebab-case")]
#[expect(missing_docs, reason = "an agent, a cell or an edge, a time in steps")]
pub enum ToldConstraint {
    /// It is not at a cell at a time.
    NotAt {
        agent: String,
        cell: Cell,
        time: u32,
    },
    /// It is at a cell at a time.
    At {
        agent: String,
        cell: Cell,
        time: u32,
    },
    /// It is not on its way from a cell to the next in the step from a time.
    NotAlong {
        agent: String,
        edge: [Cell; 2],
        time: u32,
    },
    /// It is on its way from a cell to the next in the step from a time.
    Along {
        agent: String,
        edge: [Cell; 2],
        time: u32,
    },
    /// It arrives after a time.
    ArriveAfter { agent: String, time: u32 },
    /// It arrives by a time.
    ArriveBy { agent: String, time: u32 },
}

/// A conflict of two agents.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
#[serde(tag = "kind", rename_all = "kebab-case")]
#[expect(
    missing_docs,
    reason = "two agents, a cell or an edge, a time in steps, how many of them are delayed for sure"
)]
pub enum ToldConflict {
    /// Both are at a cell.
    Vertex {
        agents: [String; 2],
        cell: Cell,
        time: u32,
        delays: u32,
    },
    /// The first goes along an edge, the second the other way.
    Swap {
        agents: [String; 2],
        edge: [Cell; 2],
        time: u32,
        delays: u32,
    },
    /// The first rests at its goal, and the second comes by.
    Target {
        agents: [String; 2],
        cell: Cell,
        time: u32,
        delays: u32,
    },
}

/// Turns numbers into names and cells.
pub(super) struct Teller<'a> {
    pub(super) problem: &'a Problem,
    pub(super) names: &'a [String],
}

impl Teller<'_> {
    pub(super) fn trace(&self, trace: &Trace) -> PlanTrace {
        let went = match trace {
            Trace::Prioritised(attempts) => Went::Prioritised {
                orders: attempts.iter().map(|attempt| self.order(attempt)).collect(),
            },
            Trace::Cbs(tree) => self.tree(tree),
        };
        PlanTrace {
            giveway: Version,
            went,
        }
    }

    pub(super) fn name(&self, agent: AgentId) -> String {
        self.names.get(agent).cloned().unwrap_or_default()
    }

    fn all(&self, agents: &[AgentId]) -> Vec<String> {
        agents.iter().map(|&agent| self.name(agent)).collect()
    }

    pub(super) fn stuck(&self, stuck: &Stuck) -> StuckAgent {
        StuckAgent {
            agent: self.name(stuck.agent),
            around: self.all(&stuck.around),
        }
    }

    fn order(&self, attempt: &Attempt) -> OrderTried {
        let planned = attempt.planned.iter().map(|planned| PlannedAgent {
            agent: self.name(planned.agent),
            arrival: planned.arrival,
            alone: planned.alone,
            around: self.all(&planned.around),
        });
        OrderTried {
            order: self.all(&attempt.order),
            planned: planned.collect(),
            stuck: attempt.stuck.as_ref().map(|stuck| self.stuck(stuck)),
        }
    }

    fn tree(&self, tree: &Tree) -> Went {
        let nodes = tree.nodes.iter().map(|node| TreeNode {
            id: node.id,
            parent: node.parent,
            constraint: node
                .constraint
                .map(|constraint| self.constraint(constraint)),
            cost: node.cost,
            conflicts: node.conflicts as u64,
            fate: self.fate(&node.fate),
        });
        Went::Cbs {
            nodes: nodes.collect(),
            left_out: tree.left_out,
        }
    }

    fn fate(&self, fate: &Fate) -> NodeFate {
        match *fate {
            Fate::Open => NodeFate::Open,
            Fate::Dead => NodeFate::Dead,
            Fate::Best { turn, bypassed } => NodeFate::Best { turn, bypassed },
            Fate::Split {
                turn,
                conflict,
                cardinality,
                bypassed,
            } => NodeFate::Split {
                turn,
                conflict: self.conflict(&conflict, cardinality),
                bypassed,
            },
        }
    }

    fn constraint(&self, Constraint { agent, rule }: Constraint) -> ToldConstraint {
        let agent = self.name(agent);
        match rule {
            Rule::NotAt { v, time } => {
                let cell = self.cell(v);
                ToldConstraint::NotAt { agent, cell, time }
            }
            Rule::At { v, time } => {
                let cell = self.cell(v);
                ToldConstraint::At { agent, cell, time }
            }
            Rule::NotCross { arc, time } => {
                let edge = self.edge(arc);
                ToldConstraint::NotAlong { agent, edge, time }
            }
            Rule::Cross { arc, time } => {
                let edge = self.edge(arc);
                ToldConstraint::Along { agent, edge, time }
            }
            Rule::ArriveAfter(time) => ToldConstraint::ArriveAfter { agent, time },
            Rule::ArriveBy(time) => ToldConstraint::ArriveBy { agent, time },
        }
    }

    fn conflict(&self, conflict: &Conflict, cardinality: Cardinality) -> ToldConflict {
        let agents = [conflict.first, conflict.second].map(|agent| self.name(agent));
        let delays = match cardinality {
            Cardinality::Cardinal => 2,
            Cardinality::SemiCardinal => 1,
            Cardinality::NonCardinal => 0,
        };
        match conflict.kind {
            Kind::Vertex { v, time } => {
                let cell = self.cell(v);
                ToldConflict::Vertex {
                    agents,
                    cell,
                    time,
                    delays,
                }
            }
            Kind::Swap { arc, time } => {
                let edge = self.edge(arc);
                ToldConflict::Swap {
                    agents,
                    edge,
                    time,
                    delays,
                }
            }
            Kind::Target { v, time } => {
                let cell = self.cell(v);
                ToldConflict::Target {
                    agents,
                    cell,
                    time,
                    delays,
                }
            }
        }
    }

    fn cell(&self, v: Vertex) -> Cell {
        self.problem.terrain.cell(v)
    }

    fn edge(&self, arc: u32) -> [Cell; 2] {
        let (from, to) = self.problem.terrain.ends(arc);
        [self.cell(from), self.cell(to)]
    }
}
