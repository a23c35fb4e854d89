//! Rules that ask for less than another one of their kind.

use super::{ConstraintKind, meant};
use crate::condition::Times;

impl ConstraintKind {
    /// The number that it allows at most: agents in a zone, or wait steps on end.
    pub const fn most(&self) -> Option<u32> {
        match self {
            Self::Capacity { most, .. } | Self::NoWaiting { most, .. } => Some(*most),
            Self::Closed { .. }
            | Self::OneWay { .. }
            | Self::Gap { .. }
            | Self::Apart { .. }
            | Self::Sequence { .. }
            | Self::Visit { .. }
            | Self::Arrive { .. }
            | Self::Late { .. }
            | Self::Depart { .. }
            | Self::Before { .. }
            | Self::Turns { .. }
            | Self::Avoid { .. } => None,
        }
    }

    /// The same with another number that it allows at most; `None` where it has none.
    ///
    /// ```
    /// use giveway_model::{condition::Times, constraint::ConstraintKind};
    /// let kind = ConstraintKind::Capacity { zone: "a".into(), most: 1, times: Times::default() };
    /// assert_eq!(kind.with_most(2).and_then(|kind| kind.most()), Some(2));
    /// ```
    #[must_use]
    pub fn with_most(&self, number: u32) -> Option<Self> {
        let mut weaker = self.clone();
        match &mut weaker {
            Self::Capacity { most, .. } | Self::NoWaiting { most, .. } => *most = number,
            Self::Closed { .. }
            | Self::OneWay { .. }
            | Self::Gap { .. }
            | Self::Apart { .. }
            | Self::Sequence { .. }
            | Self::Visit { .. }
            | Self::Arrive { .. }
            | Self::Late { .. }
            | Self::Depart { .. }
            | Self::Before { .. }
            | Self::Turns { .. }
            | Self::Avoid { .. } => return None,
        }
        Some(weaker)
    }

    /// The last time by which it has to be kept, in time steps: of a visit or an arrival.
    pub fn last_chance(&self) -> Option<u32> {
        match self {
            Self::Visit { times, .. } | Self::Arrive { times } => meant(*times).to,
            Self::Capacity { .. }
            | Self::Closed { .. }
            | Self::OneWay { .. }
            | Self::Gap { .. }
            | Self::Apart { .. }
            | Self::Sequence { .. }
            | Self::Late { .. }
            | Self::Depart { .. }
            | Self::Before { .. }
            | Self::NoWaiting { .. }
            | Self::Turns { .. }
            | Self::Avoid { .. } => None,
        }
    }

    /// The same with another last time; `None` where it has none.
    #[must_use]
    pub fn with_last_time(&self, to: u32) -> Option<Self> {
        self.last_chance()?;
        let mut weaker = self.clone();
        match &mut weaker {
            Self::Visit { times, .. } | Self::Arrive { times } => {
                *times = Times {
                    to: Some(to),
                    ..*times
                };
            }
            Self::Capacity { .. }
            | Self::Closed { .. }
            | Self::OneWay { .. }
            | Self::Gap { .. }
            | Self::Apart { .. }
            | Self::Sequence { .. }
            | Self::Late { .. }
            | Self::Depart { .. }
            | Self::Before { .. }
            | Self::NoWaiting { .. }
            | Self::Turns { .. }
            | Self::Avoid { .. } => return None,
        }
        Some(weaker)
    }
}
