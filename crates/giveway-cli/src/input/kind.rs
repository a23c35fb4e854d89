//! What a text holds.

use std::path::Path;

use giveway_model::format::foreign::{Format, recognise};
use serde::Deserialize;
use serde::de::IgnoredAny;

use super::Source;

/// What a text holds, as far as its name and its beginning tell. How the formats
/// of others are told apart is the model's business.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    /// A MovingAI scenario.
    Scenario,
    /// A MovingAI map.
    Map,
    /// A result of `solve`, with a planner or without, or of `change`, with or without a plan.
    Answer,
    /// A native plan.
    Plan,
    /// A plan, an instance or both in a format of others.
    Foreign,
    /// A native instance, or anything else, which its reader then refuses.
    Scene,
}

/// The keys that tell the native objects apart.
#[derive(Default, Deserialize)]
#[serde(default)]
struct Keys {
    paths: Option<IgnoredAny>,
    status: Option<IgnoredAny>,
    methods: Option<IgnoredAny>,
    planner: Option<IgnoredAny>,
}

impl Kind {
    /// What the source holds: by the ending of its name, else by its beginning.
    pub(crate) fn of(source: &Source) -> Self {
        match source.path.as_deref().and_then(ending).as_deref() {
            Some("scen") => Self::Scenario,
            Some("map") => Self::Map,
            Some("json") => match recognise(&source.text) {
                Ok(Format::MovingAi | Format::Giveway) | Err(_) => Self::of_json(&source.text),
                Ok(_) => Self::Foreign,
            },
            _ => Self::of_text(&source.text),
        }
    }

    fn of_text(text: &str) -> Self {
        match recognise(text) {
            Ok(Format::MovingAi) if text.trim_start().starts_with("version") => Self::Scenario,
            Ok(Format::MovingAi) => Self::Map,
            Ok(Format::Giveway) | Err(_) => Self::of_json(text),
            Ok(_) => Self::Foreign,
        }
    }

    fn of_json(text: &str) -> Self {
        let keys: Keys = serde_json::from_str(text).unwrap_or_default();
        if keys.status.is_some() || keys.methods.is_some() || keys.planner.is_some() {
            Self::Answer
        } else if keys.paths.is_some() {
            Self::Plan
        } else {
            Self::Scene
        }
    }
}

/// The ending of a file's name, in small letters.
fn ending(path: &Path) -> Option<String> {
    Some(path.extension()?.to_str()?.to_ascii_lowercase())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(name: Option<&str>, text: &str, expect: Kind) {
        let source = Source {
            path: name.map(Into::into),
            name: String::new(),
            text: text.to_owned(),
        };
        assert_eq!(Kind::of(&source), expect, "{name:?} {text:?}");
    }

    #[test]
    fn the_ending_tells_first() {
        check(Some("a.SCEN"), "{}", Kind::Scenario);
        check(Some("a.map"), "", Kind::Map);
        check(Some("version.json"), "version 1", Kind::Scene);
    }

    #[test]
    fn else_the_beginning_tells() {
        check(None, "version 1\n", Kind::Scenario);
        check(Some("a.txt"), "\ntype octile\n", Kind::Map);
        check(None, "noise", Kind::Scene);
    }

    #[test]
    fn native_objects_differ_by_their_keys() {
        check(
            None,
            r#"{ "giveway": 1, "map": [], "agents": [] }"#,
            Kind::Scene,
        );
        check(None, r#"{ "giveway": 1, "paths": {} }"#, Kind::Plan);
        check(
            None,
            r#"{ "status": "optimal", "plan": null }"#,
            Kind::Answer,
        );
        check(
            None,
            r#"{ "giveway": 1, "planner": "cbs", "plan": null }"#,
            Kind::Answer,
        );
    }
}
