//! Why a request was refused.

use borsh::{BorshDeserialize, BorshSerialize};
use giveway_model::{Fault, check::Violation, question::Misfit};
use serde::{Deserialize, Serialize};

/// Why a request was refused.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
#[serde(tag = "refusal", rename_all = "kebab-case")]
pub enum Refusal {
    /// The scene is no instance of the problem; there is at least one fault.
    Scene {
        /// Every fault, with its place in the scene.
        faults: Vec<Fault>,
    },
    /// The request asks for something that does not exist.
    Request {
        /// The fault: found, and expected.
        fault: Fault,
    },
    /// Changes contradict the world as the plan has it.
    Changes {
        /// The faults, each with its place in the changes.
        faults: Vec<Fault>,
    },
    /// The plan that is asked about is none.
    Plan {
        /// Every rule that it breaks.
        violations: Vec<Violation>,
    },
    /// The question cannot be asked of the plan.
    Question {
        /// Why the question does not fit the plan, and which questions do.
        misfit: Misfit,
    },
}

impl Refusal {
    /// The faults in sentences or phrases, one each.
    pub fn sentences(&self) -> Vec<String> {
        match self {
            Self::Scene { faults } | Self::Changes { faults } => {
                faults.iter().map(ToString::to_string).collect()
            }
            Self::Request { fault } => vec![fault.to_string()],
            Self::Plan { violations } => violations.iter().map(|v| v.message.clone()).collect(),
            Self::Question { misfit } => vec![misfit.to_string()],
        }
    }
}

impl Refusal {
    /// The faults of the request, each with its place in it.
    pub fn faults(self) -> Vec<Fault> {
        let in_part = |faults: Vec<Fault>, part| -> Vec<Fault> {
            let faults = faults.into_iter();
            faults.map(|fault| fault.of_part(part)).collect()
        };
        match self {
            Self::Scene { faults } => in_part(faults, "scene"),
            Self::Changes { faults } => in_part(faults, "changes"),
            Self::Request { fault } => vec![fault],
            Self::Plan { violations } => violations
                .into_iter()
                .map(|violation| {
                    // It is a sentence, so it is quoted.
                    let found = format!("\"{}\"", violation.message);
                    Fault::at("plan", found, "a plan that breaks no rule")
                })
                .collect(),
            Self::Question { misfit } => vec![misfit.fault().of_part("question")],
        }
    }
}
