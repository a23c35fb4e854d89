//! How far a claim reaches.

use super::{ForEver, Least, NoPlan};
use crate::reach::HandedOn;

/// How far a claim reaches.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Proved {
    /// At every horizon.
    ForEver(Reasoned),
    /// Among plans of at most this makespan.
    Within(u32),
}

/// A claim at every horizon has its reason, whichever claim it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Reasoned(());

impl Proved {
    /// Beyond a horizon only with a reason.
    pub(crate) fn new<C>(reason: Option<ForEver<C>>, horizon: u32) -> Self {
        reason.map_or(Self::Within(horizon), Self::for_ever)
    }

    /// Proved at every horizon, by a token.
    pub(crate) fn for_ever<C>(_: ForEver<C>) -> Self {
        Self::ForEver(Reasoned(()))
    }

    /// An earlier request proved at every horizon that a plan is the best.
    pub(crate) fn handed_on(earlier: HandedOn) -> Self {
        Self::for_ever(ForEver::<Least>::from(earlier))
    }

    /// There is no plan at any horizon.
    pub(crate) fn no_plan(reason: impl Into<ForEver<NoPlan>>) -> Self {
        Self::for_ever(reason.into())
    }

    /// Whether it reaches beyond every horizon.
    pub(crate) const fn is_complete(self) -> bool {
        matches!(self, Self::ForEver(_))
    }

    /// The makespan up to which it reaches; `None` for any.
    pub(crate) const fn within(self) -> Option<u32> {
        match self {
            Self::ForEver(_) => None,
            Self::Within(horizon) => Some(horizon),
        }
    }

    /// Up to where both of two claims reach.
    pub(crate) fn and(self, other: Self) -> Self {
        match (self, other) {
            (Self::Within(a), Self::Within(b)) => Self::Within(a.min(b)),
            (Self::ForEver(_), reach) | (reach, Self::ForEver(_)) => reach,
        }
    }

    /// Whether it reaches as far as another.
    pub(crate) fn covers(self, other: Self) -> bool {
        match (self, other) {
            (Self::ForEver(_), _) => true,
            (Self::Within(_), Self::ForEver(_)) => false,
            (Self::Within(a), Self::Within(b)) => a >= b,
        }
    }

    /// Up to where one of two reasons for a claim reaches.
    pub(crate) fn or(self, other: Self) -> Self {
        match (self, other) {
            (Self::Within(a), Self::Within(b)) => Self::Within(a.max(b)),
            (Self::Within(_), reach) | (reach, Self::Within(_) | Self::ForEver(_)) => reach,
        }
    }
}
