//! A command as words, in which placeholders stand for what a task has. No shell reads it.

use std::ffi::{OsStr, OsString};

/// What stands for a value of a task.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Placeholder {
    /// The path of the map.
    Map,
    /// The path of the scenario.
    Scen,
    /// How many agents there are.
    Agents,
    /// The time limit in seconds.
    Seconds,
    /// The path of the file to write.
    Out,
}

/// All of them, with their names.
const PLACEHOLDERS: [(&str, Placeholder); 5] = [
    ("map", Placeholder::Map),
    ("scen", Placeholder::Scen),
    ("agents", Placeholder::Agents),
    ("seconds", Placeholder::Seconds),
    ("out", Placeholder::Out),
];

/// A part of a word.
#[derive(Clone, Debug, PartialEq, Eq)]
enum Piece {
    Text(String),
    Value(Placeholder),
}

/// A command: its program and its arguments.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Command {
    words: Vec<Vec<Piece>>,
}

/// What was found, and what was expected.
type Wrong = (String, &'static str);

impl Command {
    /// Reads a command. It is split at blanks; single and double quotes hold a word
    /// together, and a backslash, but for one in single quotes, takes the next letter as it
    /// is. Placeholders are found in words after that, so that a path with blanks stays one
    /// word. `{{` and `}}` are braces.
    ///
    /// # Errors
    /// When there is no word, a quote has no end, or a placeholder is unknown.
    pub(crate) fn read(text: &str) -> Result<Self, Wrong> {
        let words = split(text)?;
        if words.is_empty() {
            return Err(("no word".to_owned(), "a program with its arguments"));
        }
        let words = words.iter().map(|word| pieces(word));
        Ok(Self {
            words: words.collect::<Result<_, _>>()?,
        })
    }

    /// Whether a placeholder is in it.
    pub(crate) fn uses(&self, placeholder: Placeholder) -> bool {
        let mut pieces = self.words.iter().flatten();
        pieces.any(|piece| *piece == Piece::Value(placeholder))
    }

    /// The words with the values of a task.
    #[cfg_attr(not(unix), allow(dead_code, reason = "commands are run on Unix only"))]
    pub(crate) fn words<'a>(&self, value: &dyn Fn(Placeholder) -> &'a OsStr) -> Vec<OsString> {
        let word = |pieces: &Vec<Piece>| {
            let mut word = OsString::new();
            for piece in pieces {
                match piece {
                    Piece::Text(text) => word.push(text),
                    Piece::Value(placeholder) => word.push(value(*placeholder)),
                }
            }
            word
        };
        self.words.iter().map(word).collect()
    }
}

/// A command as words.
fn split(text: &str) -> Result<Vec<String>, Wrong> {
    let mut words = Vec::new();
    let mut word: Option<String> = None;
    let mut quote: Option<char> = None;
    let mut letters = text.chars();
    while let Some(letter) = letters.next() {
        match (letter, quote) {
            (_, Some(open)) if letter == open => quote = None,
            ('\\', None | Some('"')) => {
                let Some(next) = letters.next() else {
                    return Err(("\\ at the end".to_owned(), "a letter after it"));
                };
                word.get_or_insert_default().push(next);
            }
            ('\'' | '"', None) => {
                quote = Some(letter);
                word.get_or_insert_default();
            }
            (blank, None) if blank.is_whitespace() => words.extend(word.take()),
            _ => word.get_or_insert_default().push(letter),
        }
    }
    if let Some(open) = quote {
        return Err((format!("{open} without its end"), "a quote at each end"));
    }
    words.extend(word);
    Ok(words)
}

/// The pieces of a word.
fn pieces(word: &str) -> Result<Vec<Piece>, Wrong> {
    let mut pieces = Vec::new();
    let mut text = String::new();
    let mut rest = word;
    while let Some(at) = rest.find(['{', '}']) {
        let (before, brace) = rest.split_at(at);
        text.push_str(before);
        let is_double = brace.starts_with("{{") || brace.starts_with("}}");
        if is_double {
            text.push_str(&brace[..1]);
            rest = &brace[2..];
            continue;
        }
        let name = brace
            .strip_prefix('{')
            .and_then(|name| name.split_once('}'));
        let known = name.and_then(|(name, rest)| {
            let mut known = PLACEHOLDERS.iter();
            let (_, placeholder) = known.find(|(known, _)| *known == name)?;
            Some((*placeholder, rest))
        });
        let Some((placeholder, after)) = known else {
            let end = brace.find('}').map_or(brace.len(), |end| end + 1);
            let expected = "{map}, {scen}, {agents}, {seconds} or {out}; {{ and }} are braces";
            return Err((brace[..end].to_owned(), expected));
        };
        if !text.is_empty() {
            pieces.push(Piece::Text(std::mem::take(&mut text)));
        }
        pieces.push(Piece::Value(placeholder));
        rest = after;
    }
    text.push_str(rest);
    if !text.is_empty() {
        pieces.push(Piece::Text(text));
    }
    Ok(pieces)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn words(text: &str) -> Vec<String> {
        let value = |placeholder: Placeholder| {
            OsStr::new(match placeholder {
                Placeholder::Map => "a b.map",
                Placeholder::Scen => "{out}",
                Placeholder::Agents => "7",
                Placeholder::Seconds => "2.5",
                Placeholder::Out => "'o",
            })
        };
        let words = Command::read(text).unwrap().words(&value).into_iter();
        words.map(|word| word.into_string().unwrap()).collect()
    }

    #[test]
    fn words_are_split_before_values_stand_in_them() {
        assert_eq!(
            words(" x -m {map}\t{scen} "),
            ["x", "-m", "a b.map", "{out}"]
        );
        assert_eq!(
            words("x --n={agents},{seconds} {out}"),
            ["x", "--n=7,2.5", "'o"]
        );
        assert_eq!(
            words(r#"sh -c 'a "b" $1 \n' "c \"d\" 'e'" '' f\ g"#),
            ["sh", "-c", r#"a "b" $1 \n"#, r#"c "d" 'e'"#, "", "f g"]
        );
        assert_eq!(words("x {{map}} }}{{{map}"), ["x", "{map}", "}{a b.map"]);
    }

    #[test]
    fn what_is_no_command_is_told() {
        for (text, found) in [
            ("", "no word"),
            ("x 'y", "' without its end"),
            ("x \\", "\\ at the end"),
            ("x {mpa}", "{mpa}"),
            ("x {map", "{map"),
            ("x map}", "}"),
        ] {
            assert_eq!(Command::read(text).unwrap_err().0, found);
        }
    }
}
