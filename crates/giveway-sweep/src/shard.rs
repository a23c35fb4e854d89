//! A part of a sweep, for one process.

use std::fmt;
use std::str::FromStr;

/// Part `index` of `count`, counted from 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shard {
    index: usize,
    count: usize,
}

impl Shard {
    /// All of it.
    pub const ALL: Self = Self { index: 1, count: 1 };

    /// A part; `None` where there is no such part.
    pub const fn new(index: usize, count: usize) -> Option<Self> {
        if index == 0 || index > count {
            return None;
        }
        Some(Self { index, count })
    }

    /// Whether something belongs to it, by its index from 0.
    pub(crate) const fn has(self, index: usize) -> bool {
        index % self.count == self.index - 1
    }

    /// The name of its file.
    pub(crate) fn file(self) -> String {
        format!("results-{}-of-{}.jsonl", self.index, self.count)
    }
}

impl fmt::Display for Shard {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}/{}", self.index, self.count)
    }
}

impl FromStr for Shard {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let read =
            |(index, count): (&str, &str)| Self::new(index.parse().ok()?, count.parse().ok()?);
        text.split_once('/').and_then(read).ok_or_else(|| {
            format!("found \"{text}\", expected I/N with I from 1 to N, such as 3/64")
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_are_written_from_one() {
        assert_eq!("3/64".parse::<Shard>(), Ok(Shard::new(3, 64).unwrap()));
        for wrong in ["", "3", "0/4", "5/4", "a/b", "1/0", "-1/3", "1/2/3"] {
            assert!(wrong.parse::<Shard>().is_err(), "{wrong}");
        }
        let has = |index| Shard::new(index, 3).unwrap().has(4);
        assert_eq!([has(1), has(2), has(3)], [false, true, false]);
    }
}
