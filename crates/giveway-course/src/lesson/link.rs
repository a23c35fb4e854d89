//! A lesson as a part of an address: `~` and its JSON, deflated and written as letters,
//! and perhaps a step behind a dot.
//!
//! The short name of a lesson never begins with `~`, so that both can stand in one
//! place: `#lesson=room-to-pass.2`, `#lesson=~XY3LDo...9.2`.

use data_encoding::BASE64URL_NOPAD;
use giveway_model::{Fault, tr};
use miniz_oxide::deflate::compress_to_vec;
use miniz_oxide::inflate::decompress_to_vec_with_limit;

use super::read::MAX_BYTES;
use super::write::dense;
use super::{Glossary, Lesson, read_lesson};

/// What tells a whole lesson from the name of one.
pub const MARK: char = '~';
/// How hard to deflate: as well as it can be done.
const LEVEL: u8 = 10;

/// A lesson as a part of an address, opened at a step, from 0, where one is given.
///
/// ```
/// use giveway_course::lesson::{Glossary, link, read_lesson};
/// let text = r#"{ "giveway": 1, "title": "T", "minutes": 4, "about": "A sentence.",
///   "steps": [{ "title": "One", "text": ["A sentence."],
///               "scene": { "giveway": 1, "map": ["."], "agents": [] } }] }"#;
/// let lesson = read_lesson(text, &Glossary::default()).unwrap();
/// let written = link::write(&lesson, Some(0));
/// assert!(written.starts_with('~') && written.ends_with(".1"));
/// let (read, step) = link::read(&written, &Glossary::default()).unwrap();
/// assert_eq!((read, step), (lesson, Some(0)));
/// ```
pub fn write(lesson: &Lesson, step: Option<usize>) -> String {
    let packed = compress_to_vec(dense(lesson).as_bytes(), LEVEL);
    let mut text = BASE64URL_NOPAD.encode(&packed);
    text.insert(0, MARK);
    if let Some(step) = step {
        text.push('.');
        text.push_str(&(step + 1).to_string());
    }
    text
}

/// Reads what [`write()`] wrote. Steps are counted from 1 in the text.
///
/// # Errors
/// What is wrong: the text was cut or changed on its way, it holds more than a lesson
/// may, or the lesson in it has faults.
pub fn read(text: &str, glossary: &Glossary) -> Result<(Lesson, Option<usize>), Vec<Fault>> {
    let text = text.strip_prefix(MARK).unwrap_or(text);
    let (letters, step) = match text.split_once('.') {
        Some((letters, step)) => (letters, step.parse::<usize>().ok()),
        None => (text, None),
    };
    let fault = |found: &str, expected: &str| vec![Fault::at("", found, expected)];
    // Base 64 is a third longer, and what is deflated is hardly ever longer than before.
    if letters.len() > MAX_BYTES * 2 {
        return Err(fault(
            tr!("a link that is too long"),
            tr!("that of a lesson"),
        ));
    }
    let packed = BASE64URL_NOPAD.decode(letters.as_bytes());
    let packed =
        packed.map_err(|_| fault(tr!("a link that was cut or changed"), tr!("all of it")))?;
    let bytes = decompress_to_vec_with_limit(&packed, MAX_BYTES)
        .map_err(|_| fault(tr!("a link that was cut or changed"), tr!("all of it")))?;
    let json = String::from_utf8(bytes);
    let json = json.map_err(|_| fault(tr!("a link that was cut or changed"), tr!("all of it")))?;
    let lesson = read_lesson(&json, glossary)?;
    Ok((lesson, step.and_then(|step| step.checked_sub(1))))
}
