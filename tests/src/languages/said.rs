//! The texts that a source says: what stands in its `tr!`.

use proc_macro2::{Delimiter, TokenStream, TokenTree};

use crate::source::{self, File};

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

    /// A text that data brings, by its key.
    pub(super) fn of_data(key: &str, file: &str) -> Self {
        let (context, text) = match key.split_once('\u{4}') {
            Some((context, text)) => (Some(context.to_owned()), text),
            None => (None, key),
        };
        Self {
            context,
            text: text.to_owned(),
            plural: None,
            files: vec![file.to_owned()],
        }
    }
}

/// The key of a text.
pub fn key(context: Option<&str>, text: &str) -> String {
    context.map_or_else(
        || text.to_owned(),
        |context| format!("{context}\u{4}{text}"),
    )
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
            && (name == "tr" || name == "tr_later" || name == "tr_data")
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

/// What a string literal says.
pub(super) fn unescaped(literal: &str) -> Option<String> {
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
