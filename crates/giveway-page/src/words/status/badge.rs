//! The badge before the sentence: an icon and one word.

use giveway_model::tr;

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
    /// The conflict tree is split by hand.
    ByHand,
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
    /// The plan as it is carried out when a robot is late.
    Late,
}

impl Badge {
    /// The word on it.
    pub fn word(self) -> &'static str {
        match self {
            Self::Draft => tr!("the status in a word" => "Draft"),
            Self::Faulty => tr!("the status in a word" => "Problem"),
            Self::Solving => tr!("the status in a word" => "Solving"),
            Self::Asking => tr!("the status in a word" => "Asking"),
            Self::Checking => tr!("the status in a word" => "Checking"),
            Self::Counting => tr!("the status in a word" => "Counting"),
            Self::Changing => tr!("the status in a word" => "Changing"),
            Self::Adapting => tr!("the status in a word" => "Looking"),
            Self::Compared(1) => tr!("the status in a word" => "1 answer"),
            Self::Compared(2) => tr!("the status in a word" => "2 answers"),
            Self::Compared(_) => tr!("the status in a word" => "3 answers"),
            Self::ByHand => tr!("the status in a word" => "By hand"),
            Self::Steering => tr!("the status in a word" => "Steering"),
            Self::Adopted => tr!("the status in a word" => "Adopted"),
            Self::Proved => tr!("the status in a word" => "Proved"),
            Self::Found => tr!("the status in a word" => "Plan"),
            Self::Impossible => tr!("the status in a word" => "Impossible"),
            Self::Stopped => tr!("the status in a word" => "Stopped"),
            Self::Stale => tr!("the status in a word" => "Stale"),
            Self::Shared => tr!("the status in a word" => "Shared"),
            Self::Late => tr!("the status in a word" => "Late"),
            Self::Reading => tr!("the status in a word" => "Reading"),
            Self::Saving => tr!("the status in a word" => "Saving"),
            Self::Legal => tr!("the status in a word" => "Legal"),
            Self::Illegal => tr!("the status in a word" => "Not legal"),
        }
    }

    /// Its icon.
    pub const fn icon(self) -> &'static str {
        match self {
            Self::Draft | Self::Changing => "change",
            Self::Shared => "share",
            Self::Compared(_) => "compare",
            Self::ByHand => "tree",
            Self::Steering => "steer",
            Self::Adopted | Self::Legal | Self::Found => "check",
            Self::Solving
            | Self::Adapting
            | Self::Counting
            | Self::Stopped
            | Self::Reading
            | Self::Late
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
            | Self::ByHand
            | Self::Steering => "info",
            Self::Proved => "proved",
            Self::Legal => "fine",
            Self::Impossible | Self::Faulty | Self::Illegal => "bad",
            Self::Stopped | Self::Stale | Self::Late => "warn",
        }
    }
}
