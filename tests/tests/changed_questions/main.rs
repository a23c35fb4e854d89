//! Questions about a plan around which the world has changed, against joint
//! states, exhausted: from the change on for the best way to go on, and over the
//! rest as an instance of its own for what a question contrasts it with.
//!
//! `GIVEWAY_RANDOM_CHANGES` sets how many (60 by default), `GIVEWAY_RANDOM_SEED`
//! the seed.
#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    clippy::panic,
    reason = "a test that cannot go on ends with a panic"
)]

mod claim;
mod course;

use std::collections::BTreeMap;

use claim::Claim;
use course::course;
use giveway_model::{Cost, Objective, Question};
use giveway_solve::explain::Verdict;
use giveway_tests::oracle::{self, Changed, Contrast, Held, Known};
use giveway_tests::{environment, questions};

/// Joint states that the oracle may look at.
const CAP: usize = 30_000;

fn limit() -> (u64, u64) {
    let seed = environment::number("GIVEWAY_RANDOM_SEED", 1);
    (seed, environment::number("GIVEWAY_RANDOM_CHANGES", 60))
}

/// Whether a plan is the best, or how much better one is; that there is none.
#[test]
fn the_best_way_to_go_on() {
    let (seed, count) = limit();
    let mut seen: BTreeMap<String, u64> = BTreeMap::new();
    let mut compared = 0;
    for number in 0.. {
        if compared >= count {
            break;
        }
        assert!(number < 100 * count, "too few of them can be compared");
        let Some(course) = course(seed, number) else {
            continue;
        };
        let list = &course.changes.changes;
        let costs = course.instance.objective().costs();
        let world = Changed::new(&course.instance, costs, &course.before, course.at, list);
        let Some(mut world) = world else { continue };
        let known = world.best(Held::Nothing, &[], CAP);
        if known == Known::Capped {
            continue;
        }
        let Some(plan) = &course.after else {
            let refused = match (course.ask(&course.before, &Question::Unsolvable), &known) {
                (Ok(answer), Known::None) => {
                    assert_eq!(answer.verdict, Verdict::Necessary, "{}", course.told());
                    assert_eq!(answer.since, Some(course.at));
                    for repair in &answer.repairs {
                        assert!(!repair.plan.paths.is_empty());
                    }
                    "none"
                }
                (Ok(answer), _) => panic!("{answer:?} {}", course.told()),
                (Err(_), _) => "none, refused",
            };
            *seen.entry(refused.to_owned()).or_default() += 1;
            compared += 1;
            continue;
        };
        // Every other plan is worse than it need be.
        let worse = course.delayed(plan).filter(|_| number % 2 == 1);
        let plan = worse.as_ref().unwrap_or(plan);
        let asked = course.ask(plan, &Question::Plan);
        let answer = match asked {
            Ok(answer) => answer,
            Err(refusal) => {
                let sentence = refusal.sentences().join(" ");
                let kind: String = sentence.chars().filter(|c| !c.is_ascii_digit()).collect();
                *seen.entry(kind).or_default() += 1;
                continue;
            }
        };
        compared += 1;
        course.check(plan, &answer);
        let Known::Best(best) = known else {
            panic!("{known:?} {}", course.told());
        };
        let own = course.costs(plan).vector(course.instance.objective());
        let best = &best[..costs.len()];
        if answer.since == Some(course.at) {
            let found = answer.costs.unwrap().vector(course.instance.objective());
            assert_eq!(found, best, "{} {answer:?}", course.told());
            assert_eq!(answer.optimal, Some(own == best), "{}", course.told());
            *seen.entry(format!("optimal {}", own == best)).or_default() += 1;
            let rests = |path: &Vec<_>| path.len() <= course.at as usize;
            let rested = course.instance.stays() && plan.paths.values().any(rests);
            *seen.entry("with one at rest".to_owned()).or_default() += u64::from(rested);
        } else if answer.optimal == Some(false) {
            let found = answer.costs.unwrap().vector(course.instance.objective());
            assert!(*best <= *found && found < own, "{}", course.told());
            *seen.entry("later".to_owned()).or_default() += 1;
        }
    }
    println!("{seen:?}");
    let at_least = |kind: &str, few: u64| {
        let found = seen.get(kind).copied().unwrap_or(0);
        assert!(found * 60 >= few * count, "{kind}: {found} of {count}");
    };
    at_least("optimal true", 10);
    at_least("optimal false", 5);
    at_least("with one at rest", 5);
    at_least("none", 1);
}

/// Questions about one agent and its way, against the rest by itself.
#[test]
fn what_a_question_contrasts_the_rest_with() {
    let (seed, count) = limit();
    let mut compared = 0;
    let mut kinds: BTreeMap<&str, u64> = BTreeMap::new();
    let mut verdicts: BTreeMap<Verdict, u64> = BTreeMap::new();
    let mut broken_down: BTreeMap<&str, u64> = BTreeMap::new();
    let mut half_way: BTreeMap<&str, u64> = BTreeMap::new();
    for number in 0.. {
        if compared >= count {
            break;
        }
        assert!(number < 400 * count, "too few of them can be compared");
        let Some(course) = course(seed ^ 0xc0, number) else {
            continue;
        };
        let Some(plan) = &course.after else { continue };
        let Some((instance, rest, mut with)) = course.rest(plan) else {
            continue;
        };
        let Some(relative) = questions::about(&instance, &rest, seed, number) else {
            continue;
        };
        let question = later(&relative, course.at);
        let waited = course.waited(plan, &question);
        if let (Some(agent), 1..) = (question.agent(), waited) {
            with.waited.insert(agent.to_owned(), waited);
        }
        let contrast = Contrast {
            question: &relative,
            plan: &rest,
        };
        let answer = match course.ask(plan, &question) {
            Ok(answer) => answer,
            // All of it lies in the past.
            Err(_) if has_waited_enough(&question, waited) => continue,
            Err(refusal) => panic!("{refusal:?} {question:?} {}", course.told()),
        };
        course.check(plan, &answer);
        assert_eq!(answer.since, Some(course.at));
        assert_eq!(answer.question, question);
        let asked = oracle::Question {
            instance: &instance,
            within: answer.reach.within().map(|within| within - course.at),
            cap: CAP,
        };
        let objective = instance.objective();
        let costs = giveway_model::check::costs(&instance, &rest).unwrap();
        let before = costs.vector(objective);
        let best = match asked.best_with_less(contrast, &with) {
            oracle::Verdict::Capped => continue,
            oracle::Verdict::Impossible => None,
            oracle::Verdict::Best(point) => Some(point.vector),
        };
        let (expected, deltas) = expected(best.as_deref(), &before, objective);
        let about = || format!("{question:?} {answer:?} {}", course.told());
        assert_eq!(answer.verdict, expected, "{}", about());
        assert_eq!(answer.deltas, deltas, "{}", about());
        let most = (expected == Verdict::Costly).then_some(&before);
        let claim = Claim {
            course: &course,
            instance: &instance,
            contrast,
            with: &with,
            most,
        };
        claim.check(&answer, &mut broken_down);
        if !with.held.is_empty() {
            let asked = question
                .agent()
                .is_some_and(|it| with.held.contains_key(it));
            let key = if asked {
                "its own breakdown"
            } else {
                "a breakdown"
            };
            *broken_down.entry(key).or_default() += 1;
        }
        for (is_so, key) in [
            (!with.transit.is_empty(), "in transit"),
            (!with.waited.is_empty(), "a wait begun"),
        ] {
            *half_way.entry(key).or_default() += u64::from(is_so);
        }
        compared += 1;
        *kinds.entry(question.kind()).or_default() += 1;
        *verdicts.entry(answer.verdict).or_default() += 1;
    }
    println!("{kinds:?} {verdicts:?} {broken_down:?} {half_way:?}");
    assert!(
        kinds.len() >= 8 && verdicts.len() >= 3,
        "{kinds:?} {verdicts:?}"
    );
    let seen = |key: &str| broken_down.get(key).copied().unwrap_or(0);
    for key in ["a breakdown", "its own breakdown", "a breakdown as a fact"] {
        assert!(seen(key) * 60 >= 2 * count, "{key}: {broken_down:?}");
    }
}

/// The verdict where a plan with the contrast costs `best`, and what it costs more than before.
fn expected(
    best: Option<&[u32]>,
    before: &[u32],
    objective: &Objective,
) -> (Verdict, BTreeMap<Cost, i64>) {
    let Some(best) = best else {
        return (Verdict::Necessary, BTreeMap::new());
    };
    let verdict = match best.cmp(before) {
        std::cmp::Ordering::Less => Verdict::Improvable,
        std::cmp::Ordering::Equal => Verdict::Needless,
        std::cmp::Ordering::Greater => Verdict::Costly,
    };
    let values = best.iter().zip(before);
    let more = values.map(|(&a, &b)| i64::from(a) - i64::from(b));
    let costs = objective.costs().iter().copied();
    (verdict, costs.zip(more).collect())
}

/// Whether a wait that is asked about was over before the change.
fn has_waited_enough(question: &Question, waited: u32) -> bool {
    matches!(question, Question::Wait { at_least: Some(steps), .. } if waited >= *steps)
}

/// A question with all times later.
fn later(question: &Question, by: u32) -> Question {
    let mut question = question.clone();
    for time in question.times_mut().into_iter().flatten() {
        *time += by;
    }
    question
}
