//! Capital letters made small, of the alphabets that have them in regular order.
//!
//! The standard library knows those of all scripts, by a table of 12 kB that a page on a
//! slow network would wait for. Here are Latin, Greek, Cyrillic and Armenian; other
//! letters are found as they are written.

/// A text with its letters small.
pub(super) fn letters(text: &str) -> String {
    text.chars().map(letter).collect()
}

fn letter(letter: char) -> char {
    let code = u32::from(letter);
    let small = match code {
        0x41..=0x5A | 0xC0..=0xD6 | 0xD8..=0xDE | 0x391..=0x3A1 | 0x3A3..=0x3AB | 0x410..=0x42F => {
            code + 32
        }
        0x400..=0x40F => code + 80,
        0x531..=0x556 => code + 48,
        // Pairs that begin with an even number, and with an odd one.
        0x100..=0x12F
        | 0x132..=0x137
        | 0x14A..=0x177
        | 0x460..=0x481
        | 0x48A..=0x4BF
        | 0x4D0..=0x52F
        | 0x1E00..=0x1E95
        | 0x1EA0..=0x1EFF => code | 1,
        0x139..=0x148 | 0x179..=0x17E | 0x4C1..=0x4CE => code + (code & 1),
        // Greek with accents, and the sigma at the end of a word.
        0x386 => 0x3AC,
        0x388..=0x38A => code + 37,
        0x38C => 0x3CC,
        0x38E | 0x38F => code + 63,
        0x3C2 => 0x3C3,
        0x178 => 0xFF,
        _ => code,
    };
    char::from_u32(small).unwrap_or(letter)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn they_are_those_of_the_standard_library() {
        let mut capitals = 0;
        for capital in '\0'..=char::MAX {
            let small = letter(capital);
            if small != capital && capital != 'ς' {
                assert!(capital.to_lowercase().eq([small]), "{capital}");
                capitals += 1;
            }
        }
        assert!(capitals > 400, "{capitals}");
    }

    #[test]
    fn no_letter_of_the_alphabets_is_left_out() {
        // But the dotted I, which becomes two characters.
        let alphabets = [
            (0x0, 0x17F),
            (0x386, 0x3CE),
            (0x400, 0x4BF),
            (0x4C1, 0x556),
            (0x1E00, 0x1E95),
            (0x1EA0, 0x1EFF),
        ];
        for (first, last) in alphabets {
            for capital in (first..=last)
                .filter_map(char::from_u32)
                .filter(|&c| c != 'İ')
            {
                let expected: String = capital
                    .to_lowercase()
                    .map(|c| if c == 'ς' { 'σ' } else { c })
                    .collect();
                assert_eq!(letters(&capital.to_string()), expected);
            }
        }
    }
}
