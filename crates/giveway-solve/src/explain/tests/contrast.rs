//! Questions about a plan, with all their parts.

use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;

use giveway_model::{
    Instance, Plan, Question,
    check::{check, costs},
    question::{fits, from_words},
};

use super::{read, scenario_1};
use crate::{
    Limits, Request, Response, SilentHost,
    budget::Budget,
    explain::{
        ExplainAnswer, ExplainRequest, FactKind, Verdict,
        ask::{Ask, best},
        contrasted::ContrastSearch,
        edits::edited,
        fitting::FittingQuestion,
        group::{groups, without},
        group_mus::{Inquiry, Tried, group_mus},
        verdict::compare,
        whole::WholePlan,
    },
    problem::Relaxed,
    serve,
    tests::random,
};

fn budget() -> Rc<Budget<'static>> {
    Rc::new(Budget::new(&SilentHost, Limits::default()))
}

fn asked(words: &str) -> Question {
    let words: Vec<&str> = words.split_whitespace().collect();
    from_words(&words).unwrap()
}

pub(super) fn explain(instance: &Instance, plan: &Plan, words: &str) -> ExplainAnswer {
    let request = Request::Explain(ExplainRequest {
        scene: instance.to_scene(),
        plan: Some(plan.clone()),
        question: asked(words),
        changes: None,
        at: None,
        objective: None,
        within: None,
        proved: None,
        known: None,
        layers: Vec::new(),
        limits: Limits::default(),
    });
    match serve(&request, &SilentHost) {
        Response::Explained(answer) => *answer,
        other => panic!("{words}: {other:?}"),
    }
}

#[test]
fn scenario_1_is_answered_as_published() {
    let (instance, plan, other) = scenario_1();
    let answer = explain(&instance, &plan, "wait A2 --at 3,1");
    assert_eq!(answer.verdict, Verdict::Needless);
    assert_eq!(answer.alternative, Some(other));
    assert_eq!(
        answer.words,
        "If A2 did not wait at (3, 1), it would meet A1 at (2, 1) at time 1. \
         But A1 could wait instead: there is another plan that costs the same."
    );
    assert!(answer.pending.is_empty() && answer.core.is_none());
}

#[test]
fn a_person_is_told_who_is_in_the_way() {
    let (instance, plan, _) = scenario_1();
    let answer = explain(&instance, &plan, "makespan");
    assert_eq!(answer.verdict, Verdict::Necessary);
    assert!(
        answer.words.starts_with(
            "If the makespan were below 4, A2 would meet A1 at (2, 1) at time 1. \
             There is no plan in which the makespan is below 4. \
             These facts together rule it out: "
        ),
        "{}",
        answer.words
    );
    let core = answer.core.unwrap();
    assert!(core.minimal && core.reach.is_complete());
    let kinds: Vec<FactKind> = core.facts.iter().map(|fact| fact.kind).collect();
    assert!(kinds.contains(&FactKind::Collision), "{kinds:?}");
    // Each repair is a plan of the edited instance that is as asked for.
    assert!(!answer.repairs.is_empty());
    for repair in &answer.repairs {
        let variant = edited(&instance, &repair.edits, None, WholePlan::default());
        assert_eq!(check(&variant.instance, &repair.plan).violations, []);
        assert!(repair.costs.makespan < 4, "{}", repair.text);
    }
}

#[test]
fn a_plan_of_ones_own_is_judged_through_the_service() {
    let (instance, plan) = read(
        r#"{ "giveway": 1, "map": ["..."], "agents": [
            { "name": "A1", "start": [0, 0], "goal": [2, 0] }] }"#,
        r#"{ "giveway": 1, "paths": { "A1": [[0, 0], [0, 0], [1, 0], [2, 0]] } }"#,
    );
    let answer = explain(&instance, &plan, "plan");
    assert_eq!((answer.valid, answer.optimal), (Some(true), Some(false)));
    assert_eq!(answer.verdict, Verdict::Improvable);
    let deltas: Vec<i64> = answer.deltas.values().copied().collect();
    assert_eq!(deltas, [-1, -1, 0]);
    let better = answer.alternative.unwrap();
    assert_eq!(costs(&instance, &better).map(|c| c.makespan), Some(2));
    assert_eq!(answer.excess.len(), 2);
}

/// Questions about a plan, of many kinds, those that fit.
fn questions(instance: &Instance, plan: &Plan) -> Vec<Question> {
    let mut words = vec![
        "makespan".to_owned(),
        "sum-of-costs".to_owned(),
        "waits".to_owned(),
    ];
    for agent in instance.agents() {
        let name = &agent.name;
        for kind in ["wait", "charge", "slow", "arrival", "length"] {
            words.push(format!("{kind} {name}"));
        }
        for (cell, _) in instance.grid().cells().filter(|(_, g)| g.is_vertex()) {
            let at = format!("{},{}", cell.x, cell.y);
            words.push(format!("visit {name} --at {at}"));
            words.push(format!("no-visit {name} --at {at}"));
            words.push(format!("no-charge {name} --at {at}"));
            words.push(format!("yield {name} 0 --at {at}"));
        }
    }
    let questions = words.iter().map(|words| asked(words));
    questions
        .filter(|question| fits(question, instance, plan).is_ok())
        .collect()
}

#[test]
fn of_what_excludes_a_contrast_no_fact_can_be_left_out() {
    let mut seen: BTreeMap<(Verdict, &str), u32> = BTreeMap::new();
    for seed in 0..40 {
        let instance = random(seed, 2 + (seed % 2) as usize);
        let found = best(
            &Ask {
                instance: &instance,
                relaxed: &Relaxed::default(),
                conditions: &[],
                objective: instance.objective(),
                caps: &BTreeMap::new(),
                within: None,
                at_least_within: 0,
            },
            &budget(),
        );
        let Some((plan, costs)) = found.plan.zip(found.costs) else {
            continue;
        };
        let all = questions(&instance, &plan);
        // A few of them, other kinds with every seed.
        for question in all.iter().skip(seed as usize % 5).step_by(5) {
            let whole = WholePlan::default();
            let case = FittingQuestion::new(&instance, question, &plan, costs, None, whole);
            let compared = compare(&case, None, &budget());
            let verdict = compared.verdict;
            if !matches!(verdict, Verdict::Necessary | Verdict::Costly) {
                continue;
            }
            let most = (verdict == Verdict::Costly).then(|| costs.vector(case.objective()));
            let searching = || ContrastSearch {
                case: &case,
                most: most.clone(),
                near: compared.other.as_ref().map(|(plan, _)| plan),
                horizon: costs.makespan,
                budget: budget(),
            };
            let asked: Vec<usize> = (0..instance.agents().len())
                .filter(|&i| question.agent() == Some(instance.agents()[i].name.as_str()))
                .collect();
            let refuted = Tried::None {
                reach: compared.reach.unwrap(),
                clash: Vec::new(),
            };
            let core = group_mus(
                &instance,
                &asked,
                None,
                &BTreeSet::new(),
                refuted,
                &mut searching(),
            )
            .unwrap();
            let mut left_out: BTreeSet<_> = groups(&instance, &asked, false).into_iter().collect();
            for part in &core.groups {
                left_out.remove(part);
            }
            let tried = searching().search(&without(&instance, &left_out, None));
            assert!(
                matches!(tried, Tried::None { .. }),
                "{seed} {question:?}: {tried:?}"
            );
            for &part in &core.groups {
                let mut less = left_out.clone();
                less.insert(part);
                let tried = searching().search(&without(&instance, &less, None));
                let plan = matches!(tried, Tried::Plan(_));
                assert!(
                    plan || !core.minimal,
                    "{seed} {question:?} without {part:?}"
                );
            }
            if core.minimal {
                *seen.entry((verdict, question.kind())).or_default() += 1;
            }
        }
    }
    assert!(seen.len() > 8, "{seen:?}");
}
