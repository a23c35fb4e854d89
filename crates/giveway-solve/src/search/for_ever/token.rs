//! The token of a claim that holds whatever the horizon, and what it is made of.
//!
//! It is made in this file alone, each time out of a proof that only the code which
//! proved it can make. So no claim of the search can be called complete without one.

use super::super::{
    bound::Optimum,
    closest::NoneCloser,
    deadlines::NoHorizon,
    growing::AssumptionCore,
    horizon::AllInTime,
    minima::{LimitTooLow, NeededAlone},
};
use crate::{freedom::CellNeeded, impose::Unmeetable, joint::AllStates, problem::HopelessAlone};

/// A reason why a claim holds whatever the horizon.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct ForEver(());

/// What the SAT solver refutes: a claim of all plans up to the deadlines that it knows.
pub(in crate::search) trait Refutation {}

/// Some agents cannot all arrive.
impl Refutation for AssumptionCore {}
/// No plan is closer to a given one.
impl Refutation for NoneCloser {}
/// No plan has less of a cost.
impl Refutation for Optimum {}

impl ForEver {
    /// What was refuted without the horizon holds at any.
    pub(in crate::search) const fn refuted(_: &impl Refutation, _: NoHorizon) -> Self {
        Self(())
    }
}

macro_rules! proofs {
    ($($(#[$doc:meta])* $proof:ty),+ $(,)?) => {
        $($(#[$doc])* impl From<$proof> for ForEver {
            fn from(_: $proof) -> Self {
                Self(())
            }
        })+
    };
}

proofs! {
    /// An agent cannot do its task, or meet a condition, even alone.
    HopelessAlone,
    /// An agent needs a cell that is closed.
    CellNeeded,
    /// No plan meets a condition.
    Unmeetable,
    /// What agents need alone is above a limit.
    LimitTooLow,
    /// What agents need alone is the bound.
    NeededAlone,
    /// No plan that counts arrives later than what was looked at.
    AllInTime,
    /// All joint states were looked at.
    AllStates,
}
