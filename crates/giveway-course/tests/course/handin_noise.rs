//! The reader of hand-ins on noise: bytes, cuts, depth, size.

use std::fmt::Write as _;

use fastrand::Rng;
use giveway_course::handin::{HandIn, MAX_BYTES, Shown, link, read, write};

use super::{handins, shipped};

/// How many files are damaged.
const DAMAGED: usize = 3000;

fn samples() -> Vec<HandIn> {
    let lessons = shipped::lessons();
    let solved = |(name, lesson): &(String, _)| handins::solved(name, lesson, "Ada > \u{e9}");
    lessons.iter().map(solved).collect()
}

fn damaged(text: &str, rng: &mut Rng) -> String {
    let mut bytes = text.as_bytes().to_vec();
    for _ in 0..rng.usize(1..5) {
        let at = rng.usize(0..bytes.len().max(1)).min(bytes.len());
        match rng.u8(0..6) {
            0 if at < bytes.len() => bytes[at] = rng.u8(..),
            1 if at < bytes.len() => drop(bytes.remove(at)),
            2 => bytes.insert(at, *rng.choice(b"\"[]{},:0-9> \n\\u".as_slice()).unwrap()),
            3 => bytes.truncate(at),
            4 => bytes.insert(at, b'\n'),
            _ => {
                let end = (at + rng.usize(1..60)).min(bytes.len());
                let part = bytes[at..end].to_vec();
                bytes.splice(at..at, part);
            }
        }
    }
    String::from_utf8_lossy(&bytes).into_owned()
}

#[test]
fn damaged_files_never_panic_and_what_is_read_is_written_again() {
    let mut rng = Rng::with_seed(41);
    let samples = samples();
    let texts: Vec<String> = samples.iter().map(write).collect();
    let links: Vec<String> = samples.iter().filter_map(link::write).collect();
    let lessons = shipped::lessons();
    let (mut refused, mut taken) = (0, 0);
    for round in 0..DAMAGED {
        let place = rng.usize(0..texts.len());
        let text = if round % 5 == 0 {
            damaged(rng.choice(&links).unwrap(), &mut rng)
        } else {
            damaged(&texts[place], &mut rng)
        };
        match read(&text) {
            Ok(hand_in) => {
                taken += 1;
                assert_eq!(read(&write(&hand_in)), Ok(hand_in.clone()));
                for work in &hand_in.tasks {
                    let _ = Shown::of(work, &lessons[place].1);
                }
            }
            Err(fault) => {
                refused += 1;
                let told = fault.to_string();
                assert!(told.chars().count() < 600 && !told.contains('\n'), "{told}");
                assert!(
                    !fault.expected.is_empty() && !fault.found.is_empty(),
                    "{told}"
                );
            }
        }
    }
    assert!(
        refused > DAMAGED / 4 && taken > DAMAGED / 50,
        "{refused} {taken}"
    );
}

#[test]
fn random_bytes_are_no_hand_in() {
    let mut rng = Rng::with_seed(42);
    for _ in 0..2000 {
        let bytes: Vec<u8> = (0..rng.usize(0..300)).map(|_| rng.u8(..)).collect();
        let text = String::from_utf8_lossy(&bytes);
        assert!(read(&text).is_err());
        assert!(read(&format!("{{{text}")).is_err());
        assert!(read(&format!("~{text}")).is_err());
    }
}

#[test]
fn size_and_depth_are_bounded() {
    let fault = read(&" ".repeat(MAX_BYTES + 1)).unwrap_err();
    assert_eq!(fault.expected, "at most 200000");
    let deep = "[".repeat(50_000);
    let text = format!("{{ \"giveway\": 1, \"tasks\": {deep}");
    assert!(read(&text).unwrap_err().found.contains("brackets"), "deep");
    // A few letters that unpack to a lot.
    let mut large = String::from("{\"giveway\":1,\"tasks\":[");
    for _ in 0..100_000 {
        let _ = write!(large, "{{\"step\":1}},");
    }
    let packed = miniz_oxide::deflate::compress_to_vec(large.as_bytes(), 9);
    let letters = data_encoding::BASE64URL_NOPAD.encode(&packed);
    let fault = read(&format!("~{letters}")).unwrap_err();
    assert_eq!(fault.found, "a link that was cut or changed");
}
