//! Writes a hand-in as a text that a mail survives: ASCII, short lines, and nothing at
//! their ends that a mail program takes away.

use super::HandIn;

/// The most characters of a line.
const WIDTH: usize = 72;
/// A space where a line begins or ends within a text.
const SPACE: &str = "\\u0020";

/// The text of a file, in ASCII and lines of at most 72 characters. It is JSON, but for a text
/// that is longer than a line: that goes on in the next one until [`super::read()`] joins it.
/// Ends with a line break.
pub fn write(hand_in: &HandIn) -> String {
    // Names and numbers always have a JSON form.
    let dense = serde_json::to_string(hand_in).unwrap_or_default();
    let mut lines = Lines::default();
    for unit in units(&dense) {
        lines.push(unit);
    }
    lines.text.push_str(lines.line.trim_end());
    lines.text.push('\n');
    lines.text
}

/// What is not parted between two lines.
struct Unit {
    text: String,
    /// Whether it stands within a text.
    is_within: bool,
    /// Whether a new line begins behind it.
    ends_line: bool,
}

#[derive(Default)]
struct Lines {
    text: String,
    line: String,
}

impl Lines {
    fn push(&mut self, unit: Unit) {
        // There is room for a space that is written out.
        let is_full = self.line.len() + unit.text.len() > WIDTH - SPACE.len();
        let mut text = unit.text;
        if is_full && !self.line.is_empty() {
            if unit.is_within && self.line.ends_with(' ') {
                self.line.pop();
                self.line.push_str(SPACE);
            }
            if unit.is_within && text == " " {
                SPACE.clone_into(&mut text);
            }
            self.end();
        }
        self.line.push_str(&text);
        if unit.ends_line {
            self.end();
        }
    }

    fn end(&mut self) {
        let line = std::mem::take(&mut self.line);
        self.text.push_str(line.trim_end());
        self.text.push('\n');
    }
}

/// JSON without blanks, in units: texts as far as they have room in a line, else each of their
/// characters; whole words and numbers with the sign behind them.
fn units(dense: &str) -> Vec<Unit> {
    let mut units: Vec<Unit> = Vec::new();
    let mut word = String::new();
    // Where the text begins that is read.
    let mut begins = 0;
    let (mut is_within, mut is_escaped, mut depth) = (false, false, 0_usize);
    for c in dense.chars() {
        if !is_within {
            word.push(c);
            match c {
                '"' => {
                    is_within = true;
                    begins = units.len();
                }
                '{' | '[' => depth += 1,
                '}' | ']' => depth = depth.saturating_sub(1),
                ',' | ':' => {}
                _ => continue,
            }
            let ends_line = c == ',' && depth <= 2;
            if matches!(c, ',' | ':') && !ends_line {
                word.push(' ');
            }
            let text = std::mem::take(&mut word);
            units.push(Unit {
                text,
                is_within: false,
                ends_line,
            });
            continue;
        }
        // What is escaped stays together.
        let text = match c {
            _ if is_escaped => format!("\\{c}"),
            '\\' => {
                is_escaped = true;
                continue;
            }
            '>' => "\\u003e".to_owned(),
            ' '..='~' => c.to_string(),
            other => escaped(other),
        };
        let is_end = c == '"' && !is_escaped;
        is_escaped = false;
        is_within = !is_end;
        units.push(Unit {
            text,
            is_within: true,
            ends_line: false,
        });
        if is_end {
            join(&mut units, begins);
        }
    }
    units
}

/// Joins the units of a text that has room in a line.
fn join(units: &mut Vec<Unit>, begins: usize) {
    let length: usize = units.iter().skip(begins).map(|unit| unit.text.len()).sum();
    if length <= WIDTH - SPACE.len() {
        let text = units.drain(begins..).map(|unit| unit.text).collect();
        units.push(Unit {
            text,
            is_within: false,
            ends_line: false,
        });
    }
}

/// A character as JSON has it in ASCII.
fn escaped(c: char) -> String {
    let mut pair = [0; 2];
    let pair = c.encode_utf16(&mut pair);
    let halves = pair.iter().map(|half| format!("\\u{half:04x}"));
    halves.collect::<Vec<_>>().concat()
}
