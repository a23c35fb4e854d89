//! Tables for spreadsheets, in which no text is a formula.

use crate::tr;

/// A text as a cell of a table: quoted where it must be, and never a formula.
///
/// ```
/// use giveway_model::csv::text;
/// assert_eq!(text("A1"), "A1");
/// assert_eq!(text("a, \"b\""), "\"a, \"\"b\"\"\"");
/// assert_eq!(text("=1+1"), "'=1+1");
/// ```
pub fn text(text: &str) -> String {
    let is_formula = text.starts_with(['=', '+', '-', '@', '\t', '\r']);
    let safe = if is_formula {
        format!("'{text}")
    } else {
        text.to_owned()
    };
    if safe.contains([',', '"', ';', '\t', '\n', '\r']) {
        format!("\"{}\"", safe.replace('"', "\"\""))
    } else {
        safe
    }
}

/// Rows as a table: lines as RFC 4180 has them. A byte order mark tells spreadsheets that names
/// are in UTF-8; the mark between cells is that of the spreadsheets of a language.
pub fn table(rows: impl IntoIterator<Item = Vec<String>>) -> String {
    let mark = tr!("the mark between the cells of a table in a file" => ",");
    let mut table = String::from('\u{feff}');
    for row in rows {
        table.push_str(&row.join(mark));
        table.push_str("\r\n");
    }
    table
}
