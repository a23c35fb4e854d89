//! Files that are no text, known by their first bytes.

use crate::words::Later;
use crate::{tr, tr_later};

/// The first bytes of files that people take for a map or a plan.
const KINDS: &[(&[u8], Later)] = &[
    (b"\x89PNG", tr_later!("a picture (PNG)")),
    (b"\xff\xd8\xff", tr_later!("a picture (JPEG)")),
    (b"GIF8", tr_later!("a picture (GIF)")),
    (b"BM", tr_later!("a picture (BMP)")),
    (
        b"P4",
        tr_later!("a picture (PBM), such as the map of a ROS robot"),
    ),
    (
        b"P5",
        tr_later!("a picture (PGM), such as the map of a ROS robot"),
    ),
    (b"%PDF", tr_later!("a PDF")),
    (
        b"\x1f\x8b",
        tr_later!("a packed file (gzip): unpack it first"),
    ),
    (b"BZh", tr_later!("a packed file (bzip2): unpack it first")),
    (
        b"\xfd7zXZ",
        tr_later!("a packed file (xz): unpack it first"),
    ),
    (
        b"7z\xbc\xaf",
        tr_later!("a packed file (7z): unpack it first"),
    ),
    (
        b"\xd0\xcf\x11\xe0",
        tr_later!("a document of an older Office"),
    ),
    (b"\x7fELF", tr_later!("a program")),
    (b"MZ", tr_later!("a program")),
    (b"\x80\x04\x95", tr_later!("a Python pickle")),
    (
        b"\x93NUMPY",
        tr_later!("a NumPy array: save it as text, a row a line"),
    ),
    (b"SQLite format 3", tr_later!("an SQLite database")),
];

/// The kind of bytes that are no text.
pub(super) fn kind(bytes: &[u8]) -> Option<&'static str> {
    if bytes.starts_with(b"PK\x03\x04") {
        return Some(archive(bytes));
    }
    let (_, kind) = KINDS.iter().find(|(first, _)| bytes.starts_with(first))?;
    // Some of these are letters, with which a text may begin, too.
    let head = bytes.get(..bytes.len().min(1000)).unwrap_or_default();
    let is_text = std::str::from_utf8(head).is_ok_and(|head| {
        let is_odd = |c: char| c.is_control() && !c.is_whitespace();
        !head.starts_with("%PDF") && !head.contains(is_odd)
    });
    (!is_text).then(|| kind.text())
}

/// A zip archive, or a document that is one.
fn archive(bytes: &[u8]) -> &'static str {
    let has = |name: &[u8]| bytes.windows(name.len()).take(100_000).any(|it| it == name);
    if has(b"xl/") || has(b"[Content_Types].xml") {
        tr!("a table or a document of Office (xlsx, docx): save it as text")
    } else {
        tr!("a packed file (zip): unpack it first")
    }
}
