//! The heights within a lane: for a few agents, for many, for two plans.

/// The heights within a lane, in pixels from its top.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Row {
    /// The height of the lane.
    pub height: f64,
    /// The top of the bars.
    pub bar: f64,
    /// The height of the bars.
    pub thick: f64,
    /// The top of the battery's line.
    pub level: f64,
    /// The height of the battery's line.
    pub tall: f64,
}

/// Lanes are lower from this many agents on.
const DENSE_FROM: usize = 4;
/// From this many agents on they have no room for batteries.
const MANY_FROM: usize = 9;

impl Row {
    /// Room for a few agents.
    pub const WIDE: Self = Self {
        height: 52.0,
        bar: 8.0,
        thick: 14.0,
        level: 27.0,
        tall: 20.0,
    };
    /// Room for many.
    pub const DENSE: Self = Self {
        height: 36.0,
        bar: 6.0,
        thick: 12.0,
        level: 21.0,
        tall: 11.0,
    };

    /// Of a crowd: room for the bars alone.
    pub const MANY: Self = Self {
        height: 26.0,
        bar: 7.0,
        thick: 12.0,
        level: 25.0,
        tall: 0.0,
    };
    /// The lane of the agent selected, above those of a crowd.
    pub const PINNED: Self = Self {
        height: 44.0,
        bar: 8.0,
        thick: 12.0,
        level: 25.0,
        tall: 14.0,
    };

    /// Half of a lane that shows two plans; batteries have no room there.
    pub const HALF: Self = Self {
        height: 26.0,
        bar: 7.0,
        thick: 12.0,
        level: 26.0,
        tall: 0.0,
    };

    /// Where nobody has a battery.
    pub const BARE: Self = Self {
        height: 32.0,
        bar: 10.0,
        thick: 12.0,
        level: 22.0,
        tall: 0.0,
    };

    /// Of so many agents, so many of them with a battery.
    pub const fn of(agents: usize, batteries: usize) -> Self {
        match (agents, batteries) {
            (MANY_FROM.., _) => Self::MANY,
            (_, 0) => Self::BARE,
            (..DENSE_FROM, _) => Self::WIDE,
            _ => Self::DENSE,
        }
    }

    /// The class of its lanes in the style sheet.
    pub fn class(&self) -> Option<&'static str> {
        match self {
            row if *row == Self::BARE => Some("bare"),
            row if *row == Self::DENSE => Some("dense"),
            row if *row == Self::HALF => Some("two"),
            row if *row == Self::MANY => Some("many"),
            _ => None,
        }
    }

    /// The middle of the bars.
    pub const fn middle(&self) -> f64 {
        self.bar + self.thick / 2.0
    }
}
