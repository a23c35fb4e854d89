//! Certificates of answers: what an answer claims, proved again and checked by
//! what trusts no solver ([`giveway_proof`]).

mod export;
mod hints;
#[cfg(test)]
mod tests;

use std::collections::BTreeMap;

use borsh::{BorshDeserialize, BorshSerialize};
use giveway_model::message::read_map;
use giveway_model::{
    Cost, Instance, Objective, Plan, Question, Scene, check, format::from_object, sorting,
};
use giveway_proof::{Claim, Hint, Report, Solved, confirm};
use serde::{Deserialize, Serialize};

use crate::{
    Host, Limits, Progress, Refusal, SolveAnswer, Status,
    budget::Budget,
    explain::{ExplainAnswer, Verdict},
    trace::SearchTrace,
};

pub(crate) use export::export;
pub use export::{Certificate, ExportAnswer, ExportRequest};

/// Make a certificate of what was answered, and check it.
#[derive(
    Clone, Debug, Default, PartialEq, Serialize, Deserialize, BorshSerialize, BorshDeserialize,
)]
#[serde(deny_unknown_fields)]
pub struct CertifyRequest {
    /// The instance, unchecked.
    pub scene: Scene,
    /// The objective, where it is not the scene's own.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub objective: Option<Objective>,
    /// The scope of all claims: for the answer to a question, the contrasting plans.
    pub about: Claim,
    /// The lower bounds that were claimed, each given those of the costs before.
    #[borsh(deserialize_with = "read_map")]
    pub bounds: BTreeMap<Cost, u32>,
    /// Whether it was claimed that there is no plan.
    pub impossible: bool,
    /// Whether the claims hold whatever the horizon.
    pub complete: bool,
    /// The makespan up to which they hold, where they do not.
    pub within: Option<u32>,
    /// The plan that was answered, unchecked.
    pub plan: Option<Plan>,
    /// The cores by which the bounds were raised, as far as they are known: guesses for lemmas.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub hints: Vec<Hint>,
    /// The budget.
    #[serde(default, deserialize_with = "from_object")]
    pub limits: Limits,
}

impl CertifyRequest {
    /// The claims of the answer for a scene.
    pub fn of_solved(scene: Scene, objective: Option<Objective>, answer: &SolveAnswer) -> Self {
        Self {
            scene,
            objective,
            about: Claim::default(),
            bounds: answer.bounds.clone(),
            impossible: answer.status == Status::Impossible,
            complete: answer.reach.is_complete(),
            within: answer.reach.within(),
            plan: answer.plan.clone(),
            hints: Vec::new(),
            limits: Limits::default(),
        }
    }

    /// The same with guesses for lemmas, by the steps of the search, where they are known.
    #[must_use]
    pub fn with_hints(mut self, trace: Option<&SearchTrace>) -> Self {
        self.hints = hints::hints(trace);
        self
    }

    /// The claims of the answer to a question about a plan: no other plan of that kind exists, or the best of
    /// them costs no less than the one shown. The instance has the objective of the answer. An answer about a
    /// world that changed has no claims: certificates are about one world.
    pub fn of_explained(instance: &Instance, plan: Option<&Plan>, answer: &ExplainAnswer) -> Self {
        if answer.since.is_some() {
            return Self {
                scene: instance.to_scene(),
                ..Self::default()
            };
        }
        let question = &answer.question;
        let plan = plan.or(answer.plan.as_ref());
        let contrast = plan.and_then(|plan| Claim::contrast(question, instance, plan));
        // Where a question is about one plan only, that one is the best, or another.
        let shown = answer.alternative.as_ref().or(match question {
            Question::Plan => plan.filter(|_| answer.verdict == Verdict::Needless),
            _ => None,
        });
        let costs = shown.and_then(|plan| check::costs(instance, plan));
        let known = costs.filter(|_| answer.verdict != Verdict::Unknown);
        let bounds = known.map_or(BTreeMap::new(), |costs| {
            let objective = instance.in_force(instance.objective().clone());
            let each = objective.costs().iter();
            sorting::map(each.map(|&cost| (cost, costs.get(cost))))
        });
        Self {
            scene: instance.to_scene(),
            objective: None,
            impossible: answer.verdict == Verdict::Necessary
                && (contrast.is_some() || *question == Question::Unsolvable),
            // A contrast below 0 is none: nothing is then claimed to be checked.
            about: contrast.unwrap_or_default(),
            bounds,
            complete: answer.reach.is_complete(),
            within: answer.reach.within(),
            plan: shown.cloned(),
            hints: Vec::new(),
            limits: Limits::default(),
        }
    }

    /// The instance, with the objective of the request.
    ///
    /// # Errors
    /// What is wrong with the scene.
    pub(crate) fn instance(&self) -> Result<Instance, Refusal> {
        crate::assumed::refuse_moving(&self.scene)?;
        let instance = Instance::new(self.scene.clone());
        let instance = instance.map_err(|faults| Refusal::Scene { faults })?;
        Ok(match &self.objective {
            Some(objective) => instance.with_objective(objective.clone()),
            None => instance,
        })
    }

    /// The claims, as certificates are made of them. The instance is that of the
    /// scene, with the objective of the request.
    pub fn claims<'a>(&'a self, instance: &'a Instance) -> Solved<'a> {
        Solved {
            instance,
            about: self.about.clone(),
            bounds: &self.bounds,
            impossible: self.impossible,
            complete: self.complete,
            within: self.within,
            plan: self.plan.as_ref(),
            hints: &self.hints,
        }
    }
}

/// A certificate, made and checked at once. What cannot be proved again within
/// half of the time is part of the report, and said not to be.
pub(crate) fn certify(request: &CertifyRequest, host: &dyn Host) -> Result<Report, Refusal> {
    let instance = request.instance()?;
    let solved = request.claims(&instance);
    Ok(within(
        (request.limits, &instance),
        host,
        |making, checking| confirm(&solved, making, checking),
    ))
}

/// Does what makes certificates and checks them, each within its budget: for making
/// them there is half of the time.
fn within<T>(
    (limits, instance): (Limits, &Instance),
    host: &dyn Host,
    work: impl FnOnce(&giveway_proof::Budget<'_>, &giveway_proof::Budget<'_>) -> T,
) -> T {
    let half = |seconds| 0.5 * seconds;
    let shorter = Limits {
        seconds: limits.seconds.map(half),
        ..limits
    };
    let (making, checking) = (Budget::new(host, shorter), Budget::new(host, limits));
    let tell = |checking| {
        move |claim: &Claim| {
            let claim = claim.sentence();
            host.progress(&Progress::Certifying { claim, checking });
        }
    };
    let (makes, checks) = (tell(false), tell(true));
    let size = size(&limits, instance);
    work(
        &giveway_proof::Budget {
            go_on: &|| making.check().is_ok(),
            tell: &makes,
            ..size
        },
        &giveway_proof::Budget {
            go_on: &|| checking.check().is_ok(),
            tell: &checks,
            ..size
        },
    )
}

/// The limits that fit into the memory, by the measured sizes of formulas, proofs and states while they are
/// written and checked.
fn size(limits: &Limits, instance: &Instance) -> giveway_proof::Budget<'static> {
    let whole = giveway_proof::Budget::default();
    let Some(memory) = limits.memory_bytes.and_then(|n| usize::try_from(n).ok()) else {
        return whole;
    };
    let state_bytes = if instance.is_constrained() {
        RULED_STATE_BYTES
    } else {
        STATE_BYTES
    };
    giveway_proof::Budget {
        clauses: whole.clauses.min(memory / CLAUSE_BYTES),
        proof_bytes: whole.proof_bytes.min(memory / PROOF_SHARE),
        states: whole.states.min(memory / state_bytes),
        ..whole
    }
}

const CLAUSE_BYTES: usize = 500;
const PROOF_SHARE: usize = 14;
const STATE_BYTES: usize = 800;
/// With what rules of the scene's own ask a state to remember.
const RULED_STATE_BYTES: usize = 1600;
