//! Why a claim has nothing to be shown by.

use giveway_model::tr;
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
    pub fn sentence(self) -> &'static str {
        match self {
            Self::FormulaTooLarge => tr!("Its formula would be too large."),
            Self::NoHorizon => {
                tr!("It is about plans of any makespan, and no formula can cover them all.")
            }
            Self::NoAgent => tr!("It is about a robot that does not exist."),
            Self::Contradicted => {
                tr!(
                    "Its formula can be satisfied, which contradicts the claim: the solver or the formula is wrong."
                )
            }
            Self::ProofTooLarge => tr!("Its proof took too long or became too large."),
            Self::SearchTooLarge => tr!("The search for it was too large."),
        }
    }
}
