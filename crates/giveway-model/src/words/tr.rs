//! A sentence for a person, in the language that is spoken: the macro `tr!`.
//!
//! The English sentence stands in the source and is the key of the catalogue
//! (`catalogue.rs`), as GNU gettext has it; so English needs no catalogue and costs
//! nothing. The macro has the syntax of the crate `tr`, whose tool `xtr` can read these
//! sources. That crate itself makes a `String` of each word and a closure of each call,
//! which together weigh more than the sentences.

use std::fmt::Display;

use super::catalogue::{english, spoken};
use super::places::{filled, places};

/// A sentence or a word for a person, in the language that is spoken.
///
/// - `tr!("Undo")` is a `&'static str`.
/// - `tr!("{agent} waits at {cell}", agent, cell = at(cell))` is a `String`. The
///   values stand in the order of their places in the text, which is checked when it
///   is compiled. A translation may have them in any order, and more than once.
/// - `tr!("{n} robot" | "{n} robots" % count)` chooses the form for a number; `{n}`
///   is the number. More values follow behind it.
/// - `tr!("a button" => "Open")` gives a context, where one English word has two
///   meanings. It is also how a translator is told what a short text is for.
///
/// ```
/// use giveway_model::tr;
/// let name = "A1";
/// assert_eq!(tr!("{name} waits.", name), "A1 waits.");
/// assert_eq!(tr!("{name} has {n} task" | "{name} has {n} tasks" % 2, name), "A1 has 2 tasks");
/// assert_eq!(tr!("a button" => "Open"), "Open");
/// ```
///
/// A place without a value does not compile:
///
/// ```compile_fail
/// let name = "A1";
/// giveway_model::tr!("{name} waits for {other}.", name);
/// ```
#[macro_export]
macro_rules! tr {
    ($text:literal) => {
        $crate::words::text($text)
    };
    ($context:literal => $text:literal) => {
        $crate::words::text(concat!($context, "\u{4}", $text))
    };
    ($text:literal | $plural:literal % $n:expr $(, $name:ident $(= $value:expr)?)* $(,)?) => {
        $crate::tr!(@count $text, $plural, $n, [$($name $(= $value)?),*])
    };
    ($context:literal => $text:literal | $plural:literal % $n:expr $(, $name:ident $(= $value:expr)?)* $(,)?) => {
        $crate::tr!(@count concat!($context, "\u{4}", $text), $plural, $n, [$($name $(= $value)?),*])
    };
    ($context:literal => $text:literal, $($name:ident $(= $value:expr)?),+ $(,)?) => {
        $crate::tr!(@fill concat!($context, "\u{4}", $text), [$($name $(= $value)?),+])
    };
    ($text:literal, $($name:ident $(= $value:expr)?),+ $(,)?) => {
        $crate::tr!(@fill $text, [$($name $(= $value)?),+])
    };
    (@fill $text:expr, [$($name:ident $(= $value:expr)?),+]) => {
        $crate::words::fill(
            const { $crate::words::checked($text, &[$(stringify!($name)),+]) },
            &[$($crate::tr!(@value $name $(= $value)?)),+],
        )
    };
    (@count $text:expr, $plural:literal, $n:expr, [$($name:ident $(= $value:expr)?),*]) => {
        match $n {
            n => $crate::words::fill_counted(
                const { $crate::words::checked_forms($text, $plural, &["n", $(stringify!($name)),*]) },
                $crate::words::number(n),
                &[&n, $($crate::tr!(@value $name $(= $value)?)),*],
            ),
        }
    };
    (@value $name:ident) => { &$name };
    (@value $name:ident = $value:expr) => { &$value };
}

/// A text of a table that is written before anybody knows the language: a
/// [`Later`].
///
/// ```
/// use giveway_model::tr_later;
/// use giveway_model::words::Later;
/// const TABS: [Later; 2] = [tr_later!("Timeline"), tr_later!("a page" => "Plan")];
/// assert_eq!(TABS.map(Later::text), ["Timeline", "Plan"]);
/// ```
#[macro_export]
macro_rules! tr_later {
    ($text:literal) => {
        $crate::words::Later::new($text)
    };
    ($context:literal => $text:literal) => {
        $crate::words::Later::new(concat!($context, "\u{4}", $text))
    };
}

/// A text for a person, still to be said in a language.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Later(&'static str);

impl Later {
    /// The text of a key: made by [`tr_later!`](crate::tr_later) only.
    #[doc(hidden)]
    pub const fn new(key: &'static str) -> Self {
        Self(key)
    }

    pub(super) const fn key(self) -> &'static str {
        self.0
    }

    /// The text in the language that is spoken.
    pub fn text(self) -> &'static str {
        text(self.0)
    }

    /// The text in English, which stays the same in every language.
    pub fn english(self) -> &'static str {
        english(self.0)
    }
}

impl From<Later> for String {
    fn from(later: Later) -> Self {
        later.text().to_owned()
    }
}

/// A text without places in the language that is spoken.
pub fn text(key: &'static str) -> &'static str {
    match spoken().and_then(|catalogue| catalogue.text(key)) {
        Some(text) => text,
        None => english(key),
    }
}

/// A text that data brings, such as the list of examples, which is written in English:
/// in the language that is spoken, where its catalogue has it.
pub fn translated(text: &str) -> &str {
    found(text).unwrap_or(text)
}

/// The translation of a key that data brings, in the language that is spoken; a context stands before it,
/// with U+0004 between the two.
pub fn found(key: &str) -> Option<&'static str> {
    spoken()?.text(key)
}

/// A sentence that was said in English, elsewhere or before, in the language that is
/// spoken: it is looked for among some texts, its values too. What is none of them stays
/// as it is.
///
/// ```
/// use giveway_model::tr_later;
/// use giveway_model::words::{Catalogue, retold, speak};
/// let text = "msgid \"{a} waits for {b}.\"\nmsgstr \"Auf {b} wartet {a}.\"\n";
/// speak(Some(Catalogue::read(text, Box::new(|_| 0)).unwrap().kept()));
/// let known = [tr_later!("{a} waits for {b}.")];
/// assert_eq!(retold("A1 waits for A2.", &known), "Auf A2 wartet A1.");
/// assert_eq!(retold("A1 sings.", &known), "A1 sings.");
/// speak(None);
/// assert_eq!(retold("A1 waits for A2.", &known), "A1 waits for A2.");
/// ```
pub fn retold(said: &str, among: &[Later]) -> String {
    if spoken().is_none() {
        return said.to_owned();
    }
    let mut found = among
        .iter()
        .map(|known| (known, values_in(said, known.english())));
    let Some((known, values)) = found.find_map(|(known, values)| Some((known, values?))) else {
        return said.to_owned();
    };
    let values: Vec<String> = values.iter().map(|value| retold(value, among)).collect();
    let values: Vec<&dyn Display> = values.iter().map(|value| value as &dyn Display).collect();
    fill(known.0, &values)
}

/// The values that a sentence has in the places of a text, if it is that text.
fn values_in<'a>(said: &'a str, text: &str) -> Option<Vec<&'a str>> {
    let Some((_, end)) = text.rsplit_once('}') else {
        return (said == text).then(Vec::new);
    };
    let mut between = places(text).map(|(before, _)| before);
    let mut rest = said.strip_prefix(between.next()?)?;
    let mut values = Vec::new();
    for before in between {
        let (value, behind) = rest.split_once(before)?;
        values.push(value);
        rest = behind;
    }
    values.push(rest.strip_suffix(end)?);
    values
        .iter()
        .all(|value| !value.is_empty())
        .then_some(values)
}

/// A text with its values, in the order of the key's places.
pub fn fill(key: &'static str, values: &[&dyn Display]) -> String {
    filled(text(key), english(key), values, false)
}

/// The form of a text for a number, with its values: the number, then the others in
/// the order of the plural's places.
pub fn fill_counted(key: (&'static str, &'static str), n: u64, values: &[&dyn Display]) -> String {
    let (one, many) = key;
    let form = match spoken().and_then(|catalogue| catalogue.form(one, n)) {
        Some(text) => text,
        None if n == 1 => english(one),
        None => many,
    };
    filled(form, many, values, true)
}

/// A number of things, of any type of numbers.
pub fn number<N: TryInto<u64>>(n: N) -> u64 {
    n.try_into().unwrap_or(u64::MAX)
}

#[cfg(test)]
mod tests {
    use super::super::{Catalogue, speak};

    #[test]
    fn english_is_what_the_source_says() {
        let (name, other) = ("A1", "A2");
        assert_eq!(tr!("context" => "Open"), "Open");
        assert_eq!(
            tr!("{name} before {other}, {name}!", name, other),
            "A1 before A2, A1!"
        );
        assert_eq!(tr!("context" => "to {name}", name), "to A1");
        assert_eq!(tr!("one" | "{n} of {name}" % 1, name), "one");
        assert_eq!(tr!("one" | "{n} of {name}" % 0_u64, name), "0 of A1");
        assert_eq!(tr!("context" => "one" | "{n}" % 1_usize), "one");
    }

    #[test]
    fn a_catalogue_turns_the_words_around() {
        let catalogue = r#"
            msgid "{a} waits for {b}"
            msgstr "auf {b} wartet {a}, auf {b}"
            msgctxt "button"
            msgid "Open"
            msgstr "Öffnen"
            msgid "{n} cell of {a}"
            msgid_plural "{n} cells of {a}"
            msgstr[0] "von {a} {n} Zelle"
            msgstr[1] "von {a} {n} Zellen"
        "#;
        let catalogue = Catalogue::read(catalogue, Box::new(|n| usize::from(n != 1)));
        speak(Some(catalogue.unwrap().kept()));
        let (a, b) = ("A1", "A2");
        assert_eq!(tr!("{a} waits for {b}", a, b), "auf A2 wartet A1, auf A2");
        assert_eq!(tr!("button" => "Open"), "Öffnen");
        assert_eq!(tr!("Open"), "Open", "another context");
        assert_eq!(
            tr!("{n} cell of {a}" | "{n} cells of {a}" % 1, a),
            "von A1 1 Zelle"
        );
        assert_eq!(
            tr!("{n} cell of {a}" | "{n} cells of {a}" % 3, a),
            "von A1 3 Zellen"
        );
        speak(None);
        assert_eq!(tr!("button" => "Open"), "Open");
    }
}
