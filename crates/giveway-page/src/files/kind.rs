//! What a file is.

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
    /// By its ending; by how it begins where that is another.
    pub(super) fn of(name: &str, text: &str) -> Self {
        let ending = name.rsplit_once('.').map(|(_, ending)| ending);
        match ending.map(str::to_ascii_lowercase).as_deref() {
            Some("json") => Self::Json,
            Some("map") => Self::Map,
            Some("scen") => Self::Scenario,
            Some("giveway") => Self::Kept,
            _ if text.trim_start().starts_with("type ") => Self::Map,
            _ if text.trim_start().starts_with("version ") => Self::Scenario,
            _ => Self::Json,
        }
    }
}
