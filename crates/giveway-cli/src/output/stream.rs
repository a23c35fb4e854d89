//! The only writers to standard output and standard error.

use std::io::{self, Write};

use super::plain;
use crate::failure::Failure;

/// Columns to draw for where the width of the terminal is not known.
const WIDTH: usize = 100;

/// Writes a whole result to standard output; its colours stay on a terminal
/// only, and only where `NO_COLOR` is not set.
pub(crate) fn result(text: &str) -> Result<(), Failure> {
    written(
        anstream::stdout()
            .lock()
            .write_all(text.as_bytes())
            .and_then(|()| io::stdout().flush()),
    )
}

/// Writes a whole file to standard output as it is.
pub(crate) fn file(bytes: &[u8]) -> Result<(), Failure> {
    let mut out = io::stdout().lock();
    written(out.write_all(bytes).and_then(|()| out.flush()))
}

/// A reader that went away has read enough: `giveway ... | head` is no fault.
fn written(result: io::Result<()>) -> Result<(), Failure> {
    match result {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => {
            Err(Failure::output("standard output", error))
        }
        _ => Ok(()),
    }
}

/// Writes lines to standard error; where it is closed there is nobody to tell.
pub(crate) fn error_lines(lines: &[String]) {
    let mut text = lines.join("\n");
    text.push('\n');
    let _ = io::stderr().lock().write_all(text.as_bytes());
}

/// Writes a note on standard error; it is one line whatever names are in it.
pub(crate) fn note(note: &str) {
    error_lines(&[plain::text(note)]);
}

/// How many columns a line on standard output may take.
pub(crate) fn columns() -> usize {
    terminal_size::terminal_size_of(io::stdout())
        .map_or(WIDTH, |(width, _)| usize::from(width.0).max(40))
}
