//! Numbers that a person types: which are possible, and what becomes of others.

use giveway_model::{Measure, tr};

/// The number that was typed; `None` where it is not between two, both included.
///
/// ```
/// use giveway_page::number::{possible, read, taken};
/// assert_eq!(read(" 12 ", (1, 512)), Some(12));
/// assert_eq!(read("99999999999", (1, 512)), None);
/// assert_eq!(possible((1, 512)), "Possible: 1 to 512.");
/// // A field keeps what it had: another number than the one typed would be a surprise.
/// assert_eq!(taken("99999999999", Some(5), (1, 512)), Some(5));
/// assert_eq!(taken("999", Some(5), (1, 512)), Some(5));
/// assert_eq!(taken("512", Some(5), (1, 512)), Some(512));
/// ```
pub fn read(typed: &str, (least, most): (u32, u32)) -> Option<u32> {
    let number = typed.trim().parse().ok()?;
    (least..=most).contains(&number).then_some(number)
}

/// The number nearest to the one that was typed, between two, both included; `None` where no
/// whole number was typed.
///
/// ```
/// use giveway_page::number::nearest;
/// assert_eq!(nearest(" 7 ", (0, 18)), Some(7));
/// assert_eq!(nearest("99999999999999999999", (0, 18)), Some(18));
/// assert_eq!(nearest("-4", (0, 18)), Some(0));
/// assert_eq!((nearest("", (0, 18)), nearest("7.5", (0, 18)), nearest("-", (0, 18))), (None, None, None));
/// ```
pub fn nearest(typed: &str, (least, most): (u32, u32)) -> Option<u32> {
    let typed = typed.trim();
    let digits = typed.strip_prefix('-').unwrap_or(typed);
    if digits.is_empty() || !digits.bytes().all(|byte| byte.is_ascii_digit()) {
        return None;
    }
    // What is longer than any number is as far as it goes.
    let number = digits.parse().unwrap_or(u32::MAX);
    let number = if digits == typed { number } else { 0 };
    Some(number.clamp(least, most))
}

/// What a field with a value holds after something was typed in it: that number where it is
/// possible, else what it held before.
pub fn taken(typed: &str, value: Option<u32>, range: (u32, u32)) -> Option<u32> {
    read(typed, range).or(value)
}

/// Which numbers are possible, as a sentence.
pub fn possible((least, most): (u32, u32)) -> String {
    tr!("Possible: {least} to {most}.", least, most)
}

/// The number with or without decimals that was typed, with a point or a comma; `None` where
/// it is not between two, both included.
///
/// ```
/// use giveway_page::number::{decimal, decimal_text};
/// assert_eq!(decimal(" 0,8 ", (0.0, 9.0)), Some(0.8));
/// assert_eq!(decimal("1e9", (0.0, 9.0)), None);
/// assert_eq!(decimal("NaN", (0.0, 9.0)), None);
/// assert_eq!((decimal_text(0.8), decimal_text(12.0)), ("0.8".into(), "12".into()));
/// ```
pub fn decimal(typed: &str, (least, most): (f64, f64)) -> Option<f64> {
    let number = giveway_model::decimal(&typed.trim().replace(',', "."))?;
    (least..=most).contains(&number).then_some(number)
}

/// A number with at most two decimals.
pub fn decimal_text(number: f64) -> String {
    let text = format!("{number:.2}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

/// The measure that was typed, with a point or a comma and at most three decimals; `None` where
/// it is none.
///
/// ```
/// use giveway_page::number::{measure, possible_measure};
/// assert_eq!(measure(" 0,8 ").map(|it| it.to_string()), Some("0.8".into()));
/// assert_eq!(measure("12.125").map(|it| it.thousandths()), Some(12_125));
/// for none in ["0", "-1", "0.0001", "1.0005", "1000001", "wide", ""] {
///     assert_eq!(measure(none), None, "{none}");
/// }
/// assert_eq!(possible_measure(), "Possible: 0.001 to 1000000, with at most three decimals.");
/// ```
pub fn measure(typed: &str) -> Option<Measure> {
    let thousandths = decimal(typed, (MEASURES.0, MEASURES.1))? * 1000.0;
    let whole = thousandths.round();
    let is_exact = (thousandths - whole).abs() < 1e-3;
    #[expect(
        clippy::cast_sign_loss,
        reason = "the number is within the range of measures"
    )]
    let measure = is_exact.then(|| Measure::from_thousandths(whole as u32));
    measure.flatten()
}

/// The least and the largest measure.
const MEASURES: (f64, f64) = (0.001, 1e6);

/// Which measures are possible, as a sentence.
pub fn possible_measure() -> String {
    tr!(
        "Possible: {least} to {most}, with at most three decimals.",
        least = MEASURES.0,
        most = MEASURES.1
    )
}
