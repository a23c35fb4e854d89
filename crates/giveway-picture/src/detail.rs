//! How much is drawn, by the size of a cell on the screen.

/// The level of detail.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Detail {
    /// Agents are dots.
    Dots,
    /// Agents are forms, without rings or headings; a number has room beside them only.
    Forms,
    /// Agents are forms with a number in them.
    Numbers,
    /// Agents are forms with their names.
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
    /// assert_eq!([27.9, 17.9, 11.9].map(Detail::of), [Detail::Numbers, Detail::Forms, Detail::Dots]);
    /// ```
    pub fn of(cell_px: f64) -> Self {
        match cell_px {
            48.0.. => Self::All,
            28.0.. => Self::Plain,
            18.0.. => Self::Numbers,
            12.0.. => Self::Forms,
            _ => Self::Dots,
        }
    }

    /// Whether robots lie above goals and waypoints: where cells are small, a mark in the corner of
    /// a cell would cover the name of the robot there.
    ///
    /// ```
    /// use giveway_picture::Detail;
    /// assert!(Detail::Numbers.covers_marks() && !Detail::All.covers_marks());
    /// ```
    pub fn covers_marks(self) -> bool {
        self < Self::All
    }

    /// Its classes in the style sheets.
    pub const fn class(self) -> &'static str {
        match self {
            Self::Dots => "d-dots",
            Self::Forms => "d-forms",
            Self::Numbers => "d-forms d-numbers",
            Self::Plain => "d-plain",
            Self::All => "d-all",
        }
    }
}
