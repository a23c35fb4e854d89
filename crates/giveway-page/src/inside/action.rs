//! What can happen while one looks into how the plan was found.

use super::{HandAction, Method};

/// What can happen there.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum InsideAction {
    /// Opens it, or goes back to the lanes.
    Show(bool),
    /// Looks into another method.
    By(Method),
    /// Chooses a step of the proof, by its row.
    Step(usize),
    /// Chooses a node, by its number.
    Node(u64),
    /// A person splits the conflict tree.
    Hand(HandAction),
    /// Chooses an order, by its place in the list.
    Order(usize),
    /// Shows so many robots of the order.
    Robots(usize),
    /// To the first step.
    First,
    /// To the last step.
    Last,
    /// One step back.
    Back,
    /// One step on.
    Next,
    /// Steps follow each other by themselves, or no longer.
    Play(bool),
    /// It is time for the next step.
    Tick,
    /// Asks again what was not answered.
    Again,
    /// Looks at the robots of the chosen step alone; or at all again.
    Alone(bool),
    /// Asks why there is no plan.
    Reasons,
    /// Goes back to the lanes and plays the plan.
    PlayPlan,
}
