//! The layers of an answer: what is near is a plan as asked for, and bounds the verdict.

use std::cell::RefCell;
use std::collections::BTreeMap;

use giveway_model::{
    Costs, Instance, Objective, Plan, Question,
    check::{check, cost_of},
    question::{fits, from_words},
};

use super::{read, scenario_1};
use crate::{
    Host, Limits, Progress, Request, Response, SilentHost, SolveRequest, Status,
    explain::{ExplainAnswer, ExplainRequest, Layer, Part, Variation, VariationKind, Verdict},
    serve,
    tests::random,
};

/// Keeps the answers that are told on the way.
#[derive(Default)]
struct Listener(RefCell<Vec<ExplainAnswer>>);

impl Host for Listener {
    fn wall_seconds(&self) -> f64 {
        0.0
    }

    fn progress(&self, event: &Progress) {
        if let Progress::Explained { answer } = event {
            self.0.borrow_mut().push((**answer).clone());
        }
    }
}

/// The answer, and what was told before it.
pub(super) fn explain(
    instance: &Instance,
    plan: &Plan,
    question: &Question,
    layers: &[Layer],
) -> (ExplainAnswer, Vec<ExplainAnswer>) {
    let request = Request::Explain(ExplainRequest {
        scene: instance.to_scene(),
        plan: Some(plan.clone()),
        question: question.clone(),
        changes: None,
        at: None,
        objective: None,
        within: None,
        proved: None,
        known: None,
        layers: layers.to_vec(),
        limits: Limits {
            conflicts: Some(20_000),
            ..Limits::default()
        },
    });
    let listener = Listener::default();
    match serve(&request, &listener) {
        Response::Explained(answer) => (*answer, listener.0.into_inner()),
        other => panic!("{question:?}: {other:?}"),
    }
}

pub(super) fn asked(words: &str) -> Question {
    let words: Vec<&str> = words.split_whitespace().collect();
    from_words(&words).unwrap()
}

#[test]
fn a_wait_shows_who_comes_through_and_where_else_to_wait() {
    // A1 waits in the bay while A2 passes.
    let (instance, plan) = read(
        r##"{ "giveway": 1, "map": ["#....", "....."], "agents": [
            { "name": "A1", "start": [1, 0], "goal": [4, 1] },
            { "name": "A2", "start": [4, 1], "goal": [0, 1] }] }"##,
        r#"{ "giveway": 1, "paths": {
            "A1": [[1, 0], [1, 0], [1, 0], [2, 0], [3, 0], [4, 0], [4, 1]],
            "A2": [[4, 1], [3, 1], [2, 1], [1, 1], [0, 1]] } }"#,
    );
    let (answer, told) = explain(
        &instance,
        &plan,
        &asked("wait A1 --at 1,0"),
        &[Layer::Here, Layer::Near],
    );
    assert_eq!(answer.verdict, Verdict::Unknown);
    assert!(answer.pending.is_empty() && answer.core.is_none());
    let here = answer.here.unwrap();
    assert_eq!((here.agent.as_str(), here.violations.len()), ("A1", 0));
    let near = answer.near.unwrap();
    let first = &near.variations[0];
    assert_eq!(near.at_most.unwrap().sum_of_costs, 8);
    assert_eq!(first.costs.makespan, 4);
    assert!(told[0].here.is_some() && told[0].pending == [Part::Near]);
}

#[test]
fn the_first_layers_of_scenario_1() {
    let (instance, plan, other) = scenario_1();
    let (answer, told) = explain(&instance, &plan, &asked("wait A2 --at 3,1"), &Layer::ALL);
    let here = answer.here.unwrap();
    assert_eq!(
        here.words,
        "A2 lets A1 pass: going on, it would meet A1 at (2, 1) at time 1."
    );
    assert_eq!(here.passing[0].agent, "A1");
    let near = answer.near.unwrap();
    assert_eq!(near.variations[0].kind, VariationKind::Swapped);
    assert_eq!(
        near.words,
        "A2 could go first, and A1 later: that costs the same; A1 arrives 1 later."
    );
    assert_eq!(answer.verdict, Verdict::Needless);
    assert_eq!(answer.alternative, Some(other));
    let parts: Vec<&[Part]> = told.iter().map(|it| it.pending.as_slice()).collect();
    assert!(parts.is_sorted_by_key(|pending| usize::MAX - pending.len()));
}

#[test]
fn a_wait_slides_along_the_way() {
    // A1 waits for A2, which crosses its way.
    let instance = r#"{ "giveway": 1, "map": ["@@.@@", "@@.@@", ".....", "@@.@@", "@@.@@"], "agents": [
            { "name": "A1", "start": [0, 2], "goal": [4, 2] },
            { "name": "A2", "start": [2, 0], "goal": [2, 4] }] }"#;
    let plan = r#"{ "giveway": 1, "paths": {
            "A1": [[0, 2], [1, 2], [1, 2], [2, 2], [3, 2], [4, 2]],
            "A2": [[2, 0], [2, 1], [2, 2], [2, 3], [2, 4]] } }"#;
    let (instance, plan) = read(&instance.replace('@', "#"), plan);
    let layers = [Layer::Here, Layer::Near];
    let (answer, _) = explain(&instance, &plan, &asked("wait A1 --at 1,2"), &layers);
    let here = answer.here.unwrap();
    assert_eq!(
        here.words,
        "A1 lets A2 pass: going on, it would meet A2 at (2, 2) at time 2."
    );
    assert_eq!((here.passing[0].cell.x, here.passing[0].time), (2, 2));
    let near = answer.near.unwrap();
    assert_eq!(
        near.words,
        "A1 could wait at (0, 2) from time 0 on: that costs the same."
    );
    assert_eq!(near.variations[0].kind, VariationKind::Elsewhere);
    assert_eq!(near.variations[1].kind, VariationKind::Swapped);
    assert_eq!(answer.pays[0].agent, "A1");
}

/// Of another order it is told who comes first now, and what would happen on another way.
#[test]
fn who_is_first_is_told_before_what_would_happen() {
    let mut told = 0;
    for seed in 0..120 {
        let instance = random(seed, 3);
        let Some((plan, _)) = solved(&instance) else {
            continue;
        };
        for question in questions(&instance, &plan) {
            let Question::Yield { agent, to, at } = &question else {
                continue;
            };
            let (answer, _) = explain(&instance, &plan, &question, &[Layer::Here]);
            let Some(here) = answer.here.filter(|it| !it.violations.is_empty()) else {
                continue;
            };
            let time = here.passing[0].time;
            let start = format!(
                "{to} is at {at} first, at time {time}. On its quickest way to be there before, \
                 {agent} would "
            );
            assert!(here.words.starts_with(&start), "{seed} {}", here.words);
            told += 1;
        }
    }
    assert!(told > 5, "{told}");
}

/// The plan with the paths of a variation.
fn with(plan: &Plan, variation: &Variation) -> Plan {
    let mut plan = plan.clone();
    for name in variation.pays.iter().map(|it| &it.agent) {
        plan.charges.remove(name);
    }
    plan.paths.extend(variation.plan.paths.clone());
    plan.charges.extend(variation.plan.charges.clone());
    plan
}

fn solved(instance: &Instance) -> Option<(Plan, Costs)> {
    let request = Request::Solve(SolveRequest {
        scene: instance.to_scene(),
        ..SolveRequest::default()
    });
    match serve(&request, &SilentHost) {
        Response::Solved(answer) if answer.status == Status::Optimal => {
            answer.plan.zip(answer.costs)
        }
        _ => None,
    }
}

pub(super) fn questions(instance: &Instance, plan: &Plan) -> Vec<Question> {
    let mut questions = vec![asked("makespan"), asked("sum-of-costs")];
    for agent in instance.agents() {
        let name = &agent.name;
        questions.push(asked(&format!("wait {name}")));
        questions.push(asked(&format!("arrival {name}")));
        questions.push(asked(&format!("charge {name}")));
        for cell in plan.path(name).iter().flatten().skip(1) {
            let at = format!("{},{}", cell.x, cell.y);
            questions.push(asked(&format!("visit {name} --at {at}")));
            for other in instance.agents().iter().filter(|it| it.name != *name) {
                questions.push(asked(&format!("yield {name} {} --at {at}", other.name)));
            }
        }
    }
    questions.retain(|question| fits(question, instance, plan).is_ok());
    questions
}

/// Each variation is a plan of the costs that are told, and is as asked for; the bound falls
/// only, and never below what the search for the best proves.
#[test]
fn what_is_near_bounds_the_verdict() {
    let mut kinds: BTreeMap<VariationKind, u32> = BTreeMap::new();
    let (mut tight, mut bounds) = (0, 0);
    for seed in 0..200 {
        let instance = random(seed, 2 + (seed % 3) as usize);
        let Some((plan, _)) = solved(&instance) else {
            continue;
        };
        let objective: &Objective = instance.objective();
        for question in questions(&instance, &plan).into_iter().take(12) {
            let layers = [Layer::Here, Layer::Near];
            let (answer, told) = explain(&instance, &plan, &question, &layers);
            let near = answer.near.unwrap();
            for variation in &near.variations {
                *kinds.entry(variation.kind).or_default() += 1;
                let other = with(&plan, variation);
                let report = check(&instance, &other);
                assert!(report.is_valid(), "{seed} {question:?} {variation:?}");
                assert_eq!(report.costs, Some(variation.costs), "{seed} {question:?}");
                let before = |agent: Option<&str>, cost| cost_of(&instance, &plan, agent, cost);
                let condition = question.condition(before).unwrap();
                assert_eq!(
                    condition.holds(&instance, &other),
                    Some(true),
                    "{question:?}"
                );
            }
            let all = told.iter().filter_map(|it| it.near.as_ref()?.at_most);
            let all: Vec<Vec<u32>> = all.map(|costs| costs.vector(objective)).collect();
            assert!(
                all.is_sorted_by(|a, b| a >= b),
                "{seed} {question:?} {all:?}"
            );
            let Some(at_most) = near.at_most else {
                continue;
            };
            assert_eq!(answer.costs, Some(at_most));
            let (whole, _) = explain(&instance, &plan, &question, &[Layer::Whole]);
            let (Verdict::Needless | Verdict::Costly, Some(least)) = (whole.verdict, whole.costs)
            else {
                continue;
            };
            let least = least.vector(objective);
            assert!(at_most.vector(objective) >= least, "{seed} {question:?}");
            bounds += 1;
            tight += u32::from(at_most.vector(objective) == least);
        }
    }
    println!("{kinds:?}, {tight} of {bounds} bounds are the optimum");
    assert!(kinds.len() >= 3, "{kinds:?}");
    assert!(
        bounds > 30 && tight * 10 >= bounds * 8,
        "{tight} of {bounds}"
    );
}

/// Without layers the answer is what it was before there were any: the last three of them.
#[test]
fn a_request_without_layers_has_the_last_three() {
    let (instance, plan, _) = scenario_1();
    for words in ["wait A2 --at 3,1", "makespan", "arrival A1"] {
        let question = asked(words);
        let (mut none, _) = explain(&instance, &plan, &question, &[]);
        let (mut named, _) = explain(&instance, &plan, &question, &[Layer::Help]);
        (none.stats, named.stats) = Default::default();
        assert!(none.here.is_none() && none.near.is_none());
        assert_eq!(none, named);
        let (whole, _) = explain(&instance, &plan, &question, &[Layer::Whole]);
        assert_eq!(whole.verdict, none.verdict);
        assert!(whole.witness.is_empty() && whole.core.is_none() && whole.repairs.is_empty());
    }
}
