//! Answers to random questions against the oracle.
//!
//! `GIVEWAY_RANDOM_QUESTIONS` sets how many (100 by default),
//! `GIVEWAY_RANDOM_CERTIFICATES` of how many the answer is certified (30), and
//! `GIVEWAY_RANDOM_SEED` the seed. The long run:
//!
//! ```text
//! GIVEWAY_RANDOM_QUESTIONS=2000 GIVEWAY_RANDOM_SEED=7 \
//!     cargo test --release -p giveway-tests --test explain_oracle -- --nocapture
//! ```
#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    clippy::panic,
    reason = "a test that cannot go on ends with a panic"
)]

use std::collections::BTreeMap;

use giveway_model::question::to_words;
use giveway_solve::CertifyRequest;
use giveway_solve::explain::Verdict;
use giveway_tests::certified::Tally;
use giveway_tests::questions::Case;
use giveway_tests::{answers, compare::Comparison, environment, questions, random};

#[test]
fn verdicts_and_deltas() {
    verdicts(questions::random, 15);
}

#[test]
fn verdicts_and_deltas_where_robots_have_no_goals() {
    verdicts(without_goals, 12);
}

/// A case in which some agents have no goal.
fn without_goals(seed: u64, number: u64) -> Option<Case> {
    questions::of(random::small_goalless(seed, number), seed, number)
}

fn verdicts(case_of: impl Fn(u64, u64) -> Option<Case>, least_kinds: usize) {
    let seed = environment::number("GIVEWAY_RANDOM_SEED", 1);
    let count = environment::number("GIVEWAY_RANDOM_QUESTIONS", 100);
    let (mut differ, mut too_large) = (0, 0);
    let mut verdicts: BTreeMap<Verdict, u64> = BTreeMap::new();
    let mut kinds: BTreeMap<&str, u64> = BTreeMap::new();
    let mut incomplete = 0;
    for number in 0.. {
        if verdicts.values().sum::<u64>() >= count || too_large > count {
            break;
        }
        let Some(case) = case_of(seed, number) else {
            continue;
        };
        let (comparison, answer) = answers::compare(&case, None);
        match comparison {
            Comparison::TooLarge => {
                too_large += 1;
                continue;
            }
            Comparison::Agreed => {}
            Comparison::Differ(faults) => {
                differ += 1;
                let scene = serde_json::to_string(&case.instance.to_scene()).unwrap();
                println!("question {number} of seed {seed}: {scene}");
                for fault in faults {
                    println!("  {fault}");
                }
            }
        }
        *verdicts.entry(answer.verdict).or_default() += 1;
        *kinds.entry(case.question.kind()).or_default() += 1;
        incomplete += u64::from(!answer.reach.is_complete());
    }
    println!(
        "{verdicts:?}, {incomplete} of them within a horizon, {too_large} too large; {kinds:?}"
    );
    assert_eq!(differ, 0, "the scenes and both answers are printed above");
    assert!(too_large * 5 <= count, "too many for the oracle");
    for verdict in [
        Verdict::Needless,
        Verdict::Improvable,
        Verdict::Costly,
        Verdict::Necessary,
    ] {
        let seen = verdicts.get(&verdict).copied().unwrap_or(0);
        assert!(seen * 30 >= count, "{verdict:?}: {seen} of {count}");
    }
    assert!(kinds.len() >= least_kinds, "{kinds:?}");
}

/// The fifth verdict: a budget of nothing leaves every question open.
#[test]
fn without_a_budget_nothing_is_known() {
    let mut seen = 0;
    for number in 0..20 {
        let Some(case) = questions::random(3, number) else {
            continue;
        };
        let answer = answers::without_budget(&case);
        let found = answer.alternative.is_some();
        assert!(matches!(
            answer.verdict,
            Verdict::Unknown | Verdict::Improvable
        ));
        assert!(found || answer.verdict == Verdict::Unknown, "{number}");
        assert!(
            !answer.reach.is_complete() && answer.reach.within().is_none(),
            "{number}"
        );
        seen += 1;
    }
    assert!(seen > 5);
}

/// Whatever is answered can be shown: each answer is certified, and checked.
#[test]
fn every_answer_is_certified() {
    certified(questions::random);
}

#[test]
fn every_answer_where_robots_have_no_goals_is_certified() {
    certified(without_goals);
}

fn certified(case_of: impl Fn(u64, u64) -> Option<Case>) {
    let seed = environment::number("GIVEWAY_RANDOM_SEED", 1);
    let count = environment::number("GIVEWAY_RANDOM_CERTIFICATES", 30);
    let mut tally = Tally::default();
    let mut seen = 0;
    for number in 0.. {
        if seen >= count {
            break;
        }
        let Some(case) = case_of(seed, number) else {
            continue;
        };
        seen += 1;
        let within = (number % 4 == 0).then_some((number % 9) as u32);
        let answer = answers::explained(&case, within);
        let plan = Some(&case.plan);
        let request = CertifyRequest::of_explained(&case.instance, plan, &answer);
        let words = to_words(&case.question);
        let name = format!(
            "question {number} of seed {seed}: {words}, {:?}",
            answer.verdict
        );
        tally.add(&name, &case.instance, &request);
    }
    println!("{:?}", tally.last_lines);
    tally.end();
    assert_eq!(tally.last_lines.len(), 2, "{:?}", tally.last_lines);
}
