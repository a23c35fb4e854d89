//! A sentence as data: a text of the catalogue with its values. It is kept, compared and
//! moved around before anybody knows the language, and said when it is shown.

use std::fmt;

use super::tr::{Later, fill, fill_counted, text};
use crate::Cell;

/// A sentence as data; its [`Display`](fmt::Display) says it in the language that is spoken then.
///
/// ```
/// use giveway_model::{tr_data, words::{Catalogue, speak}};
/// let told = tr_data!("{name} stays: {why}.", name = "A1", why = tr_data!("the map ends there"));
/// assert_eq!(told.to_string(), "A1 stays: the map ends there.");
/// let german = "msgid \"the map ends there\"\nmsgstr \"dort endet die Karte\"\n";
/// speak(Some(Catalogue::read(german, Box::new(|_| 0)).unwrap().kept()));
/// assert_eq!(told.to_string(), "A1 stays: dort endet die Karte.");
/// speak(None);
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Sentence(Form);

#[derive(Clone, Debug, PartialEq, Eq)]
enum Form {
    /// The same in every language: a name, a number, or words of another program.
    Words(String),
    /// A text with its values, in the order of the text's places.
    Text(&'static str, Vec<Sentence>),
    /// A text in its forms for one and for more, with the number, and the other values.
    Counted((&'static str, &'static str), u64, Vec<Sentence>),
}

impl Sentence {
    /// A text with its values: made by [`tr_data!`](crate::tr_data) only.
    #[doc(hidden)]
    pub const fn of_text(key: &'static str, values: Vec<Self>) -> Self {
        Self(Form::Text(key, values))
    }

    /// A text for a number, with its other values: made by [`tr_data!`](crate::tr_data) only.
    #[doc(hidden)]
    pub const fn counted(key: (&'static str, &'static str), n: u64, values: Vec<Self>) -> Self {
        Self(Form::Counted(key, n, values))
    }
}

impl Default for Sentence {
    /// Nothing to say.
    fn default() -> Self {
        Self(Form::Words(String::new()))
    }
}

impl Sentence {
    /// Whether there is nothing to say.
    pub const fn is_empty(&self) -> bool {
        match &self.0 {
            Form::Words(words) => words.is_empty(),
            Form::Text(..) | Form::Counted(..) => false,
        }
    }
}

impl fmt::Display for Sentence {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.0 {
            Form::Words(words) => f.write_str(words),
            Form::Text(key, values) if values.is_empty() => f.write_str(text(key)),
            Form::Text(key, values) => {
                let values: Vec<&dyn fmt::Display> = values.iter().map(|it| it as _).collect();
                f.write_str(&fill(key, &values))
            }
            Form::Counted(key, n, values) => {
                let values = values.iter().map(|it| it as &dyn fmt::Display);
                let values: Vec<_> = std::iter::once(n as _).chain(values).collect();
                f.write_str(&fill_counted(*key, *n, &values))
            }
        }
    }
}

impl From<String> for Sentence {
    fn from(words: String) -> Self {
        Self(Form::Words(words))
    }
}

impl From<&str> for Sentence {
    fn from(words: &str) -> Self {
        Self(Form::Words(words.to_owned()))
    }
}

impl From<&String> for Sentence {
    fn from(words: &String) -> Self {
        words.as_str().into()
    }
}

impl From<Later> for Sentence {
    fn from(later: Later) -> Self {
        Self::of_text(later.key(), Vec::new())
    }
}

impl From<&Self> for Sentence {
    fn from(sentence: &Self) -> Self {
        sentence.clone()
    }
}

impl From<Cell> for Sentence {
    fn from(cell: Cell) -> Self {
        cell.to_string().into()
    }
}

impl From<u64> for Sentence {
    fn from(n: u64) -> Self {
        n.to_string().into()
    }
}

impl From<u32> for Sentence {
    fn from(n: u32) -> Self {
        n.to_string().into()
    }
}

impl From<usize> for Sentence {
    fn from(n: usize) -> Self {
        n.to_string().into()
    }
}

/// A sentence as data, a [`Sentence`]: with the syntax of
/// [`tr!`](crate::tr), whose values may be such sentences themselves.
#[macro_export]
macro_rules! tr_data {
    ($text:literal) => {
        $crate::words::Sentence::of_text($text, ::std::vec::Vec::new())
    };
    ($context:literal => $text:literal) => {
        $crate::words::Sentence::of_text(concat!($context, "\u{4}", $text), ::std::vec::Vec::new())
    };
    ($text:literal | $plural:literal % $n:expr $(, $name:ident $(= $value:expr)?)* $(,)?) => {
        $crate::words::Sentence::counted(
            const { $crate::words::checked_forms($text, $plural, &["n", $(stringify!($name)),*]) },
            $crate::words::number($n),
            ::std::vec![$($crate::tr_data!(@value $name $(= $value)?)),*],
        )
    };
    ($context:literal => $text:literal, $($name:ident $(= $value:expr)?),+ $(,)?) => {
        $crate::tr_data!(@fill concat!($context, "\u{4}", $text), [$($name $(= $value)?),+])
    };
    ($text:literal, $($name:ident $(= $value:expr)?),+ $(,)?) => {
        $crate::tr_data!(@fill $text, [$($name $(= $value)?),+])
    };
    (@fill $text:expr, [$($name:ident $(= $value:expr)?),+]) => {
        $crate::words::Sentence::of_text(
            const { $crate::words::checked($text, &[$(stringify!($name)),+]) },
            ::std::vec![$($crate::tr_data!(@value $name $(= $value)?)),+],
        )
    };
    (@value $name:ident) => { $crate::words::Sentence::from($name) };
    (@value $name:ident = $value:expr) => { $crate::words::Sentence::from($value) };
}

#[cfg(test)]
mod tests {
    use super::super::{Catalogue, speak};
    use super::Sentence;

    #[test]
    fn a_sentence_is_said_in_the_language_of_the_moment() {
        let what = tr_data!("the cell of its" => "goal");
        let told = [
            tr_data!("Press the {what}.", what),
            tr_data!(
                "{n} robot of {name}" | "{n} robots of {name}" % 2_u32,
                name = "A"
            ),
            Sentence::from("A1"),
        ];
        let say = || told.clone().map(|it| it.to_string());
        assert_eq!(say(), ["Press the goal.", "2 robots of A", "A1"]);
        let catalogue = r#"
            msgid "Press the {what}."
            msgstr "{what} anklicken."
            msgctxt "the cell of its"
            msgid "goal"
            msgstr "Ziel"
            msgid "{n} robot of {name}"
            msgid_plural "{n} robots of {name}"
            msgstr[0] "von {name} {n} Roboter"
            msgstr[1] "von {name} {n} Roboter (mehr)"
        "#;
        let catalogue = Catalogue::read(catalogue, Box::new(|n| usize::from(n != 1)));
        speak(Some(catalogue.unwrap().kept()));
        assert_eq!(say(), ["Ziel anklicken.", "von A 2 Roboter (mehr)", "A1"]);
        speak(None);
        assert_eq!(say(), ["Press the goal.", "2 robots of A", "A1"]);
    }

    #[test]
    fn only_no_words_are_empty() {
        assert!(Sentence::default().is_empty());
        assert!(!tr_data!("Undo").is_empty());
    }
}
