//! The sentences of the sources and the catalogues of the languages: what `tr!` says,
//! what a PO file says, and a PO file brought up to date.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::Path;

use giveway_model::words::{Message, messages};
use proc_macro2::{Delimiter, TokenStream, TokenTree};

use crate::source::{self, File};

/// Where people find sentences; the rest is for programs or not said in other
/// languages yet.
pub const FOLDERS: [&str; 6] = [
    "web/src",
    "crates/giveway-page/src",
    "crates/giveway-solve/src",
    "crates/giveway-planners/src",
    "crates/giveway-picture/src",
    "crates/giveway-model/src",
];

/// The program of the course: its lessons are in English alone so far, and so is it.
const ENGLISH: &str = "web/src/course/";

/// The list of examples, whose words are said, too.
const EXAMPLES: &str = "static/examples/index.json";

/// A text that the sources say.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Said {
    /// Tells two meanings apart.
    pub context: Option<String>,
    /// The text.
    pub text: String,
    /// The text for more than one.
    pub plural: Option<String>,
    /// The files that say it.
    pub files: Vec<String>,
}

impl Said {
    /// As the catalogue finds it.
    pub fn key(&self) -> String {
        key(self.context.as_deref(), &self.text)
    }
}

/// The key of a text.
pub fn key(context: Option<&str>, text: &str) -> String {
    context.map_or_else(
        || text.to_owned(),
        |context| format!("{context}\u{4}{text}"),
    )
}

/// Every text of the sources, each once, in the order of the files.
///
/// # Panics
///
/// If one text has two plurals, or `tr!` is not read.
pub fn said() -> Vec<Said> {
    let mut all: Vec<Said> = Vec::new();
    let mut places: BTreeMap<String, usize> = BTreeMap::new();
    for folder in FOLDERS {
        for file in source::files(folder) {
            if !is_source(&file.path) {
                continue;
            }
            for one in of_file(&file) {
                let place = *places.entry(one.key()).or_insert(all.len());
                if place == all.len() {
                    all.push(one);
                    continue;
                }
                let before = &mut all[place];
                assert!(
                    before.plural == one.plural || one.plural.is_none() || before.plural.is_none(),
                    "two plurals of {}: {:?}, {:?}",
                    one.text,
                    before.plural,
                    one.plural
                );
                before.plural = before.plural.take().or(one.plural);
                if !before.files.contains(&file.path) {
                    before.files.push(file.path.clone());
                }
            }
        }
    }
    let text = std::fs::read_to_string(source::root().join(EXAMPLES)).expect("the examples");
    let examples: Vec<BTreeMap<String, String>> = serde_json::from_str(&text).expect("a list");
    for text in examples
        .into_iter()
        .flatten()
        .filter(|(key, _)| key != "file")
    {
        all.push(Said {
            context: None,
            text: text.1,
            plural: None,
            files: vec![EXAMPLES.to_owned()],
        });
    }
    all
}

/// Whether a path is a Rust source that is no test, and is said in other languages.
pub fn is_source(path: &str) -> bool {
    let is_rust = Path::new(path).extension().is_some_and(|end| end == "rs");
    is_rust && !path.contains("/tests") && !path.starts_with(ENGLISH)
}

/// The texts of one file.
pub fn of_file(file: &File) -> Vec<Said> {
    let mut found = Vec::new();
    collect(source::tokens(file), &file.path, &mut found);
    found
}

fn collect(tokens: TokenStream, path: &str, found: &mut Vec<Said>) {
    let tokens: Vec<TokenTree> = tokens.into_iter().collect();
    let mut i = 0;
    while i < tokens.len() {
        if let [
            TokenTree::Ident(name),
            TokenTree::Punct(bang),
            TokenTree::Group(inner),
            ..,
        ] = &tokens[i..]
            && (name == "tr" || name == "tr_later")
            && bang.as_char() == '!'
        {
            found.extend(read(inner.stream(), path));
        }
        // Tests say what they like.
        if let [
            TokenTree::Group(attribute),
            TokenTree::Ident(word),
            TokenTree::Ident(_),
            TokenTree::Group(_),
            ..,
        ] = &tokens[i..]
            && word == "mod"
            && attribute.stream().to_string().replace(' ', "") == "cfg(test)"
        {
            i += 4;
            continue;
        }
        // A macro's own rules name themselves.
        if let [
            TokenTree::Ident(name),
            TokenTree::Punct(_),
            TokenTree::Ident(_),
            TokenTree::Group(_),
            ..,
        ] = &tokens[i..]
            && name == "macro_rules"
        {
            i += 4;
            continue;
        }
        if let TokenTree::Group(group) = &tokens[i] {
            collect(group.stream(), path, found);
        }
        i += 1;
    }
}

/// What stands in the parentheses of a `tr!`.
fn read(tokens: TokenStream, path: &str) -> Option<Said> {
    let tokens: Vec<TokenTree> = tokens.into_iter().collect();
    let mark = |i: usize| match tokens.get(i) {
        Some(TokenTree::Punct(mark)) => Some(mark.as_char()),
        _ => None,
    };
    let literal = |i: usize| match tokens.get(i) {
        Some(TokenTree::Literal(literal)) => unescaped(&literal.to_string()),
        // A literal that came through a macro stands in an invisible group.
        Some(TokenTree::Group(group)) if group.delimiter() == Delimiter::None => None,
        _ => None,
    };
    let first = literal(0)?;
    let (context, text, next) = if mark(1) == Some('=') && mark(2) == Some('>') {
        (Some(first), literal(3)?, 4)
    } else {
        (None, first, 1)
    };
    let plural = if mark(next) == Some('|') {
        literal(next + 1)
    } else {
        None
    };
    Some(Said {
        context,
        text,
        plural,
        files: vec![path.to_owned()],
    })
}

/// Names that are the same in every language.
const NAMES: [&str; 1] = ["Giveway"];
/// Macros and functions whose texts no person reads in another language.
const INNER: [&str; 5] = ["tr", "tr_later", "expect", "panic", "unreachable"];
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

/// What a string literal says.
pub fn unescaped(literal: &str) -> Option<String> {
    let inner = literal.strip_prefix('"')?.strip_suffix('"')?;
    let mut text = String::new();
    let mut rest = inner;
    while let Some((before, after)) = rest.split_once('\\') {
        text.push_str(before);
        let mut chars = after.chars();
        match chars.next()? {
            'n' => text.push('\n'),
            't' => text.push('\t'),
            'u' => {
                let (code, behind) = chars.as_str().strip_prefix('{')?.split_once('}')?;
                text.push(char::from_u32(u32::from_str_radix(code, 16).ok()?)?);
                rest = behind;
                continue;
            }
            '\n' => {
                rest = chars.as_str().trim_start();
                continue;
            }
            other => text.push(other),
        }
        rest = chars.as_str();
    }
    text.push_str(rest);
    Some(text)
}

/// The places `{name}` of a text, sorted, each once.
pub fn places(text: &str) -> Vec<String> {
    let parts = text.split('{').skip(1);
    let names = parts.filter_map(|part| Some(part.split_once('}')?.0.to_owned()));
    let mut names: Vec<String> = names.collect();
    names.sort();
    names.dedup();
    names
}

/// A PO file with exactly the texts of the sources: translations are kept, what is
/// missing has none yet, and what nobody says is left out.
///
/// # Panics
///
/// If the file is no PO.
pub fn updated(po: &str, said: &[Said]) -> String {
    let known = messages(po).expect("a PO file");
    let known: BTreeMap<String, Message> = known.into_iter().map(|m| (m.key(), m)).collect();
    let head = po.split_once("\n\n").map_or(po, |(head, _)| head);
    let mut text = format!("{}\n", head.trim_end());
    for one in said {
        let _ = writeln!(text);
        for file in &one.files {
            let _ = writeln!(text, "#: {file}");
        }
        if let Some(context) = &one.context {
            let _ = writeln!(text, "msgctxt {}", quoted(context));
        }
        let _ = writeln!(text, "msgid {}", quoted(&one.text));
        let forms = known.get(&one.key()).map(|message| message.forms.clone());
        let forms = forms.unwrap_or_default();
        let form = |i: usize| forms.get(i).map_or("", String::as_str);
        match &one.plural {
            None => {
                let _ = writeln!(text, "msgstr {}", quoted(form(0)));
            }
            Some(plural) => {
                let _ = writeln!(text, "msgid_plural {}", quoted(plural));
                for i in 0..2.max(forms.len()) {
                    let _ = writeln!(text, "msgstr[{i}] {}", quoted(form(i)));
                }
            }
        }
    }
    text
}

fn quoted(text: &str) -> String {
    let text = text.replace('\\', "\\\\").replace('"', "\\\"");
    format!("\"{}\"", text.replace('\n', "\\n").replace('\t', "\\t"))
}
