//! Noise for the readers of a test: bytes, texts, and files with faults.
//!
//! The test has the readers as `read_all`, and valid files as `FILES`.

use giveway_model::{Fault, format::read_text};
use proptest::prelude::*;

use super::{FILES, read_all};

/// A fault is a sentence, however long the input.
pub(super) fn assert_short(fault: &Fault) {
    let text = fault.to_string();
    assert!(text.chars().count() < 400, "{text}");
    assert!(!text.contains(['\n', '\r']), "{text}");
}

fn valid_file() -> impl Strategy<Value = &'static str> {
    prop::sample::select(FILES.to_vec())
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn bytes_are_read_without_a_panic(bytes in prop::collection::vec(any::<u8>(), 0..200)) {
        match read_text(&bytes) {
            Ok(text) => read_all(&text),
            Err(fault) => assert_short(&fault),
        }
    }

    #[test]
    fn text_is_read_without_a_panic(text in "\\PC*|[\\[\\]{}:,\"a-z0-9 \\n]*") {
        read_all(&text);
    }

    #[test]
    fn truncated_files_are_read_without_a_panic(file in valid_file(), at in any::<prop::sample::Index>()) {
        read_all(&file[..at.index(file.len() + 1)]);
    }

    #[test]
    fn mutated_files_are_read_without_a_panic(
        file in valid_file(),
        places in prop::collection::vec((any::<prop::sample::Index>(), any::<char>()), 1..4),
        part in any::<(prop::sample::Index, prop::sample::Index)>(),
    ) {
        let mut letters: Vec<char> = file.chars().collect();
        for (place, letter) in places {
            *place.get_mut(&mut letters) = letter;
        }
        read_all(&letters.iter().collect::<String>());
        // A part of the file, put once more somewhere else.
        let (from, to) = (part.0.index(letters.len()), part.1.index(letters.len()));
        let copy = letters[from.min(to)..from.max(to)].to_vec();
        let again: String = letters[..to].iter().chain(&copy).chain(&letters[to..]).collect();
        read_all(&again);
    }

    #[test]
    fn digits_may_change_without_a_panic(file in valid_file(), number in any::<u64>(), digit in "[0-9]") {
        read_all(&file.replace(&digit, &number.to_string()));
    }
}
