//! Questions about a plan around which the world has changed, under rules of a scene's own:
//! the solver against joint states, exhausted from the time of the change on.
//!
//! What a question contrasts the plan with is a rule for the oracle, which is added at the
//! time of the change.
//!
//! `GIVEWAY_RULE_CHANGES` sets how many random changes each test compares,
//! `GIVEWAY_RANDOM_SEED` the seed.
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    clippy::print_stdout,
    reason = "a test that cannot go on ends with a panic"
)]

mod case;
mod claims;
mod contrast;

use std::collections::BTreeMap;

use case::Case;
use giveway_model::Question;
use giveway_solve::explain::{ExplainAnswer, Verdict};
use giveway_tests::environment;
use giveway_tests::rules_oracle::Answer;
use giveway_tests::rules_random::KINDS;

fn count(usual: u64) -> u64 {
    environment::number("GIVEWAY_RULE_CHANGES", usual)
}

/// Three kinds of rules: two of the scene, one that may begin with the change.
fn kinds(number: u64) -> [&'static str; 3] {
    let k = number as usize;
    let kind = |which: usize| KINDS[which % KINDS.len()];
    [kind(k / 14 + k), kind(k / 3), kind(k)]
}

#[derive(Default)]
struct Seen(BTreeMap<String, u64>);

impl Seen {
    fn note(&mut self, what: impl Into<String>) {
        *self.0.entry(what.into()).or_default() += 1;
    }

    fn at_least(&self, what: &str, few: u64) {
        let found = self.0.get(what).copied().unwrap_or(0);
        assert!(found >= few, "{what}: {found}, not {few}: {:?}", self.0);
    }
}

/// The verdict where the best plan with the contrast costs so much.
fn expected(best: Option<&[i64]>, own: &[i64]) -> Verdict {
    match best.map(|best| best.cmp(own)) {
        None => Verdict::Necessary,
        Some(std::cmp::Ordering::Less) => Verdict::Improvable,
        Some(std::cmp::Ordering::Equal) => Verdict::Needless,
        Some(std::cmp::Ordering::Greater) => Verdict::Costly,
    }
}

/// Whether a plan that the oracle knows is beyond what the answer speaks of.
fn is_beyond(answer: &ExplainAnswer, best: Option<&[i64]>) -> bool {
    let within = answer.reach.within().map(i64::from);
    within
        .zip(best)
        .is_some_and(|(within, best)| best[0] > within)
}

#[test]
fn whether_a_plan_is_the_best_one_to_go_on_with() {
    let seed = environment::number("GIVEWAY_RANDOM_SEED", 11);
    let mut seen = Seen::default();
    for number in 0..count(700) {
        let Some(case) = Case::random(seed, number, &kinds(number)) else {
            continue;
        };
        let Answer::Best(best) = case.best(&[]) else {
            continue;
        };
        for plan in &case.plans {
            let what = || format!("{}\n{}", case.told, serde_json::to_string(plan).unwrap());
            let own = case.vector(plan);
            let answer = match case.ask(plan, &Question::Plan) {
                Ok(answer) => answer,
                Err(refusal) => panic!("{refusal:?}\n{}", what()),
            };
            let Some(optimal) = answer.optimal else {
                seen.note("open");
                continue;
            };
            assert_eq!(
                optimal,
                own == best,
                "{best:?} {own:?} {answer:?}\n{}",
                what()
            );
            let told = answer.costs.map(|costs| case.costs_of(&costs));
            assert_eq!(told.as_ref(), Some(&best), "{answer:?}\n{}", what());
            seen.note(format!("optimal {optimal}"));
        }
    }
    println!("{:?}", seen.0);
    seen.at_least("optimal true", 150);
    seen.at_least("optimal false", 8);
}

#[test]
fn why_there_is_no_way_to_go_on() {
    let seed = environment::number("GIVEWAY_RANDOM_SEED", 12);
    let mut seen = Seen::default();
    for number in 0..count(900) {
        let Some(case) = Case::random(seed, number, &kinds(number)) else {
            continue;
        };
        if !case.plans.is_empty() {
            continue;
        }
        let best = match case.best(&[]) {
            Answer::Capped => continue,
            Answer::Impossible => None,
            Answer::Best(best) => Some(best),
        };
        match case.ask(&case.plan, &Question::Unsolvable) {
            Ok(answer) => {
                if answer.verdict == Verdict::Unknown || is_beyond(&answer, best.as_deref()) {
                    seen.note("open");
                    continue;
                }
                assert_eq!(answer.verdict, Verdict::Necessary, "{}", case.told);
                assert_eq!(best, None, "{answer:?}\n{}", case.told);
                seen.note("none");
                claims::check(&case, &[], &answer, None, &mut seen);
            }
            Err(refusal) => {
                // A goal is an obstacle, or there is a plan.
                assert!(
                    best.is_some() || case.told.contains("add-obstacle"),
                    "{refusal:?}\n{}",
                    case.told
                );
                seen.note("refused");
            }
        }
    }
    println!("{:?}", seen.0);
    seen.at_least("none", 40);
    seen.at_least("a rule helps", 40);
    seen.at_least("a rule does not help", 1);
    seen.at_least("off", 30);
    seen.at_least("more", 3);
    seen.at_least("until", 5);
}

#[test]
fn what_a_question_contrasts_the_rest_with() {
    let seed = environment::number("GIVEWAY_RANDOM_SEED", 13);
    let mut seen = Seen::default();
    for number in 0..count(700) {
        let Some(case) = Case::random(seed, number, &kinds(number)) else {
            continue;
        };
        for plan in case.plans.iter().take(1) {
            for (question, rules) in contrast::questions(&case, plan, seed, number) {
                let best = match case.best(&rules) {
                    Answer::Capped => continue,
                    Answer::Impossible => None,
                    Answer::Best(best) => Some(best),
                };
                let own = case.vector(plan);
                let what = || {
                    let plan = serde_json::to_string(plan).unwrap();
                    format!(
                        "{question:?} {rules:?}\n{best:?} {own:?}\n{}\n{plan}",
                        case.told
                    )
                };
                let answer = match case.ask(plan, &question) {
                    Ok(answer) => answer,
                    Err(refusal) => {
                        // What is asked about is not so: then the plan meets the contrast.
                        if refusal.sentences().join(" ").contains("is no longer there") {
                            seen.note("gone");
                            continue;
                        }
                        let kept = case.with_rules(&rules).allows(plan);
                        let is_past = !matches!(question, Question::Rule { .. });
                        assert!(kept || is_past, "refused\n{}", what());
                        seen.note("refused");
                        continue;
                    }
                };
                if answer.verdict == Verdict::Unknown || is_beyond(&answer, best.as_deref()) {
                    seen.note("open");
                    continue;
                }
                let known = expected(best.as_deref(), &own);
                assert_eq!(answer.verdict, known, "{answer:?}\n{}", what());
                if let Some(other) = &answer.alternative {
                    let costs = case.vector(other);
                    assert_eq!(Some(&costs), best.as_ref(), "{answer:?}\n{}", what());
                    assert_eq!(answer.costs.map(|it| case.costs_of(&it)), Some(costs));
                    assert!(
                        case.with_rules(&rules).allows(other),
                        "{answer:?}\n{}",
                        what()
                    );
                }
                seen.note(question.kind());
                seen.note(format!("{:?}", answer.verdict));
                let most = (known == Verdict::Costly).then_some(own.as_slice());
                claims::check(&case, &rules, &answer, most, &mut seen);
            }
        }
    }
    println!("{:?}", seen.0);
    for kind in [
        "rule", "visit", "no-visit", "move", "arrival", "makespan", "wait",
    ] {
        seen.at_least(kind, 6);
    }
    for verdict in ["Necessary", "Costly", "Needless", "Improvable"] {
        seen.at_least(verdict, 5);
    }
    seen.at_least("a rule helps", 40);
    seen.at_least("a rule does not help", 3);
    seen.at_least("off", 30);
}
