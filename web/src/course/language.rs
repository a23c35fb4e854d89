//! The language of the course: that of the page. Its catalogue is the page's, with one of
//! the course's own beside it, which is fetched here; until that is there, and where it
//! does not arrive, the course speaks English.

use std::cell::Cell;
use std::cmp::Ordering;

use giveway_course::lesson::{Worded, translated};
use giveway_model::words::{Catalogue, found, speak};
use giveway_wasm::language::catalogue;
use js_sys::{Array, JsString, Object};

use crate::held::Held;
use crate::{files, language};

thread_local! {
    /// The languages that were fetched, by their tags.
    static FETCHED: Held<Vec<(String, &'static Catalogue)>> = Held::default();
    /// How often a language was told.
    static TOLD: Cell<u32> = const { Cell::new(0) };
    /// Which of these is spoken.
    static SPOKEN: Cell<u32> = const { Cell::new(0) };
}

/// Speaks what the page told, and tells the workers; whether nothing else was told
/// meanwhile.
pub(super) async fn hear(told: String) -> bool {
    let number = TOLD.get() + 1;
    TOLD.set(number);
    let catalogue = of(&told).await;
    if TOLD.get() != number {
        return false;
    }
    speak(catalogue);
    SPOKEN.set(number);
    language::tell(catalogue.map_or("", |_| &told));
    true
}

/// Whether a language is on its way.
pub(super) fn is_coming() -> bool {
    TOLD.get() != SPOKEN.get()
}

/// The catalogue of a language as the page tells it; none where that is English.
async fn of(told: &str) -> Option<&'static Catalogue> {
    let (tag, page) = told.split_once('\n')?;
    let mut all = FETCHED.with(Held::get);
    if let Some((_, known)) = all.iter().find(|(known, _)| known == tag) {
        return Some(known);
    }
    let course = files::fetch_language(&format!("course/{tag}")).await.ok()?;
    let catalogue = catalogue(tag, &format!("{page}\n{course}")).ok()?;
    all.push((tag.to_owned(), catalogue));
    FETCHED.with(|fetched| fetched.set(all));
    Some(catalogue)
}

/// The tag of the language that is spoken; empty for English.
pub(super) fn tag() -> String {
    let told = language::told();
    let tag = told.split_once('\n').map(|(tag, _)| tag);
    tag.unwrap_or_default().to_owned()
}

/// A lesson, an index or a glossary in the language that is spoken.
pub(super) fn said<W: Worded + Clone>(english: &W) -> W {
    translated(english, found)
}

/// The order of two words in a list of the language that is spoken.
pub(super) fn order(one: &str, two: &str) -> Ordering {
    let locales = Array::of1(&tag().into());
    let order = JsString::from(one).locale_compare(two, &locales, &Object::new());
    order.cmp(&0)
}

/// A text in small letters, of any alphabet: the browser has the table.
pub(super) fn small(text: &str) -> String {
    JsString::from(text).to_lower_case().into()
}
