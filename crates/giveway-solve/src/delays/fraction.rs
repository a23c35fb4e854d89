//! Exact parts of a number of steps.

use std::cmp::Ordering;
use std::fmt;

use borsh::{BorshDeserialize, BorshSerialize};
use serde::{Deserialize, Serialize};

/// The largest number that JavaScript holds exactly.
const LARGEST: u64 = (1 << 53) - 1;

/// A fraction of steps in its lowest terms; both numbers are below 2^53. The denominator is 1
/// or more.
///
/// ```
/// use giveway_solve::delays::Fraction;
/// let half = Fraction::of(43, 2);
/// assert_eq!(half.to_string(), "21½");
/// assert_eq!(half.plus(half), Some(Fraction::of(43, 1)));
/// assert_eq!(Fraction::of(8, 7).to_string(), "1 1/7");
/// ```
#[derive(
    Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize,
)]
#[serde(deny_unknown_fields)]
pub struct Fraction {
    /// The number above the line.
    pub numerator: u64,
    /// The number below the line.
    pub denominator: u64,
}

impl Fraction {
    /// So many steps.
    pub const fn whole(steps: u32) -> Self {
        Self {
            numerator: steps as u64,
            denominator: 1,
        }
    }

    /// One of so many even parts of some steps; all of them where there are no parts.
    pub const fn of(steps: u32, parts: u32) -> Self {
        if parts == 0 {
            return Self::whole(steps);
        }
        let common = greatest_common_divisor(steps as u64, parts as u64);
        Self {
            numerator: steps as u64 / common,
            denominator: parts as u64 / common,
        }
    }

    /// The sum; `None` where its numbers are too large.
    pub fn plus(self, other: Self) -> Option<Self> {
        if self.denominator == 0 || other.denominator == 0 {
            return None;
        }
        let common = greatest_common_divisor(self.denominator, other.denominator);
        let (own, its) = (other.denominator / common, self.denominator / common);
        let numerator = self
            .numerator
            .checked_mul(own)?
            .checked_add(other.numerator.checked_mul(its)?)?;
        let denominator = self.denominator.checked_mul(own)?;
        let common = greatest_common_divisor(numerator, denominator);
        let sum = Self {
            numerator: numerator / common,
            denominator: denominator / common,
        };
        (sum.numerator.max(sum.denominator) <= LARGEST).then_some(sum)
    }
}

impl PartialOrd for Fraction {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Fraction {
    fn cmp(&self, other: &Self) -> Ordering {
        let product = |a: u64, b: u64| u128::from(a) * u128::from(b);
        let own = product(self.numerator, other.denominator);
        own.cmp(&product(other.numerator, self.denominator))
    }
}

/// As people write it: `21½`, `6`, `1 1/7`.
impl fmt::Display for Fraction {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let denominator = self.denominator.max(1);
        let (whole, rest) = (self.numerator / denominator, self.numerator % denominator);
        let sign = match (rest, denominator) {
            (0, _) => return write!(f, "{whole}"),
            (1, 2) => "½",
            (1, 3) => "⅓",
            (2, 3) => "⅔",
            (1, 4) => "¼",
            (3, 4) => "¾",
            (1, 5) => "⅕",
            (2, 5) => "⅖",
            (3, 5) => "⅗",
            (4, 5) => "⅘",
            (1, 6) => "⅙",
            (5, 6) => "⅚",
            (1, 8) => "⅛",
            (3, 8) => "⅜",
            (5, 8) => "⅝",
            (7, 8) => "⅞",
            (rest, denominator) if whole == 0 => return write!(f, "{rest}/{denominator}"),
            (rest, denominator) => return write!(f, "{whole} {rest}/{denominator}"),
        };
        if whole == 0 {
            write!(f, "{sign}")
        } else {
            write!(f, "{whole}{sign}")
        }
    }
}

/// The greatest common divisor; 1 where both are 0.
const fn greatest_common_divisor(mut a: u64, mut b: u64) -> u64 {
    while b != 0 {
        (a, b) = (b, a % b);
    }
    if a == 0 { 1 } else { a }
}
