//! What an answer claims of the facts that it names, against the oracle.

use std::collections::BTreeMap;

use giveway_model::Instance;
use giveway_solve::explain::{ExplainAnswer, Fact, FactKind};
use giveway_tests::facts;
use giveway_tests::oracle::{self, Contrast, Leniency};

use super::CAP;
use super::course::Course;

/// What a set of facts claims of the rest.
pub(super) struct Claim<'a> {
    pub(super) course: &'a Course,
    pub(super) instance: &'a Instance,
    pub(super) contrast: Contrast<'a>,
    /// Who is broken down.
    pub(super) with: &'a Leniency,
    /// The most that a plan may cost, where only dearer ones exist.
    pub(super) most: Option<&'a Vec<u32>>,
}

impl Claim<'_> {
    /// Whether there is a plan as asked for with only these facts; `None` where
    /// the oracle cannot tell.
    fn has_plan(&self, facts: &[Fact], within: Option<u32>) -> Option<bool> {
        let question = self.contrast.question;
        let (scene, mut leniency) = facts::only(self.instance, question, facts);
        if scene.agents.is_empty() {
            return None;
        }
        leniency.transit = self.with.transit.clone();
        leniency.waited = self.with.waited.clone();
        let breakdowns = facts.iter().filter(|it| it.kind == FactKind::Breakdown);
        for name in breakdowns.flat_map(|fact| &fact.agents) {
            let held = self.with.held.get(name).copied();
            assert!(held.is_some(), "{name} {}", self.course.told());
            leniency.held.extend(held.map(|held| (name.clone(), held)));
        }
        let asked = oracle::Question {
            instance: &Instance::new(scene).ok()?,
            within,
            cap: CAP,
        };
        match asked.best_with_less(self.contrast, &leniency) {
            oracle::Verdict::Capped => None,
            oracle::Verdict::Impossible => Some(false),
            oracle::Verdict::Best(point) => {
                Some(self.most.is_none_or(|most| point.vector <= *most))
            }
        }
    }

    /// The facts rule a plan out, and where they are minimal, without any one of
    /// them there is one.
    pub(super) fn check(&self, answer: &ExplainAnswer, seen: &mut BTreeMap<&'static str, u64>) {
        let Some(core) = answer.core.as_ref().filter(|_| !self.with.held.is_empty()) else {
            return;
        };
        let about = || format!("{answer:?} {}", self.course.told());
        let within = core.reach.within().map(|within| within - self.course.at);
        let all = self.has_plan(&core.facts, within);
        assert_ne!(all, Some(true), "{}", about());
        let needed = core.facts.iter().filter(|_| core.minimal && all.is_some());
        for fact in needed {
            let others: Vec<Fact> = core
                .facts
                .iter()
                .filter(|it| *it != fact)
                .cloned()
                .collect();
            assert_ne!(
                self.has_plan(&others, None),
                Some(false),
                "{} {}",
                fact.text,
                about()
            );
            if fact.kind == FactKind::Breakdown {
                // A slow move under way comes first.
                let is_in_transit = |agent: &String| self.with.transit.contains_key(agent);
                let begins = self.course.at + u32::from(fact.agents.iter().any(is_in_transit));
                assert_eq!(fact.time, Some(begins), "{}", about());
                *seen.entry("a breakdown as a fact").or_default() += 1;
            }
        }
    }
}
