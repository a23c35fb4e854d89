//! The planners of the textbook, asked as a front asks them.

use std::cell::Cell;

use giveway_model::{Costs, Instance, Plan};
use giveway_planners::{
    budget::{Budget, HeldBytes, Stop, Unlimited},
    planner::{self, Asked, Planner, Report},
    prioritised::Order,
    problem::{Problem, ProblemError},
    walk::{self, Walk, to_plan},
};

/// How often a planner may ask whether to go on.
#[derive(Clone, Copy, Debug)]
pub struct Steps(pub u64);

struct Counted {
    left: Cell<u64>,
    held: HeldBytes,
}

impl Budget for Counted {
    fn check(&self) -> Result<(), Stop> {
        self.tick()
    }

    fn tick(&self) -> Result<(), Stop> {
        let left = self.left.get().checked_sub(1).ok_or(Stop::Time)?;
        self.left.set(left);
        Ok(())
    }

    fn spend(&self, _states: u64) -> Result<(), Stop> {
        self.check()
    }

    fn held_bytes(&self) -> &HeldBytes {
        &self.held
    }
}

/// The problem of an instance.
///
/// # Errors
/// Where an agent alone decides it.
pub fn problem(instance: &Instance) -> Result<Problem, ProblemError> {
    Problem::new(instance, &Unlimited::default())
}

/// What a planner makes of an instance, within its default horizon.
pub fn plan(planner: Planner, instance: &Instance, problem: &Problem, steps: Steps) -> Report {
    let asked = Asked {
        problem,
        objective: instance.objective(),
        within: None,
        default_horizon: problem.default_horizon(instance.grid()),
        order: Order::default(),
        traced: false,
    };
    let budget = Counted {
        left: Cell::new(steps.0),
        held: HeldBytes::default(),
    };
    planner::plan(planner, &asked, &mut |_| {}, &budget)
}

/// Walks as a plan of the instance.
pub fn plan_of(instance: &Instance, problem: &Problem, walks: &[Walk]) -> Plan {
    let agents = instance.agents().iter();
    let names: Vec<String> = agents.map(|agent| agent.name.clone()).collect();
    to_plan(problem, &names, walks)
}

/// The costs of walks as the planners count them.
pub fn costs(problem: &Problem, walks: &[Walk]) -> Costs {
    walk::costs(problem, walks)
}
