//! Takes a hand-in out of what a mail has made of it.

use giveway_model::{Fault, tr};

use super::bounds::MAX_DEPTH;

/// The text of a hand-in: JSON again, with the number of the line in which each of its
/// lines stood, from 1.
pub(super) struct Unwrapped {
    pub(super) json: String,
    pub(super) lines: Vec<usize>,
}

/// Joins what was broken within texts, without the marks of a quotation, without blanks at
/// the ends of lines, and without what a person wrote before and after it.
///
/// # Errors
/// Where there is nothing that begins as a hand-in, where there are two, or where too many
/// brackets stand within each other.
pub(super) fn unwrapped(text: &str) -> Result<Unwrapped, Fault> {
    let mut found = Unwrapped {
        json: String::new(),
        lines: Vec::new(),
    };
    let mut scan = Scan::default();
    let text = text.trim_start_matches('\u{feff}');
    for (number, line) in (1..).zip(text.lines()) {
        let line = line
            .trim_start_matches([' ', '\t', '>', '\u{feff}'])
            .trim_end();
        let begins = line.starts_with('{');
        match scan.state {
            State::Before if !begins => continue,
            State::Before | State::Within => {}
            State::After if begins => {
                let expected = tr!("one hand-in; save each as a file of its own");
                let fault = Fault::at("", tr!("a second hand-in"), expected);
                return Err(fault.in_text(number, 1));
            }
            State::After => continue,
        }
        if !scan.is_text && !found.json.is_empty() {
            found.json.push('\n');
        }
        if !scan.is_text {
            found.lines.push(number);
        }
        for c in line.chars() {
            // What stands behind it in its last line is for the reader to refuse.
            scan.take(c);
            found.json.push(c);
        }
        if scan.deepest > MAX_DEPTH {
            let most = MAX_DEPTH;
            let found = tr!("more than {most} brackets within each other", most);
            return Err(Fault::at("", found, tr!("a hand-in")).in_text(number, 1));
        }
    }
    match scan.state {
        State::Before if text.trim().is_empty() => {
            let found = tr!("an empty file");
            Err(Fault::at("", found, tr!("a hand-in")).in_text(1, 1))
        }
        State::Before => {
            let expected = tr!(
                "a hand-in, as {button} in a lesson saves it",
                button = tr!("Hand in")
            );
            Err(Fault::at("", tr!("another text"), expected))
        }
        State::Within => {
            let line = text.lines().count();
            let column = text.lines().last().map_or(0, |line| line.chars().count());
            let expected = tr!("all of the file; ask for it again");
            let fault = Fault::at("", tr!("the end of the text"), expected);
            Err(fault.in_text(line, column + 1))
        }
        State::After => Ok(found),
    }
}

#[derive(Clone, Copy, Default)]
enum State {
    #[default]
    Before,
    Within,
    After,
}

/// Where in a JSON text a reader is.
#[derive(Default)]
struct Scan {
    state: State,
    is_text: bool,
    is_escaped: bool,
    depth: usize,
    deepest: usize,
}

impl Scan {
    fn take(&mut self, c: char) {
        if self.is_text {
            let is_end = c == '"' && !self.is_escaped;
            self.is_escaped = c == '\\' && !self.is_escaped;
            self.is_text = !is_end;
            return;
        }
        match c {
            '"' => self.is_text = true,
            '{' | '[' => {
                self.state = State::Within;
                self.depth += 1;
                self.deepest = self.deepest.max(self.depth);
            }
            '}' | ']' => {
                self.depth = self.depth.saturating_sub(1);
                if self.depth == 0 {
                    self.state = State::After;
                }
            }
            _ => {}
        }
    }
}
