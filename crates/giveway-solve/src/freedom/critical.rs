//! Computes the cost of closing each free cell.
//!
//! Nothing where some best plan leaves the cell alone. One call asks for a plan that
//! leaves *any* of the other cells alone; where there is none, each of them costs
//! something, and the scene without it is solved.

use std::rc::Rc;

use giveway_model::{Cell, Cost, Costs, Ground, Instance, Scene, check::check};

use super::{
    Closed, CriticalCell, Need,
    cell_rules::{must_be_at, without_rules_at},
    every::Every,
    formula::{Way, plan_of},
};
use crate::{
    Limits, Status,
    budget::Stop,
    search::Proved,
    single::Place,
    solve::{self, SolveTask},
    terrain::Vertex,
};

/// Conflicts that the search without a cell may take, round after round: so that what is
/// shown soon does not wait for what takes long.
const ROUNDS: [Option<u64>; 3] = [Some(3_000), Some(30_000), None];

/// The proof that no scene is left without a cell, as an agent starts there, or has its goal
/// or a waypoint there, or a rule wants it there.
#[derive(Clone, Copy, Debug)]
pub(crate) struct CellNeeded(());

/// The costs of closing cells, as far as they are known.
pub(super) struct Critical<'t, 'h> {
    task: &'t SolveTask<'h>,
    scene: &'t Scene,
    optimum: Proved,
    costs: Costs,
    cells: Vec<CriticalCell>,
    /// Which of the [`ROUNDS`] it is.
    round: usize,
    /// The next cell of this round.
    next: usize,
}

impl<'t, 'h> Critical<'t, 'h> {
    /// All free cells, nothing known but of those that agents need.
    pub(super) fn new(
        (task, scene): (&'t SolveTask<'h>, &'t Scene),
        (optimum, costs): (Proved, Costs),
    ) -> Self {
        let grid = task.instance.grid();
        let free = grid.cells().filter(|(_, ground)| ground.is_vertex());
        let cells = free.map(|(cell, _)| {
            let closed = match need(&task.instance, cell) {
                None => Closed::Unknown { worse: false },
                Some((needed, shown)) => Closed::Impossible {
                    needed: Some(needed),
                    reach: Proved::no_plan(shown).into(),
                },
            };
            CriticalCell { cell, closed }
        });
        Self {
            task,
            scene,
            optimum,
            costs,
            cells: cells.collect(),
            round: 0,
            next: 0,
        }
    }

    /// The cells with their costs, as far as they are known.
    pub(super) fn told(&self) -> Vec<CriticalCell> {
        self.cells.clone()
    }

    /// Tells which cells cost something to close.
    ///
    /// # Errors
    /// When the budget is spent; what is known until then stays.
    pub(super) fn sort_out(&mut self, every: &mut Every) -> Result<(), Stop> {
        self.learn(every, 0);
        let open: Vec<Vertex> = self
            .open()
            .filter_map(|cell| every.problem.terrain.vertex(cell.cell))
            .collect();
        let uses = every.formula.uses(open);
        loop {
            let terrain = &every.problem.terrain;
            let unused: Vec<_> = uses
                .iter()
                .filter(|&&(v, _)| self.open().any(|it| it.cell == terrain.cell(v)))
                .map(|&(_, used)| !used)
                .collect();
            if unused.is_empty() {
                return Ok(());
            }
            let known = every.found().len();
            let any = every.formula.some(unused);
            let is_found = every.find(&[any])?;
            every.formula.retire(any);
            if !is_found {
                for cell in &mut self.cells {
                    if cell.closed.is_open() {
                        cell.closed = Closed::Unknown { worse: true };
                    }
                }
                return Ok(());
            }
            self.learn(every, known);
        }
    }

    /// Cells of which nothing is known.
    fn open(&self) -> impl Iterator<Item = &CriticalCell> {
        self.cells.iter().filter(|it| it.closed.is_open())
    }

    /// The plans that were found, from one on, show which cells can do without.
    fn learn(&mut self, every: &Every, from: usize) {
        for plan in every.found().iter().skip(from) {
            let used = used(every, plan);
            let mut costs = None;
            for it in self.cells.iter_mut().filter(|it| it.closed.is_open()) {
                if used.contains(&it.cell) {
                    continue;
                }
                let plan = || plan_of(every.problem, every.instance, plan);
                let judged = || check(every.instance, &plan()).costs;
                let costs = *costs.get_or_insert_with(|| judged().unwrap_or(self.costs));
                it.closed = self.task.closed_at(costs, self.costs, self.optimum);
            }
        }
    }

    /// Solves the scene without one of the cells that are open; whether any is left.
    ///
    /// # Errors
    /// When the budget is spent; what is known until then stays.
    pub(super) fn solve_next(&mut self) -> Result<bool, Stop> {
        while let Some(&conflicts) = ROUNDS.get(self.round) {
            let mut rest = self.cells.iter().enumerate().skip(self.next);
            if let Some((number, _)) = rest.find(|(_, it)| it.closed.is_open()) {
                self.next = number + 1;
                self.solve_without_cell(number, conflicts)?;
                return Ok(true);
            }
            self.round += 1;
            self.next = 0;
        }
        Ok(false)
    }

    /// Solves the scene without a cell, as long as it takes no more conflicts.
    fn solve_without_cell(&mut self, number: usize, conflicts: Option<u64>) -> Result<(), Stop> {
        let Some(it) = self.cells.get_mut(number) else {
            return Ok(());
        };
        let closed = scene_without(self.scene, it.cell).map(Instance::new);
        let Some(Ok(instance)) = closed else {
            return Ok(());
        };
        let limits = Limits {
            conflicts,
            ..Limits::default()
        };
        let budget = Rc::new(self.task.budget.part(limits));
        let closed = SolveTask {
            instance,
            objective: self.task.objective.clone(),
            within: self.task.within.or(self.optimum.within()),
            start: None,
            as_found: false,
            budget: Rc::clone(&budget),
        };
        let solved = solve::solve(&closed);
        self.task.budget.absorb(&budget);
        let answer = solved.answer;
        match (answer.status, answer.costs, solved.reach) {
            (Status::Optimal, Some(costs), Some(reach)) => {
                let objective = &self.task.objective;
                // Without a cell no plan is better.
                if costs.vector(objective) >= self.costs.vector(objective) {
                    it.closed = self.task.closed_at(costs, self.costs, reach);
                }
            }
            (Status::Impossible, _, Some(reach)) => {
                it.closed = Closed::Impossible {
                    needed: None,
                    reach: reach.into(),
                };
            }
            _ => {}
        }
        self.task.budget.check()
    }
}

impl SolveTask<'_> {
    /// A best plan without a cell, set against the best plan with it.
    fn closed_at(&self, costs: Costs, before: Costs, reach: Proved) -> Closed {
        let delta = |&cost: &Cost| {
            let delta = i64::from(costs.get(cost)) - i64::from(before.get(cost));
            (cost, delta)
        };
        Closed::Optimal {
            costs,
            deltas: self.objective.costs().iter().map(delta).collect(),
            reach: reach.into(),
        }
    }
}

/// The agent's need for this very cell, so that there is no scene without it.
fn need(instance: &Instance, cell: Cell) -> Option<(Need, CellNeeded)> {
    let any = |needs: &dyn Fn(&giveway_model::Agent) -> bool| instance.agents().iter().any(needs);
    let needed = if any(&|agent| agent.start == cell) {
        Some(Need::Start)
    } else if any(&|agent| agent.goal == Some(cell)) {
        Some(Need::Goal)
    } else if any(&|agent| agent.waypoints.contains(&cell)) {
        Some(Need::Waypoint)
    } else if instance
        .constraints_in_force()
        .any(|rule| must_be_at(rule.constraint, cell))
    {
        Some(Need::Rule)
    } else {
        None
    };
    needed.map(|needed| (needed, CellNeeded(())))
}

/// The cells in which anybody is at any time of a plan.
fn used(every: &Every, plan: &[Way]) -> std::collections::BTreeSet<Cell> {
    let places = plan.iter().flat_map(|way| &way.places);
    let cells = places.filter_map(|place| match place {
        Place::At(v) => Some(every.problem.terrain.cell(*v)),
        Place::Along(_) => None,
    });
    cells.collect()
}

/// The scene without a cell; `None` off the map.
pub(super) fn scene_without(scene: &Scene, cell: Cell) -> Option<Scene> {
    let mut scene = scene.clone();
    let row = scene.map.get_mut(cell.y as usize)?;
    let wall = Ground::Obstacle.to_char();
    *row = row
        .chars()
        .enumerate()
        .map(|(x, here)| if x == cell.x as usize { wall } else { here })
        .collect();
    without_rules_at(&mut scene, cell);
    Some(scene)
}
