//! Bytes as text: UTF-8, UTF-16 with or without a byte order mark, Windows-1252.

use std::borrow::Cow;

use super::text::{position, without_mark};
use crate::{Fault, tr, tr_later};

mod binary;

/// How the letters of a text are written as bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Encoding {
    /// UTF-8, as this project writes texts.
    Utf8,
    /// UTF-16, the low byte first.
    Utf16Le,
    /// UTF-16, the high byte first.
    Utf16Be,
    /// Windows-1252, of which Latin-1 is a part.
    Windows1252,
}

impl Encoding {
    /// The remark that the encoding of a file is an assumption, where it is one.
    pub fn note(self, file: &str) -> Option<String> {
        (self == Self::Windows1252).then(|| {
            tr!(
                "{file} is not UTF-8; its letters are read as Windows-1252 (Latin-1).",
                file
            )
        })
    }
}

/// The bytes of a file as text, without the byte order mark that some editors
/// put first.
///
/// # Errors
/// As [`decode`].
///
/// ```
/// use giveway_model::format::read_text;
/// assert_eq!(read_text(b"\xff\xfet\0y\0").unwrap(), "ty");
/// ```
pub fn read_text(bytes: &[u8]) -> Result<Cow<'_, str>, Fault> {
    decode(bytes).map(|(text, _)| text)
}

/// The same with the encoding.
///
/// # Errors
/// When the bytes are those of an image, an archive or another file that is no
/// text, or in an encoding that is not known. The fault has a line and a column.
pub fn decode(bytes: &[u8]) -> Result<(Cow<'_, str>, Encoding), Fault> {
    if let Some(rest) = bytes.strip_prefix(b"\xff\xfe") {
        return utf16(rest, Encoding::Utf16Le);
    }
    if let Some(rest) = bytes.strip_prefix(b"\xfe\xff") {
        return utf16(rest, Encoding::Utf16Be);
    }
    if let Some(kind) = binary::kind(bytes) {
        let expected = tr!("a text: a map, a scenario, an instance or a plan");
        return Err(Fault::at("", kind, expected).in_text(1, 1));
    }
    if let Some(encoding) = utf16_without_mark(bytes) {
        return utf16(bytes, encoding);
    }
    match std::str::from_utf8(bytes) {
        Ok(text) => Ok((Cow::Borrowed(without_mark(text)), Encoding::Utf8)),
        Err(error) => windows1252(bytes, error.valid_up_to()),
    }
}

/// Half of the bytes of a text in UTF-16 are zero, mostly all of one parity: its
/// letters are of ASCII but for some names.
fn utf16_without_mark(bytes: &[u8]) -> Option<Encoding> {
    let (pairs, _) = bytes.as_chunks::<2>();
    let count = |at: fn(&[u8; 2]) -> bool| pairs.iter().filter(|pair| at(pair)).count();
    let low_first = count(|&[low, high]| high == 0 && low != 0);
    let high_first = count(|&[high, low]| high == 0 && low != 0);
    let most = |some: usize| some > 0 && some * 10 >= pairs.len() * 7;
    match (most(low_first), most(high_first)) {
        (true, false) => Some(Encoding::Utf16Le),
        (false, true) => Some(Encoding::Utf16Be),
        _ => None,
    }
}

fn utf16(bytes: &[u8], encoding: Encoding) -> Result<(Cow<'_, str>, Encoding), Fault> {
    let (pairs, rest) = bytes.as_chunks::<2>();
    let units = pairs.iter().map(|&pair| match encoding {
        Encoding::Utf16Be => u16::from_be_bytes(pair),
        _ => u16::from_le_bytes(pair),
    });
    let mut text = String::with_capacity(pairs.len());
    for letter in char::decode_utf16(units) {
        match letter {
            Ok(letter) => text.push(letter),
            Err(error) => {
                let unit = format!("0x{:04X}", error.unpaired_surrogate());
                return Err(broken_utf16(&text, tr!("the number {unit}", unit)));
            }
        }
    }
    match rest {
        [] => Ok((Cow::Owned(without_mark(&text).to_owned()), encoding)),
        _ => Err(broken_utf16(&text, tr!("half a letter").to_owned())),
    }
}

fn broken_utf16(before: &str, found: String) -> Fault {
    let (line, column) = position(before, before.len());
    Fault::at("", found, tr_later!("a letter in UTF-16")).in_text(line, column)
}

/// Reads bytes that are no UTF-8 as Windows-1252, unless a part of them is UTF-8
/// beyond ASCII: then the text is UTF-8 and damaged.
fn windows1252(bytes: &[u8], valid: usize) -> Result<(Cow<'_, str>, Encoding), Fault> {
    let fault = |at: usize| {
        let good = bytes.get(..at).unwrap_or_default();
        let good = String::from_utf8_lossy(good);
        let (line, column) = position(&good, good.len());
        let byte = bytes.get(at).copied().unwrap_or_default();
        let byte = format!("0x{byte:02X}");
        let found = tr!("the byte {byte}", byte);
        Fault::at(
            "",
            found,
            tr_later!("text in UTF-8, UTF-16 or Windows-1252"),
        )
        .in_text(line, column)
    };
    let is_utf8 = |chunk: std::str::Utf8Chunk<'_>| !chunk.valid().is_ascii();
    if bytes.utf8_chunks().any(is_utf8) {
        return Err(fault(valid));
    }
    let mut text = String::with_capacity(bytes.len());
    for (at, &byte) in bytes.iter().enumerate() {
        let letter = match byte {
            0x80..=0x9f => HIGH.get(usize::from(byte - 0x80)).copied().flatten(),
            b'\t' | b'\n' | 0x0c | b'\r' | b' '..=0x7e | 0xa0.. => Some(char::from(byte)),
            _ => None,
        };
        text.push(letter.ok_or_else(|| fault(at))?);
    }
    Ok((Cow::Owned(text), Encoding::Windows1252))
}

/// The letters of Windows-1252 in the places of Latin-1's control characters.
const HIGH: [Option<char>; 32] = [
    Some('€'),
    None,
    Some('‚'),
    Some('ƒ'),
    Some('„'),
    Some('…'),
    Some('†'),
    Some('‡'),
    Some('ˆ'),
    Some('‰'),
    Some('Š'),
    Some('‹'),
    Some('Œ'),
    None,
    Some('Ž'),
    None,
    None,
    Some('‘'),
    Some('’'),
    Some('“'),
    Some('”'),
    Some('•'),
    Some('–'),
    Some('—'),
    Some('˜'),
    Some('™'),
    Some('š'),
    Some('›'),
    Some('œ'),
    None,
    Some('ž'),
    Some('Ÿ'),
];
