//! `README.md`: what was proved, for people.

use std::fmt::Write as _;

use giveway_model::words::{count, name as name_of, values};
use giveway_model::{Cost, Instance};

use super::manifest::{Entry, Manifest, Method};
use super::proof_files;
use crate::lemma::Least;
use crate::{conclude::conclude, escape};

/// The text; it follows from the manifest and the instance.
pub(crate) fn text(manifest: &Manifest, instance: &Instance) -> String {
    let grid = instance.grid();
    let name = if instance.name().is_empty() {
        "an unnamed instance"
    } else {
        instance.name()
    };
    // A name is a person's text: no line break or mark of it may look like this one's.
    let name = escape::text(name).replace('`', "'");
    let objective = manifest.objective.costs().iter();
    let objective: Vec<&str> = objective.map(|&cost| name_of(cost)).collect();
    let mut text = format!(
        "# Certificate\n\nAbout `{name}`: {} x {} cells, {}, for plans that minimise {}.\n",
        grid.width(),
        grid.height(),
        count(instance.agents().len(), "robot"),
        objective.join(", then "),
    );
    text.push_str(&rules(instance));
    text.push_str("\n## What is claimed\n\n");
    if let Some(costs) = &manifest.costs {
        let is_listed =
            |cost: &&Cost| Cost::USUAL.contains(cost) || manifest.objective.costs().contains(cost);
        let _ = writeln!(
            text,
            "- **There is a plan** that keeps every rule: `plan.json`. Its costs: {}.",
            values(Cost::ALL.iter().filter(is_listed), costs)
        );
    }
    for entry in &manifest.claims {
        let claim = entry.claim();
        let _ = write!(text, "- **{}** ", escape::markdown(&claim.sentence()));
        shown_by(&mut text, entry, instance);
        text.push('\n');
    }
    if manifest.claims.is_empty() {
        text.push_str("- Nothing is claimed to be impossible: no cost can be below 0.\n");
    }
    // Where there is no plan, the claims say it all.
    let together = conclude(&manifest.objective, manifest.costs, &manifest.claims);
    if manifest.costs.is_some()
        && let Some(together) = together
    {
        let _ = writeln!(text, "\n{}", together.sentence());
    }
    text.push_str(HOW);
    text
}

/// What a claim rests on.
fn shown_by(text: &mut String, entry: &Entry, instance: &Instance) {
    match entry {
        Entry::Proof {
            name,
            variables,
            clauses,
            ..
        } => {
            let [cnf, drat, names] = proof_files(name);
            let _ = write!(
                text,
                "*A proof that can be checked:* `{cnf}` says that there is such a plan ({}, {}; \
                 `{names}` tells what they mean), `{drat}` proves that nothing satisfies it.",
                count(*variables, "variable"),
                count(*clauses, "clause"),
            );
            text.push_str(horizon(entry, instance).as_str());
        }
        Entry::Lemmas {
            name,
            least,
            lemmas,
            ..
        } => {
            let [cnf, drat, _] = proof_files(name);
            let _ = write!(
                text,
                "*Proofs of lemmas that can be checked:* each is about some robots alone, with a \
                 formula and a proof of its own. `{cnf}` says that they leave room for such a plan, \
                 beyond {}; `{drat}` proves that nothing satisfies it.",
                match least {
                    Least::Distance => "the steps that each goal is away",
                    Least::Search => {
                        "what each robot needs alone, which rests on a search of it on the map"
                    }
                }
            );
            for proved in lemmas {
                let _ = write!(
                    text,
                    "\n  - `{}`: {}",
                    proved.name,
                    escape::markdown(&proved.lemma.sentence())
                );
            }
        }
        Entry::Search { method, .. } => {
            text.push_str("*No proof: it rests on search.* ");
            text.push_str(match method {
                Method::Alone => {
                    "For each robot alone on the map, a search found the least that it needs."
                }
                Method::Joint => {
                    "A search went through all states of all robots together; no state that \
                     can be reached ends such a plan."
                }
                Method::Counting => {
                    "Some robots have to pass where only so many can be at a time; the time \
                     that they need there, one after the other, was counted."
                }
            });
            text.push_str(" To check it, a program other than the solver searches again.");
        }
        Entry::None { why, .. } => {
            let _ = write!(text, "*Not certified.* {}", why.sentence());
        }
    }
}

/// The rules of the scene's own, a line each.
fn rules(instance: &Instance) -> String {
    let mut text = String::new();
    for rule in instance.constraints_in_force() {
        if text.is_empty() {
            text.push_str(RULES);
        }
        let sentence = escape::markdown(&rule.constraint.sentence());
        let _ = write!(text, "- Rule {}: {sentence}.", rule.index);
        if let Some(name) = &rule.constraint.name {
            let name = escape::text(name).replace('`', "'");
            let _ = write!(text, " It is called `{name}`.");
        }
        text.push('\n');
    }
    text
}

const RULES: &str = "
## Rules of the scene's own

Every plan keeps these as well. Rules that name a cost forbid nothing: what they cost is the penalty
of a plan. A rule has the number of its place in the list of `instance.json`, from 0; rules that are
off are not listed.

";

/// Why a formula up to some makespan is enough.
fn horizon(entry: &Entry, instance: &Instance) -> String {
    let claim = entry.claim();
    if claim.most.contains_key(&Cost::Makespan) || claim.within.is_some() {
        return String::new();
    }
    claim.horizon(instance).map_or(String::new(), |last| {
        format!(
            " It covers plans of makespan at most {last}: a longer plan has a higher sum of costs, \
             because every other robot needs at least as many steps as its goal is cells away."
        )
    })
}

const HOW: &str = "
## How to check it

    giveway verify FOLDER

checks the fingerprints of all files, checks the plan against the rules, writes every formula again
from `instance.json` and compares it byte for byte, checks every proof, and repeats every search. It
does not use the solver that found the plan and the bounds.

Formulas are in the format DIMACS CNF, proofs are in the standard format DRAT as text, so other
programs can check them, too. A program that takes deletions of unit clauses literally must be told
not to:

    drat-trim NAME.cnf NAME.drat
    rate --skip-unit-deletions NAME.cnf NAME.drat

To see that a formula says what is claimed, read its list of names, or the source of the program
that writes it. It follows the rules of the problem one by one, and leaves out only the cells and
times at which a robot cannot be because its start or its goal is too many cells away.

`manifest.json` says the same for programs, with the SHA-256 fingerprint of every file.
";
