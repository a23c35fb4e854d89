//! The numbers that texts claim are true: each stands in `claims.json` with the words
//! that claim it, and the solver is asked.

use std::collections::BTreeMap;

use giveway_course::judge::{Did, Judging, Situation, Why, begin, conclude};
use giveway_course::lesson::task::Predict;
use giveway_course::lesson::{Quantity, Step, Task, Value};
use giveway_model::check::check;
use giveway_model::{Cost, Costs, Grid, Instance, Objective, Question, Scene};
use giveway_solve::explain::ExplainRequest;
use giveway_solve::{Limits, Request, Response, SilentHost, SolveRequest, serve};
use serde::Deserialize;

use super::{reading, shipped};

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
struct Claim {
    lesson: String,
    step: usize,
    says: String,
    /// Arrivals of each robot alone.
    alone: Option<Vec<u32>>,
    longest_alone: Option<u32>,
    sum_alone: Option<u32>,
    /// By which costs the best plan is best, where they are not the scene's own.
    objective: Option<Objective>,
    /// Costs of the best plan.
    best: Option<BTreeMap<Cost, u32>>,
    /// Costs of the step's plan.
    plan: Option<BTreeMap<Cost, u32>>,
    /// Costs of the other plan that a question contrasts the step's plan with.
    question: Option<Question>,
    costs: Option<BTreeMap<Cost, u32>>,
    /// A quantity as the judge of predictions has it.
    quantity: Option<Quantity>,
    value: Option<u32>,
}

fn solved(scene: &Scene, objective: Option<Objective>) -> Costs {
    let request = Request::Solve(SolveRequest {
        scene: scene.clone(),
        objective,
        ..SolveRequest::default()
    });
    match serve(&request, &SilentHost) {
        Response::Solved(answer) if answer.reach.is_complete() => answer.costs.unwrap(),
        other => panic!("{other:?}"),
    }
}

fn alone(scene: &Scene) -> Vec<u32> {
    let alone = scene.agents.iter().map(|agent| {
        let mut scene = scene.clone();
        scene.agents = vec![agent.clone()];
        let grid = Grid::from_rows(&scene.map).unwrap();
        scene.settle_rules(&grid);
        solved(&scene, None).makespan
    });
    alone.collect()
}

fn measured(quantity: &Quantity, scene: &Scene) -> Value {
    let task = Predict {
        say: "What?".parse().unwrap(),
        what: quantity.clone(),
        answers: Vec::new(),
    };
    let step = Step {
        task: Some(Task::Predict(task)),
        ..Step::default()
    };
    let situation = Situation {
        step: &step,
        start: scene,
        scene,
    };
    let did = Did::Guessed(Value::Number(u32::MAX));
    let Some(Judging::Ask(requests)) = begin(situation, &did) else {
        panic!("nothing to ask of {quantity:?}");
    };
    let responses: Vec<Response> = requests.iter().map(|r| serve(r, &SilentHost)).collect();
    match conclude(situation, &did, &responses).unwrap().why {
        Why::Guessed { truth, .. } => truth,
        other => panic!("{other:?}"),
    }
}

fn has(costs: &Costs, wanted: Option<&BTreeMap<Cost, u32>>, place: &str) {
    for (cost, value) in wanted.into_iter().flatten() {
        assert_eq!(costs.get(*cost), *value, "{place}: {cost}");
    }
}

#[test]
fn numbers_in_texts_are_true() {
    let claims: Vec<Claim> = serde_json::from_str(include_str!("../claims.json")).unwrap();
    for claim in claims {
        let lesson = shipped::lesson(&claim.lesson);
        let step = &lesson.steps[claim.step];
        let scene = lesson.scene(claim.step).unwrap();
        let place = format!("{}, step {}: {}", claim.lesson, claim.step, claim.says);
        let mut texts = reading::texts(step).into_iter();
        assert!(
            texts.any(|text| text.plain().contains(&claim.says)),
            "{place}: not said"
        );
        let alone = alone(scene);
        assert!(
            claim.alone.is_none_or(|wanted| wanted == alone),
            "{place}: {alone:?}"
        );
        let longest = alone.iter().max().copied();
        assert!(
            claim.longest_alone.is_none_or(|n| Some(n) == longest),
            "{place}: {longest:?}"
        );
        let sum: u32 = alone.iter().sum();
        assert!(claim.sum_alone.is_none_or(|n| n == sum), "{place}: {sum}");
        if claim.best.is_some() {
            has(
                &solved(scene, claim.objective.clone()),
                claim.best.as_ref(),
                &place,
            );
        }
        if claim.plan.is_some() {
            let instance = Instance::new(scene.clone()).unwrap();
            let report = check(&instance, step.plan.as_ref().unwrap());
            has(&report.costs.unwrap(), claim.plan.as_ref(), &place);
        }
        if let Some(question) = claim.question {
            let request = Request::Explain(ExplainRequest {
                scene: scene.clone(),
                plan: step.plan.clone(),
                changes: None,
                at: None,
                question,
                objective: None,
                within: None,
                proved: None,
                known: None,
                layers: Vec::new(),
                limits: Limits::default(),
            });
            match serve(&request, &SilentHost) {
                Response::Explained(answer) if answer.reach.is_complete() => {
                    has(&answer.costs.unwrap(), claim.costs.as_ref(), &place);
                }
                other => panic!("{place}: {other:?}"),
            }
        }
        if let Some(quantity) = &claim.quantity {
            let truth = measured(quantity, scene);
            assert_eq!(Some(truth), claim.value.map(Value::Number), "{place}");
        }
    }
}
