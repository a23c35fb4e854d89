//! The exit status, fixed in this one place.

use std::process::ExitCode;

/// How the command ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Exit {
    /// 0: the question was answered; impossible is an answer, feasible too.
    Answered,
    /// 1: the input is wrong, a check found violations, a certificate was
    /// rejected, or a result could not be written.
    Wrong,
    /// 2: the command line is wrong.
    Usage,
    /// 3: the budget ran out without any answer.
    Unknown,
    /// 130: Ctrl-C; the best plan so far is told, if there is one.
    Interrupted,
}

impl Exit {
    /// The exit status.
    pub(crate) const fn code(self) -> u8 {
        match self {
            Self::Answered => 0,
            Self::Wrong => 1,
            Self::Usage => 2,
            Self::Unknown => 3,
            Self::Interrupted => 130,
        }
    }
}

impl From<Exit> for ExitCode {
    fn from(exit: Exit) -> Self {
        Self::from(exit.code())
    }
}
