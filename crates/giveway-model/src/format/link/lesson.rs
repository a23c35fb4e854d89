//! Links to lessons, and to what is handed in of them.

use super::repair::{decoded, readings};

/// What is handed in of a lesson begins with this, with its equals sign.
const HAND_IN: &str = "hand-in=";

/// The name or the letters of a lesson in a text that names one, `lesson=...`, in whatever
/// form; what a sentence puts behind them is left out. What is handed in of a lesson keeps its
/// `hand-in=`.
///
/// ```
/// use giveway_model::format::link::lesson::named;
/// assert_eq!(named("lesson%3Droom-to-pass.2)."), Some("room-to-pass.2".to_owned()));
/// assert_eq!(named("hand-in=~Xy_-9."), Some("hand-in=~Xy_-9".to_owned()));
/// assert_eq!(named("giveway=1"), None);
/// ```
pub fn named(text: &str) -> Option<String> {
    let mut readings = readings(text).into_iter().map(|text| decoded(&text));
    let found = readings.find_map(|text| {
        let name = text.strip_prefix("lesson=").map(str::to_owned);
        name.or_else(|| text.starts_with(HAND_IN).then_some(text))
    })?;
    let end = found.find(['&', '?', ' ']).unwrap_or(found.len());
    let name = found.get(..end).unwrap_or_default();
    let is_behind = |letter: char| !letter.is_ascii_alphanumeric() && !"-_~".contains(letter);
    Some(name.trim_end_matches(is_behind).to_owned())
}
