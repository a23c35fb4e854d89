//! A hand-in as a part of an address: `~` and its JSON, deflated and written as letters,
//! as `#hand-in=~XY3LDo...9`.

use data_encoding::BASE64URL_NOPAD;
use giveway_model::{Fault, tr};
use miniz_oxide::deflate::compress_to_vec;
use miniz_oxide::inflate::decompress_to_vec_with_limit;

use super::HandIn;
use super::bounds::{MAX_BYTES, MAX_DEPTH};
use super::read::from_json;

/// What tells a hand-in in an address from anything else there, with its equals sign.
pub const KEY: &str = "hand-in=";
/// What the letters begin with.
const MARK: char = '~';
/// The most letters of a link; browsers and mail programs cut longer ones.
pub const MAX_LETTERS: usize = 2_000;
/// How hard to deflate: as well as it can be done.
const LEVEL: u8 = 10;

/// A hand-in as the value behind [`KEY`]; `None` where it is too long for a link.
///
/// ```
/// use giveway_course::handin::{link, read};
/// let text = r#"{ "giveway": 1, "tasks": [], "hand-in": { "lesson": "a", "title": "A", "sum": "00000000000000a7" } }"#;
/// let hand_in = read(text).unwrap();
/// let letters = link::write(&hand_in).unwrap();
/// assert!(letters.starts_with('~'));
/// assert_eq!(read(&format!("https://example.org/#hand-in={letters}")).unwrap(), hand_in);
/// ```
pub fn write(hand_in: &HandIn) -> Option<String> {
    // Names and numbers always have a JSON form.
    let dense = serde_json::to_string(hand_in).unwrap_or_default();
    let mut text = BASE64URL_NOPAD.encode(&compress_to_vec(dense.as_bytes(), LEVEL));
    text.insert(0, MARK);
    (text.len() <= MAX_LETTERS).then_some(text)
}

/// The letters of a link, whether or not an address stands before them, without what a
/// mail program wrote behind them or in the place of a sign; `None` where a text is no link.
pub fn letters(text: &str) -> Option<String> {
    let line = text.trim().trim_start_matches(['<', '"', '(', '>', ' ']);
    if line.contains(char::is_whitespace) {
        return None;
    }
    let line = line.replace("%3D", "=").replace("%7E", "~");
    let letters = match line.rfind(KEY) {
        Some(place) => line.get(place + KEY.len()..)?,
        None => &line,
    };
    let is_letter = |c: &char| c.is_ascii_alphanumeric() || matches!(*c, '-' | '_' | MARK);
    let is_link = letters.starts_with(MARK);
    is_link.then(|| letters.chars().take_while(is_letter).collect())
}

/// Reads the letters that [`write()`] wrote.
///
/// # Errors
/// What is wrong: the link was cut or changed on its way, it holds more than a hand-in
/// may, or what is in it is none.
pub fn read(letters: &str) -> Result<HandIn, Fault> {
    let cut = || {
        let found = tr!("a link that was cut or changed");
        Fault::at("", found, tr!("all of it"))
    };
    let letters = letters.strip_prefix(MARK).ok_or_else(cut)?;
    // Longer ones are never written.
    if letters.len() > 2 * MAX_LETTERS {
        let expected = tr!("that of a hand-in");
        return Err(Fault::at("", tr!("a link that is too long"), expected));
    }
    let packed = BASE64URL_NOPAD.decode(letters.as_bytes());
    let packed = packed.map_err(|_| cut())?;
    let bytes = decompress_to_vec_with_limit(&packed, MAX_BYTES).map_err(|_| cut())?;
    let json = String::from_utf8(bytes).map_err(|_| cut())?;
    if depth(&json) > MAX_DEPTH {
        return Err(cut());
    }
    from_json(&json).map_err(|mut fault| {
        (fault.line, fault.column) = (None, None);
        fault
    })
}

/// The most brackets within each other; those in texts are counted, too.
fn depth(json: &str) -> usize {
    let (mut depth, mut deepest) = (0_usize, 0);
    for c in json.chars() {
        match c {
            '{' | '[' => depth += 1,
            '}' | ']' => depth = depth.saturating_sub(1),
            _ => {}
        }
        deepest = deepest.max(depth);
    }
    deepest
}
