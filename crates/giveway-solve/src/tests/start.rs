//! A search that tells of its plans, and one that begins with a plan.

use std::cell::{Cell, RefCell};

use giveway_model::{Assumption, Cost, Instance, LeftOutRule, Plan, check::check};

use super::{instance, random};
use crate::{
    Host, Limits, Progress, Request, Response, SilentHost, SolveAnswer, SolveRequest, Status,
    serve, serve_basic,
};

/// Notes the plans that it is told of; gives up after so many of them, and
/// after so many questions whether to.
struct Listener {
    plans: RefCell<Vec<(Plan, giveway_model::Costs)>>,
    patience: usize,
    questions: Cell<u32>,
    most_questions: u32,
}

impl Listener {
    fn new(patience: usize, most_questions: u32) -> Self {
        Self {
            plans: RefCell::new(Vec::new()),
            patience,
            questions: Cell::new(0),
            most_questions,
        }
    }
}

impl Host for Listener {
    fn wall_seconds(&self) -> f64 {
        0.0
    }

    fn cancelled(&self) -> bool {
        self.questions.set(self.questions.get() + 1);
        self.plans.borrow().len() >= self.patience || self.questions.get() > self.most_questions
    }

    fn progress(&self, event: &Progress) {
        if let Progress::Plan { costs, plan } = event {
            self.plans.borrow_mut().push((plan.clone(), *costs));
        }
    }
}

fn solve(request: &SolveRequest, host: &dyn Host) -> SolveAnswer {
    match serve(&Request::Solve(request.clone()), host) {
        Response::Solved(answer) => answer,
        other => panic!("{other:?}"),
    }
}

fn request(instance: &Instance, start: Option<Plan>) -> SolveRequest {
    SolveRequest {
        scene: instance.to_scene(),
        start,
        limits: Limits {
            conflicts: Some(20_000),
            ..Limits::default()
        },
        ..SolveRequest::default()
    }
}

/// Two swap their places by way of a bay; slow cells and batteries beside.
fn bay() -> Instance {
    instance(
        "aB  .   ~   bA
         #   .   #   #
         c   *   ~   C
         battery c 3/6",
    )
}

#[test]
fn every_plan_told_of_passes_the_judge_and_is_better_than_the_last() {
    let mut told = 0;
    for seed in 0..120 {
        let instance = random(seed, 3);
        let host = Listener::new(usize::MAX, u32::MAX);
        let answer = solve(&request(&instance, None), &host);
        let plans = host.plans.into_inner();
        for (plan, costs) in &plans {
            let report = check(&instance, plan);
            assert_eq!(report.violations, [], "{seed}");
            assert_eq!(report.costs, Some(*costs), "{seed}");
        }
        let vectors = plans
            .iter()
            .map(|(_, costs)| costs.vector(instance.objective()));
        let vectors: Vec<Vec<u32>> = vectors.collect();
        assert!(vectors.is_sorted_by(|a, b| a > b), "{seed}: {vectors:?}");
        // The answer's plan is a calm one of the same costs.
        let costs = answer.costs.map(|costs| costs.vector(instance.objective()));
        assert_eq!(vectors.last(), costs.as_ref(), "{seed}");
        told += plans.len();
    }
    assert!(told > 40, "{told}");
}

#[test]
fn a_search_goes_on_from_the_plan_that_it_is_given() {
    let mut kept = 0;
    for seed in 0..200 {
        let instance = random(seed, 3);
        let first = Listener::new(1, u32::MAX);
        let _ = solve(&request(&instance, None), &first);
        let Some((plan, costs)) = first.plans.into_inner().into_iter().next() else {
            continue;
        };
        kept += 1;
        // However soon it ends, the plan is not lost.
        for questions in [0, 1, 2, 5, 50] {
            let host = Listener::new(usize::MAX, questions);
            let answer = solve(&request(&instance, Some(plan.clone())), &host);
            let found = answer.costs.map(|costs| costs.vector(instance.objective()));
            let found = found.unwrap_or_else(|| panic!("{seed}: {answer:?}"));
            assert!(found <= costs.vector(instance.objective()), "{seed}");
            let plan = answer.plan.unwrap();
            assert!(check(&instance, &plan).is_valid(), "{seed}");
        }
        // And what is claimed in the end is the same.
        let [with, without] =
            [Some(plan), None].map(|start| solve(&request(&instance, start), &SilentHost));
        assert_eq!(with.status, without.status, "{seed}");
        let best = |answer: &SolveAnswer| answer.costs.map(|c| c.vector(instance.objective()));
        assert_eq!(best(&with), best(&without), "{seed}");
    }
    assert!(kept > 20, "{kept}");
}

#[test]
fn the_first_plan_told_of_is_the_one_given() {
    let bay = bay();
    let best = solve(&request(&bay, None), &SilentHost);
    assert_eq!(best.status, Status::Optimal);
    let mut given = best.plan.clone().unwrap();
    // It waits at its goal for some time, which is no part of the plan.
    let path = given.paths.get_mut("c").unwrap();
    let goal = *path.last().unwrap();
    path.extend([goal, goal]);
    let host = Listener::new(usize::MAX, u32::MAX);
    let again = solve(&request(&bay, Some(given)), &host);
    assert_eq!(again.plan, best.plan);
    let plans: Vec<Plan> = host.plans.into_inner().into_iter().map(|it| it.0).collect();
    assert_eq!(plans, Vec::from_iter(best.plan));
}

#[test]
fn the_same_request_gives_the_same_answer() {
    for seed in 0..60 {
        let instance = random(seed, 3);
        let start = solve(&request(&instance, None), &SilentHost).plan;
        let request = request(&instance, start);
        let [one, two] = [(); 2].map(|()| solve(&request, &SilentHost));
        assert_eq!(one, two, "{seed}");
    }
}

#[test]
fn what_the_judge_does_not_pass_is_ignored() {
    let bay = bay();
    let without = solve(&request(&bay, None), &SilentHost);
    let good = without.plan.clone().unwrap();
    let mut jumps = good.clone();
    jumps.paths.get_mut("a").unwrap().remove(1);
    let mut lacks_one = good.clone();
    lacks_one.paths.remove("b");
    let mut joins_later = good.clone();
    joins_later.from.insert("a".to_owned(), 1);
    for start in [jumps, lacks_one, joins_later, Plan::default()] {
        assert!(!check(&bay, &start).is_valid());
        let answer = solve(&request(&bay, Some(start.clone())), &SilentHost);
        assert_eq!(answer, without);
        let soon = Listener::new(usize::MAX, 1);
        let answer = solve(&request(&bay, Some(start)), &soon);
        assert_eq!((answer.status, answer.plan), (Status::Unknown, None));
    }
    // A plan beyond the horizon is none of those looked for.
    let mut tight = request(&bay, Some(good.clone()));
    tight.within = without.costs.map(|costs| costs.makespan - 1);
    let answer = solve(&tight, &SilentHost);
    assert_eq!((answer.status, answer.plan), (Status::Impossible, None));
    let soon = Listener::new(usize::MAX, 1);
    assert_eq!(solve(&tight, &soon).status, Status::Unknown);
}

/// Nobody checks that a plan keeps a rule that is left out, so that it says nothing of which
/// bounds plans that do can reach: that of a later cost is not told.
#[test]
fn a_plan_vouches_for_no_rule_that_is_left_out() {
    let bay = bay();
    let own = solve(&request(&bay, None), &SilentHost);
    assert_eq!(own.status, Status::Optimal);
    assert!(own.bounds.len() > 1, "{:?}", own.bounds);
    let mut left_out = request(&bay, own.plan);
    left_out.scene.assumptions = vec![Assumption::RuleLeftOut {
        rule: LeftOutRule::Turning,
    }];
    let answer = solve(&left_out, &SilentHost);
    assert_eq!(answer.status, Status::Feasible);
    let first = left_out.scene.objective.costs()[0];
    let bounds: Vec<Cost> = answer.bounds.keys().copied().collect();
    assert_eq!(bounds, [first]);
}

#[test]
fn what_a_small_program_serves_is_what_the_whole_serves() {
    let plan = |response| match response {
        Response::Solved(answer) => answer.plan,
        other => panic!("expected a plan, found {other:?}"),
    };
    let mut solved = 0;
    for seed in 0..60 {
        let solve = SolveRequest {
            scene: random(seed, 2).to_scene(),
            ..SolveRequest::default()
        };
        let front = SolveRequest {
            pareto: true,
            ..solve.clone()
        };
        assert_eq!(Request::Solve(front).basic(), None);
        let solve = Request::Solve(solve);
        let basic = solve.basic().expect("a solve is basic");
        let whole = plan(serve(&solve, &SilentHost));
        solved += usize::from(whole.is_some());
        assert_eq!(plan(serve_basic(basic, &SilentHost)), whole);
    }
    assert!(solved > 3, "only {solved} of 60 scenes have a plan");
}
