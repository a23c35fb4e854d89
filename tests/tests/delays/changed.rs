//! The ledger after changes of the world: from where the last one finds each robot.

use giveway_model::change::{Changes, History};
use giveway_model::check::{Violation, check_history};
use giveway_model::constraint::ConstraintKind;
use giveway_model::format::native;
use giveway_model::snapshot::Snapshot;
use giveway_model::{Instance, Plan, Version};
use giveway_solve::change::Method;
use giveway_solve::delays::{DelaysAnswer, DelaysRequest};
use giveway_tests::alone::{paths, replaced};
use giveway_tests::going_on::{go_on, plan_of};
use giveway_tests::random::small;
use giveway_tests::rules_random::{KINDS, changes_of_rules, scene_to_change};
use giveway_tests::upheaval;
use serde_json::json;

use crate::{ask, causes, offended, scenes};

/// Ways alone of more steps are not listed one by one.
const MOST_STEPS: u32 = 7;

/// What the comparison looked at.
#[derive(Debug, Default)]
struct Seen {
    plans: u32,
    alone: u32,
    split: u32,
    rested: u32,
}

#[test]
fn after_changes_robots_are_compared_from_there() {
    let (seed, count) = scenes(150);
    let mut seen = Seen::default();
    for number in 0..count {
        let instance = small(seed ^ 0xc4a, number);
        let Some(plan) = plan_of(&instance) else {
            continue;
        };
        let longest = plan.paths.values().map(Vec::len).max().unwrap_or(1) as u32 - 1;
        let changes = Changes {
            giveway: Version,
            changes: upheaval::changes(&instance, longest, seed, number),
        };
        let what = format!("{seed}-{number}");
        compare_all(&instance, &plan, &changes, &what, &mut seen);
    }
    println!("{seen:?}");
    assert!(seen.alone > 0 && seen.split > 0, "{seen:?}");
}

#[test]
fn rules_that_begin_or_end_are_heeded() {
    let (seed, count) = scenes(150);
    let mut seen = Seen::default();
    // An order between two robots is broken by one of them alone.
    let kinds: Vec<&str> = KINDS.into_iter().filter(|&kind| kind != "before").collect();
    for number in 0..count {
        let kind = kinds[number as usize % kinds.len()];
        let (scene, rule) = scene_to_change(seed ^ 0x2e1, number, &[kind]);
        let instance = native::read_instance(&scene.to_string()).unwrap();
        let Some(plan) = plan_of(&instance) else {
            continue;
        };
        let longest = plan.paths.values().map(Vec::len).max().unwrap_or(1) as u32 - 1;
        let changes = changes_of_rules(seed, number, (&scene, &rule), longest);
        let file = json!({ "giveway": 1, "changes": changes }).to_string();
        let changes = native::read_changes(&file).unwrap();
        let what = format!("{kind} {seed}-{number}");
        compare_all(&instance, &plan, &changes, &what, &mut seen);
    }
    println!("{seen:?}");
    assert!(seen.alone > 0 && seen.split > 0, "{seen:?}");
}

/// Compares each plan with which one can go on.
fn compare_all(instance: &Instance, plan: &Plan, changes: &Changes, what: &str, seen: &mut Seen) {
    let methods = [Method::Revise, Method::Replan];
    let Some(answer) = go_on(instance, plan, changes, &methods) else {
        return;
    };
    for (_, method) in &answer.methods.0 {
        if let Some(plan) = &method.result.plan {
            compare(instance, changes, plan, what, seen);
        }
    }
}

fn compare(instance: &Instance, changes: &Changes, plan: &Plan, what: &str, seen: &mut Seen) {
    let answer = ask(DelaysRequest {
        scene: instance.to_scene(),
        plan: Some(plan.clone()),
        changes: Some(changes.clone()),
        ledger_only: true,
        ..DelaysRequest::default()
    });
    seen.plans += 1;
    assert_eq!(answer.reason, None, "{what}");
    let history = History::of(instance, changes, plan).unwrap();
    let report = check_history(&history, plan);
    assert_eq!(answer.costs, report.costs, "{what}");
    let sum = answer.costs.unwrap().sum_of_costs;
    assert_eq!(answer.alone + answer.delay, sum, "{what}");
    let at = answer.since.unwrap();
    let snapshot = Snapshot::new(at, instance, (&history, &history), plan);
    assert_eq!(answer.agents.len(), snapshot.agents.len(), "{what}");
    let calm = answer.calm.as_ref().unwrap_or(plan);
    assert!(check_history(&history, calm).is_valid(), "{what}");
    let calm = Snapshot::new(at, instance, (&history, &history), calm).rest();
    rows_are_right(&answer, &snapshot, &calm, what, seen);
}

fn rows_are_right(
    answer: &DelaysAnswer,
    snapshot: &Snapshot<'_>,
    calm: &Plan,
    what: &str,
    seen: &mut Seen,
) {
    let instance = &snapshot.instance;
    let (at, rest) = (snapshot.at, snapshot.rest());
    for row in &answer.agents {
        let what = &format!("{what}, {}", row.agent);
        let lost: u32 = row.lost.iter().map(|loss| loss.steps).sum();
        assert_eq!(lost, row.delay, "{what}");
        assert_eq!(row.arrival - row.alone, row.delay, "{what}");
        let path = rest.path(&row.agent);
        if path.first().is_none_or(Option::is_none) {
            continue; // it begins half way along a slow edge
        }
        let rested = instance.start_state(&row.agent).rested;
        let own = |violation: &Violation| {
            violation.agents == [row.agent.clone()] || is_of_the_past(snapshot, violation)
        };
        let judged = |steps: u32| {
            let begin = (&path[..1], [].as_slice());
            let walks = paths(instance, &row.agent, begin, steps)?;
            let others = walks.iter().map(|walk| {
                let plan = replaced(calm, walk);
                snapshot.check(&plan).violations
            });
            let keeps = |violations: &Vec<Violation>| !violations.iter().any(own);
            Some(others.filter(keeps).collect::<Vec<_>>())
        };
        let whole = |steps: u32| if steps == 0 { at - rested } else { at + steps };
        let most = row.arrival.saturating_sub(at).min(MOST_STEPS);
        let found = (0..=most).find_map(|steps| match judged(steps) {
            None => Some(None),
            Some(walks) => (!walks.is_empty()).then_some(Some((steps, walks))),
        });
        let Some(Some((steps, walks))) = found else {
            continue;
        };
        assert_eq!(row.alone, whole(steps), "{what}");
        seen.alone += 1;
        seen.rested += u32::from(row.delay > 0 && steps == 0);
        if row.delay == 0 {
            continue;
        }
        let fewest = walks.iter().map(Vec::len).min().unwrap();
        // With rules among robots the search counts robots, and the judge times.
        let has_rules = !snapshot.history.constraints().is_empty();
        let mut best = walks
            .iter()
            .filter(|walk| has_rules || walk.len() == fewest);
        let told = causes(row);
        assert!(
            best.any(|walk| offended(&row.agent, walk, at + steps) == told),
            "{what}: {told:?}"
        );
        seen.split += 1;
    }
}

/// Whether a gap is broken to where another robot was before the last change: that is past, and
/// each way from there has to keep it.
fn is_of_the_past(snapshot: &Snapshot<'_>, violation: &Violation) -> bool {
    let Some(broken) = &violation.broken else {
        return false;
    };
    let rule = &snapshot.history.constraints()[broken.index as usize].constraint;
    let ConstraintKind::Gap { steps } = rule.kind else {
        return false;
    };
    let plan = snapshot.plan;
    let times = violation.time.saturating_sub(steps)..violation.time.min(snapshot.at);
    let was_there = |name: &String| {
        let from = plan.from.get(name).copied().unwrap_or(0);
        let path = plan.path(name);
        let place = |time: u32| {
            let entry = path.get(time.checked_sub(from)? as usize);
            entry.or(path.last()).copied().flatten()
        };
        let mut times = times.clone();
        times.any(|time| place(time).is_some_and(|cell| broken.cells.contains(&cell)))
    };
    violation.agents.iter().any(was_there)
}
