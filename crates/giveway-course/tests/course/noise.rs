//! Readers never panic on noise, and tell what is wrong in a short sentence.

use fastrand::Rng;
use giveway_course::judge::{Did, Situation, begin};
use giveway_course::learner::Progress;
use giveway_course::lesson::{Lesson, Text, read_course, read_glossary, read_lesson, write_lesson};

use super::shipped;

/// How many files are damaged.
const DAMAGED: usize = 1200;

/// A text with a few bytes changed, lost, repeated or moved, as text again.
fn damaged(text: &str, rng: &mut Rng) -> String {
    let mut bytes = text.as_bytes().to_vec();
    for _ in 0..rng.usize(1..6) {
        let at = rng.usize(0..bytes.len());
        match rng.u8(0..5) {
            0 => bytes[at] = rng.u8(..),
            1 => {
                bytes.remove(at);
            }
            2 => bytes.insert(at, *rng.choice(b"\"[]{},:0-9*\\<nt".as_slice()).unwrap()),
            3 => bytes.truncate(at.max(1)),
            _ => {
                let end = (at + rng.usize(1..40)).min(bytes.len());
                let part = bytes[at..end].to_vec();
                let to = rng.usize(0..=bytes.len());
                bytes.splice(to..to, part);
            }
        }
        if bytes.is_empty() {
            bytes.push(b'{');
        }
    }
    String::from_utf8_lossy(&bytes).into_owned()
}

#[test]
fn damaged_files_never_panic() {
    let mut rng = Rng::with_seed(7);
    let glossary = shipped::glossary();
    let mut texts: Vec<String> = shipped::lessons()
        .iter()
        .map(|(_, l)| write_lesson(l))
        .collect();
    texts.retain(|text| text.len() < 20_000);
    texts.push(shipped::text("index"));
    texts.push(shipped::text("glossary"));
    let mut refused = 0;
    for _ in 0..DAMAGED {
        let text = damaged(rng.choice(&texts).unwrap(), &mut rng);
        match read_lesson(&text, &glossary) {
            Ok(lesson) => looked_at(&lesson),
            Err(faults) => {
                refused += 1;
                assert!(!faults.is_empty());
                for fault in faults {
                    assert!(fault.line.is_some(), "{fault}");
                    let told = fault.to_string();
                    assert!(told.chars().count() < 600, "{told}");
                    assert!(!told.contains('\n'), "{told}");
                }
            }
        }
        let _ = read_course(&text);
        let _ = read_glossary(&text);
        let _ = Progress::read(&text);
    }
    assert!(refused > DAMAGED / 4, "{refused}");
}

/// A damaged lesson that can be read can be written, and judged up to the solver.
fn looked_at(lesson: &Lesson) {
    let again = giveway_model::format::native::read_object(&write_lesson(lesson));
    assert_eq!(again.as_ref(), Ok(lesson));
    for (index, step) in lesson.steps.iter().enumerate() {
        let start = lesson.scene(index).unwrap();
        let situation = Situation {
            step,
            start,
            scene: start,
        };
        let dids = [
            Did::Edits,
            Did::Chose(0),
            Did::Marked(Vec::new()),
            Did::NoOrder,
        ];
        for did in dids {
            let _ = begin(situation, &did);
        }
    }
}

#[test]
fn random_texts_never_panic_and_read_back() {
    let mut rng = Rng::with_seed(11);
    let parts = [
        "*",
        "[",
        "]",
        "(",
        ")",
        "\\",
        "<",
        "a",
        "robot:A1",
        "cell:3,1",
        "term:x",
        "time:3",
        " ",
        "](",
        "é",
        "\n",
        "[b](robot:C\\)D)",
        "*e*",
        "<b>",
        ":",
        "\\*",
    ];
    let mut read = 0;
    for _ in 0..20_000 {
        let count = rng.usize(0..8);
        let text: String = (0..count).map(|_| *rng.choice(&parts).unwrap()).collect();
        if let Ok(parsed) = text.parse::<Text>() {
            read += 1;
            assert_eq!(parsed.to_string().parse::<Text>(), Ok(parsed), "{text:?}");
        }
    }
    assert!(read > 1000, "{read}");
}

#[test]
fn too_large_a_file_is_refused_unread() {
    let text = " ".repeat(2 << 20);
    let faults = read_lesson(&text, &shipped::glossary()).unwrap_err();
    assert_eq!(faults[0].expected, "at most 1048576");
}
