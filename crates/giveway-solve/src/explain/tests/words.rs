//! Sentences, as they are expected to be read.

use giveway_model::{Instance, Plan, Question, question::from_words};

use super::{read, scenario_1};
use crate::Reach;
use crate::explain::{
    Core, Edit, Repair, Verdict, WitnessEntry,
    group::groups,
    waits,
    whole::WholePlan,
    words::{KnownSoFar, verdict},
};

fn asked(words: &str) -> Question {
    let words: Vec<&str> = words.split_whitespace().collect();
    from_words(&words).unwrap()
}

/// The words where no reason is known.
fn plain(
    instance: &Instance,
    plan: &Plan,
    words: &str,
    found: Verdict,
    alternative: Option<&Plan>,
) -> String {
    verdict(&KnownSoFar {
        whole: WholePlan::default(),
        instance,
        question: &asked(words),
        objective: instance.objective(),
        plan,
        verdict: found,
        is_open: false,
        alternative,
        within: None,
        alone: &[],
        here: None,
        witness: ("", &[]),
        core: None,
        repairs: &[],
    })
}

#[test]
fn scenario_1_is_told_as_a_person_would() {
    let (instance, plan, other) = scenario_1();
    let question = asked("wait A2 --at 3,1");
    let entries: Vec<WitnessEntry> =
        waits::witness(&instance, &question, &plan, WholePlan::default())
            .into_iter()
            .map(|violation| WitnessEntry {
                violation,
                class: None,
            })
            .collect();
    let words = verdict(&KnownSoFar {
        whole: WholePlan::default(),
        instance: &instance,
        question: &question,
        objective: instance.objective(),
        plan: &plan,
        verdict: Verdict::Needless,
        is_open: false,
        alternative: Some(&other),
        within: None,
        alone: &[],
        here: None,
        witness: ("A2", &entries),
        core: None,
        repairs: &[],
    });
    assert_eq!(
        words,
        "If A2 did not wait at (3, 1), it would meet A1 at (2, 1) at time 1. \
         But A1 could wait instead: there is another plan that costs the same."
    );
}

#[test]
fn each_verdict_has_its_sentence() {
    let (instance, plan, other) = scenario_1();
    let tell = |found| plain(&instance, &plan, "arrival A2", found, Some(&other));
    assert_eq!(
        tell(Verdict::Needless),
        "It does not have to be this way. A1 could move differently: there is a plan that costs \
         the same and in which A2 arrives before time 4."
    );
    assert_eq!(
        tell(Verdict::Necessary),
        "There is no plan in which A2 arrives before time 4."
    );
    // It costs more, but a cheaper one may be found.
    let mut late = other.clone();
    let first = late.paths.get("A1").and_then(|path| path.first().copied());
    late.paths.get_mut("A1").unwrap().insert(0, first.unwrap());
    let so_far = verdict(&KnownSoFar {
        whole: WholePlan::default(),
        instance: &instance,
        question: &asked("arrival A2"),
        objective: instance.objective(),
        plan: &plan,
        verdict: Verdict::Costly,
        is_open: true,
        alternative: Some(&late),
        within: None,
        alone: &[],
        here: None,
        witness: ("", &[]),
        core: None,
        repairs: &[],
    });
    let begin = "There is a plan in which A2 arrives before time 4, but none costs as little: the \
                 best one so far has ";
    assert!(so_far.starts_with(begin), "{so_far}");
    assert_eq!(
        tell(Verdict::Unknown),
        "The search ended before it was known whether a plan in which A2 arrives before time 4 \
         would cost more."
    );
    let mut late = plan.clone();
    late.paths
        .get_mut("A2")
        .unwrap()
        .insert(0, Some(giveway_model::Cell::new(3, 1)));
    assert_eq!(
        plain(
            &instance,
            &late,
            "wait A2",
            Verdict::Improvable,
            Some(&plan)
        ),
        "There is even a better plan in which A2 does not wait: a makespan of 4 instead of 5 \
         and a sum of costs of 7 instead of 8."
    );
    assert_eq!(
        plain(&instance, &plan, "wait A2", Verdict::Costly, Some(&late)),
        "There is a plan in which A2 does not wait, but the best one has a makespan of 5 \
         instead of 4 and a sum of costs of 8 instead of 7."
    );
}

#[test]
fn each_kind_of_question_has_its_contrast() {
    let (instance, plan) = read(
        r#"{ "giveway": 1, "map": ["+~~.", "...."], "agents": [
            { "name": "A1", "start": [0, 0], "goal": [3, 0], "waypoints": [[1, 0], [2, 0]],
              "battery": { "capacity": 9, "initial": 9 } },
            { "name": "A2", "start": [3, 1], "goal": [0, 1] }] }"#,
        r#"{ "giveway": 1, "paths": {
            "A1": [[0, 0], [1, 0], null, [2, 0], [3, 0]],
            "A2": [[3, 1], [2, 1], [1, 1], [0, 1]] }, "charges": { "A1": [0] } }"#,
    );
    for (words, does) in [
        ("wait A1", "A1 does not wait"),
        ("wait A1 --at 1,0", "A1 does not wait at (1, 0)"),
        (
            "wait A1 --from 2 --to 5",
            "A1 does not wait between time 2 and 5",
        ),
        ("wait A1 --from 2", "A1 does not wait from time 2 on"),
        ("wait A1 --at-least 3", "A1 does not wait 3 steps in a row"),
        ("charge A1", "A1 does not charge"),
        (
            "charge A1 --at 0,0 --time 0",
            "A1 does not charge at (0, 0) at time 0",
        ),
        ("no-charge A1 --at 0,0", "A1 charges at (0, 0)"),
        ("visit A1 --at 1,0", "A1 does not pass (1, 0)"),
        (
            "visit A1 --at 1,0 --time 1",
            "A1 is not at (1, 0) at time 1",
        ),
        ("no-visit A1 --at 1,1", "A1 passes (1, 1)"),
        ("no-visit any --at 3,0", "somebody passes (3, 0)"),
        (
            "move A1 --from-cell 0,0 --to-cell 1,0",
            "A1 does not go from (0, 0) to (1, 0)",
        ),
        (
            "no-move A1 --from-cell 0,0 --to-cell 0,1 --time 0",
            "A1 goes from (0, 0) to (0, 1) at time 0",
        ),
        ("slow A1", "A1 does not take the slow way"),
        (
            "slow A1 --from-cell 1,0 --to-cell 2,0",
            "A1 does not take the slow way between (1, 0) and (2, 0)",
        ),
        (
            "order A1 --first 1,0 --second 2,0",
            "A1 visits (2, 0) before (1, 0)",
        ),
        ("arrival A1", "A1 arrives before time 4"),
        ("length A1", "A1 makes fewer than 3 moves"),
        ("length A1 --fewer-than 2", "A1 makes fewer than 2 moves"),
        ("makespan", "the makespan is below 4"),
        ("sum-of-costs", "the sum of costs is below 7"),
        ("charges", "the number of charges is below 1"),
        ("charges A1", "A1 makes fewer than 1 charges"),
        ("moves", "the number of moves is below 6"),
        ("waits A2", "A2 makes fewer than 0 waits"),
        ("yield A1 A2 --at 1,1", "A1 is at (1, 1) before A2"),
    ] {
        let told = plain(&instance, &plan, words, Verdict::Necessary, None);
        assert_eq!(
            told,
            format!("There is no plan in which {does}."),
            "{words}"
        );
    }
}

#[test]
fn what_a_set_excludes_and_what_helps_is_told_at_the_end() {
    let (instance, plan, _) = scenario_1();
    let all = groups(&instance, &[], false);
    let facts = all.iter().take(2).map(|part| part.fact(&instance, None));
    let core = Core {
        groups: Vec::new(),
        facts: facts.collect(),
        prices: Vec::new(),
        minimal: true,
        reach: Reach::unproved(None),
        further: Vec::new(),
    };
    let repair = Repair {
        edits: vec![Edit::RemoveObstacle {
            cell: giveway_model::Cell::new(2, 0),
        }],
        least: true,
        costs: giveway_model::Costs {
            makespan: 3,
            sum_of_costs: 6,
            ..giveway_model::Costs::default()
        },
        arrival: None,
        proved: true,
        plan: plan.clone(),
        text: "Remove the obstacle at (2, 0): makespan 3, sum of costs 6.".to_owned(),
    };
    let words = verdict(&KnownSoFar {
        whole: WholePlan::default(),
        instance: &instance,
        question: &asked("makespan"),
        objective: instance.objective(),
        plan: &plan,
        verdict: Verdict::Necessary,
        is_open: false,
        alternative: None,
        within: Some(40),
        alone: &[],
        here: None,
        witness: ("", &[]),
        core: Some(&core),
        repairs: &[repair],
    });
    assert_eq!(
        words,
        "There is no plan with a makespan of at most 40 in which the makespan is below 4. \
         These facts together rule it out: A1 must go from (2, 2) to (0, 1); \
         A2 must go from (3, 1) to (1, 0). \
         It would help to remove the obstacle at (2, 0): makespan 3, sum of costs 6."
    );
}
