//! Bytes in other encodings than UTF-8.

use std::path::PathBuf;

use giveway_model::format::{Encoding, decode, read_text};

const MAP: &str = "type octile\nheight 1\nwidth 4\nmap\n....\n";

fn utf16(text: &str, bytes: fn(u16) -> [u8; 2]) -> Vec<u8> {
    text.encode_utf16().flat_map(bytes).collect()
}

#[test]
fn utf_16_is_read_with_and_without_a_mark() {
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tests/data/brought/utf16.map");
    assert_eq!(read_text(&std::fs::read(path).unwrap()).unwrap(), MAP);
    let names = "{ \"giveway\": 1, \"name\": \"Łódź 倉庫 🤖\" }";
    for text in [MAP, names] {
        for mark in ["", "\u{feff}"] {
            let marked = format!("{mark}{text}");
            for (bytes, encoding) in [
                (utf16(&marked, u16::to_le_bytes), Encoding::Utf16Le),
                (utf16(&marked, u16::to_be_bytes), Encoding::Utf16Be),
            ] {
                let (read, found) = decode(&bytes).unwrap();
                assert_eq!((&*read, found), (text, encoding));
                assert_eq!(found.note("a"), None);
            }
        }
    }
}

#[test]
fn broken_utf_16_is_refused_with_its_place() {
    let mut bytes = utf16("\u{feff}ab\nc", u16::to_le_bytes);
    bytes.push(b'x');
    assert_eq!(
        decode(&bytes).unwrap_err().to_string(),
        "line 2, column 2: found half a letter, expected a letter in UTF-16"
    );
    let lone = [0xff, 0xfe, b'a', 0, 0x00, 0xd8, b'b', 0];
    assert!(
        decode(&lone)
            .unwrap_err()
            .to_string()
            .starts_with("line 1, column 2: found the number 0xD800")
    );
}

#[test]
fn names_in_windows_1252_are_read_and_told() {
    let bytes = b"{ \"giveway\": 1, \"name\": \"Gr\xfc\xdfe \x80 \x96\" }";
    let (text, encoding) = decode(bytes).unwrap();
    assert!(text.contains("Grüße € –"), "{text}");
    let note = encoding.note("a.json").unwrap();
    assert!(note.contains("Windows-1252"), "{note}");
    // A text that is UTF-8 elsewhere is damaged, not in another encoding.
    assert!(decode("Grüße \u{e9}".as_bytes()).is_ok());
    assert!(decode(b"Gr\xc3\xbc\xdfe").is_err());
    // Neither has letters for these bytes.
    assert!(decode(b"a\x81b").is_err() && decode(b"a\xe9\x07").is_err());
}

#[test]
fn files_that_are_no_text_are_named() {
    for (bytes, kind) in [
        (&b"\x89PNG\r\n\x1a\n\0\0"[..], "a picture (PNG)"),
        (b"\xff\xd8\xff\xe0\0", "a picture (JPEG)"),
        (b"PK\x03\x04\x14\0xl/workbook.xml", "Office"),
        (b"PK\x03\x04\x14\0a.map", "zip"),
        (b"%PDF-1.7\n", "a PDF"),
        (b"\x1f\x8b\x08\0", "gzip"),
        (b"P5\n# map\n2 2\n255\n\0\xff\0\xff", "ROS"),
    ] {
        let told = decode(bytes).unwrap_err().to_string();
        assert!(told.contains(kind), "{told}");
    }
    assert!(decode(b"BMW is no picture").is_ok());
}
