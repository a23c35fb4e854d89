//! Undoes what mail programs, chats and trackers do to a link: characters written as
//! `%21` or `&amp;`, line breaks, brackets and stops behind it, parameters of trackers.

// Writing to a string cannot fail.
use std::fmt::Write as _;

use super::LONGEST;
use super::seal::DIGITS;

/// How often a text may have been encoded as a whole.
const LEVELS: usize = 3;
/// The marks that have a meaning in a link and that some programs encode, each with its encoding.
const MARKS: [(char, &str); 5] = [
    ('!', "21"),
    (';', "3B"),
    ('=', "3D"),
    ('&', "26"),
    ('.', "2E"),
];
/// The forms of `&` in an HTML text.
const AMPERSANDS: [&str; 5] = ["&amp;", "&#38;", "&#038;", "&#x26;", "&AMP;"];
/// How a parameter of a tracker begins; `%5F` is `_`, which no link holds.
const TRACKERS: [&str; 12] = [
    "utm%5F", "fbclid", "gclid", "dclid", "gbraid", "wbraid", "msclkid", "mc%5F", "igsh", "twclid",
    "%5Fhs", "si=",
];

/// The texts that a link may have been before it came here, the likeliest first; the first
/// one is the text as it is, without what no link holds.
///
/// ```
/// use giveway_model::format::link::repair::readings;
/// let readings = readings("giveway%3D1%26map%3D3.3f)");
/// assert!(readings.contains(&"giveway=1&map=3.3f".to_owned()));
/// ```
pub fn readings(text: &str) -> Vec<String> {
    let mut found: Vec<String> = Vec::new();
    let mut add = |text: String| {
        if !found.contains(&text) {
            found.push(text);
        }
    };
    let mut level = joined(text, false);
    let mut levels = Vec::new();
    for _ in 0..=LEVELS {
        let plain = ampersands(&level);
        let next = decoded(&plain);
        levels.push(plain);
        if levels.last() == Some(&next) {
            break;
        }
        level = next;
    }
    for text in &levels {
        add(escaped(text));
    }
    for text in &levels {
        let there = present(text);
        // All of the marks first, then some of them.
        let mut set = there;
        while set != 0 {
            add(escaped(&marks(text, set)));
            set = (set - 1) & there;
        }
    }
    add(escaped(&ampersands(&joined(text, true))));
    add(escaped(&printable(text)));
    let shorter: Vec<String> = found.iter().map(|text| trimmed(text).to_owned()).collect();
    for text in shorter {
        if !found.contains(&text) {
            found.push(text);
        }
    }
    found
}

/// Whether a text may be a link of the page, or the beginning of one, in whatever form.
///
/// ```
/// use giveway_model::format::link::repair::seems_link;
/// assert!(seems_link("giveway%3D1%26map%3D3.3f") && seems_link("giv"));
/// assert!(!seems_link("top") && !seems_link(""));
/// ```
pub fn seems_link(whole: &str) -> bool {
    const NAME: &str = "giveway";
    let text = whole;
    let end = text.char_indices().nth(60).map_or(text.len(), |(at, _)| at);
    let text = readings(text.get(..end).unwrap_or(text));
    let is_named = text.iter().any(|text| {
        let text = text.to_ascii_lowercase();
        let is_begun = !text.is_empty() && NAME.starts_with(&*text);
        is_begun
            || text
                .trim_start_matches(['/', '!', '?', '#'])
                .starts_with(NAME)
    });
    is_named || lacks_beginning(whole)
}

/// Whether a text is a link of the page without its beginning, `giveway=1`, in whatever form:
/// it has the check of a link, or the part that names the robots.
///
/// ```
/// use giveway_model::format::link::repair::lacks_beginning;
/// assert!(lacks_beginning("check=35.035698fb&map=1.f&rules=0.0&costs=012&agents="));
/// assert!(lacks_beginning("2s5f%26rules%3D0.0%26costs%3D012%26agents%3DA.0.0"));
/// assert!(!lacks_beginning("giveway=1&map=1.f&rules=0.0&costs=012&agents="));
/// assert!(!lacks_beginning("check=yes") && !lacks_beginning("agents"));
/// ```
pub fn lacks_beginning(text: &str) -> bool {
    if text.len() > LONGEST {
        return false;
    }
    let mut level = joined(text, true);
    for _ in 0..=LEVELS {
        level = ampersands(&level);
        if level.to_ascii_lowercase().contains("giveway=") {
            return false;
        }
        if level.contains("&agents=") || has_check(&level) {
            return true;
        }
        level = decoded(&level);
    }
    false
}

/// Whether a text has the check of a link: `check=231.9ae0daaf`.
fn has_check(text: &str) -> bool {
    let is_check = |rest: &str| {
        let sum = rest.trim_start_matches(|letter: char| letter.is_ascii_digit());
        let sum = sum.strip_prefix('.').filter(|_| sum.len() < rest.len());
        let is_sum = |sum: &str| sum.bytes().all(|byte| byte.is_ascii_hexdigit());
        sum.and_then(|sum| sum.get(..DIGITS)).is_some_and(is_sum)
    };
    text.split("check=").skip(1).any(is_check)
}

/// Lines as one text: breaks with the blanks and quotation marks around them go, and so do
/// all blanks where `all` is set; blanks inside a line are those of a name.
fn joined(text: &str, all: bool) -> String {
    let mut joined = String::new();
    for line in text.trim().lines() {
        let line = line.trim();
        joined += line.trim_start_matches(['>', ' ']);
    }
    if all {
        let blanks = joined.replace("%20", " ").replace("%0A", " ");
        return blanks.replace("%0D", " ").split_whitespace().collect();
    }
    for line_break in ["%0D%0A", "%0D", "%0A", "%0d%0a", "%0d", "%0a"] {
        joined = joined.replace(line_break, "");
    }
    joined
}

fn ampersands(text: &str) -> String {
    let mut text = text.to_owned();
    // A program that encodes twice writes `&amp;amp;`.
    while AMPERSANDS.iter().any(|one| text.contains(one)) {
        for one in AMPERSANDS {
            text = text.replace(one, "&");
        }
    }
    text
}

/// A text with all its `%XX` decoded; those that are none stay.
pub(super) fn decoded(text: &str) -> String {
    let mut bytes = Vec::new();
    let mut rest = text;
    while let Some((before, after)) = rest.split_once('%') {
        bytes.extend_from_slice(before.as_bytes());
        let code = after.get(..2).filter(|code| !code.starts_with('+'));
        if let Some(byte) = code.and_then(|code| u8::from_str_radix(code, 16).ok()) {
            bytes.push(byte);
            rest = after.get(2..).unwrap_or_default();
        } else {
            bytes.push(b'%');
            rest = after;
        }
    }
    bytes.extend_from_slice(rest.as_bytes());
    String::from_utf8(bytes).unwrap_or_else(|_| text.to_owned())
}

/// The bits of the marks that stand encoded in a text.
fn present(text: &str) -> usize {
    let codes = MARKS.iter().enumerate();
    let is_there = |code: &str| {
        let mut all = text.split('%').skip(1);
        all.any(|rest| {
            rest.get(..2)
                .is_some_and(|two| two.eq_ignore_ascii_case(code))
        })
    };
    codes
        .filter(|(_, (_, code))| is_there(code))
        .map(|(bit, _)| 1 << bit)
        .sum()
}

/// A text in which some of the marks are decoded: those whose bits are in `set`.
fn marks(text: &str, set: usize) -> String {
    let mut text = text.to_owned();
    for (bit, (mark, code)) in MARKS.iter().enumerate() {
        if set & (1 << bit) != 0 {
            let mark = mark.to_string();
            text = text.replace(&format!("%{code}"), &mark);
            text = text.replace(&format!("%{}", code.to_ascii_lowercase()), &mark);
        }
    }
    text
}

/// The text without the encoding of quoted-printable mails: `=3D`, and `=` at the end of a line.
fn printable(text: &str) -> String {
    let lines = text.trim().lines().map(|line| {
        let line = line.trim_end();
        line.strip_suffix('=').unwrap_or(line)
    });
    let text: String = lines.collect();
    text.replace("=3D", "=")
        .replace("=26", "&")
        .replace("=21", "!")
}

/// A text in which everything that no link holds is encoded, as links are written.
fn escaped(text: &str) -> String {
    let mut escaped = String::new();
    let mut rest = text.chars();
    while let Some(letter) = rest.next() {
        let mut bytes = [0; 4];
        match letter {
            '%' => {
                escaped.push('%');
                let code = rest.as_str().get(..2).unwrap_or_default();
                if code.bytes().all(|byte| byte.is_ascii_hexdigit()) {
                    escaped += &code.to_ascii_uppercase();
                    rest = rest.as_str().get(code.len()..).unwrap_or_default().chars();
                }
            }
            _ if letter.is_ascii_alphanumeric() || "-=&.;!".contains(letter) => {
                escaped.push(letter);
            }
            _ => {
                for byte in letter.encode_utf8(&mut bytes).bytes() {
                    let _ = write!(escaped, "%{byte:02X}");
                }
            }
        }
    }
    escaped
}

/// A text without the parameters of trackers, and without what a sentence puts behind a
/// link: none of the page's links ends with a mark or an escaped bracket.
fn trimmed(text: &str) -> &str {
    const BEHIND: [&str; 19] = [
        "%29",
        "%5D",
        "%7D",
        "%3E",
        "%22",
        "%27",
        "%2C",
        "%3A",
        "%3F",
        "%2A",
        "%5F",
        "%60",
        "%20",
        "%E2%80%9D",
        "%E2%80%99",
        "%E2%80%9C",
        "%C2%BB",
        "%E2%80%A6",
        ".",
    ];
    let mut text = text;
    loop {
        let before = text;
        if let Some((start, parameter)) = text.rsplit_once(['&', '?'])
            && TRACKERS.iter().any(|name| parameter.starts_with(name))
        {
            text = start;
        }
        for mark in BEHIND {
            text = text.strip_suffix(mark).unwrap_or(text);
        }
        if text == before {
            return text;
        }
    }
}
