//! A plan as it plays: the time and the speed.

/// How fast a plan plays.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Speed {
    /// Half as fast.
    Half,
    /// One step in the time that the design gives it.
    #[default]
    One,
    /// Twice as fast.
    Two,
    /// Four times as fast.
    Four,
}

impl Speed {
    /// All, the slowest first.
    pub const ALL: [Self; 4] = [Self::Half, Self::One, Self::Two, Self::Four];

    /// The factor.
    pub const fn factor(self) -> f64 {
        match self {
            Self::Half => 0.5,
            Self::One => 1.0,
            Self::Two => 2.0,
            Self::Four => 4.0,
        }
    }

    /// As it stands on its button.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Half => "\u{bd}",
            Self::One => "1\u{d7}",
            Self::Two => "2\u{d7}",
            Self::Four => "4\u{d7}",
        }
    }
}

/// What is shown of the plan's time.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Playback {
    /// The step shown; between two steps while it plays, the one before.
    pub time: u32,
    /// Whether it plays.
    pub playing: bool,
    /// Whether it stopped because this very time was asked for: else what moves
    /// goes on to the end of its step.
    pub sought: bool,
    /// How fast.
    pub speed: Speed,
}

impl Playback {
    /// Stands still at a time that was asked for.
    pub(crate) const fn stop_at(&mut self, time: u32) {
        self.time = time;
        self.playing = false;
        self.sought = true;
    }
}
