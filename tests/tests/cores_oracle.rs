//! Minimal sets against the oracle: with only the facts of a set there is no such
//! plan, and without any one of them there is.
//!
//! `GIVEWAY_RANDOM_CORES` sets how many sets are looked at (60 by default),
//! `GIVEWAY_RANDOM_SEED` the seed. The long run:
//!
//! ```text
//! GIVEWAY_RANDOM_CORES=1000 GIVEWAY_RANDOM_SEED=7 \
//!     cargo test --release -p giveway-tests --test cores_oracle -- --nocapture
//! ```
#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    clippy::panic,
    reason = "a test that cannot go on ends with a panic"
)]

use std::collections::BTreeMap;

use giveway_model::{Cost, Instance, Plan, Question};
use giveway_solve::explain::{Core, Fact, FactKind, Verdict};
use giveway_tests::oracle::{self, Contrast};
use giveway_tests::{answers, ask, environment, facts, questions, random, recount};

/// Labels that the oracle may make for one set of facts.
const CAP: usize = 300_000;

/// What is claimed to be impossible.
struct Claim<'a> {
    instance: &'a Instance,
    question: &'a Question,
    /// The plan asked about; none where an instance has no plan.
    plan: Option<&'a Plan>,
    /// The most that a plan may cost, where only dearer ones exist.
    at_most: Option<Vec<u32>>,
}

impl Claim<'_> {
    /// Whether there is a plan as asked for with only these facts; `None` where
    /// that is too large for the oracle.
    fn has_plan(&self, facts: &[Fact], within: Option<u32>) -> Option<bool> {
        let (scene, leniency) = facts::only(self.instance, self.question, facts);
        if scene.agents.is_empty() {
            return Some(self.holds_of_nobody());
        }
        let instance = Instance::new(scene).unwrap();
        let asked = oracle::Question {
            instance: &instance,
            within,
            cap: CAP,
        };
        let verdict = match self.plan {
            Some(plan) => asked.best_with_less(
                Contrast {
                    question: self.question,
                    plan,
                },
                &leniency,
            ),
            None => asked.best_without(&leniency),
        };
        match verdict {
            oracle::Verdict::Capped => None,
            oracle::Verdict::Impossible => Some(false),
            oracle::Verdict::Best(point) => {
                let dearer = self
                    .at_most
                    .as_ref()
                    .is_some_and(|most| point.vector > *most);
                Some(!dearer)
            }
        }
    }
}

impl Claim<'_> {
    /// Whether the plan of no agents, which costs nothing, is as asked for.
    fn holds_of_nobody(&self) -> bool {
        let costs = self.plan.map(recount::costs);
        let cheaper = |cost: Cost| costs.is_some_and(|costs| costs.get(cost) > 0);
        match self.question {
            Question::NoVisit { .. } => false,
            Question::Makespan => cheaper(Cost::Makespan),
            Question::SumOfCosts => cheaper(Cost::SumOfCosts),
            Question::Charges { .. } => cheaper(Cost::Charges),
            Question::Moves { .. } => cheaper(Cost::Moves),
            Question::Waits { .. } => cheaper(Cost::Waits),
            _ => true,
        }
    }
}

/// What was seen of the sets.
#[derive(Debug, Default)]
struct Seen {
    sets: u64,
    facts: BTreeMap<FactKind, u64>,
    verdicts: BTreeMap<&'static str, u64>,
    not_minimal: u64,
    too_large: u64,
}

impl Seen {
    /// Looks at one set; tells what is wrong with it.
    fn look(&mut self, verdict: &'static str, claim: &Claim, core: &Core) -> Vec<String> {
        let mut faults = Vec::new();
        match claim.has_plan(&core.facts, core.within) {
            None => {
                self.too_large += 1;
                return faults;
            }
            Some(true) => faults.push("there is a plan with all of them".to_owned()),
            Some(false) => {}
        }
        self.sets += 1;
        *self.verdicts.entry(verdict).or_default() += 1;
        if !core.minimal {
            self.not_minimal += 1;
            return faults;
        }
        for (i, fact) in core.facts.iter().enumerate() {
            let mut others = core.facts.clone();
            others.remove(i);
            // Where it needs longer than the horizon of the set, it is a plan.
            match claim.has_plan(&others, None) {
                None => self.too_large += 1,
                Some(true) => *self.facts.entry(fact.kind).or_default() += 1,
                Some(false) => faults.push(format!("not needed: {}", fact.text)),
            }
        }
        faults
    }
}

fn report(number: u64, claim: &Claim, core: &Core, faults: &[String]) {
    let scene = serde_json::to_string(&claim.instance.to_scene()).unwrap();
    println!("{number}: {scene}");
    println!("  {:?} {:?}", claim.question, claim.plan);
    println!("  {core:?}");
    for fault in faults {
        println!("  {fault}");
    }
}

#[test]
fn sets_of_answers_are_needed_as_a_whole() {
    let seed = environment::number("GIVEWAY_RANDOM_SEED", 5);
    let count = environment::number("GIVEWAY_RANDOM_CORES", 60);
    let (mut seen, mut wrong) = (Seen::default(), 0);
    for number in 0.. {
        if seen.sets + seen.too_large >= count {
            break;
        }
        let Some(case) = questions::random(seed, number) else {
            continue;
        };
        let answer = answers::in_full(&case);
        let costs = recount::costs(&case.plan).vector(case.instance.objective());
        let (verdict, at_most) = match answer.verdict {
            Verdict::Necessary => ("necessary", None),
            Verdict::Costly => ("costly", Some(costs)),
            _ => continue,
        };
        let Some(core) = &answer.core else { continue };
        let claim = Claim {
            instance: &case.instance,
            question: &case.question,
            plan: Some(&case.plan),
            at_most,
        };
        let faults = seen.look(verdict, &claim, core);
        if !faults.is_empty() {
            wrong += 1;
            report(number, &claim, core, &faults);
        }
    }
    println!("{seen:?}");
    assert_eq!(wrong, 0, "they are printed above");
    assert!(seen.too_large * 4 <= count, "{seen:?}");
    assert!(seen.not_minimal * 10 <= count, "{seen:?}");
    assert_eq!(seen.verdicts.len(), 2, "{seen:?}");
    assert!(seen.facts.len() >= 4, "{seen:?}");
}

#[test]
fn sets_of_instances_without_a_plan_are_needed_as_a_whole() {
    let seed = environment::number("GIVEWAY_RANDOM_SEED", 5);
    let count = environment::number("GIVEWAY_RANDOM_CORES", 60) / 2;
    let (mut seen, mut wrong) = (Seen::default(), 0);
    for number in 0.. {
        if seen.sets + seen.too_large >= count {
            break;
        }
        let instance = random::small(seed, number);
        let Some(answer) = ask::unsolvable(&instance) else {
            continue;
        };
        let Some(core) = &answer.core else { continue };
        let claim = Claim {
            instance: &instance,
            question: &Question::Unsolvable,
            plan: None,
            at_most: None,
        };
        let faults = seen.look("unsolvable", &claim, core);
        if !faults.is_empty() {
            wrong += 1;
            report(number, &claim, core, &faults);
        }
    }
    println!("{seen:?}");
    assert_eq!(wrong, 0, "they are printed above");
    assert!(seen.facts.len() >= 3, "{seen:?}");
    assert!(seen.not_minimal * 10 <= count, "{seen:?}");
}
