//! Where the others are held to their ways in the plan, an agent alone goes as it would anyway.

use crate::{
    Limits, Request, Response, SilentHost, SolveRequest,
    budget::Budget,
    explain::{
        ask::walks,
        lone_walk::{lone_walk, problem_of_one},
    },
    problem::Problem,
    serve,
    tests::random,
};

#[test]
fn to_hold_the_others_to_their_ways_changes_no_lone_walk() {
    let mut compared = 0;
    for seed in 0..400 {
        let instance = random(seed, 2 + (seed % 3) as usize);
        let request = Request::Solve(SolveRequest {
            scene: instance.to_scene(),
            ..SolveRequest::default()
        });
        let Response::Solved(solved) = serve(&request, &SilentHost) else {
            panic!("{seed}");
        };
        let Some(plan) = solved.plan else { continue };
        let budget = Budget::new(&SilentHost, Limits::default());
        let Ok(all) = Problem::new(&instance, &budget) else {
            panic!("{seed}");
        };
        let together = walks(&instance, &all, &plan).unwrap();
        let latest = all.default_horizon(instance.grid());
        for agent in 0..instance.agents().len() {
            let one = problem_of_one(&instance, &plan, (agent, None), &budget).unwrap();
            let held = walks(&instance, &one, &plan).unwrap();
            assert_eq!(held, together, "{seed}");
            let walk = |problem| lone_walk(problem, &held, (agent, latest), &budget);
            assert_eq!(walk(&one).unwrap(), walk(&all).unwrap(), "{seed}, {agent}");
            let other = (agent + 1) % one.agents();
            compared += usize::from(one.tasks[other].along().is_some());
        }
    }
    assert!(compared > 200, "{compared}");
}
