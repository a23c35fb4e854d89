//! Every term of the field that a lesson uses has an entry, and is linked to it where
//! it stands first.

use std::collections::BTreeSet;

use giveway_course::lesson::{Glossary, Span, Target, Term, Text};

use super::reading::texts;
use super::shipped;

/// The words for a term, as they stand in a sentence.
fn words(term: &Term) -> Vec<String> {
    let name = term.name.clone();
    let is_word = name.chars().skip(1).all(|c| !c.is_uppercase());
    let name = if is_word { name.to_lowercase() } else { name };
    std::iter::once(name).chain(term.also.clone()).collect()
}

/// Whether a text has some words, as whole words.
fn has(text: &str, words: &str) -> bool {
    let is_name = words.chars().any(char::is_uppercase);
    let text = if is_name {
        text.to_owned()
    } else {
        text.to_lowercase()
    };
    let is_part = |c: char| c.is_alphanumeric() || c == '-';
    text.match_indices(words).any(|(at, _)| {
        let before = text[..at].chars().next_back();
        let after = text[at + words.len()..].chars().next();
        !before.is_some_and(is_part) && !after.is_some_and(is_part)
    })
}

#[test]
fn no_term_stands_unlinked_where_it_stands_first() {
    let glossary = shipped::glossary();
    let mut complaints = Vec::new();
    for (name, lesson) in shipped::lessons() {
        let mut linked = BTreeSet::new();
        for text in lesson.steps.iter().flat_map(texts) {
            for span in text.spans() {
                match span {
                    Span::Link {
                        target: Target::Term(term),
                        ..
                    } => {
                        linked.insert(term.clone());
                    }
                    Span::Plain(plain) | Span::Emphasis(plain) => {
                        for term in unlinked(&glossary, plain) {
                            if !linked.contains(&term.term) {
                                complaints.push(format!("{name}: \"{}\" in: {plain}", term.name));
                                linked.insert(term.term.clone());
                            }
                        }
                    }
                    Span::Link { .. } => {}
                }
            }
        }
    }
    assert!(complaints.is_empty(), "{}", complaints.join("\n"));
}

/// The terms of a text; one within the words of a longer one is not meant.
fn unlinked<'a>(glossary: &'a Glossary, plain: &str) -> Vec<&'a Term> {
    let mut entries: Vec<(String, &Term)> = Vec::new();
    for term in &glossary.terms {
        entries.extend(words(term).into_iter().map(|words| (words, term)));
    }
    entries.sort_by_key(|(words, _)| std::cmp::Reverse(words.len()));
    let mut plain = plain.to_owned();
    let mut found = Vec::new();
    for (words, term) in entries {
        if has(&plain, &words) {
            found.push(term);
            plain = plain.to_lowercase().replace(&words.to_lowercase(), "_");
        }
    }
    found
}

#[test]
fn lessons_of_the_glossary_exist_and_use_the_term() {
    let glossary = shipped::glossary();
    let lessons = shipped::lessons();
    for term in &glossary.terms {
        let Some(about) = &term.lesson else {
            continue;
        };
        let found = lessons.iter().find(|(name, _)| name == about.as_str());
        let (_, lesson) = found.unwrap_or_else(|| panic!("{}: no lesson {about}", term.term));
        let mut targets = lesson.steps.iter().flat_map(texts).flat_map(Text::targets);
        let is_linked = targets.any(|t| matches!(t, Target::Term(id) if *id == term.term));
        assert!(is_linked, "{about} has no link to {}", term.term);
    }
}

#[test]
fn entries_are_short_and_in_order() {
    let glossary = shipped::glossary();
    let names: Vec<String> = glossary
        .terms
        .iter()
        .map(|t| t.name.to_lowercase())
        .collect();
    let mut sorted = names.clone();
    sorted.sort();
    assert_eq!(names, sorted);
    for term in &glossary.terms {
        let plain = term.text.plain();
        let sentences = plain
            .split_inclusive(['.', '?', '!'])
            .filter(|s| s.trim().len() > 1);
        assert!(sentences.count() <= 3, "{}: {plain}", term.name);
        assert!(
            plain.split_whitespace().count() <= 50,
            "{}: {plain}",
            term.name
        );
    }
}
