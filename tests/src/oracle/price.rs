//! The five costs as sums over steps.
//!
//! - **makespan**: each joint step costs one as long as some agent has not
//!   arrived. After the last arrival the plan ends.
//! - **sum-of-costs**: each joint step costs one for every agent that has not
//!   arrived when it begins.
//! - **charges**, **moves**, **waits**: one for each agent that charges, that
//!   begins a move (the second half of a slow move is no other move), or that
//!   waits before its arrival.
//!
//! No step has a negative price, and an agent that has arrived pays nothing.

use giveway_model::Cost;

/// What one agent pays for one step.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Price {
    /// 1 before the arrival, 0 after it.
    pub(crate) steps: u32,
    /// 1 where the agent charges.
    pub(crate) charges: u32,
    /// 1 where the agent begins a move.
    pub(crate) moves: u32,
    /// 1 where the agent waits.
    pub(crate) waits: u32,
}

impl Price {
    /// What a second agent pays in the same step comes on top.
    pub(crate) const fn and(self, other: Self) -> Self {
        Self {
            steps: self.steps + other.steps,
            charges: self.charges + other.charges,
            moves: self.moves + other.moves,
            waits: self.waits + other.waits,
        }
    }

    /// What the joint step adds to a cost, when this is what all agents
    /// together pay.
    pub(crate) const fn adds_to(self, cost: Cost) -> u32 {
        match cost {
            Cost::Makespan => {
                if self.steps > 0 {
                    1
                } else {
                    0
                }
            }
            Cost::SumOfCosts => self.steps,
            Cost::Charges => self.charges,
            Cost::Moves => self.moves,
            Cost::Waits => self.waits,
            Cost::Penalty => 0,
        }
    }
}

/// The costs of an objective in its order; the places that it does not use
/// stay 0. Comparing two vectors compares them lexicographically.
pub(crate) type Vector = [u32; 5];

/// The vector after one more joint step.
pub(crate) fn after(mut vector: Vector, price: Price, costs: &[Cost]) -> Vector {
    for (value, &cost) in vector.iter_mut().zip(costs) {
        *value += price.adds_to(cost);
    }
    vector
}

/// Whether each cost is at most as high.
pub(crate) fn nowhere_higher(a: &Vector, b: &Vector) -> bool {
    a.iter().zip(b).all(|(a, b)| a <= b)
}
