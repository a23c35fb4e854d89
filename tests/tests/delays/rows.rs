//! Rows of random scenes, with rules of their own and without.

use giveway_model::check::{Violation, arrivals, check, costs};
use giveway_model::format::native;
use giveway_model::{Cost, Instance, Plan};
use giveway_solve::delays::{AgentDelay, Fraction};
use giveway_tests::alone::{paths, replaced};
use giveway_tests::random::small;
use giveway_tests::rules_random::{KINDS, scene_with_rules};

use crate::lost::{by_cell, lost_slowly, places_are_right};
use crate::{MOST_STEPS, causes, least, ledger, offended, plans, scenes};

#[test]
fn rows_are_those_of_a_slow_search() {
    let (seed, count) = scenes(150);
    let mut seen = Compared::default();
    for number in 0..count {
        let instance = small(seed, number);
        for plan in plans(&instance) {
            compare(
                &instance,
                &plan,
                &format!("small {seed}-{number}"),
                &mut seen,
            );
        }
    }
    println!("{seen:?}");
    assert!(
        seen.split > 0 && seen.lost > 0 && seen.nobody > 0,
        "{seen:?}"
    );
}

#[test]
fn rows_under_rules_are_those_of_a_slow_search() {
    let (seed, count) = scenes(150);
    let mut seen = Compared::default();
    for number in 0..count {
        let kind = KINDS[number as usize % KINDS.len()];
        let other = KINDS[(number as usize / KINDS.len()) % KINDS.len()];
        let scene = scene_with_rules(seed, number, &[kind, other]);
        let instance = native::read_instance(&scene.to_string()).unwrap();
        for plan in plans(&instance) {
            compare(
                &instance,
                &plan,
                &format!("{kind} {other} {seed}-{number}"),
                &mut seen,
            );
        }
    }
    println!("{seen:?}");
    assert!(
        seen.split > 0 && seen.lost > 0 && seen.by_rules > 0,
        "{seen:?}"
    );
}

/// The sum of fractions that add up to a whole number.
fn sum(parts: impl Iterator<Item = Fraction>) -> Fraction {
    parts.fold(Fraction::whole(0), |sum, part| sum.plus(part).unwrap())
}

/// What the comparison looked at.
#[derive(Debug, Default)]
struct Compared {
    plans: u32,
    delayed: u32,
    alone: u32,
    split: u32,
    nobody: u32,
    by_rules: u32,
    lost: u32,
    calmed: u32,
}

fn compare(instance: &Instance, plan: &Plan, what: &str, seen: &mut Compared) {
    let answer = ledger(instance, plan);
    assert_eq!(answer.reason, None, "{what}");
    let own = costs(instance, plan).unwrap();
    assert_eq!(answer.costs, Some(own), "{what}");
    assert_eq!(answer.agents.len(), instance.agents().len(), "{what}");
    seen.plans += 1;
    let delay: u32 = answer.agents.iter().map(|row| row.delay).sum();
    let alone: u32 = answer.agents.iter().map(|row| row.alone).sum();
    assert_eq!((answer.delay, answer.alone), (delay, alone), "{what}");
    assert_eq!(delay + alone, own.sum_of_costs, "{what}");
    let rows = answer.agents.iter().flat_map(|row| &row.because);
    let parts = sum(rows.map(|share| share.steps));
    assert_eq!(parts, Fraction::whole(delay), "{what}");
    let totals = sum(answer.because.iter().map(|total| total.steps.unwrap()));
    assert_eq!(totals, Fraction::whole(delay), "{what}");
    places_are_right(&answer, what);
    let calm = answer.calm.as_ref().unwrap_or(plan);
    seen.calmed += u32::from(answer.calm.is_some());
    assert!(check(instance, calm).is_valid(), "{what}");
    assert_eq!(arrivals(instance, calm), arrivals(instance, plan), "{what}");
    for (agent, arrival) in instance.agents().iter().zip(arrivals(instance, plan)) {
        let row = answer
            .agents
            .iter()
            .find(|row| row.agent == agent.name)
            .unwrap();
        assert_eq!(Some(row.arrival), arrival, "{what}");
        row_is_right(instance, (plan, calm), row, what, seen);
    }
}

fn row_is_right(
    instance: &Instance,
    (plan, calm): (&Plan, &Plan),
    row: &AgentDelay,
    what: &str,
    seen: &mut Compared,
) {
    let what = &format!("{what}, {}", row.agent);
    let lone = instance.alone(&row.agent).unwrap();
    if let Some(costs) = least(&lone, &[Cost::Makespan], None) {
        assert_eq!(row.alone, costs[0], "{what}");
        seen.alone += 1;
    }
    assert_eq!(row.arrival - row.alone, row.delay, "{what}");
    let lost: u32 = row.lost.iter().map(|loss| loss.steps).sum();
    assert_eq!(lost, row.delay, "{what}");
    let parts = row.because.len() as u32;
    assert_eq!(parts == 0, row.delay == 0, "{what}");
    for share in &row.because {
        assert_eq!(share.steps, Fraction::of(row.delay, parts), "{what}");
    }
    if row.delay == 0 || row.alone > MOST_STEPS {
        return;
    }
    seen.delayed += 1;
    let path = plan.path(&row.agent);
    let begin = (&path[..1], [].as_slice());
    let Some(walks) = paths(instance, &row.agent, begin, row.alone) else {
        return;
    };
    let walks = walks
        .into_iter()
        .filter(|walk| check(&lone, walk).is_valid());
    let judged = walks.map(|walk| check(instance, &replaced(calm, &walk)).violations);
    let judged: Vec<Vec<Violation>> = judged.collect();
    let has_rules = instance.constraints().iter().any(|rule| !rule.off);
    let fewest = judged.iter().map(Vec::len).min().unwrap();
    // With rules among robots the search counts robots, and the judge times.
    let is_best = |violations: &&Vec<Violation>| has_rules || violations.len() == fewest;
    let mut sets = judged.iter().filter(is_best);
    let told = causes(row);
    assert!(
        sets.any(|violations| offended(&row.agent, violations, row.alone) == told),
        "{what}: {told:?}"
    );
    seen.split += 1;
    seen.nobody += u32::from(told.is_empty());
    seen.by_rules += u32::from(told.iter().any(|name| name.starts_with('#')));
    if let Some(lost) = lost_slowly(&lone, &row.agent, plan) {
        assert_eq!(by_cell(&row.lost), lost, "{what}");
        seen.lost += 1;
    }
}
