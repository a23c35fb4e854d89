//! The language that is spoken, in a page and in its workers: a catalogue with the
//! browser's own rule for plurals.

use giveway_model::words::{Catalogue, NoCatalogue, speak};
use js_sys::Intl::PluralRules;
use js_sys::{Array, Object};

/// The kinds of numbers that a language may tell apart, in the order in which gettext
/// lists the forms of a text (Unicode CLDR).
const KINDS: [&str; 6] = ["zero", "one", "two", "few", "many", "other"];
/// So far kinds of whole numbers are looked for; later ones begin anew.
const LOOKED_AT: u64 = 200;

/// Reads the catalogue of a language, by its BCP 47 tag.
///
/// # Errors
/// When the text is no PO file.
pub fn catalogue(tag: &str, po: &str) -> Result<&'static Catalogue, NoCatalogue> {
    let rules = PluralRules::new(&Array::of1(&tag.into()), &Object::new());
    let kind = move |n: u64| String::from(rules.select(n as f64));
    let found: Vec<String> = (0..=LOOKED_AT).map(&kind).collect();
    let kinds: Vec<&str> = KINDS
        .into_iter()
        .filter(|kind| found.iter().any(|other| other == kind))
        .collect();
    let last = kinds.len().saturating_sub(1);
    let rule = move |n: u64| {
        let kind = kind(n);
        kinds.iter().position(|own| *own == kind).unwrap_or(last)
    };
    Ok(Catalogue::read(po, Box::new(rule))?.kept())
}

/// What a page posts to a worker, as a text, so that the worker speaks a language from
/// then on.
pub fn told(tag: &str, po: &str) -> String {
    format!("{tag}\n{po}")
}

/// Speaks the language that a page told; English where the text is empty, or no
/// catalogue.
pub fn hear(told: &str) {
    let (tag, po) = told.split_once('\n').unwrap_or_default();
    speak(catalogue(tag, po).ok().filter(|_| !tag.is_empty()));
}
