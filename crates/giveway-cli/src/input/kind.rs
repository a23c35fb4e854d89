//! What a text holds, as the recogniser of the model tells it.

use giveway_formats::{Format, movingai, recognise};

use super::Source;

/// What a text holds. How formats are told apart is the model's business.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    /// A MovingAI scenario.
    Scenario,
    /// A MovingAI map.
    Map,
    /// JSON of the project's own: an instance, a plan, changes or a result.
    Native,
    /// A plan, an instance or both in a format of others, or nothing that is known, which
    /// its reader then refuses.
    Foreign,
}

impl Kind {
    /// What the source holds, by its text alone.
    pub(crate) fn of(source: &Source) -> Self {
        match recognise(&source.text) {
            Ok(Format::MovingAi) if movingai::is_scenario(&source.text) => Self::Scenario,
            Ok(Format::MovingAi) => Self::Map,
            Ok(Format::Giveway) => Self::Native,
            Ok(_) | Err(_) => Self::Foreign,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(name: Option<&str>, text: &str, expect: Kind) {
        let source = Source {
            path: name.map(Into::into),
            name: String::new(),
            text: text.to_owned(),
            note: None,
        };
        assert_eq!(Kind::of(&source), expect, "{name:?} {text:?}");
    }

    #[test]
    fn the_text_tells_whatever_the_name_is() {
        check(Some("a.SCEN"), "{}", Kind::Native);
        check(Some("version.json"), "version 1\n", Kind::Scenario);
        check(None, "version 1\n", Kind::Scenario);
        check(Some("a.txt"), "\ntype octile\n", Kind::Map);
        check(Some("a.txt"), "height 1\nwidth 2\nmap\n..\n", Kind::Map);
        check(None, "noise", Kind::Foreign);
        check(Some("a.map"), "...\n.#.\n", Kind::Foreign);
        check(None, r#"{ "giveway": 1, "paths": {} }"#, Kind::Native);
    }
}
