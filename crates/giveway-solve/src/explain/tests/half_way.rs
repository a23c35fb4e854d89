//! Questions at a time at which something has begun: a slow move, a wait, a stand at the
//! goal.

use giveway_model::check::Rule;

use super::rest::course;
use crate::explain::Verdict;

#[test]
fn who_is_half_way_along_a_slow_move_completes_it() {
    let course = course(
        r#"{ "giveway": 1, "map": [".~~...", "......"], "agents": [
            { "name": "a", "start": [1, 0], "goal": [4, 0] }] }"#,
        r#"{ "giveway": 1, "paths": { "a": [[1, 0], null, [2, 0], [2, 0], [3, 0], [4, 0]] } }"#,
        r#"{ "at": 1, "change": "add-obstacle", "cell": [5, 1] }"#,
    );
    let answer = course.ask("wait a");
    assert_eq!(
        (answer.since, answer.verdict),
        (Some(1), Verdict::Improvable)
    );
    let other = answer.alternative.unwrap();
    assert_eq!(course.costs(&other).makespan, 4);
    assert_eq!(other.path("a")[..3], course.plan.path("a")[..3]);
    assert_eq!(
        course.refused("unsolvable"),
        "There is a plan, with a makespan of 4. You can ask: makespan"
    );
    // What it is at when the change comes cannot be taken back.
    let answer = course.ask("visit a --at 2,0 --time 2");
    assert_eq!(answer.verdict, Verdict::Necessary, "{}", answer.words);
    assert!(answer.reach.is_complete());
}

#[test]
fn two_that_are_on_one_slow_edge_collide() {
    // `a` is half way from (1, 0) to (2, 0), where `b` stands until time 1.
    let course = course(
        r#"{ "giveway": 1, "map": [".~~.", "...."], "agents": [
            { "name": "a", "start": [1, 0], "goal": [3, 0] },
            { "name": "b", "start": [2, 0], "goal": [1, 0] }] }"#,
        r#"{ "giveway": 1, "paths": {
            "a": [[1, 0], null, [2, 0], [3, 0]],
            "b": [[2, 0], [2, 0], [2, 1], [1, 1], [1, 0]] } }"#,
        r#"{ "at": 1, "change": "add-obstacle", "cell": [3, 1] }"#,
    );
    let answer = course.ask("no-move b --from-cell 2,0 --to-cell 1,0 --time 1");
    assert_eq!(
        (answer.since, answer.verdict),
        (Some(1), Verdict::Necessary)
    );
    assert!(answer.reach.is_complete());
    let rules: Vec<Rule> = answer.witness.iter().map(|it| it.violation.rule).collect();
    assert_eq!(rules, [Rule::SlowSwap], "{}", answer.words);
}

#[test]
fn a_wait_that_began_before_the_change_goes_on() {
    // `a` waits at (2, 1) from time 1 to 5; the change comes at time 3.
    let course = course(
        r#"{ "giveway": 1, "map": ["......", "......"], "agents": [
            { "name": "a", "start": [1, 1], "goal": [5, 1] }] }"#,
        r#"{ "giveway": 1, "paths": { "a": [[1, 1], [2, 1], [2, 1], [2, 1], [2, 1], [2, 1],
            [3, 1], [4, 1], [5, 1]] } }"#,
        r#"{ "at": 3, "change": "add-obstacle", "cell": [5, 0] }"#,
    );
    for words in ["wait a --at-least 4", "wait a --at 2,1 --at-least 3"] {
        let answer = course.ask(words);
        assert_eq!(answer.verdict, Verdict::Improvable, "{words}");
        assert_eq!(course.costs(&answer.alternative.unwrap()).makespan, 6);
    }
    // Of the steps that are asked about, one is past.
    let answer = course.ask("wait a --from 2 --at-least 3");
    assert_eq!(answer.verdict, Verdict::Improvable);
    assert_eq!(
        course.refused("wait a --at-least 2"),
        "a was already waiting before the change. Ask about its wait from time 3 on."
    );
    let refused = course.refused("wait a --from 3 --at-least 3");
    assert!(refused.starts_with("From time 3 on: "), "{refused}");
}

#[test]
fn a_robot_that_stood_at_its_goal_may_have_arrived() {
    // `a` stands at its goal from time 1 to 4, and then goes out of the way of nobody.
    let course = course(
        r#"{ "giveway": 1, "map": ["...", "..."], "objective": ["sum-of-costs", "waits"],
            "agents": [{ "name": "a", "start": [0, 0], "goal": [1, 0] }] }"#,
        r#"{ "giveway": 1, "paths": { "a": [[0, 0], [1, 0], [1, 0], [1, 0], [1, 0], [1, 1],
            [1, 0]] } }"#,
        r#"{ "at": 3, "change": "add-obstacle", "cell": [2, 1] }"#,
    );
    for words in [
        "plan",
        "waits a",
        "arrival a",
        "move a --from-cell 1,0 --to-cell 1,1",
    ] {
        let answer = course.ask(words);
        assert_eq!(answer.verdict, Verdict::Improvable, "{words}");
        let other = answer.alternative.unwrap();
        let costs = course.costs(&other);
        assert_eq!((costs.sum_of_costs, costs.waits), (1, 0), "{words}");
        assert_eq!(answer.costs, Some(costs), "{words}");
        assert_eq!(other.path("a").len(), 2, "{words}");
    }
}
