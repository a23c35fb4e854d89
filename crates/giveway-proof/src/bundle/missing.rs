//! Why a claim has nothing to be shown by.

use serde::{Deserialize, Serialize};

/// Why a claim has nothing to be shown by. A choice and no text, so that nothing
/// else can be said in its place.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Missing {
    /// The formula is larger than is written.
    FormulaTooLarge,
    /// The claim is about plans of any makespan.
    NoHorizon,
    /// The claim is about an agent that there is not.
    NoAgent,
    /// Something satisfies the formula: the solver or the formula is wrong.
    Contradicted,
    /// The proof took too long, or became too large.
    ProofTooLarge,
    /// The search became too large.
    SearchTooLarge,
}

impl Missing {
    /// The same as a sentence.
    pub const fn sentence(self) -> &'static str {
        match self {
            Self::FormulaTooLarge => "Its formula would be too large.",
            Self::NoHorizon => "It has no horizon.",
            Self::NoAgent => "It is about no agent.",
            Self::Contradicted => {
                "It contradicts the formula of certificates, which can be satisfied: \
                 the solver or the formula is wrong."
            }
            Self::ProofTooLarge => "The time or the size allowed for its proof ran out.",
            Self::SearchTooLarge => "The search for it was too large.",
        }
    }
}
