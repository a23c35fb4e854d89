//! The sentences of a language other than English, and which language is spoken.

use std::cell::Cell;
use std::collections::BTreeMap;

use super::po::{self, Message, NoCatalogue};

/// Which form of a text a number takes, as the index of its `msgstr`: the rule of the
/// language, from the browser's `Intl.PluralRules` or wherever a front has it from.
pub type PluralRule = Box<dyn Fn(u64) -> usize>;

/// The sentences of a language: what stands in its PO file.
///
/// ```
/// use giveway_model::tr;
/// use giveway_model::words::{Catalogue, speak};
///
/// let text = "msgid \"Undo\"\nmsgstr \"Rückgängig\"\n";
/// let german = Catalogue::read(text, Box::new(|n| usize::from(n != 1)))?;
/// speak(Some(german.kept()));
/// assert_eq!(tr!("Undo"), "Rückgängig");
/// assert_eq!(tr!("Redo"), "Redo", "what is missing is said in English");
/// speak(None);
/// assert_eq!(tr!("Undo"), "Undo");
/// # Ok::<(), giveway_model::words::NoCatalogue>(())
/// ```
pub struct Catalogue {
    /// The forms of each text; most have one.
    forms: BTreeMap<String, Vec<String>>,
    rule: PluralRule,
}

impl Catalogue {
    /// Reads a PO file; messages marked as fuzzy, or without a translation, are left
    /// out.
    ///
    /// # Errors
    ///
    /// [`NoCatalogue`] with the line that is not PO.
    pub fn read(text: &str, rule: PluralRule) -> Result<Self, NoCatalogue> {
        let messages = po::read(text)?;
        let known = messages.into_iter().filter(Message::is_translated);
        let forms = known
            .map(|message| (message.key(), message.forms))
            .collect();
        Ok(Self { forms, rule })
    }

    /// The catalogue for as long as the program runs: words are `&'static str`. A
    /// program keeps each language once.
    pub fn kept(self) -> &'static Self {
        Box::leak(Box::new(self))
    }

    /// The translation of a text, if the catalogue has it.
    pub(super) fn text(&'static self, key: &str) -> Option<&'static str> {
        self.forms.get(key)?.first().map(String::as_str)
    }

    /// The form of a text for a number.
    pub(super) fn form(&'static self, key: &str, n: u64) -> Option<&'static str> {
        let forms = self.forms.get(key)?;
        let form = forms.get((self.rule)(n)).or(forms.last())?;
        Some(form)
    }
}

thread_local! {
    static SPOKEN: Cell<Option<&'static Catalogue>> = const { Cell::new(None) };
}

/// From now on this thread speaks the language of a catalogue; without one, English.
pub fn speak(catalogue: Option<&'static Catalogue>) {
    SPOKEN.set(catalogue);
}

/// Runs something while this thread speaks English, such as making a text that programs compare.
///
/// ```
/// use giveway_model::tr;
/// use giveway_model::words::{Catalogue, in_english, speak};
/// let text = "msgid \"Undo\"\nmsgstr \"Rückgängig\"\n";
/// speak(Some(Catalogue::read(text, Box::new(|_| 0)).unwrap().kept()));
/// assert_eq!(in_english(|| tr!("Undo")), "Undo");
/// assert_eq!(tr!("Undo"), "Rückgängig");
/// speak(None);
/// ```
pub fn in_english<T>(done: impl FnOnce() -> T) -> T {
    let before = SPOKEN.replace(None);
    let done = done();
    SPOKEN.set(before);
    done
}

/// The language of this thread, if it is not English.
pub(super) fn spoken() -> Option<&'static Catalogue> {
    SPOKEN.get()
}

/// The English text of a key: without its context.
pub(super) fn english(key: &'static str) -> &'static str {
    key.split_once('\u{4}').map_or(key, |(_, text)| text)
}
