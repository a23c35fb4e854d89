//! What a person sets for the solver and for the page.

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
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            within: None,
            seconds: 30,
            solve_on_change: false,
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

/// What is shown and how.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct View {
    /// Whether ways behind and ahead are drawn.
    pub trails: bool,
    /// Whether the plan table is open.
    pub table: bool,
    /// The colours.
    pub theme: Theme,
    /// What a phone shows below the board.
    pub tab: Tab,
}

impl Default for View {
    fn default() -> Self {
        Self {
            trails: true,
            table: true,
            theme: Theme::System,
            tab: Tab::Timeline,
        }
    }
}
