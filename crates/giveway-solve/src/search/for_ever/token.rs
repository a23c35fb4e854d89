//! The token of a claim that holds whatever the horizon, and what it is made of.
//!
//! It is made in this file alone, each time out of a proof that only the code which
//! proved it can make. So no claim of the search can be called complete without one, and no
//! proof of one claim stands for another. The claim is a type, but not the cost: an objective
//! names its costs at run time.

use std::marker::PhantomData;

use super::super::{
    bound::Optimum,
    closest::NoneCloser,
    counting::{Counted, QueueTooLong},
    deadlines::NoHorizon,
    earlier::EarlierOptimum,
    growing::AssumptionCore,
    horizon::AllInTime,
    latest::TooLateAlone,
    minima::{LimitTooLow, NeededAlone},
};
use crate::{
    freedom::CellNeeded, impose::Unmeetable, joint::AllStates, problem::NeverAlone, reach::HandedOn,
};

/// A reason why a claim holds whatever the horizon: that there is [`NoPlan`], that costs are
/// the [`Least`], or that a plan is the [`Closest`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct ForEver<C>(PhantomData<C>);

/// The claim that there is no plan within the limits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum NoPlan {}
/// The claim that no plan costs less.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Least {}
/// The claim that no plan within the limits is closer to a given one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Closest {}

/// A refutation by the SAT solver: a claim about all plans up to the deadlines that it knows.
pub(in crate::search) trait Refutation {
    /// The claim.
    type Claim;
}

impl Refutation for AssumptionCore {
    type Claim = NoPlan;
}
impl Refutation for NoneCloser {
    type Claim = Closest;
}
impl Refutation for Optimum {
    type Claim = Least;
}

impl<C> ForEver<C> {
    /// A refutation that does not use the horizon holds at every horizon.
    pub(in crate::search) const fn refuted(_: &impl Refutation<Claim = C>, _: NoHorizon) -> Self {
        Self(PhantomData)
    }
}

macro_rules! proofs {
    ($($(#[$doc:meta])* $proof:ty => $claim:ty),+ $(,)?) => {
        $($(#[$doc])* impl From<$proof> for ForEver<$claim> {
            fn from(_: $proof) -> Self {
                Self(PhantomData)
            }
        })+
    };
}

/// No plan that counts arrives later than what was looked at, whatever is claimed of these.
impl<C> From<AllInTime> for ForEver<C> {
    fn from(_: AllInTime) -> Self {
        Self(PhantomData)
    }
}

/// All joint states were looked at, whatever was found among them.
impl<C> From<AllStates> for ForEver<C> {
    fn from(_: AllStates) -> Self {
        Self(PhantomData)
    }
}

proofs! {
    /// An agent cannot do its task, or meet a condition, even alone.
    NeverAlone => NoPlan,
    /// An agent needs a cell that is closed.
    CellNeeded => NoPlan,
    /// No plan meets a condition.
    Unmeetable => NoPlan,
    /// The least that agents need alone is above a limit.
    LimitTooLow => NoPlan,
    /// Agents at a bottleneck cannot all arrive in time.
    QueueTooLong => NoPlan,
    /// The least that agents need alone is the bound.
    NeededAlone => Least,
    /// Counting at a bottleneck shows the bound.
    Counted => Least,
    /// It is the optimum of an earlier search with fewer conditions.
    EarlierOptimum => Least,
    /// An agent alone needs longer than any best plan leaves it.
    TooLateAlone => NoPlan,
    /// An earlier request proved it.
    HandedOn => Least,
}
