//! What a person sets, for all scenes.

use giveway_model::tr;

use crate::changing::Choice;
use crate::edit::Fill;

/// What a person sets, for all scenes; the objective, the rules and the horizon
/// belong to a scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// The time limit in seconds.
    pub seconds: u32,
    /// Whether every edit is solved at once.
    pub solve_on_change: bool,
    /// The methods to try where the world changes.
    pub methods: Choice,
    /// Whether all plans of the Pareto front are sought, where the objective has
    /// one.
    pub front: bool,
    /// What is strewn by chance next time.
    pub fill: Fill,
    /// Whether single letters are keys: speech input and shaky hands press them
    /// by accident (WCAG 2.1.4).
    pub letter_keys: bool,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            seconds: 30,
            solve_on_change: false,
            methods: Choice::default(),
            front: false,
            fill: Fill::default(),
            letter_keys: true,
        }
    }
}

/// Light, dark, or as the system has it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Theme {
    /// As the system has it.
    #[default]
    System,
    /// Light.
    Light,
    /// Dark.
    Dark,
}

impl Theme {
    /// The next one, so that every press but one changes what is seen: first
    /// the other one than the system's, then the system's own, then whichever
    /// the system has.
    ///
    /// ```
    /// use giveway_page::Theme;
    /// assert_eq!(Theme::System.next(true), Theme::Light);
    /// ```
    #[must_use]
    pub const fn next(self, system_is_dark: bool) -> Self {
        match (self, system_is_dark) {
            (Self::System, false) | (Self::Light, true) => Self::Dark,
            (Self::System, true) | (Self::Dark, false) => Self::Light,
            (Self::Light, false) | (Self::Dark, true) => Self::System,
        }
    }

    /// Its name in a sentence.
    pub fn name(self) -> &'static str {
        match self {
            Self::System => tr!("a theme" => "as the system has it"),
            Self::Light => tr!("a theme" => "light"),
            Self::Dark => tr!("a theme" => "dark"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn three_presses_come_back_and_the_first_is_seen() {
        for system_is_dark in [false, true] {
            let first = Theme::System.next(system_is_dark);
            let unlike = if system_is_dark {
                Theme::Light
            } else {
                Theme::Dark
            };
            assert_eq!(first, unlike);
            let second = first.next(system_is_dark);
            assert!(![Theme::System, first].contains(&second));
            assert_eq!(second.next(system_is_dark), Theme::System);
        }
    }
}
