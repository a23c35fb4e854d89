//! The check of a link: the length of its text and a check sum, behind the version.
//!
//! It stands at the beginning, so that a link that was cut anywhere behind it says how much
//! of it is missing: `giveway=1&check=231.9ae0daaf&map=...`.

/// The name of the part that holds the check.
const CHECK: &str = "check=";
/// Characters of the check sum, in hexadecimal.
pub(super) const DIGITS: usize = 8;

/// A text of the page's links with its check.
///
/// ```
/// use giveway_model::format::link::seal;
/// let sealed = seal::write("giveway=1&map=1.f");
/// assert_eq!(sealed, "giveway=1&check=7.c549acf1&map=1.f");
/// assert_eq!(seal::write(&sealed), sealed, "one check is enough");
/// ```
pub fn write(text: &str) -> String {
    let (version, rest) = text.split_once('&').unwrap_or((text, ""));
    let rest = match rest.strip_prefix(CHECK) {
        Some(checked) => checked.split_once('&').map_or("", |(_, rest)| rest),
        None => rest,
    };
    let (length, sum) = (rest.len(), sum(rest));
    format!("{version}&{CHECK}{length}.{sum:08x}&{rest}")
}

/// The result of the check of a text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Sealed {
    /// The text has no check.
    Without,
    /// The text without its check and without what was appended to it: all of it is there.
    Whole(String),
    /// The text ends too early: so many characters of how many there were. The second is
    /// unknown where the check itself is cut.
    Cut(usize, Option<usize>),
    /// The text is long enough, but not the one that was sent.
    Changed,
}

/// Compares a text with its check.
pub fn read(text: &str) -> Sealed {
    let Some((version, rest)) = text.split_once('&') else {
        return Sealed::Without;
    };
    let (check, rest) = match rest.split_once('&') {
        Some((check, rest)) => (check, Some(rest)),
        None => (rest, None),
    };
    let Some(check) = check.strip_prefix(CHECK) else {
        let is_begun = rest.is_none() && CHECK.starts_with(check);
        return if is_begun {
            Sealed::Cut(text.len(), None)
        } else {
            Sealed::Without
        };
    };
    let Some(rest) = rest else {
        return Sealed::Cut(text.len(), None);
    };
    let told = check.split_once('.').and_then(|(length, sum)| {
        let sum = (sum.len() == DIGITS).then(|| u32::from_str_radix(sum, 16).ok())?;
        Some((length.parse::<usize>().ok()?, sum?))
    });
    let Some((length, expected)) = told else {
        return Sealed::Changed;
    };
    match rest.get(..length) {
        Some(rest) if sum(rest) == expected => Sealed::Whole(format!("{version}&{rest}")),
        None if rest.len() < length => Sealed::Cut(rest.len(), Some(length)),
        Some(_) | None => Sealed::Changed,
    }
}

/// CRC-32 of the bytes, as in zip files and PNG (ISO 3309).
fn sum(text: &str) -> u32 {
    let mut sum = u32::MAX;
    for byte in text.bytes() {
        sum ^= u32::from(byte);
        for _ in 0..8 {
            let is_odd = sum & 1;
            sum = (sum >> 1) ^ (0xEDB8_8320 * is_odd);
        }
    }
    !sum
}
