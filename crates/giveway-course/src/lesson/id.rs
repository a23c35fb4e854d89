//! Short names of lessons and terms, as they stand in links and file names.

use std::borrow::Cow;
use std::fmt;
use std::str::FromStr;

use serde::{Deserialize, Deserializer, Serialize, de};

/// The most letters of a short name.
const LONGEST: usize = 60;

/// A short name: small letters, digits and hyphens, such as `room-to-pass`.
///
/// ```
/// use giveway_course::lesson::Id;
/// assert!("room-to-pass".parse::<Id>().is_ok());
/// assert!("../room".parse::<Id>().is_err());
/// ```
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, borsh::BorshSerialize)]
pub struct Id(String);

/// A word that is no short name.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct BadId(String);

impl fmt::Display for BadId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let shown: String = self.0.chars().take(LONGEST).collect();
        write!(
            f,
            "found {shown:?}, expected small letters, digits and hyphens, at most {LONGEST}"
        )
    }
}

impl std::error::Error for BadId {}

/// The FNV-1a hash of a text, with 64 bits. Nothing is at stake but what a learner has done.
pub(crate) fn hash(text: &str) -> u64 {
    let mix = |hash: u64, byte: u8| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
    text.bytes().fold(0xcbf2_9ce4_8422_2325, mix)
}

impl Id {
    /// The name of a lesson that is no part of a course: by what is in it, so that the
    /// same lesson is found again wherever it comes from.
    pub(super) fn of_content(content: &str) -> Self {
        Self(format!("own-{:016x}", hash(content)))
    }

    /// The name of a lesson that is tried while it is written. Nothing that is read can
    /// have it, and no progress is kept under it.
    pub(crate) fn tried() -> Self {
        Self("~".to_owned())
    }

    /// Whether it is the name of a lesson that is no part of a course.
    pub fn is_own(&self) -> bool {
        self.0.starts_with("own-") || self.0 == "~"
    }

    /// The name.
    pub fn as_str(&self) -> &str {
        &self.0
    }
}

impl fmt::Display for Id {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl FromStr for Id {
    type Err = BadId;

    fn from_str(word: &str) -> Result<Self, BadId> {
        let plain = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '-';
        let is_id = (1..=LONGEST).contains(&word.len()) && word.chars().all(plain);
        if is_id {
            Ok(Self(word.to_owned()))
        } else {
            Err(BadId(word.to_owned()))
        }
    }
}

impl<'de> Deserialize<'de> for Id {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let word = Cow::<str>::deserialize(deserializer)?;
        word.parse().map_err(de::Error::custom)
    }
}
