//! A claim shown by lemmas: those that hold are proved, then that they are enough.

use std::collections::{BTreeMap, BTreeSet};

use giveway_model::{Cost, Instance};

use super::choose::Chooser;
use super::refine::{Excluded, can_refine};
use super::{Hint, LEMMA, Least, Lemma, ProvedLemma};
use crate::plain::{self, Cnf};
use crate::show::Keep;
use crate::{Budget, Claim, Outcome, prove};

/// How often further lemmas are looked for: some half minute for fifty robots.
const ROUNDS: usize = 100;
/// The most bytes of the proof of a lemma that is tried before a weaker one.
const SMALL_PROOF: usize = 2 << 20;
/// The most bytes of the proof of a lemma, as a share of a whole proof.
const SHARE: usize = 4;

/// Which lemmas are tried.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Effort {
    /// Those that the cores of the search suggest, each about its own agents: soon done.
    Suggested,
    /// Further ones, until they are enough.
    Further,
}

/// What shows a claim by lemmas.
pub(crate) struct Shown {
    /// The lemmas.
    pub(crate) lemmas: Vec<ProvedLemma>,
    /// What they add to.
    pub(crate) least: Least,
    /// That they are enough: the formula, and its proof.
    pub(crate) formula: Cnf,
    pub(crate) proof: Vec<u8>,
}

/// The lemmas that were proved for the claims of one certificate, so that none is proved twice.
#[derive(Default)]
pub(crate) struct Pool {
    proved: BTreeMap<Lemma, Proved>,
    /// Those that do not hold, or whose proof takes too much.
    failed: BTreeSet<Lemma>,
}

struct Proved {
    entry: ProvedLemma,
    /// The instance of its agents, the formula and the proof, until they are kept.
    files: Option<(Instance, Cnf, Vec<u8>)>,
}

impl Pool {
    /// Shows a claim about a cost by lemmas, those of claims before among them; `None` where what is guessed
    /// is not enough, or not proved within the budget.
    pub(crate) fn show(
        &mut self,
        (instance, claim, cost): (&Instance, &Claim, Cost),
        (hints, effort): (&[Hint], Effort),
        budget: &Budget<'_>,
        keep: &mut Keep<'_>,
    ) -> Option<Shown> {
        let mut chooser = Chooser::new((instance, claim, cost), hints, budget);
        let least = chooser.by()?;
        let of = (instance, claim, least);
        let most = budget.proof_bytes / SHARE;
        let needs_further = effort == Effort::Further && chooser.may_need_further_agents();
        for hint in chooser.cores() {
            let lemma = chooser.of_core(hint);
            let is_proved = lemma.is_some_and(|lemma| {
                self.proved.contains_key(&lemma) || self.prove(instance, lemma, most, budget)
            });
            if is_proved || !needs_further || !hint.is_clause {
                continue;
            }
            let lemmas: Vec<&Lemma> = self.proved.keys().collect();
            if let Some(lemma) = chooser.with_further_agents(hint, (least, &lemmas)) {
                self.prove(instance, lemma, most, budget);
            }
        }
        let mut enough = self.together(of, budget);
        if enough.is_none() && effort == Effort::Further && can_refine(instance, claim) {
            self.refine(of, &mut chooser, budget);
            enough = self.together(of, budget);
        }
        if enough.is_none() && effort == Effort::Further {
            for lemma in chooser.of_groups()? {
                self.prove(instance, lemma, most, budget);
            }
            enough = self.together(of, budget);
        }
        let (formula, proof) = enough?;
        Some(Shown {
            lemmas: self.keep(keep),
            least,
            formula,
            proof,
        })
    }

    /// That the lemmas show a claim, if they do: the formula that puts them together, and its proof.
    fn together(
        &self,
        (instance, claim, least): (&Instance, &Claim, Least),
        budget: &Budget<'_>,
    ) -> Option<(Cnf, Vec<u8>)> {
        let lemmas: Vec<&Lemma> = self.proved.keys().collect();
        if lemmas.is_empty() {
            return None;
        }
        let formula = plain::of_lemmas(instance, claim, (least, &lemmas), budget).ok()?;
        match prove(&formula, budget) {
            Outcome::Proof(proof) => Some((formula, proof)),
            Outcome::Satisfiable | Outcome::Stopped => None,
        }
    }

    /// Adds lemmas until they are enough, or none is found any more.
    fn refine(
        &mut self,
        (instance, claim, by): (&Instance, &Claim, Least),
        chooser: &mut Chooser<'_>,
        budget: &Budget<'_>,
    ) -> Option<()> {
        let (_, refining) = chooser.refining()?;
        let is_sum = claim.most.contains_key(&Cost::SumOfCosts);
        for _ in 0..ROUNDS {
            let lemmas: Vec<&Lemma> = self.proved.keys().collect();
            let formula = plain::of_lemmas(instance, claim, (by, &lemmas), budget).ok()?;
            let arrivals = refining.left(&formula)?;
            let before = self.proved.len();
            let all = refining.excluded(&arrivals)?;
            for Excluded { lemma, late } in all {
                let agents: Vec<String> = lemma.by.keys().cloned().collect();
                self.prove(instance, lemma, budget.proof_bytes / SHARE, budget);
                // That they are so late in all, however that is divided, says more.
                let mut more = late.saturating_add(1);
                while is_sum
                    && agents.len() > 1
                    && self.prove(instance, chooser.count(&agents, more)?, SMALL_PROOF, budget)
                {
                    more = more.saturating_add(1);
                }
            }
            if self.proved.len() == before {
                return None;
            }
        }
        None
    }

    /// Proves a lemma, where it holds and that does not take too much; whether it is proved now.
    fn prove(
        &mut self,
        instance: &Instance,
        lemma: Lemma,
        proof_bytes: usize,
        budget: &Budget<'_>,
    ) -> bool {
        if self.proved.contains_key(&lemma) || self.failed.contains(&lemma) {
            return false;
        }
        let budget = Budget {
            proof_bytes,
            ..*budget
        };
        let scene = lemma.scene(instance);
        let formula = scene.and_then(|scene| {
            let formula = plain::of_lemma(&scene, &lemma, &budget).ok()?;
            Some((scene, formula))
        });
        let Some((scene, formula)) = formula else {
            self.failed.insert(lemma);
            return false;
        };
        let Outcome::Proof(proof) = prove(&formula, &budget) else {
            self.failed.insert(lemma);
            return false;
        };
        let entry = ProvedLemma {
            lemma: lemma.clone(),
            name: format!("{LEMMA}{}", self.proved.len() + 1),
            variables: formula.variables(),
            clauses: formula.clauses(),
        };
        let files = Some((scene, formula, proof));
        self.proved.insert(lemma, Proved { entry, files });
        true
    }

    /// All lemmas that are proved, their files kept.
    fn keep(&mut self, keep: &mut Keep<'_>) -> Vec<ProvedLemma> {
        let mut lemmas = Vec::new();
        for proved in self.proved.values_mut() {
            if let Some((scene, formula, proof)) = proved.files.take() {
                keep(&proved.entry.name, &scene, &formula, proof);
            }
            lemmas.push(proved.entry.clone());
        }
        lemmas
    }
}
