//! Plans judged and claims shown a second time, wherever their proofs lie.

use std::collections::BTreeMap;

use giveway_model::{Costs, Instance, Plan, check, tr};

use crate::bundle::{Entry, MANIFEST, PLAN, proof_files};
use crate::drat::{self, Refused};
use crate::lemma::ProvedLemma;
use crate::plain::{self, Cnf, NoFormula};
use crate::report::{CheckedLemma, Fault};
use crate::{Budget, Checked, Claim, Least, Lemma};

/// A formula that a certificate names, with the size that it says.
pub(crate) struct Named<'a> {
    /// The name of its files, without their endings.
    pub(crate) name: &'a str,
    /// The instance that it is about.
    pub(crate) instance: &'a Instance,
    statement: Statement<'a>,
    variables: usize,
    clauses: usize,
}

/// The statement that a formula contradicts.
enum Statement<'a> {
    /// A claim, by the rules of the problem.
    Claim(&'a Claim),
    /// A lemma, likewise, of its agents alone.
    Lemma(&'a Lemma),
    /// A claim, given lemmas.
    Lemmas(&'a Claim, (Least, Vec<&'a Lemma>)),
}

impl Named<'_> {
    /// The formula, written again; its size must be the one that is said.
    pub(crate) fn formula(&self, budget: &Budget<'_>) -> Result<Cnf, Fault> {
        let formula = match &self.statement {
            Statement::Claim(claim) => plain::formula(self.instance, claim, budget),
            Statement::Lemma(lemma) => plain::of_lemma(self.instance, lemma, budget),
            Statement::Lemmas(claim, (least, lemmas)) => {
                plain::of_lemmas(self.instance, claim, (*least, lemmas), budget)
            }
        };
        let formula = formula.map_err(|error| match error {
            NoFormula::NoHorizon => Fault::of(
                MANIFEST,
                "a claim with a proof is about plans of any makespan",
            ),
            NoFormula::NoAgent => {
                Fault::of(MANIFEST, "a claim is about a robot that does not exist")
            }
            NoFormula::TooLarge => {
                let [cnf, ..] = proof_files(self.name);
                Fault::Stopped(tr!("{file}: it is too large to check.", file = cnf))
            }
        })?;
        if (self.variables, self.clauses) != (formula.variables(), formula.clauses()) {
            return Err(Fault::of(MANIFEST, "the size of a formula differs"));
        }
        Ok(formula)
    }
}

/// Checks a formula with its proof, and counts the steps that were needed.
pub(crate) type Steps<'a> = dyn Fn(&Named<'_>) -> Result<usize, Fault> + 'a;

/// The plan keeps the rules and costs what is said.
pub(crate) fn check_plan(
    instance: &Instance,
    plan: &Plan,
    costs: Option<Costs>,
) -> Result<(), Fault> {
    let report = check::check(instance, plan);
    if let Some(violation) = report.violations.first() {
        return Err(Fault::Rejected(format!("{PLAN}: {}", violation.message)));
    }
    if report.costs != costs {
        return Err(Fault::of(PLAN, "it does not cost what the manifest says"));
    }
    Ok(())
}

/// Checks each claim and puts it on the list; `steps` checks a proof and counts
/// the steps that were needed.
pub(crate) fn check_claims(
    instance: &Instance,
    entries: &[Entry],
    budget: &Budget<'_>,
    claims: &mut Vec<Checked>,
    steps: &Steps<'_>,
) -> Result<(), Fault> {
    let mut lemmas = CheckedLemmas::default();
    for entry in entries {
        (budget.tell)(entry.claim());
        claims.push(check_entry(instance, entry, budget, &mut lemmas, steps)?);
    }
    Ok(())
}

/// The lemmas that were checked, by the names of their files: claims share them.
#[derive(Default)]
struct CheckedLemmas<'a>(BTreeMap<&'a str, (&'a ProvedLemma, usize)>);

impl<'a> CheckedLemmas<'a> {
    /// The steps of the proof of a lemma, which is checked once.
    fn steps(
        &mut self,
        instance: &Instance,
        proved: &'a ProvedLemma,
        steps: &Steps<'_>,
    ) -> Result<usize, Fault> {
        if let Some(&(known, needed)) = self.0.get(proved.name.as_str()) {
            return if known == proved {
                Ok(needed)
            } else {
                Err(Fault::of(MANIFEST, "two lemmas have one name"))
            };
        }
        let of_agents = proved
            .lemma
            .scene(instance)
            .ok_or_else(|| Fault::of(MANIFEST, "a lemma is about a robot that does not exist"))?;
        let needed = steps(&Named {
            name: &proved.name,
            instance: &of_agents,
            statement: Statement::Lemma(&proved.lemma),
            variables: proved.variables,
            clauses: proved.clauses,
        })?;
        self.0.insert(&proved.name, (proved, needed));
        Ok(needed)
    }
}

fn check_entry<'a>(
    instance: &Instance,
    entry: &'a Entry,
    budget: &Budget<'_>,
    lemmas: &mut CheckedLemmas<'a>,
    steps: &Steps<'_>,
) -> Result<Checked, Fault> {
    let claim = entry.claim().clone();
    let text = claim.sentence();
    match entry {
        Entry::Proof {
            claim: of,
            name,
            variables,
            clauses,
        } => {
            let (variables, clauses) = (*variables, *clauses);
            let steps = steps(&Named {
                name,
                instance,
                statement: Statement::Claim(of),
                variables,
                clauses,
            })?;
            Ok(Checked::Proof {
                text,
                claim,
                variables,
                clauses,
                steps,
            })
        }
        Entry::Lemmas {
            claim: of,
            name,
            variables,
            clauses,
            least,
            lemmas: proved,
        } => {
            if of.within.is_some() || of.condition.is_some() {
                return Err(Fault::of(
                    MANIFEST,
                    "a claim that is not about all plans has lemmas",
                ));
            }
            let mut checked = Vec::new();
            for proved in proved {
                checked.push(CheckedLemma {
                    text: proved.lemma.sentence(),
                    lemma: proved.lemma.clone(),
                    variables: proved.variables,
                    clauses: proved.clauses,
                    steps: lemmas.steps(instance, proved, steps)?,
                });
            }
            let stated = proved.iter().map(|proved| &proved.lemma).collect();
            let steps = steps(&Named {
                name,
                instance,
                statement: Statement::Lemmas(of, (*least, stated)),
                variables: *variables,
                clauses: *clauses,
            })?;
            Ok(Checked::Lemmas {
                text,
                claim,
                least: *least,
                lemmas: checked,
                variables: *variables,
                clauses: *clauses,
                steps,
            })
        }
        Entry::Search { method, .. } => {
            // A search knows no horizon: it must be about plans of any makespan.
            let shown = match claim.within {
                Some(_) => Some(false),
                None => method.shows(instance, &claim, budget),
            };
            match shown {
                Some(true) => Ok(Checked::Search {
                    text,
                    claim,
                    method: *method,
                }),
                Some(false) => Err(Fault::Rejected(tr!(
                    "The search does not show: {text}",
                    text
                ))),
                None => Err(Fault::Stopped(tr!(
                    "The search ended too early to show: {text}",
                    text
                ))),
            }
        }
        Entry::None { why, .. } => Ok(Checked::None {
            text,
            claim,
            why: why.sentence().to_owned(),
        }),
    }
}

/// Checks a proof of a formula, which is called `file`.
pub(crate) fn check_proof(
    formula: &str,
    proof: &str,
    file: &str,
    budget: &Budget<'_>,
) -> Result<usize, Fault> {
    match drat::check(formula, proof, budget.go_on) {
        Ok(proved) => Ok(proved.steps),
        Err(Refused::Stopped) => Err(Fault::Stopped(tr!("{file}: the check was stopped.", file))),
        Err(refused) => Err(Fault::of(file, &refused.to_string())),
    }
}
