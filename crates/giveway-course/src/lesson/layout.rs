//! Lays JSON out as a person would: what is short on one line, a map a row a line.

/// The most characters of a line, where a text is not longer by itself.
const WIDTH: usize = 110;

/// Lays out JSON that was written without blanks.
pub(super) fn laid_out(dense: &str) -> String {
    let mut text = String::new();
    lay(dense, 0, 0, false, &mut text);
    text
}

/// Lays a value out behind so many characters of its line, what is in it two further in
/// than `indent`.
fn lay(dense: &str, indent: usize, before: usize, stacked: bool, text: &mut String) {
    let line = spaced(dense);
    let has_parts = dense.len() > 2 && dense.starts_with(['{', '[']);
    if !has_parts || (!stacked && before + line.chars().count() <= WIDTH) {
        text.push_str(&line);
        return;
    }
    let (open, close) = (dense.get(..1), dense.get(dense.len() - 1..));
    let inner = dense.get(1..dense.len() - 1).unwrap_or_default();
    text.push_str(open.unwrap_or_default());
    for (index, part) in parts(inner, ',').into_iter().enumerate() {
        text.push_str(if index == 0 { "\n" } else { ",\n" });
        text.push_str(&" ".repeat(indent + 2));
        match parts(part, ':').as_slice() {
            [key, value] => {
                text.push_str(key);
                text.push_str(": ");
                let is_map = *key == "\"map\"" && value.contains(',');
                lay(value, indent + 2, indent + key.len() + 5, is_map, text);
            }
            _ => lay(part, indent + 2, indent + 3, false, text),
        }
    }
    text.push('\n');
    text.push_str(&" ".repeat(indent));
    text.push_str(close.unwrap_or_default());
}

/// The parts between separators that are in no text and no bracket; a key and its value
/// where the separator is a colon.
fn parts(inner: &str, separator: char) -> Vec<&str> {
    let mut parts = Vec::new();
    let mut begin = 0;
    each(inner, |byte, c, depth| {
        if depth == 0 && c == separator {
            parts.push(inner.get(begin..byte).unwrap_or_default());
            begin = byte + 1;
        }
    });
    parts.push(inner.get(begin..).unwrap_or_default());
    parts
}

/// One line with blanks where a person would put them.
fn spaced(dense: &str) -> String {
    let mut line = String::with_capacity(dense.len() * 5 / 4);
    let mut copied = 0;
    each(dense, |byte, c, _| {
        let is_empty = dense.get(byte..byte + 2) == Some("{}")
            || dense.get(byte.saturating_sub(1)..=byte) == Some("{}");
        let (before, after) = match c {
            ',' | ':' => ("", " "),
            '{' if !is_empty => ("", " "),
            '}' if !is_empty => (" ", ""),
            _ => return,
        };
        line.push_str(dense.get(copied..byte).unwrap_or_default());
        line.push_str(before);
        line.push(c);
        line.push_str(after);
        copied = byte + 1;
    });
    line.push_str(dense.get(copied..).unwrap_or_default());
    line
}

/// Calls for each character that is in no text, with the brackets that are open.
fn each(dense: &str, mut call: impl FnMut(usize, char, usize)) {
    let (mut depth, mut in_text, mut escaped) = (0_usize, false, false);
    for (byte, c) in dense.char_indices() {
        match c {
            _ if escaped => escaped = false,
            '\\' if in_text => escaped = true,
            '"' => in_text = !in_text,
            _ if in_text => {}
            '{' | '[' => {
                call(byte, c, depth);
                depth += 1;
            }
            '}' | ']' => {
                depth = depth.saturating_sub(1);
                call(byte, c, depth);
            }
            c => call(byte, c, depth),
        }
    }
}
