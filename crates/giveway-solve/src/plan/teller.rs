//! From the numbers of planners to names and cells.

use giveway_model::{Cell, Constraint as SceneRule, Path, Version};
use giveway_planners::{
    AgentId,
    cbs::{Cardinality, Conflict, ConflictKind, Constraint, Fate, Rule, Tree},
    lacam::{Event, Made},
    pibt::Inheritance,
    planner::Trace,
    prioritised::{OrderAttempt, Stuck},
    problem::Problem,
    single::Place,
    terrain::Vertex,
};

use super::{
    Inherited, LacamEvent, LnsImprovement, NodeFate, OrderTried, PlanTrace, PlannedAgent,
    StuckAgent, ToldConflict, ToldConstraint, TreeNode, Went,
};

/// Turns numbers into names and cells.
pub(super) struct Teller<'a> {
    pub(super) problem: &'a Problem,
    pub(super) names: &'a [String],
    /// The rules of the scene's own that the planner does not keep.
    pub(super) unkept: Vec<SceneRule>,
}

impl Teller<'_> {
    pub(super) fn trace(&self, trace: &Trace) -> PlanTrace {
        let went = match trace {
            Trace::Prioritised(attempts) => Went::Prioritised {
                orders: attempts.iter().map(|attempt| self.order(attempt)).collect(),
            },
            Trace::Cbs(tree) => self.tree(tree),
            Trace::Pibt { inherited, leaders } => {
                let told = |(time, one): &(u32, Inheritance)| self.inherited(Some(*time), one);
                Went::Pibt {
                    inherited: inherited.iter().map(told).collect(),
                    leaders: self.all(leaders),
                }
            }
            Trace::Lacam(trace) => Went::Lacam {
                events: trace.events.iter().map(|event| self.event(event)).collect(),
            },
            Trace::Lns(improvements) => {
                let told = improvements.iter().map(|improvement| LnsImprovement {
                    changed: self.all(&improvement.changed),
                    before: improvement.before.clone(),
                    after: improvement.after.clone(),
                });
                Went::Lns {
                    improvements: told.collect(),
                }
            }
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

    fn order(&self, attempt: &OrderAttempt) -> OrderTried {
        let planned = attempt.planned.iter().map(|planned| PlannedAgent {
            agent: self.name(planned.agent),
            arrival: planned.arrival,
            alone: planned.alone,
            around: self.all(&planned.around),
            path: self.path(&planned.walk),
        });
        OrderTried {
            order: self.all(&attempt.order),
            planned: planned.collect(),
            stuck: attempt.stuck.as_ref().map(|stuck| self.stuck(stuck)),
            furthest: self.path(&attempt.furthest),
            dead_end: attempt.dead_end,
        }
    }

    fn inherited(&self, time: Option<u32>, one: &Inheritance) -> Inherited {
        Inherited {
            time,
            from: self.name(one.from),
            to: self.name(one.to),
            cell: self.cell(one.at),
        }
    }

    fn event(&self, event: &Event) -> LacamEvent {
        let inherited = event.inherited.iter();
        LacamEvent {
            from: event.from,
            constrained: self.all(&event.constrained),
            constraints: event.constraints.iter().map(|&v| self.cell(v)).collect(),
            inherited: inherited.map(|one| self.inherited(None, one)).collect(),
            made: match event.made {
                Made::New(id) | Made::Again(id) => Some(id),
                Made::Nothing => None,
            },
            known: matches!(event.made, Made::Again(_)),
            cells: event.cells.iter().map(|&v| self.cell(v)).collect(),
        }
    }

    fn tree(&self, tree: &Tree) -> Went {
        Went::Cbs {
            nodes: self.nodes(tree),
            left_out: tree.left_out,
        }
    }

    /// The nodes of a constraint tree.
    pub(super) fn nodes(&self, tree: &Tree) -> Vec<TreeNode> {
        let nodes = tree.nodes.iter().map(|node| TreeNode {
            id: node.id,
            parent: node.parent,
            constraint: node
                .constraint
                .map(|constraint| self.constraint(constraint)),
            cost: node.cost,
            conflicts: node.conflicts as u64,
            paths: node
                .walks
                .iter()
                .map(|(&agent, walk)| (self.name(agent), self.path(walk)))
                .collect(),
            fate: self.fate(&node.fate),
        });
        nodes.collect()
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

    pub(super) fn constraint(&self, Constraint { agent, rule }: Constraint) -> ToldConstraint {
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

    pub(super) fn conflict(&self, conflict: &Conflict, cardinality: Cardinality) -> ToldConflict {
        let agents = [conflict.first, conflict.second].map(|agent| self.name(agent));
        let delays = match cardinality {
            Cardinality::Cardinal => 2,
            Cardinality::SemiCardinal => 1,
            Cardinality::NonCardinal => 0,
        };
        match conflict.kind {
            ConflictKind::Vertex { v, time } => {
                let cell = self.cell(v);
                ToldConflict::Vertex {
                    agents,
                    cell,
                    time,
                    delays,
                }
            }
            ConflictKind::Swap { arc, time } => {
                let edge = self.edge(arc);
                ToldConflict::Swap {
                    agents,
                    edge,
                    time,
                    delays,
                }
            }
            ConflictKind::Target { v, time } => {
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

    fn path(&self, walk: &[Place]) -> Path {
        let cell = |place: &Place| match *place {
            Place::At(v) => Some(self.cell(v)),
            Place::Along(_) => None,
        };
        walk.iter().map(cell).collect()
    }

    fn cell(&self, v: Vertex) -> Cell {
        self.problem.terrain.cell(v)
    }

    fn edge(&self, arc: u32) -> [Cell; 2] {
        let (from, to) = self.problem.terrain.ends(arc);
        [self.cell(from), self.cell(to)]
    }
}
