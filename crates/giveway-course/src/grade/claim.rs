//! What a file claims beside what is so.

use super::Judgement;
use crate::handin::Work;

/// What a file claims of a task, beside what it is judged to be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Claim {
    /// It claims nothing: not solved, or not tried.
    None,
    /// It says that the task is solved, and nothing speaks against it.
    Solved,
    /// It says that the task is solved, and it is not.
    False,
}

impl Claim {
    /// What a file claims of a task; of one that is not judged yet, or not decided, no
    /// claim is false.
    pub fn of(work: Option<&Work>, judgement: Option<&Judgement>) -> Self {
        let says = work.is_some_and(|work| work.solved);
        match judgement {
            _ if !says => Self::None,
            Some(Judgement::NotSolved(_) | Judgement::NotTried) => Self::False,
            Some(Judgement::Solved(_) | Judgement::Undecided(_)) | None => Self::Solved,
        }
    }
}
