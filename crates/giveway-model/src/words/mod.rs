//! Small parts of sentences for people, made in one place for the page, the
//! command and certificates: lists, numbers of things, costs; and in which language
//! they are said (`tr.rs`, `catalogue.rs`).

mod catalogue;
mod places;
mod po;
mod sentence;
mod tr;
mod units;

use std::fmt::Display;

use crate::{Cost, Costs, tr};

pub use catalogue::{Catalogue, PluralRule, in_english, speak};
#[doc(hidden)]
pub use places::{checked, checked_forms};
pub use po::{Message, NoCatalogue, read as messages};
pub use sentence::Sentence;
pub use tr::{Later, found, retold, translated};
#[doc(hidden)]
pub use tr::{fill, fill_counted, number, text};
pub use units::{distance, duration, length, measured, timed};

/// Phrases in a row: `a`, `a and b`, `a, b and c`.
///
/// ```
/// use giveway_model::words::and;
/// assert_eq!(and(&["a", "b", "c"]), "a, b and c");
/// ```
pub fn and<S: AsRef<str>>(phrases: &[S]) -> String {
    match phrases {
        [] => String::new(),
        [one] => one.as_ref().to_owned(),
        [init @ .., last] => {
            let init: Vec<&str> = init.iter().map(AsRef::as_ref).collect();
            let (list, last) = (init.join(", "), last.as_ref());
            tr!("list" => "{list} and {last}", list, last)
        }
    }
}

/// Phrases of which one holds: `a`, `a or b`.
///
/// ```
/// use giveway_model::words::or;
/// assert_eq!(or(&["here", "there"]), "here or there");
/// ```
pub fn or<S: AsRef<str>>(phrases: &[S]) -> String {
    let phrases: Vec<&str> = phrases.iter().map(AsRef::as_ref).collect();
    phrases.join(tr!("between phrases" => " or "))
}

/// A number with so many digits behind the decimal mark of the language.
///
/// ```
/// assert_eq!(giveway_model::words::decimal(2.25, 1), "2.2");
/// ```
pub fn decimal(n: f64, digits: usize) -> String {
    let text = format!("{n:.digits$}");
    text.replace('.', tr!("decimal mark" => "."))
}

/// A name of at most so many letters: of a longer one the beginning and the end, since the
/// names of one fleet mostly differ at their ends.
///
/// ```
/// use giveway_model::words::middle_cut;
/// assert_eq!(middle_cut("Transporter_in_hall_East_01", 12), "Trans…ast_01");
/// assert_eq!(middle_cut("A1", 12), "A1");
/// ```
pub fn middle_cut(name: &str, most: usize) -> String {
    let letters: Vec<char> = name.chars().collect();
    if letters.len() <= most {
        return name.to_owned();
    }
    let room = most.saturating_sub(1);
    let begin = letters.iter().take(room / 2);
    let end = letters.iter().skip(letters.len() - room.div_ceil(2));
    begin.chain([&'…']).chain(end).collect()
}

/// A number of things: `1 robot`, `2 robots`.
///
/// ```
/// use giveway_model::words::count;
/// assert_eq!(count(1_u32, "robot"), "1 robot");
/// assert_eq!(count(0_u32, "robot"), "0 robots");
/// ```
pub fn count<N: Copy + Display + PartialEq + From<u8>>(n: N, thing: &str) -> String {
    let plural = if n == N::from(1) { "" } else { "s" };
    format!("{n} {thing}{plural}")
}

/// A number with thin spaces where it is long.
pub fn grouped(n: u64) -> String {
    let digits = n.to_string();
    if digits.len() <= 4 {
        return digits;
    }
    let mut text = String::new();
    for (i, digit) in digits.chars().enumerate() {
        if i > 0 && (digits.len() - i).is_multiple_of(3) {
            text.push('\u{202f}');
        }
        text.push(digit);
    }
    text
}

/// A phrase as the beginning of a sentence. A name that begins with a letter of
/// another alphabet stands as it is: a table of all letters would weigh more in a
/// page than all of its words.
pub fn capital(phrase: &str) -> String {
    with_first(phrase, char::to_ascii_uppercase)
}

/// A sentence in the middle of another one, behind a colon.
pub fn lower(sentence: &str) -> String {
    with_first(sentence, char::to_ascii_lowercase)
}

fn with_first(text: &str, change: fn(&char) -> char) -> String {
    let mut chars = text.chars();
    let first = chars.next().map(|first| change(&first));
    first.into_iter().chain(chars).collect()
}

/// A sentence with a full stop at its end, if it has none of its own.
///
/// ```
/// use giveway_model::words::sentence;
/// assert_eq!(sentence(" A1 cannot arrive"), "A1 cannot arrive.");
/// assert_eq!(sentence("Why?"), "Why?");
/// ```
pub fn sentence(text: &str) -> String {
    let text = text.trim();
    if text.is_empty() || text.ends_with(['.', '!', '?']) {
        text.to_owned()
    } else {
        format!("{text}.")
    }
}

/// The name of a cost within a sentence.
pub fn name(cost: Cost) -> &'static str {
    match cost {
        Cost::Makespan => tr!("makespan"),
        Cost::SumOfCosts => tr!("sum of costs"),
        Cost::Charges => tr!("charges"),
        Cost::Moves => tr!("moves"),
        Cost::Waits => tr!("waits"),
        Cost::Penalty => tr!("penalty"),
    }
}

/// A cost as a noun of one thing: `number of charges`.
pub fn noun(cost: Cost) -> &'static str {
    match cost {
        Cost::Makespan => tr!("makespan"),
        Cost::SumOfCosts => tr!("sum of costs"),
        Cost::Charges => tr!("number of charges"),
        Cost::Moves => tr!("number of moves"),
        Cost::Waits => tr!("number of waits"),
        Cost::Penalty => tr!("penalty"),
    }
}

/// A cost and its value: `makespan 18`, `1 charge`.
pub fn value(cost: Cost, n: u32) -> String {
    match cost {
        Cost::Makespan | Cost::SumOfCosts | Cost::Penalty => format!("{} {n}", name(cost)),
        Cost::Charges => tr!("{n} charge" | "{n} charges" % n),
        Cost::Moves => tr!("{n} move" | "{n} moves" % n),
        Cost::Waits => tr!("{n} wait" | "{n} waits" % n),
    }
}

/// Costs with their values: `makespan 18, sum of costs 35`.
pub fn values<'a>(order: impl IntoIterator<Item = &'a Cost>, costs: &Costs) -> String {
    let parts = order.into_iter().map(|&cost| value(cost, costs.get(cost)));
    parts.collect::<Vec<_>>().join(", ")
}

/// By how much a cost differs, with its unit: `+2 steps`, `−16 in the sum of costs`, `same`.
///
/// ```
/// use giveway_model::{Cost, words::by};
/// assert_eq!(by(Cost::Makespan, 2), "+2 steps");
/// ```
pub fn by(cost: Cost, delta: i64) -> String {
    if delta == 0 {
        return tr!("a cost is the" => "same").to_owned();
    }
    let by = signed(delta);
    let n = delta.unsigned_abs();
    match cost {
        Cost::Makespan => tr!("a difference" => "{by} step" | "{by} steps" % n, by),
        Cost::SumOfCosts => tr!("a difference" => "{by} in the sum of costs", by),
        Cost::Charges => tr!("a difference" => "{by} charge" | "{by} charges" % n, by),
        Cost::Moves => tr!("a difference" => "{by} move" | "{by} moves" % n, by),
        Cost::Waits => tr!("a difference" => "{by} wait" | "{by} waits" % n, by),
        Cost::Penalty => tr!("a difference" => "{by} in the penalty", by),
    }
}

/// The same with the name of the cost also where steps alone could be those of one robot:
/// `+2 in the makespan`.
///
/// ```
/// use giveway_model::{Cost, words::by_named};
/// assert_eq!(by_named(Cost::Makespan, 2), "+2 in the makespan");
/// assert_eq!(by_named(Cost::Charges, 0), "same");
/// ```
pub fn by_named(cost: Cost, delta: i64) -> String {
    if cost == Cost::Makespan && delta != 0 {
        return tr!("a difference" => "{by} in the makespan", by = signed(delta));
    }
    by(cost, delta)
}

fn signed(delta: i64) -> String {
    format!("{delta:+}").replace('-', "\u{2212}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_of_costs() {
        assert_eq!(value(Cost::Makespan, 18), "makespan 18");
        assert_eq!(value(Cost::SumOfCosts, 35), "sum of costs 35");
        assert_eq!(value(Cost::Charges, 1), "1 charge");
        assert_eq!(value(Cost::Moves, 2), "2 moves");
        assert_eq!(value(Cost::Waits, 0), "0 waits");
    }

    #[test]
    fn only_the_first_letter_changes() {
        assert_eq!(capital("remove A1"), "Remove A1");
        assert_eq!(lower("There is No plan"), "there is No plan");
        assert_eq!(capital(""), "");
    }
}
