//! Looser rules: a rule asks for less in one of its numbers, or at an end of its times.

use super::{ConstraintKind, MAX_NUMBER, meant};
use crate::condition::Times;

/// What of a rule can ask for less.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Loosens {
    /// Its number: how many at most, how far apart, how many steps, at what weight.
    Number,
    /// The last time of its times, or the time by which robots arrive.
    LastTime,
    /// The first time of its times, or the time from which on robots start.
    FirstTime,
}

/// A way in which a rule can ask for less: the further from today's number, the less it asks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LooserWay {
    /// What changes.
    pub loosens: Loosens,
    /// The number today. Of times without an end it is the first one that nothing looks at.
    pub today: u32,
    /// The number at which it asks for the least, without being off.
    pub loosest: u32,
    /// Whether today's times have no end, for which a number stands.
    pub is_open: bool,
}

impl LooserWay {
    const fn new(loosens: Loosens, today: u32, loosest: u32) -> Self {
        Self {
            loosens,
            today,
            loosest,
            is_open: false,
        }
    }

    /// How many numbers ask for less.
    pub const fn steps(&self) -> u32 {
        self.today.abs_diff(self.loosest)
    }

    /// The number so many steps from today's.
    pub const fn number(&self, steps: u32) -> u32 {
        if self.today <= self.loosest {
            self.today.saturating_add(steps)
        } else {
            self.today.saturating_sub(steps)
        }
    }
}

impl ConstraintKind {
    /// The ways in which it can ask for less, the usual one first; none where it is only on or
    /// off. Times without an end are looked at up to the time `last`.
    ///
    /// ```
    /// use giveway_model::constraint::ConstraintKind;
    /// let ways = ConstraintKind::Gap { steps: 3 }.looser_ways(20);
    /// assert_eq!((ways.len(), ways[0].loosest), (1, 1));
    /// assert!(ConstraintKind::Gap { steps: 1 }.looser_ways(20).is_empty());
    /// ```
    pub fn looser_ways(&self, last: u32) -> Vec<LooserWay> {
        let number = |today, loosest| LooserWay::new(Loosens::Number, today, loosest);
        let later =
            |today: Option<u32>| today.map(|to| LooserWay::new(Loosens::LastTime, to, MAX_NUMBER));
        let sooner = |today| LooserWay::new(Loosens::FirstTime, today, 0);
        let mut ways: Vec<LooserWay> = match self {
            Self::Capacity { most, times, .. } => {
                let mut ways = vec![number(*most, MAX_NUMBER)];
                ways.extend(shorter(*times, last, false));
                ways
            }
            Self::Closed { times, .. } => shorter(*times, last, true).collect(),
            Self::Apart { distance, times } => {
                let mut ways = vec![number(*distance, 2)];
                ways.extend(shorter(*times, last, false));
                ways
            }
            Self::Gap { steps: least } | Self::Turns { quarter: least } => vec![number(*least, 1)],
            Self::Avoid { weight, .. } => vec![number(*weight, 1)],
            Self::NoWaiting { most, .. } => vec![number(*most, MAX_NUMBER)],
            Self::Visit { stay, times, .. } => {
                let ways = [number(*stay, 0), sooner(times.first())];
                ways.into_iter().chain(later(meant(*times).to)).collect()
            }
            Self::Arrive { times } => {
                let ways = later(meant(*times).to).into_iter();
                ways.chain([sooner(times.first())]).collect()
            }
            Self::Late { by, weight } => {
                let ways = later(Some(*by)).into_iter();
                ways.chain([number(*weight, 1)]).collect()
            }
            Self::Depart { from } => vec![sooner(*from)],
            Self::OneWay { .. } | Self::Sequence { .. } | Self::Before { .. } => Vec::new(),
        };
        ways.retain(|way| way.steps() > 0);
        ways
    }

    /// The same with another number in one of its [`Self::looser_ways`]; `None` where it has
    /// no such way.
    #[must_use]
    pub fn loosened(&self, loosens: Loosens, number: u32) -> Option<Self> {
        let mut looser = self.clone();
        let (own, times) = match &mut looser {
            Self::Capacity { most, times, .. } => (Some(most), Some(times)),
            Self::Closed { times, .. } | Self::Arrive { times } => (None, Some(times)),
            Self::Apart { distance, times } => (Some(distance), Some(times)),
            Self::Visit { stay, times, .. } => (Some(stay), Some(times)),
            Self::Gap { steps: own }
            | Self::Turns { quarter: own }
            | Self::Avoid { weight: own, .. }
            | Self::NoWaiting { most: own, .. } => (Some(own), None),
            Self::Late { by, weight } => {
                match loosens {
                    Loosens::Number => *weight = number,
                    Loosens::LastTime => *by = number,
                    Loosens::FirstTime => return None,
                }
                return Some(looser);
            }
            Self::Depart { from } => {
                if loosens != Loosens::FirstTime {
                    return None;
                }
                *from = number;
                return Some(looser);
            }
            Self::OneWay { .. } | Self::Sequence { .. } | Self::Before { .. } => (None, None),
        };
        match loosens {
            Loosens::Number => *own? = number,
            Loosens::LastTime => times?.to = Some(number),
            Loosens::FirstTime => {
                let times = times?;
                // From 0 on is from the beginning; an arrival has to name a time.
                let is_said = number > 0 || times.to.is_none();
                times.from = is_said.then_some(number);
            }
        }
        Some(looser)
    }
}

/// Shorter times of a rule: it ends sooner, or begins later. Where they are all times, only
/// if that is wanted.
fn shorter(times: Times, last: u32, even_always: bool) -> impl Iterator<Item = LooserWay> {
    let (from, to) = (times.first(), meant(times).to);
    let is_always = from == 0 && to.is_none();
    let beyond = last.saturating_add(1).max(from.saturating_add(1));
    let ends = LooserWay {
        is_open: to.is_none(),
        ..LooserWay::new(Loosens::LastTime, to.unwrap_or(beyond), from)
    };
    let begins = LooserWay::new(Loosens::FirstTime, from, to.unwrap_or(beyond - 1));
    let ways = [ends, begins].into_iter();
    ways.filter(move |_| even_always || !is_always)
}
