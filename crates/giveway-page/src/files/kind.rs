//! What a file is.

use giveway_formats::movingai;

/// What a file is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// The project's own.
    Json,
    /// A MovingAI map.
    Map,
    /// A MovingAI scenario.
    Scenario,
    /// What the browser kept, downloaded.
    Kept,
}

impl Kind {
    /// By its text; what the browser kept, by its ending.
    pub(super) fn of(name: &str, text: &str) -> Self {
        if is_kept(name, text) {
            Self::Kept
        } else if movingai::is_map(text) {
            Self::Map
        } else if movingai::is_scenario(text) {
            Self::Scenario
        } else {
            Self::Json
        }
    }
}

/// Whether a file is what the browser kept, downloaded.
fn is_kept(name: &str, text: &str) -> bool {
    let ending = name.rsplit_once('.').map(|(_, ending)| ending);
    ending.is_some_and(|ending| ending.eq_ignore_ascii_case("giveway"))
        || text.trim_start().starts_with("giveway-kept=")
}

/// Whether the page reads a file by itself: a map or a scenario of the benchmark, or what
/// the browser kept. All others are for the reader.
pub(crate) fn is_read_here(name: &str, text: &str) -> bool {
    Kind::of(name, text) != Kind::Json
}
