//! The search over configurations, depth first.

use fastrand::Rng;

use super::{
    Ended, Exhausted, Found, Options,
    explored::{ConfigurationId, Explored, Node},
    trace::{Event, Made, Trace},
};
use crate::{
    AgentId,
    budget::{Budget, MemoryUse, Stop},
    chance::shuffle,
    pibt::{Guide, Priorities, Ranks, Step},
    plain::Plain,
    terrain::Vertex,
};

/// The seed of all choices among equals.
const SEED: u64 = 23;

/// The search, between two steps.
pub(super) struct Search<'s> {
    pub(super) plain: &'s Plain<'s>,
    options: Options,
    budget: &'s dyn Budget,
    ranks: Ranks,
    step: Step<'s>,
    pub(super) rng: Rng,
    pub(super) explored: Explored,
    /// Configurations to go on from, the last one first.
    pub(super) open: Vec<ConfigurationId>,
    pub(super) goal: Option<ConfigurationId>,
    /// The sum of losses of the last plan that was told.
    told: u64,
    /// Where the first agents have to go, in the step that is made.
    path: Vec<Vertex>,
    held: MemoryUse,
    pub(super) steps: u64,
    /// The steps after which it ends where there is no plan yet.
    pub(super) patience: u64,
    pub(super) trace: Trace,
}

impl<'s> Search<'s> {
    pub(super) fn new(
        plain: &'s Plain<'s>,
        guide: Option<&'s Guide>,
        options: Options,
        budget: &'s dyn Budget,
    ) -> Self {
        let ranks = Ranks::new(plain);
        let mut search = Self {
            plain,
            options,
            budget,
            step: Step::new(plain, guide, SEED, options.told > 0),
            rng: Rng::with_seed(SEED),
            explored: Explored::new(plain.agents()),
            open: Vec::new(),
            goal: None,
            told: u64::MAX,
            path: Vec::new(),
            held: budget.hold(0),
            steps: 0,
            patience: u64::MAX,
            trace: Trace::new(options.told),
            ranks,
        };
        let first = Priorities::first(&search.ranks);
        let distance = |(agent, &v)| u64::from(plain.distance(agent, v));
        let least = plain.starts().iter().enumerate().map(distance).sum();
        search.add(plain.starts(), Node::new(None, [0, least], first));
        search
    }

    /// Goes on until something ends it; each plan is told that is better than
    /// the one before.
    pub(super) fn run(&mut self, on_plan: &mut dyn FnMut(&Found)) -> Ended {
        loop {
            match self.once(on_plan) {
                Ok(None) => {}
                Ok(Some(ended)) => return ended,
                Err(stop) => return Ended::Stopped(stop),
            }
        }
    }

    /// Looks at the last open configuration once.
    fn once(&mut self, on_plan: &mut dyn FnMut(&Found)) -> Result<Option<Ended>, Stop> {
        self.budget.spend(self.plain.agents() as u64)?;
        let Some(&from) = self.open.last() else {
            return Ok(Some(match self.goal {
                None => Ended::Exhausted(Exhausted::configurations()),
                Some(_) => Ended::LeastLoss,
            }));
        };
        if self.cannot_improve(from) {
            self.open.pop();
            return Ok(None);
        }
        if self.goal.is_none() && self.explored.cells(from) == self.plain.goals() {
            self.goal = Some(from);
            self.tell(on_plan);
            return Ok(self.options.first_only.then_some(Ended::FirstPlan));
        }
        let node = &mut self.explored.nodes[from as usize];
        let Some(constraint) = node.constraints.take(&mut self.path) else {
            self.held.less(node.constraints.close());
            self.open.pop();
            return Ok(None);
        };
        let in_vain = self.goal.is_none() && self.steps >= self.patience;
        if in_vain || self.steps >= self.options.step_limit {
            return Ok(Some(Ended::StepLimit));
        }
        self.steps += 1;
        self.constrain_next(from, constraint);
        let made = self.make(from);
        let explored = &self.explored;
        let order = explored.nodes[from as usize].priorities.order.iter();
        self.trace.tell(|| Event {
            from,
            constrained: order
                .zip(&self.path)
                .map(|(&agent, _)| agent as AgentId)
                .collect(),
            constraints: self.path.clone(),
            inherited: self.step.inherited().to_vec(),
            made,
            cells: match made {
                Made::New(to) => explored.cells(to).to_vec(),
                Made::Again(_) | Made::Nothing => Vec::new(),
            },
        });
        if let Made::Again(to) = made {
            self.again(from, to);
        }
        self.tell(on_plan);
        Ok(None)
    }

    /// Whether no plan through this configuration can be better than the best one so far.
    pub(super) fn cannot_improve(&self, id: ConfigurationId) -> bool {
        let bound = self.explored.nodes[id as usize].bound();
        let goal = self.goal.map(|goal| &self.explored.nodes[goal as usize]);
        goal.is_some_and(|goal| bound >= goal.loss)
    }

    /// Grows the tree of constraints below one of its nodes.
    fn constrain_next(&mut self, from: ConfigurationId, constraint: u32) {
        let node = &self.explored.nodes[from as usize];
        let Some(&agent) = node.priorities.order.get(self.path.len()) else {
            return;
        };
        let at = self.explored.cells(from)[agent as usize];
        let mut ways = [at; 5];
        let neighbours = self.plain.neighbours(at);
        ways[1..=neighbours.len()].copy_from_slice(neighbours);
        let ways = &mut ways[..=neighbours.len()];
        shuffle(&mut self.rng, ways);
        let constraints = &mut self.explored.nodes[from as usize].constraints;
        let before = constraints.bytes();
        constraints.add(constraint, ways);
        let grown = constraints.bytes() - before;
        self.budget.hold_more(&mut self.held, grown);
    }

    /// Makes the next configuration under the constraints.
    fn make(&mut self, from: ConfigurationId) -> Made {
        let node = &self.explored.nodes[from as usize];
        let order = &node.priorities.order;
        self.step.begin(self.explored.cells(from));
        let mut constrained = order.iter().zip(&self.path);
        if !constrained.all(|(&agent, &to)| self.step.fix(agent as usize, to))
            || !self.step.choose(order)
        {
            return Made::Nothing;
        }
        let next = self.step.next();
        if let Some(known) = self.explored.find(next) {
            return Made::Again(known);
        }
        let cells = next.to_vec();
        let loss = node.loss + self.edge(self.explored.cells(from), &cells);
        let least = self.onward(node.least, self.explored.cells(from), &cells);
        let priorities = node
            .priorities
            .after(&self.ranks, &cells, self.plain.goals());
        let node = Node::new(Some(from), [loss, least], priorities);
        let to = self.add(&cells, node);
        self.link(from, to);
        Made::New(to)
    }

    /// Adds a configuration, and goes on from it unless it is of no use.
    fn add(&mut self, cells: &[Vertex], node: Node) -> ConfigurationId {
        let bytes = self.explored.bytes_each() + node.constraints.bytes();
        self.budget.hold_more(&mut self.held, bytes);
        let id = self.explored.add(cells, node);
        if !self.cannot_improve(id) {
            self.open.push(id);
        }
        id
    }

    pub(super) fn link(&mut self, from: ConfigurationId, to: ConfigurationId) {
        let Some(place) = self.explored.nodes[from as usize].place_of(to) else {
            return;
        };
        let loss = self.edge(self.explored.cells(from), self.explored.cells(to));
        let successors = &mut self.explored.nodes[from as usize].successors;
        successors.insert(place, (to, loss));
        let grown = size_of::<(ConfigurationId, u64)>();
        self.budget.hold_more(&mut self.held, grown);
    }

    /// Tells the plan, where it is better than the last one.
    fn tell(&mut self, on_plan: &mut dyn FnMut(&Found)) {
        let Some(goal) = self.goal else { return };
        let loss = self.explored.nodes[goal as usize].loss;
        if loss >= self.told {
            return;
        }
        self.told = loss;
        let mut configurations = Vec::new();
        let mut id = Some(goal);
        while let Some(at) = id {
            configurations.push(self.explored.cells(at));
            id = self.explored.nodes[at as usize].parent;
        }
        configurations.reverse();
        on_plan(&Found {
            walks: self.plain.walks(&configurations),
            loss,
            steps: self.steps,
        });
    }
}
