//! Letters of a link: runs of letters, names.

// Writing to a string cannot fail.
use std::fmt::Write as _;

/// A text with every run of a letter as a number and the letter: `2f6sf`.
pub fn runs(letters: impl Iterator<Item = char>) -> String {
    let mut text = String::new();
    let mut run: Option<(char, usize)> = None;
    let mut end = |run: Option<(char, usize)>| {
        if let Some((letter, count)) = run {
            if count > 1 {
                text += &count.to_string();
            }
            text.push(letter);
        }
    };
    for letter in letters {
        run = match run {
            Some((last, count)) if last == letter => Some((last, count + 1)),
            _ => {
                end(run);
                Some((letter, 1))
            }
        };
    }
    end(run);
    text
}

/// The letters of runs, at most so many; `None` where they are none or more.
pub fn letters(runs: &str, most: usize) -> Option<Vec<char>> {
    let mut letters = Vec::new();
    let mut count: Option<usize> = None;
    for letter in runs.chars() {
        if let Some(digit) = letter.to_digit(10) {
            let tens = count.unwrap_or(0).checked_mul(10)?;
            count = Some(tens.checked_add(digit as usize)?);
            continue;
        }
        let count = count.take().unwrap_or(1);
        if count > most.checked_sub(letters.len())? {
            return None;
        }
        letters.extend(std::iter::repeat_n(letter, count));
    }
    count.is_none().then_some(letters)
}

/// A name in letters that a link leaves as they are.
pub fn escape(name: &str) -> String {
    let mut text = String::new();
    for byte in name.bytes() {
        if byte.is_ascii_alphanumeric() || byte == b'-' {
            text.push(char::from(byte));
        } else {
            let _ = write!(text, "%{byte:02X}");
        }
    }
    text
}

/// The name that was escaped; `None` where it was not.
pub fn unescape(text: &str) -> Option<String> {
    let mut parts = text.split('%');
    let mut bytes = parts.next()?.as_bytes().to_vec();
    for part in parts {
        bytes.push(u8::from_str_radix(part.get(..2)?, 16).ok()?);
        bytes.extend_from_slice(part.get(2..)?.as_bytes());
    }
    String::from_utf8(bytes).ok()
}

/// Numbers joined by points.
pub fn numbers(text: &str) -> Option<Vec<u32>> {
    text.split('.').map(|n| n.parse().ok()).collect()
}
