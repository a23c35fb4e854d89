//! How what two tabs keep is related: told from the texts alone, so that nothing
//! has to be read and judged for it.

use super::book::HEAD;
use super::text::unescape;

/// How what another tab keeps stands to what this one does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kin {
    /// Both made the same.
    Same,
    /// The other goes on from what is here: nothing was edited here since.
    Ahead,
    /// What is here goes on from the other.
    Behind,
    /// Both went on, each its own way, with a scene of one name.
    Apart,
    /// They have nothing to do with each other.
    Strange,
}

/// The parts of a document that a person made. Answers are not among them: the
/// solver gives them again.
const MADE: [&str; 10] = [
    "map=", "name=", "rules=", "costs=", "agents=", "within=", "colours=", "looks=", "listed=",
    "own=",
];

/// How `theirs` stands to `ours`; both are what [`keep`](super::keep) wrote.
///
/// ```
/// use giveway_page::{Draft, State, link};
/// let text = link::keep(&State::new(Draft::default()));
/// assert_eq!(link::kin(&text, &text), link::Kin::Same);
/// assert_eq!(link::kin(&text, "?"), link::Kin::Strange);
/// ```
pub fn kin(ours: &str, theirs: &str) -> Kin {
    let (ours, theirs) = (moments(ours), moments(theirs));
    let (Some((here, past)), Some((there, their_past))) =
        (ours.split_first(), theirs.split_first())
    else {
        return Kin::Strange;
    };
    if here == there {
        return Kin::Same;
    }
    if name(here) != name(there) {
        return Kin::Strange;
    }
    match (their_past.contains(here), past.contains(there)) {
        (true, false) => Kin::Ahead,
        (false, true) => Kin::Behind,
        _ => Kin::Apart,
    }
}

/// The name of the scene that a text keeps; `None` where it keeps none.
pub fn title(text: &str) -> Option<String> {
    let moments = moments(text);
    let name = name(moments.first()?).unwrap_or_default();
    unescape(name.strip_prefix("name=").unwrap_or_default())
}

/// Whether a text is of a version that is newer than this page.
///
/// ```
/// assert!(giveway_page::link::is_newer("giveway-kept=3\n"));
/// assert!(!giveway_page::link::is_newer("giveway-kept=2\n"));
/// ```
pub fn is_newer(text: &str) -> bool {
    let head = text.lines().next().unwrap_or_default();
    match (
        head.strip_prefix("giveway-kept="),
        head.strip_prefix("giveway="),
    ) {
        (Some(_), _) => head != HEAD,
        (None, Some(document)) => !document.starts_with("1&"),
        (None, None) => false,
    }
}

/// Whether anything was ever done to what a text keeps: else there is nothing to
/// miss.
pub fn is_touched(text: &str) -> bool {
    text.lines().any(|line| line == "touched")
}

/// What was made of each document of a text, the present one first.
fn moments(text: &str) -> Vec<Vec<&str>> {
    let made = |part: &&str| MADE.iter().any(|key| part.starts_with(key));
    let mut lines = text.lines();
    if lines.next() != Some(HEAD) {
        return Vec::new();
    }
    let (mut parts, mut moments) = (Vec::new(), Vec::new());
    for line in lines {
        if let Some(part) = line.strip_prefix('=') {
            parts.push(part);
        } else if let Some(moment) = line.strip_prefix('+') {
            // Time and selection come first.
            let places = moment.split('.').skip(2);
            let own = places.filter_map(|place| parts.get(place.parse::<usize>().ok()?));
            moments.push(own.copied().filter(made).collect());
        }
    }
    moments
}

fn name<'a>(moment: &[&'a str]) -> Option<&'a str> {
    moment
        .iter()
        .copied()
        .find(|part| part.starts_with("name="))
}
