//! How far the claim of an answer reaches.

use borsh::{BorshDeserialize, BorshSerialize};
use giveway_planners::cbs;
use serde::{Deserialize, Serialize, Serializer};

use crate::{SolveRequest, search::Proved};

/// How far the claim of an answer reaches: nothing is claimed, or it holds for plans of at
/// most a makespan, or for every horizon.
///
/// Only the solver makes one that claims something, and only out of a proof. Elsewhere it is
/// read from an answer, compared, weakened, or comes out of a message. In JSON it is the two
/// keys `complete` and `within` of the answer.
#[derive(
    Clone,
    Copy,
    Debug,
    Default,
    PartialEq,
    Eq,
    Serialize,
    Deserialize,
    BorshSerialize,
    BorshDeserialize,
)]
#[serde(into = "WrittenReach", try_from = "WrittenReach")]
pub struct Reach(Claimed);

/// A claim for every horizon that the solver made for an earlier request. Only a [`Reach`] makes
/// one.
#[derive(Clone, Copy, Debug)]
pub(crate) struct HandedOn(());

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, BorshSerialize, BorshDeserialize)]
enum Claimed {
    #[default]
    Nothing,
    Within(u32),
    EveryHorizon,
}

/// A reach as it is written.
#[derive(Serialize, Deserialize)]
struct WrittenReach {
    complete: bool,
    within: Option<u32>,
}

impl Reach {
    /// Whether the claim holds for every horizon.
    pub const fn is_complete(self) -> bool {
        matches!(self.0, Claimed::EveryHorizon)
    }

    /// The makespan, in steps, up to which the claim holds; `None` where it holds for every
    /// horizon, and where nothing is claimed.
    pub const fn within(self) -> Option<u32> {
        match self.0 {
            Claimed::Within(makespan) => Some(makespan),
            Claimed::Nothing | Claimed::EveryHorizon => None,
        }
    }

    /// How far bounds reach that [`Progress::Bound`](crate::Progress::Bound) tells while a
    /// request is solved: up to the makespan that it asks for.
    pub fn of_bounds_so_far(request: &SolveRequest) -> Self {
        Self(request.within.map_or(Claimed::Nothing, Claimed::Within))
    }

    /// The reach of the bounds where the claim of the answer is gone: the makespan up to which they hold. It
    /// is not said any more that they hold at every horizon.
    #[must_use]
    pub const fn of_bounds(self) -> Self {
        match self.0 {
            Claimed::Within(_) => self,
            Claimed::Nothing | Claimed::EveryHorizon => Self(Claimed::Nothing),
        }
    }

    /// The claim of an answer that a front kept, and hands on with another request.
    pub(crate) fn handed_on(self) -> Option<Proved> {
        match self.0 {
            Claimed::Nothing => None,
            Claimed::Within(makespan) => Some(Proved::Within(makespan)),
            Claimed::EveryHorizon => Some(Proved::handed_on(HandedOn(()))),
        }
    }

    /// The same, but not beyond a makespan that it names.
    pub(crate) fn up_to(self, makespan: u32) -> Self {
        self.with_makespan(|within| within.min(makespan))
    }

    /// The same in the times of a plan that began so many steps earlier.
    pub(crate) fn later(self, steps: u32) -> Self {
        self.with_makespan(|within| within.saturating_add(steps))
    }

    fn with_makespan(self, change: impl Fn(u32) -> u32) -> Self {
        match self.0 {
            Claimed::Within(makespan) => Self(Claimed::Within(change(makespan))),
            Claimed::Nothing | Claimed::EveryHorizon => self,
        }
    }
}

#[cfg(test)]
impl Reach {
    /// Up to a makespan, or for every horizon, without a proof.
    pub(crate) const fn unproved(within: Option<u32>) -> Self {
        Self(match within {
            Some(makespan) => Claimed::Within(makespan),
            None => Claimed::EveryHorizon,
        })
    }
}

impl From<Option<Proved>> for Reach {
    fn from(proved: Option<Proved>) -> Self {
        Self(match proved {
            None => Claimed::Nothing,
            Some(Proved::Within(makespan)) => Claimed::Within(makespan),
            Some(Proved::ForEver(_)) => Claimed::EveryHorizon,
        })
    }
}

impl From<cbs::Proved> for Reach {
    fn from(proved: cbs::Proved) -> Self {
        Self(
            proved
                .within()
                .map_or(Claimed::EveryHorizon, Claimed::Within),
        )
    }
}

impl From<Proved> for Reach {
    fn from(proved: Proved) -> Self {
        Some(proved).into()
    }
}

impl From<Reach> for WrittenReach {
    fn from(reach: Reach) -> Self {
        Self {
            complete: reach.is_complete(),
            within: reach.within(),
        }
    }
}

impl TryFrom<WrittenReach> for Reach {
    type Error = &'static str;

    fn try_from(written: WrittenReach) -> Result<Self, &'static str> {
        match (written.complete, written.within) {
            (true, None) => Ok(Self(Claimed::EveryHorizon)),
            (false, Some(makespan)) => Ok(Self(Claimed::Within(makespan))),
            (false, None) => Ok(Self(Claimed::Nothing)),
            (true, Some(_)) => Err("found a claim that is complete and within a makespan"),
        }
    }
}

/// Writes the makespan alone, where something is claimed in any case; `null` is every
/// horizon.
///
/// # Errors
/// Those of the serializer.
#[cfg_attr(
    target_pointer_width = "64",
    expect(clippy::trivially_copy_pass_by_ref, reason = "the signature of serde")
)]
pub(crate) fn within_alone<S: Serializer>(reach: &Reach, to: S) -> Result<S::Ok, S::Error> {
    Serialize::serialize(&reach.within(), to)
}
