//! Phrases in a row.

/// `a`, `a and b`, `a, b and c`.
pub(crate) fn and<S: AsRef<str>>(phrases: &[S]) -> String {
    match phrases {
        [] => String::new(),
        [one] => one.as_ref().to_owned(),
        [init @ .., last] => {
            let init: Vec<&str> = init.iter().map(AsRef::as_ref).collect();
            format!("{} and {}", init.join(", "), last.as_ref())
        }
    }
}

/// A phrase as the beginning of a sentence. A name that begins with a letter of
/// another alphabet stands as it is: a table of all letters would weigh more in a
/// page than all of its words.
pub(crate) fn capital(phrase: &str) -> String {
    let mut chars = phrase.chars();
    chars.next().map_or_else(String::new, |first| {
        [first.to_ascii_uppercase()]
            .into_iter()
            .chain(chars)
            .collect()
    })
}

/// `1 step`, `2 steps`.
pub(crate) fn count(n: u32, one: &str, many: &str) -> String {
    format!("{n} {}", if n == 1 { one } else { many })
}
