//! What the page says, made apart from how it is known.

pub mod change;
mod costs;
mod status;
mod steering;

pub use costs::{objective, title, values};
pub use giveway_model::words::{by, by_named};
pub use giveway_model::words::{count, grouped, name, value};
pub use giveway_model::words::{distance, duration, measured, timed};
pub use status::{Badge, Standing, later, standing};

use giveway_model::Question;

/// A question as a sentence.
pub fn question(question: &Question) -> String {
    unnested(&giveway_model::question::sentence(question))
}

/// A sentence without quotes within quotes: what is quoted as a whole, as a rule is by its sentence,
/// has none of its own around its names.
///
/// ```
/// let nested = "the rule \"At most 1 robot in 'aisle 1'\" of A1's aisle 'x'";
/// let told = "the rule \"At most 1 robot in aisle 1\" of A1's aisle 'x'";
/// assert_eq!(giveway_page::words::unnested(nested), told);
/// ```
pub fn unnested(text: &str) -> String {
    let mut told = String::with_capacity(text.len());
    let (mut depth, mut is_quoted, mut in_name) = (0_u32, false, false);
    let mut letters = text.chars().peekable();
    let mut before = ' ';
    while let Some(letter) = letters.next() {
        let is_inner = is_quoted || depth > 0;
        let ends = letters.peek().is_none_or(|next| !next.is_alphanumeric());
        let is_shown = match letter {
            // German quotes begin with another letter than they end with.
            '\u{201e}' => {
                depth += 1;
                depth == 1
            }
            '\u{201c}' if depth > 0 => {
                depth -= 1;
                depth == 0
            }
            '"' => {
                is_quoted = !is_quoted;
                true
            }
            '\u{201c}' | '\u{201d}' => {
                is_quoted = letter == '\u{201c}';
                true
            }
            '\'' | '\u{2018}' if in_name && ends => {
                in_name = false;
                false
            }
            '\'' | '\u{201a}' if is_inner && !in_name && !before.is_alphanumeric() => {
                in_name = true;
                false
            }
            _ => true,
        };
        if is_shown {
            told.push(letter);
        }
        before = letter;
    }
    told
}

/// A cell in a sentence: `(3, 1)`.
pub fn at(cell: giveway_model::Cell) -> String {
    cell.to_string()
}
