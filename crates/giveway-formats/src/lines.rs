//! Lines of a text and faults in them.

use std::str::FromStr;

use giveway_model::format::text::shorten;
use giveway_model::{Fault, tr};

/// A line without its end, and its number from 1.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Line<'a> {
    pub(crate) number: usize,
    pub(crate) text: &'a str,
}

/// The lines of a text, without blanks and CR at their ends.
pub(crate) fn lines(text: &str) -> impl Iterator<Item = Line<'_>> {
    giveway_model::format::text::without_mark(text)
        .lines()
        .enumerate()
        .map(|(i, line)| Line {
            number: i + 1,
            text: line.trim_end(),
        })
}

impl<'a> Line<'a> {
    /// A fault at a part of this line, which must be a slice of its text.
    pub(crate) fn fault(&self, part: &str, expected: impl Into<String>) -> Fault {
        let found = if part.is_empty() {
            tr!("the end of the line").to_owned()
        } else {
            format!("\"{}\"", shorten(part))
        };
        self.fault_saying(part, found, expected)
    }

    /// A fault at a part of this line, with words of its own for what was found.
    pub(crate) fn fault_saying(
        &self,
        part: &str,
        found: impl Into<String>,
        expected: impl Into<String>,
    ) -> Fault {
        let offset = part
            .as_ptr()
            .addr()
            .saturating_sub(self.text.as_ptr().addr());
        let before = self.text.get(..offset).unwrap_or(self.text);
        Fault::at("", found, expected).in_text(self.number, before.chars().count() + 1)
    }

    /// The empty part at the end, where a fault of what lacks there points.
    pub(crate) fn end(&self) -> &'a str {
        self.text.get(self.text.len()..).unwrap_or("")
    }

    /// The columns: split at tabs where that gives as many as wanted, so that a
    /// map's name may hold blanks, else at blanks and tabs.
    pub(crate) fn columns(&self, wanted: usize) -> Vec<&'a str> {
        let tabs: Vec<&str> = self.text.split('\t').map(str::trim).collect();
        if tabs.len() == wanted {
            return tabs;
        }
        self.text.split_whitespace().collect()
    }

    /// Reads a part of this line as a number.
    pub(crate) fn number<T: FromStr>(
        &self,
        part: &str,
        expected: impl FnOnce() -> String,
    ) -> Result<T, Fault> {
        part.parse().map_err(|_| self.fault(part, expected()))
    }
}

/// Reads a number such as `2.41421356`, without a sign or an exponent.
///
/// The standard library reads every float there is to the last bit, by a table of
/// twelve kilobytes. What is written with up to 15 digits comes out the same here.
pub(crate) fn decimal(text: &str) -> Option<f64> {
    let (whole, fraction) = text.split_once('.').unwrap_or((text, ""));
    let (mut number, mut unit) = (0.0, 1.0);
    for digit in whole.chars().chain(fraction.chars()) {
        number = 10.0 * number + f64::from(digit.to_digit(10)?);
    }
    for _ in fraction.chars() {
        unit *= 10.0;
    }
    let is_empty = whole.is_empty() && fraction.is_empty();
    Some(number / unit).filter(|number| !is_empty && number.is_finite())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn decimals_are_read_as_the_standard_library_reads_them() {
        for text in [
            "0",
            "1",
            "1.00",
            "2.41421356",
            "1234.56789012",
            "0.1",
            "007",
            "5.",
            ".5",
        ] {
            assert_eq!(decimal(text), text.parse().ok(), "{text}");
        }
        let endless = "9".repeat(400);
        for text in [
            "", ".", "-1", "1e3", "1.2.3", "nan", "inf", "long", &endless,
        ] {
            assert_eq!(decimal(text), None, "{text}");
        }
    }
}
