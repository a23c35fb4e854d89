//! How full a battery is, in the three steps that the page colours.

/// How full a battery is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reserve {
    /// More than 40 %.
    Enough,
    /// At most 40 %.
    Low,
    /// At most 20 %.
    Critical,
}

impl Reserve {
    /// The step of a level.
    ///
    /// ```
    /// use giveway_page::Reserve;
    /// assert_eq!(Reserve::of(5, 10), Reserve::Enough);
    /// assert_eq!(Reserve::of(4, 10), Reserve::Low);
    /// assert_eq!(Reserve::of(2, 10), Reserve::Critical);
    /// ```
    pub const fn of(level: u32, capacity: u32) -> Self {
        let (level, capacity) = (level as u64, capacity as u64);
        if 5 * level <= capacity {
            Self::Critical
        } else if 5 * level <= 2 * capacity {
            Self::Low
        } else {
            Self::Enough
        }
    }

    /// Its class in the style sheets; none where there is enough.
    pub const fn class(self) -> Option<&'static str> {
        match self {
            Self::Enough => None,
            Self::Low => Some("mid"),
            Self::Critical => Some("low"),
        }
    }
}
