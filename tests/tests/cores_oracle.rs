//! Minimal sets against the oracle: with only the facts of a set there is no such
//! plan, and with only the others of the set there is, for each of its facts. A fact
//! helps if and only if the whole instance without it has a plan. Where none helps,
//! the next set shares no fact with the first, wherever there is such a set.
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

use giveway_model::{Cost, Instance, Plan, Question, Scene};
use giveway_solve::explain::{Core, Fact, FactKind, Helps, Verdict};
use giveway_tests::oracle::{self, Contrast, Leniency};
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
        self.is_met(facts::only(self.instance, self.question, facts), within)
    }

    /// Whether there is one of the whole instance without some facts.
    fn has_plan_without(&self, facts: &[Fact], within: Option<u32>) -> Option<bool> {
        self.is_met(facts::without(self.instance, self.question, facts), within)
    }

    fn is_met(&self, (scene, leniency): (Scene, Leniency), within: Option<u32>) -> Option<bool> {
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
    helps: BTreeMap<Helps, u64>,
    further: u64,
    sharing: u64,
    not_minimal: u64,
    too_large: u64,
    too_large_parts: u64,
}

impl Seen {
    /// Looks at a set and the further ones; tells what is wrong with them.
    fn look(&mut self, verdict: &'static str, claim: &Claim, core: &Core) -> Vec<String> {
        let Some(mut faults) = self.look_at_set(claim, core) else {
            self.too_large += 1;
            return Vec::new();
        };
        self.sets += 1;
        *self.verdicts.entry(verdict).or_default() += 1;
        self.look_at_further(claim, core, &mut faults);
        faults
    }

    /// One set; `None` where it is too large.
    fn look_at_set(&mut self, claim: &Claim, core: &Core) -> Option<Vec<String>> {
        let mut faults = Vec::new();
        if claim.has_plan(&core.facts, core.reach.within())? {
            faults.push("there is a plan with all of them".to_owned());
        }
        for fact in &core.facts {
            *self.helps.entry(fact.helps).or_default() += 1;
            let left_out = std::slice::from_ref(fact);
            // What was only looked for within a horizon is claimed no further.
            let (claimed, within) = match fact.helps {
                Helps::Yes => (true, None),
                Helps::No => (false, core.reach.within()),
                Helps::Unknown => continue,
            };
            match claim.has_plan_without(left_out, within) {
                None => self.too_large_parts += 1,
                Some(has_plan) if has_plan == claimed => {}
                Some(_) => faults.push(format!("helps is wrong: {}", fact.text)),
            }
        }
        if !core.minimal {
            self.not_minimal += 1;
            return Some(faults);
        }
        for (i, fact) in core.facts.iter().enumerate() {
            let mut others = core.facts.clone();
            others.remove(i);
            // Where it needs longer than the horizon of the set, it is a plan.
            match claim.has_plan(&others, None) {
                None => self.too_large_parts += 1,
                Some(true) => *self.facts.entry(fact.kind).or_default() += 1,
                Some(false) => faults.push(format!("not needed: {}", fact.text)),
            }
        }
        Some(faults)
    }

    /// The further sets: each new, and without any fact of those before it where
    /// there is such a set.
    fn look_at_further(&mut self, claim: &Claim, core: &Core, faults: &mut Vec<String>) {
        let mut counted = core
            .facts
            .iter()
            .filter(|f| !matches!(f.kind, FactKind::Task | FactKind::Presence));
        if !core.further.is_empty() && counted.clone().any(|fact| fact.helps == Helps::Yes) {
            faults.push("a fact helps, and there are further sets".to_owned());
        }
        let none_helps = counted.clone().count() > 0 && counted.all(|f| f.helps == Helps::No);
        if none_helps && core.further.is_empty() {
            faults.push("no fact helps, and there is no further set".to_owned());
        }
        let mut earlier = core.facts.clone();
        for (i, further) in core.further.iter().enumerate() {
            self.further += 1;
            match self.look_at_set(claim, further) {
                None => self.too_large_parts += 1,
                Some(found) => faults.extend(found),
            }
            let has = |fact: &Fact| further.facts.contains(fact);
            if core.sets().take(i + 1).any(|set| set.facts.iter().all(has)) {
                faults.push("a further set has all facts of an earlier one".to_owned());
            }
            if earlier.iter().any(has) {
                self.sharing += 1;
                match claim.has_plan_without(&earlier, further.reach.within()) {
                    None => self.too_large_parts += 1,
                    Some(true) => {}
                    Some(false) => faults.push("a set that shares no fact is left".to_owned()),
                }
            }
            earlier.extend(further.facts.iter().cloned());
        }
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
        let instance = random::with_floor(random::small(seed, number), number);
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
    assert!(seen.facts.len() >= 4, "{seen:?}");
    assert!(seen.facts.contains_key(&FactKind::Floor), "{seen:?}");
    assert!(seen.further > 0 && seen.helps.len() >= 2, "{seen:?}");
    assert!(seen.not_minimal * 10 <= count, "{seen:?}");
}
