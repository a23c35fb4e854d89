//! What a person sets for the solver and for the page.

use crate::Colours;
use crate::changing::Choice;

/// What the solver is told beside the scene; the objective and the rules are
/// part of the scene itself.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// The horizon in time steps: only plans of at most this makespan count;
    /// `None` leaves it to the solver.
    pub within: Option<u32>,
    /// The time limit in seconds.
    pub seconds: u32,
    /// Whether every edit is solved at once.
    pub solve_on_change: bool,
    /// The methods to try where the world changes.
    pub methods: Choice,
    /// Whether all plans of the Pareto front are sought, where the objective has
    /// one.
    pub front: bool,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            within: None,
            seconds: 30,
            solve_on_change: false,
            methods: Choice::default(),
            front: false,
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
    pub const fn name(self) -> &'static str {
        match self {
            Self::System => "as the system has it",
            Self::Light => "light",
            Self::Dark => "dark",
        }
    }
}

/// What a phone shows below the board.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Tab {
    /// The agent or cell selected.
    Inspector,
    /// The lanes.
    #[default]
    Timeline,
    /// The plan table.
    Plan,
}

/// What is drawn over the map.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Layers {
    /// Ways behind and ahead.
    pub trails: bool,
    /// Cells shaded by how much they are used.
    pub heat: bool,
}

impl Default for Layers {
    fn default() -> Self {
        Self {
            trails: true,
            heat: false,
        }
    }
}

/// What is shown and how.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct View {
    /// What is drawn over the map.
    pub layers: Layers,
    /// Whether the camera goes with the agent selected.
    pub follow: bool,
    /// Whether the plan table is open.
    pub table: bool,
    /// Light or dark.
    pub theme: Theme,
    /// The colours of agents.
    pub colours: Colours,
    /// What a phone shows below the board.
    pub tab: Tab,
    /// Whether there is room for two boards side by side: else the other plan of
    /// an answer takes the place of this one.
    pub is_wide: bool,
}

impl Default for View {
    fn default() -> Self {
        Self {
            layers: Layers::default(),
            follow: false,
            table: true,
            theme: Theme::System,
            colours: Colours::default(),
            tab: Tab::Timeline,
            is_wide: false,
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
