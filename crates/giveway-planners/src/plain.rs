//! The plain problem: a start and a goal for each agent, and nothing else.
//!
//! PIBT and LaCAM move all agents at once, a step at a time, and know no more
//! than how far each one still has to go. What they cannot do is refused here.

use crate::{
    AgentId,
    problem::{Problem, Relaxed},
    single::{Bounds, Place, Task},
    terrain::{Arc, Vertex},
    walk::Walk,
};

/// A part of an instance that a planner for the plain problem cannot handle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unsupported {
    /// This agent has no goal.
    NoGoal(AgentId),
    /// This agent has waypoints.
    Waypoints(AgentId),
    /// This agent has a battery.
    Battery(AgentId),
    /// A question asks something of this agent beside its task.
    Condition(AgentId),
    /// This agent may only go to some cells.
    Bounds(AgentId),
    /// This agent is under way already: in transit, held, or not to arrive yet.
    UnderWay(AgentId),
    /// These two have one goal; the planner needs a place for each.
    SharedGoal(AgentId, AgentId),
    /// The map has slow zones.
    SlowZones,
    /// Some rules between agents do not count.
    Relaxed,
    /// The scene has rules of its own.
    Rules,
}

/// A plain problem. It is only made from a problem that has nothing else.
pub struct Plain<'p> {
    problem: &'p Problem,
    starts: Vec<Vertex>,
    goals: Vec<Vertex>,
    /// Where the neighbours of each vertex begin; one more entry than vertices.
    begins: Vec<u32>,
    neighbours: Vec<Vertex>,
}

impl<'p> Plain<'p> {
    /// The problem as a plain one.
    ///
    /// # Errors
    /// What it has beside starts and goals.
    pub fn new(problem: &'p Problem) -> Result<Self, Unsupported> {
        if problem.relaxed != Relaxed::default() {
            return Err(Unsupported::Relaxed);
        }
        if problem.is_constrained {
            return Err(Unsupported::Rules);
        }
        for (agent, task) in problem.tasks.iter().enumerate() {
            check(agent, task)?;
        }
        let terrain = &problem.terrain;
        let mut of_goal = vec![None; terrain.size()];
        for (agent, task) in problem.tasks.iter().enumerate() {
            let goal = task.goal.ok_or(Unsupported::NoGoal(agent))?;
            if let Some(other) = of_goal[goal as usize].replace(agent) {
                return Err(Unsupported::SharedGoal(other, agent));
            }
        }
        let mut plain = Self {
            problem,
            starts: problem.tasks.iter().map(|task| task.start).collect(),
            goals: problem.tasks.iter().filter_map(|task| task.goal).collect(),
            begins: vec![0],
            neighbours: Vec::new(),
        };
        for v in 0..terrain.size() as Vertex {
            for arc in terrain.arcs(v) {
                if arc.slow {
                    return Err(Unsupported::SlowZones);
                }
                plain.neighbours.push(arc.to);
            }
            plain.begins.push(plain.neighbours.len() as u32);
        }
        Ok(plain)
    }

    /// The number of agents.
    pub fn agents(&self) -> usize {
        self.starts.len()
    }

    /// The number of vertices.
    pub fn vertices(&self) -> usize {
        self.begins.len() - 1
    }

    /// Where the agents start.
    pub fn starts(&self) -> &[Vertex] {
        &self.starts
    }

    /// Where the agents have to arrive.
    pub fn goals(&self) -> &[Vertex] {
        &self.goals
    }

    /// The vertices one move away.
    pub fn neighbours(&self, v: Vertex) -> &[Vertex] {
        let (begin, end) = (self.begins[v as usize], self.begins[v as usize + 1]);
        &self.neighbours[begin as usize..end as usize]
    }

    /// The arcs that leave a vertex; those of an edge are `2 e` and `2 e + 1`.
    pub(crate) fn arcs(&self, v: Vertex) -> &[Arc] {
        self.problem.terrain.arcs(v)
    }

    /// Where an arc begins.
    pub(crate) fn arc_begin(&self, arc: u32) -> Vertex {
        self.problem.terrain.ends(arc).0
    }

    /// The number of arcs.
    pub(crate) fn arc_count(&self) -> usize {
        self.neighbours.len()
    }

    /// The steps that an agent alone still needs. Whoever starts where its goal
    /// can be reached never comes to where it cannot.
    pub fn distance(&self, agent: AgentId, v: Vertex) -> u32 {
        let distance = self.problem.cost_to_go[agent].from(v, 0, 0);
        distance.unwrap_or(u32::MAX)
    }

    /// Whether arrived agents stay at their goals.
    pub fn stays(&self) -> bool {
        self.problem.stays
    }

    /// Configurations, one a time step, as walks. Where agents stay, a walk ends
    /// with the last arrival at the goal; where they vanish, with the first.
    pub fn walks(&self, configurations: &[&[Vertex]]) -> Vec<Walk> {
        let walk = |agent: AgentId| {
            let cells = || configurations.iter().map(|cells| cells[agent]);
            let goal = self.goals[agent];
            let end = if self.stays() {
                cells().rposition(|v| v != goal).map_or(0, |last| last + 1)
            } else {
                cells().position(|v| v == goal).unwrap_or(0)
            };
            cells().take(end + 1).map(Place::At).collect()
        };
        (0..self.agents()).map(walk).collect()
    }
}

/// Looks for what a task has beside a start and a goal.
fn check(agent: AgentId, task: &Task) -> Result<(), Unsupported> {
    if !task.waypoints.is_empty() {
        return Err(Unsupported::Waypoints(agent));
    }
    if task.reserve.is_some() {
        return Err(Unsupported::Battery(agent));
    }
    if !task.conditions.is_empty() {
        return Err(Unsupported::Condition(agent));
    }
    if !matches!(task.bounds, Bounds::Free) {
        return Err(Unsupported::Bounds(agent));
    }
    let timed = [
        task.not_before,
        task.earliest_move,
        task.cost_if_it_leaves_goal,
        task.waits_if_it_leaves_goal,
    ];
    if task.transit.is_some() || timed != [0; 4] {
        return Err(Unsupported::UnderWay(agent));
    }
    Ok(())
}
