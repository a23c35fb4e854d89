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
}

impl From<Exit> for ExitCode {
    fn from(exit: Exit) -> Self {
        Self::from(match exit {
            Exit::Answered => 0,
            Exit::Wrong => 1,
            Exit::Usage => 2,
            Exit::Unknown => 3,
        })
    }
}
