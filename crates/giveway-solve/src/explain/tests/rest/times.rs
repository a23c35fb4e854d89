//! Answers about a plan around which the world has changed, in the times and costs of the whole.

use giveway_model::check::Rule;

use super::{around, course};
use crate::{
    Host, Progress, Request, Response,
    explain::{Edit, ExplainAnswer, ExplainRequest, Layer, Verdict, tests::handed_on::Eager},
    serve,
};

#[test]
fn a_wait_after_the_change_is_told_in_times_of_the_whole() {
    let course = around();
    let answer = course.ask("wait a --from 3 --to 4");
    assert_eq!(
        (answer.since, answer.verdict),
        (Some(3), Verdict::Improvable)
    );
    let other = answer.alternative.unwrap();
    let costs = course.costs(&other);
    assert_eq!((costs.makespan, costs.sum_of_costs), (7, 8));
    assert_eq!(answer.costs, Some(costs));
    assert_eq!(
        answer.words,
        "This is about the plan from time 3 on. There is even a better plan in which a does \
         not wait between time 3 and 4: a makespan of 7 instead of 8 and a sum of costs of 8 \
         instead of 9."
    );
}

#[test]
fn arrivals_and_facts_are_those_of_the_whole() {
    let mut course = around();
    course.plan.paths.get_mut("a").unwrap().remove(4);
    let answer = course.ask("arrival a");
    assert_eq!(answer.verdict, Verdict::Necessary);
    let words = answer.words;
    assert!(words.contains("a arrives before time 7"), "{words}");
    let facts = answer.core.unwrap().facts;
    let facts: Vec<&str> = facts.iter().map(|fact| fact.text.as_str()).collect();
    assert!(facts.contains(&"(4, 1) is an obstacle"), "{facts:?}");
    let repair = answer.repairs.first().unwrap();
    assert!(matches!(repair.edits[..], [Edit::RemoveObstacle { .. }]));
    assert_eq!(
        repair.text,
        "Remove the obstacle at (4, 1): a arrives at 5, makespan 5, sum of costs 6."
    );
    assert_eq!((repair.costs.makespan, repair.costs.moves), (5, 6));
    assert_eq!(repair.plan.path("a").len(), 6);
}

#[test]
fn what_would_happen_has_the_times_of_the_whole() {
    let course = course(
        r#"{ "giveway": 1, "map": ["....", "....", "...."], "agents": [
            { "name": "a", "start": [0, 1], "goal": [3, 1] },
            { "name": "b", "start": [1, 0], "goal": [2, 1] }] }"#,
        r#"{ "giveway": 1, "paths": {
            "a": [[0, 1], [1, 1], [2, 1], [3, 1]],
            "b": [[1, 0], [2, 0], [2, 0], [2, 1]] } }"#,
        r#"{ "at": 1, "change": "add-obstacle", "cell": [0, 2] }"#,
    );
    let answer = course.ask("wait b");
    assert_eq!(answer.since, Some(1));
    let told: Vec<(Rule, u32, &str)> = answer
        .witness
        .iter()
        .map(|entry| &entry.violation)
        .map(|it| (it.rule, it.time, it.message.as_str()))
        .collect();
    let message = "a and b are both at (2, 1) at time 2.";
    assert_eq!(told, [(Rule::Vertex, 2, message)]);
    assert!(
        answer.words.contains("meet a at (2, 1) at time 2"),
        "{}",
        answer.words
    );
    let times = course.ask("move a --from-cell 2,1 --to-cell 3,1 --time 2");
    assert!(times.words.contains("at time 2"), "{}", times.words);
}

#[test]
fn to_wake_a_sleeper_costs_all_that_it_slept() {
    // `b` rests in the only way; it can step aside into the bay.
    let course = course(
        r#"{ "giveway": 1, "map": ["....", ".#.."], "agents": [
            { "name": "b", "start": [2, 0], "goal": [2, 0] }] }"#,
        r#"{ "giveway": 1, "paths": { "b": [[2, 0], [2, 0], [2, 0], [2, 0], [2, 0], [2, 1], [2, 1],
            [2, 0]], "n": [[0, 0], [1, 0], [2, 0], [3, 0]] }, "from": { "n": 4 } }"#,
        r#"{ "at": 4, "change": "add-agent", "agent":
            { "name": "n", "start": [0, 0], "goal": [3, 0] } }"#,
    );
    let answer = course.ask("plan");
    assert_eq!(
        (answer.valid, answer.optimal),
        (Some(true), Some(true)),
        "{}",
        answer.words
    );
    assert_eq!(answer.costs, Some(course.costs(&course.plan)));
    assert_eq!(answer.costs.unwrap().sum_of_costs, 14);
    let answer = course.ask("sum-of-costs");
    assert_eq!(answer.verdict, Verdict::Necessary);
    assert!(
        answer.words.contains("sum of costs is below 14"),
        "{}",
        answer.words
    );
}

#[test]
fn another_plan_says_who_slept() {
    // The same, but everyone begins a step later than need be.
    let course = course(
        r#"{ "giveway": 1, "map": ["....", ".#.."], "agents": [
            { "name": "b", "start": [2, 0], "goal": [2, 0] }] }"#,
        r#"{ "giveway": 1, "knows": 4, "slept": { "b": [[0, 4]] }, "paths": {
            "b": [[2, 0], [2, 0], [2, 0], [2, 0], [2, 0], [2, 0], [2, 1], [2, 1], [2, 0]],
            "n": [[0, 0], [0, 0], [1, 0], [2, 0], [3, 0]] }, "from": { "n": 4 } }"#,
        r#"{ "at": 4, "change": "add-agent", "agent":
            { "name": "n", "start": [0, 0], "goal": [3, 0] } }"#,
    );
    assert_eq!(course.costs(&course.plan).sum_of_costs, 16);
    let answer = course.ask("wait n");
    assert_eq!(answer.verdict, Verdict::Improvable, "{}", answer.words);
    let other = answer.alternative.unwrap();
    assert_eq!((other.knows, other.slept("b")), (Some(4), &[[0, 4]][..]));
    let costs = course.costs(&other);
    assert_eq!((costs.sum_of_costs, answer.costs), (14, Some(costs)));
    assert!(costs.waits <= 2, "{costs:?}");
}

#[test]
fn what_is_told_on_the_way_is_of_the_whole_too() {
    struct Heard(std::cell::RefCell<Vec<ExplainAnswer>>);
    impl Host for Heard {
        fn wall_seconds(&self) -> f64 {
            0.0
        }
        fn progress(&self, event: &Progress) {
            if let Progress::Explained { answer } = event {
                self.0.borrow_mut().push((**answer).clone());
            }
        }
    }
    let heard = Heard(std::cell::RefCell::default());
    let course = around();
    let request = Request::Explain(course.request("wait a"));
    let _ = serve(&request, &heard);
    let heard = heard.0.into_inner();
    assert!(heard.len() > 2);
    for answer in heard {
        assert_eq!(answer.since, Some(3));
        assert_eq!(answer.question, course.request("wait a").question);
        if let Some(plan) = &answer.alternative {
            assert_eq!(answer.costs, Some(course.costs(plan)));
        }
    }
}

/// What agents alone need is told of the whole plan: with what they had paid before the change.
#[test]
fn what_agents_alone_need_counts_from_the_beginning() {
    let course = course(
        r#"{ "giveway": 1, "map": ["....", "@.@@", "@@@@", "..@@"], "agents": [
            { "name": "a", "start": [0, 0], "goal": [3, 0] },
            { "name": "b", "start": [3, 0], "goal": [0, 0] }] }"#
            .replace('@', "#")
            .as_str(),
        r#"{ "giveway": 1, "paths": {
            "a": [[0, 0], [1, 0], [1, 1], [1, 0], [2, 0], [3, 0]],
            "b": [[3, 0], [2, 0], [1, 0], [0, 0]] } }"#,
        r#"{ "at": 1, "change": "add-obstacle", "cell": [0, 3] }"#,
    );
    let request = ExplainRequest {
        layers: vec![Layer::Reason],
        ..course.request("sum-of-costs")
    };
    let Response::Explained(answer) = serve(&Request::Explain(request), &Eager::default()) else {
        panic!("not answered");
    };
    assert_eq!(
        (answer.since, answer.verdict),
        (Some(1), Verdict::Necessary)
    );
    let costs = course.costs(&course.plan);
    let bounds = answer.alone.iter();
    let bounds: Vec<_> = bounds.map(|it| (it.own, it.least, it.here)).collect();
    assert_eq!(bounds, [(6, costs.sum_of_costs, costs.sum_of_costs)]);
}
