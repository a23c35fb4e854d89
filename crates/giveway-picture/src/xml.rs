//! Text as it stands in XML, and numbers as they stand in SVG.

use std::fmt;

/// A text within XML: what means something there is escaped, and what an XML file
/// must not hold is left out.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Escaped<'a>(pub(crate) &'a str);

impl fmt::Display for Escaped<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        use fmt::Write as _;
        for c in self.0.chars() {
            match c {
                '&' => f.write_str("&amp;")?,
                '<' => f.write_str("&lt;")?,
                '>' => f.write_str("&gt;")?,
                '"' => f.write_str("&quot;")?,
                '\'' => f.write_str("&#39;")?,
                '\n' | '\t' | '\r' => f.write_char(' ')?,
                c if c.is_control() || matches!(c, '\u{fffe}' | '\u{ffff}') => {}
                c => f.write_char(c)?,
            }
        }
        Ok(())
    }
}

/// A number with at most two decimals, and none that is not needed.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Number(pub(crate) f64);

impl fmt::Display for Number {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let text = format!("{:.2}", self.0);
        let text = text.trim_end_matches('0').trim_end_matches('.');
        f.write_str(if text == "-0" { "0" } else { text })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_cannot_leave_their_place() {
        let name = "<script>\"a\" & 'b'\u{0}\u{1b}[1m\u{ffff}\n";
        let expect = "&lt;script&gt;&quot;a&quot; &amp; &#39;b&#39;[1m ";
        assert_eq!(Escaped(name).to_string(), expect);
    }

    #[test]
    fn numbers_are_short() {
        let numbers = [1.0, 0.5, 33.333_333, -0.001, 100.0, -12.5];
        let written = numbers.map(|number| Number(number).to_string());
        assert_eq!(written, ["1", "0.5", "33.33", "0", "100", "-12.5"]);
    }
}
