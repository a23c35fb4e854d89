//! How much is drawn, by the size of a cell on the screen.

/// The level of detail.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Detail {
    /// Agents are dots.
    Dots,
    /// Agents are forms, without names, rings or headings.
    Forms,
    /// All but labels and the axis.
    Plain,
    /// All.
    All,
}

impl Detail {
    /// The level for cells of this many pixels.
    ///
    /// ```
    /// use giveway_picture::Detail;
    /// assert_eq!(Detail::of(48.0), Detail::All);
    /// assert_eq!(Detail::of(47.9), Detail::Plain);
    /// ```
    pub fn of(cell_px: f64) -> Self {
        match cell_px {
            48.0.. => Self::All,
            28.0.. => Self::Plain,
            14.0.. => Self::Forms,
            _ => Self::Dots,
        }
    }

    /// Its class in the style sheets.
    pub const fn class(self) -> &'static str {
        match self {
            Self::Dots => "d-dots",
            Self::Forms => "d-forms",
            Self::Plain => "d-plain",
            Self::All => "d-all",
        }
    }
}
