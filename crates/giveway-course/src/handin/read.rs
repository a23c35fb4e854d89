//! Reads a hand-in with the distrust of any file that a stranger wrote.

use giveway_model::{Fault, format::native, tr};

use super::bounds::{self, MAX_BYTES};
use super::unwrap::{Unwrapped, unwrapped};
use super::{HandIn, link};

/// Reads the text of a file, or a link: whatever [`super::write()`] and [`link::write()`]
/// wrote, also where a mail has quoted it, has added blanks at the ends of lines, or other
/// line breaks.
///
/// # Errors
/// The first fault, with its place, and the line and column where they are known: it is
/// too long, no hand-in, has an unknown key, a name that is not read as it is written, or
/// more than there can be.
///
/// ```
/// use giveway_course::handin::{read, write};
/// let text = r#"{ "giveway": 1, "name": "Ada", "tasks": [{ "step": 2, "answer": { "is": "value", "value": 9 },
///   "solved": true, "tries": 2 }], "hand-in": { "lesson": "a", "title": "A", "sum": "00000000000000a7" } }"#;
/// let hand_in = read(text).unwrap();
/// let quoted: String = write(&hand_in).lines().map(|line| format!("> {line} \r\n")).collect();
/// assert_eq!(read(&quoted).unwrap(), hand_in);
/// assert_eq!(read(r#"{ "giveway": 1, "tasks": 3 }"#).unwrap_err().place, "tasks");
/// ```
pub fn read(text: &str) -> Result<HandIn, Fault> {
    if text.len() > MAX_BYTES {
        return Err(too_long(text.len()));
    }
    if let Some(letters) = link::letters(text) {
        return link::read(&letters);
    }
    let Unwrapped { json, lines } = unwrapped(text)?;
    from_json(&json).map_err(|mut fault| {
        let line = fault.line.and_then(|line| lines.get(line.checked_sub(1)?));
        fault.line = line.copied();
        // Where texts were joined, a column says nothing.
        fault.column = fault.column.filter(|_| json.lines().count() == lines.len());
        fault
    })
}

fn too_long(bytes: usize) -> Fault {
    let found = tr!("{n} bytes", n = bytes);
    Fault::at("", found, tr!("at most {most}", most = MAX_BYTES)).in_text(1, 1)
}

/// Reads the JSON of a hand-in.
pub(super) fn from_json(json: &str) -> Result<HandIn, Fault> {
    let phrase = tr!("a hand-in, with \"hand-in\" and \"tasks\"");
    let hand_in: HandIn = native::read_file(json, "hand-in", phrase)?;
    match bounds::faults(&hand_in) {
        None => Ok(hand_in),
        Some(fault) => {
            let located = native::in_text(json, vec![fault.clone()]);
            Err(located.into_iter().next().unwrap_or(fault))
        }
    }
}
