//! PO files (GNU gettext): what translators and their tools, such as Poedit and
//! Weblate, write.
//!
//! The libraries for it bring tables of encodings or of line breaks along, of many
//! times this file's weight in a page. A test of the workspace compares this reader with
//! one of them.

use std::fmt;

/// A message of a PO file.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Message {
    /// Tells two meanings of one text apart.
    pub context: Option<String>,
    /// The text in English.
    pub text: String,
    /// The text for more than one, where things are counted.
    pub plural: Option<String>,
    /// The translation: one form, or one for each kind of number.
    pub forms: Vec<String>,
    /// Whether a person still has to look at it.
    pub is_fuzzy: bool,
}

impl Message {
    /// The key that `tr!` looks for.
    pub fn key(&self) -> String {
        match &self.context {
            Some(context) => format!("{context}\u{4}{}", self.text),
            None => self.text.clone(),
        }
    }

    /// Whether it has a translation that counts; the head of the file has none.
    pub fn is_translated(&self) -> bool {
        let is_whole = !self.forms.is_empty() && self.forms.iter().all(|form| !form.is_empty());
        !self.text.is_empty() && !self.is_fuzzy && is_whole
    }
}

/// A text that is no PO file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NoCatalogue {
    /// The line, from 1.
    pub line: usize,
}

impl fmt::Display for NoCatalogue {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "line {} is not PO", self.line)
    }
}

impl std::error::Error for NoCatalogue {}

/// Where the next text in quotation marks belongs.
#[derive(Clone, Copy, PartialEq)]
enum Part {
    Context,
    Text,
    Plural,
    Form,
}

/// All messages of a PO file in their order, the head included, whose text is empty.
///
/// # Errors
///
/// [`NoCatalogue`] with the first line that is not PO.
///
/// ```
/// use giveway_model::words::messages;
/// let read = messages("# Of the menu\nmsgid \"Undo\"\nmsgstr \"Rück\"\n\"gängig\"\n").unwrap();
/// assert_eq!(read[0].text, "Undo");
/// assert_eq!(read[0].forms, ["Rückgängig"]);
/// ```
pub fn read(file: &str) -> Result<Vec<Message>, NoCatalogue> {
    let mut messages: Vec<Message> = Vec::new();
    let mut next = Message::default();
    let mut part = Part::Form;
    for (i, line) in file.lines().enumerate() {
        let fault = NoCatalogue { line: i + 1 };
        let line = line.trim();
        if line.is_empty() || line.starts_with('#') {
            // A flag stands before the message that it is about.
            if line.starts_with("#,") && line.contains("fuzzy") {
                finish(&mut next, &mut messages);
                next.is_fuzzy = true;
            }
            continue;
        }
        let (word, quoted) = line.split_at(line.find('"').ok_or(fault.clone())?);
        let text = unquoted(quoted).ok_or(fault.clone())?;
        match word.trim_end() {
            "" => {}
            "msgctxt" => {
                finish(&mut next, &mut messages);
                part = Part::Context;
                next.context = Some(String::new());
            }
            "msgid" => {
                finish(&mut next, &mut messages);
                part = Part::Text;
            }
            "msgid_plural" => {
                part = Part::Plural;
                next.plural = Some(String::new());
            }
            form if form.starts_with("msgstr") => {
                part = Part::Form;
                next.forms.push(String::new());
            }
            _ => return Err(fault),
        }
        let place = match part {
            Part::Context => next.context.as_mut(),
            Part::Text => Some(&mut next.text),
            Part::Plural => next.plural.as_mut(),
            Part::Form => next.forms.last_mut(),
        };
        place.ok_or(fault)?.push_str(&text);
    }
    finish(&mut next, &mut messages);
    Ok(messages)
}

/// Ends a message that has its translation; what has none yet goes on.
fn finish(next: &mut Message, messages: &mut Vec<Message>) {
    if !next.forms.is_empty() {
        messages.push(std::mem::take(next));
    }
}

/// A text in quotation marks without them, its escapes read.
fn unquoted(quoted: &str) -> Option<String> {
    let inner = quoted.strip_prefix('"')?.strip_suffix('"')?;
    let mut text = String::with_capacity(inner.len());
    let mut chars = inner.chars();
    while let Some(char) = chars.next() {
        text.push(match char {
            '"' => return None,
            '\\' => match chars.next()? {
                'n' => '\n',
                't' => '\t',
                other => other,
            },
            other => other,
        });
    }
    Some(text)
}

#[cfg(test)]
mod tests {
    use super::{Message, NoCatalogue, read};

    #[test]
    fn a_file_is_read_whole() {
        let file = r#"# Translators know this.
msgid ""
msgstr ""
"Language: de\n"

#: web/src/app.rs:3
msgctxt "of a file"
msgid "Open \"it\""
msgstr "Öffnen"

#, fuzzy
msgid "Unsure"
msgstr "Unsicher"

msgid "{n} step"
msgid_plural "{n} steps"
msgstr[0] "{n} Schritt"
msgstr[1] "{n} "
"Schritte"

#~ msgid "Gone"
#~ msgstr "Weg"
msgid "Later"
msgstr ""
"#;
        let messages = read(file).unwrap();
        let message = |text: &str, forms: &[&str]| Message {
            text: text.to_owned(),
            forms: forms.iter().map(ToString::to_string).collect(),
            ..Message::default()
        };
        let mut open = message("Open \"it\"", &["Öffnen"]);
        open.context = Some("of a file".to_owned());
        let mut unsure = message("Unsure", &["Unsicher"]);
        unsure.is_fuzzy = true;
        let mut steps = message("{n} step", &["{n} Schritt", "{n} Schritte"]);
        steps.plural = Some("{n} steps".to_owned());
        let head = message("", &["Language: de\n"]);
        let later = message("Later", &[""]);
        assert_eq!(messages, [head, open, unsure, steps, later]);
        let known: Vec<bool> = messages.iter().map(Message::is_translated).collect();
        assert_eq!(known, [false, true, false, true, false]);
    }

    #[test]
    fn what_is_no_po_is_refused_with_its_line() {
        for (file, line) in [
            ("hello", 1),
            ("msgid \"a\"\nmsgstr \"b", 2),
            ("\"a\"", 1),
            ("msgid \"a\"\nmsgwhat \"b\"", 2),
            ("msgid \"a\"b\"", 1),
            ("msgid \"a\\\"", 1),
        ] {
            assert_eq!(read(file), Err(NoCatalogue { line }), "{file}");
        }
    }
}
