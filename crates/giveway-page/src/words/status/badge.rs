//! The badge before the sentence: an icon and one word.

/// What stands before the sentence: an icon and one word, never a colour alone.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Badge {
    /// No answer yet.
    Draft,
    /// The scene has a fault.
    Faulty,
    /// The solver works.
    Solving,
    /// It works on a question.
    Asking,
    /// It checks a proof.
    Checking,
    /// It looks for what must be so.
    Counting,
    /// What changes in the world is being listed.
    Changing,
    /// It looks for ways to go on.
    Adapting,
    /// Ways to go on are side by side; how many.
    Compared(u8),
    /// An agent is led by hand.
    Steering,
    /// A plan that went on where the world changed.
    Adopted,
    /// A plan, with a proof that none is better.
    Proved,
    /// No plan, with a proof.
    Impossible,
    /// A plan of a planner, of which less is proved.
    Found,
    /// The budget ran out.
    Stopped,
    /// An answer to what the scene was before.
    Stale,
    /// Files are being read.
    Reading,
    /// A file is being written or drawn.
    Saving,
    /// A plan of elsewhere that keeps every rule.
    Legal,
    /// A plan of elsewhere that breaks a rule.
    Illegal,
    /// A plan from elsewhere of which nothing was proved here.
    Shared,
}

impl Badge {
    /// The word on it.
    pub const fn word(self) -> &'static str {
        match self {
            Self::Draft => "Draft",
            Self::Faulty => "Problem",
            Self::Solving => "Solving",
            Self::Asking => "Asking",
            Self::Checking => "Checking",
            Self::Counting => "Counting",
            Self::Changing => "Changing",
            Self::Adapting => "Looking",
            Self::Compared(1) => "1 answer",
            Self::Compared(2) => "2 answers",
            Self::Compared(_) => "3 answers",
            Self::Steering => "Steering",
            Self::Adopted => "Adopted",
            Self::Proved => "Proved",
            Self::Found => "Plan",
            Self::Impossible => "Impossible",
            Self::Stopped => "Stopped",
            Self::Stale => "Stale",
            Self::Shared => "Shared",
            Self::Reading => "Reading",
            Self::Saving => "Saving",
            Self::Legal => "Legal",
            Self::Illegal => "Not legal",
        }
    }

    /// Its icon.
    pub const fn icon(self) -> &'static str {
        match self {
            Self::Draft | Self::Changing => "change",
            Self::Shared => "share",
            Self::Compared(_) => "compare",
            Self::Steering => "steer",
            Self::Adopted | Self::Legal | Self::Found => "check",
            Self::Solving
            | Self::Adapting
            | Self::Counting
            | Self::Stopped
            | Self::Reading
            | Self::Saving => "clock",
            Self::Asking => "question",
            Self::Checking => "search",
            Self::Proved => "proved",
            Self::Impossible | Self::Illegal => "cancel",
            Self::Faulty | Self::Stale => "warning",
        }
    }

    /// Its class in the style sheet.
    pub const fn class(self) -> &'static str {
        match self {
            Self::Draft | Self::Adopted | Self::Shared | Self::Found => "plain",
            Self::Solving
            | Self::Asking
            | Self::Checking
            | Self::Counting
            | Self::Changing
            | Self::Adapting
            | Self::Compared(_)
            | Self::Reading
            | Self::Saving
            | Self::Steering => "info",
            Self::Proved => "proved",
            Self::Legal => "fine",
            Self::Impossible | Self::Faulty | Self::Illegal => "bad",
            Self::Stopped | Self::Stale => "warn",
        }
    }
}
