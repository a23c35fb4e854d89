//! Texts of a source that a person reads and that are not said by a catalogue.

use proc_macro2::{Delimiter, TokenStream, TokenTree};

use super::said::unescaped;
use crate::source::{self, File};

/// Names that are the same in every language.
const NAMES: [&str; 1] = ["Giveway"];
/// Macros and functions whose texts no person reads in another language.
const INNER: [&str; 6] = [
    "tr",
    "tr_later",
    "tr_data",
    "expect",
    "panic",
    "unreachable",
];
/// Attributes that a person reads or hears.
const HEARD: [&str; 7] = [
    "title",
    "placeholder",
    "alt",
    "label",
    "valuetext",
    "roledescription",
    "description",
];

/// Texts of a source that a person reads and that are not said by the catalogue, with
/// their lines: text nodes and attributes of a view, and what looks like a sentence.
pub fn unsaid(file: &File) -> Vec<(usize, String)> {
    let mut found = Vec::new();
    collect_unsaid(source::tokens(file), false, &mut found);
    found
}

fn collect_unsaid(tokens: TokenStream, in_view: bool, found: &mut Vec<(usize, String)>) {
    let tokens: Vec<TokenTree> = tokens.into_iter().collect();
    let is = |i: usize, mark: char| matches!(tokens.get(i), Some(TokenTree::Punct(punct)) if punct.as_char() == mark);
    let word = |i: usize| match tokens.get(i) {
        Some(TokenTree::Ident(word)) => word.to_string(),
        _ => String::new(),
    };
    let only = tokens.len() == 1;
    let mut i = 0;
    while i < tokens.len() {
        // Attributes of Rust, and modules of tests.
        if is(i, '#') && matches!(tokens.get(i + 1), Some(TokenTree::Group(_))) {
            let attribute = tokens[i + 1].to_string().replace(' ', "");
            i += if attribute == "[cfg(test)]" && word(i + 2) == "mod" {
                5
            } else {
                2
            };
            continue;
        }
        match &tokens[i] {
            TokenTree::Group(group) => {
                let before = if i > 0 && is(i - 1, '!') {
                    i.wrapping_sub(2)
                } else {
                    i.wrapping_sub(1)
                };
                let name = word(before);
                if !INNER.contains(&name.as_str()) {
                    // A value in braces is no text of the view itself.
                    let is_value = i > 0 && is(i - 1, '=');
                    let is_block = group.delimiter() == Delimiter::Brace;
                    let view = name == "html" || (in_view && !is_value && is_block);
                    collect_unsaid(group.stream(), view, found);
                }
            }
            TokenTree::Literal(literal) => {
                if let Some(text) = unescaped(&literal.to_string()) {
                    let has_letters = without_places(&text).chars().any(char::is_alphabetic);
                    let is_text = in_view && only;
                    let is_heard =
                        in_view && i > 1 && is(i - 1, '=') && HEARD.contains(&word(i - 2).as_str());
                    let counts = has_letters && (is_text || is_heard);
                    if (counts || is_sentence(&text)) && !NAMES.contains(&text.as_str()) {
                        found.push((literal.span().start().line, text));
                    }
                }
            }
            _ => {}
        }
        i += 1;
    }
}

/// A text without its places.
fn without_places(text: &str) -> String {
    let parts = text.split('{').enumerate();
    let rest = parts.map(|(i, part)| match part.split_once('}') {
        Some((_, after)) if i > 0 => after,
        _ => part,
    });
    rest.collect()
}

/// Whether a text begins with a capital letter and has several words.
fn is_sentence(text: &str) -> bool {
    let mut words = text.split(' ');
    let is_word = |word: &str| word.chars().filter(|char| char.is_alphabetic()).count() > 1;
    let begins = |word: &str| {
        let mut chars = word.chars();
        let first = chars.next().is_some_and(char::is_uppercase);
        first && chars.next().is_none_or(char::is_lowercase)
    };
    words.next().is_some_and(begins) && words.any(is_word) && !text.contains(['<', '='])
}
