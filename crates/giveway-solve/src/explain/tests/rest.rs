//! Questions about a plan around which the world has changed: in the times of
//! the whole, and refused where they cannot be answered.

use giveway_model::{
    Costs, Instance, Plan, Question,
    change::Changes,
    check::{Rule, check_changes},
    format::native,
    question::from_words,
};

use giveway_proof::Claim;

use super::{handed_on::Eager, read};
use crate::{
    CertifyRequest, Host, Progress, Refusal, Request, Response, SilentHost,
    explain::{Edit, ExplainAnswer, ExplainRequest, Layer, Verdict},
    serve,
};

pub(super) struct Course {
    pub(super) instance: Instance,
    pub(super) plan: Plan,
    pub(super) changes: Changes,
}

pub(super) fn course(instance: &str, plan: &str, changes: &str) -> Course {
    let (instance, plan) = read(instance, plan);
    let changes = format!(r#"{{ "giveway": 1, "changes": [{changes}] }}"#);
    let changes = native::read_changes(&changes).unwrap();
    Course {
        instance,
        plan,
        changes,
    }
}

/// `a` goes along the middle row from the left; `b` has arrived below at time 1.
/// At time 3 the cell (4, 1) becomes an obstacle; `a` goes around by the top
/// row and waits on the way.
fn around() -> Course {
    course(
        r#"{ "giveway": 1, "map": ["......", "......", "......"], "agents": [
            { "name": "a", "start": [0, 1], "goal": [5, 1] },
            { "name": "b", "start": [4, 1], "goal": [4, 2] }] }"#,
        r#"{ "giveway": 1, "paths": {
            "a": [[0, 1], [1, 1], [2, 1], [3, 1], [3, 1], [3, 0], [4, 0], [5, 0], [5, 1]],
            "b": [[4, 1], [4, 2]] } }"#,
        r#"{ "at": 3, "change": "add-obstacle", "cell": [4, 1] }"#,
    )
}

impl Course {
    pub(super) fn request(&self, words: &str) -> ExplainRequest {
        let words: Vec<&str> = words.split_whitespace().collect();
        ExplainRequest {
            scene: self.instance.to_scene(),
            plan: Some(self.plan.clone()),
            changes: Some(self.changes.clone()),
            at: None,
            question: from_words(&words).unwrap(),
            objective: None,
            within: None,
            proved: None,
            known: None,
            layers: Vec::new(),
            limits: crate::Limits::default(),
        }
    }

    pub(super) fn ask(&self, words: &str) -> ExplainAnswer {
        explained(self.request(words)).unwrap_or_else(|refused| panic!("{words}: {refused:?}"))
    }

    pub(super) fn refused(&self, words: &str) -> String {
        let refusal = explained(self.request(words)).unwrap_err();
        refusal.sentences().join(" ")
    }

    pub(super) fn costs(&self, plan: &Plan) -> Costs {
        let report = check_changes(&self.instance, &self.changes, plan).unwrap();
        assert_eq!(report.violations, []);
        report.costs.unwrap()
    }
}

pub(super) fn explained(request: ExplainRequest) -> Result<ExplainAnswer, Refusal> {
    match serve(&Request::Explain(request), &SilentHost) {
        Response::Explained(answer) => Ok(*answer),
        Response::Refused(refusal) => Err(refusal),
        other => panic!("{other:?}"),
    }
}

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
        "Remove the obstacle at (4, 1): makespan 5, sum of costs 6."
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
fn what_is_past_is_refused() {
    let course = around();
    assert_eq!(
        course.refused("visit a --at 1,1 --time 1"),
        "Time 1 is already past: the question is about the plan from time 3 on, and the past \
         cannot change."
    );
    assert_eq!(
        course.refused("visit a --at 1,1"),
        "From time 3 on: a never passes (1, 1). You can ask: no-visit a --at 1,1"
    );
    assert_eq!(
        course.refused("arrival b"),
        "b was already at its goal at time 3, and the past cannot change."
    );
    assert!(
        course
            .refused("wait a --at 5,0")
            .contains("at (3, 1) from time 3 to 4")
    );
}

#[test]
fn changes_after_the_time_shown_do_not_count() {
    let mut course = around();
    let later = r#"{ "giveway": 1, "changes": [
        { "at": 3, "change": "add-obstacle", "cell": [4, 1] },
        { "at": 5, "change": "remove-agent", "agent": "b" }] }"#;
    course.changes = native::read_changes(later).unwrap();
    let mut request = course.request("arrival a");
    request.at = Some(4);
    assert_eq!(explained(request.clone()).unwrap().since, Some(3));
    // Before any change it is a question about the plan in one world.
    request.at = Some(2);
    request.question = Question::Arrival {
        agent: "b".to_owned(),
    };
    let answer = explained(request.clone()).unwrap();
    assert_eq!((answer.since, answer.verdict), (None, Verdict::Necessary));
    // With the later change the plan is none: `b` is not said to be gone.
    request.at = None;
    assert!(matches!(
        explained(request.clone()),
        Err(Refusal::Plan { .. })
    ));
    request.plan = None;
    assert!(matches!(explained(request), Err(Refusal::Request { .. })));
}

#[test]
fn why_there_is_no_way_to_go_on() {
    let course = course(
        r#"{ "giveway": 1, "map": ["...."], "agents": [
            { "name": "a", "start": [0, 0], "goal": [3, 0] }] }"#,
        r#"{ "giveway": 1, "paths": { "a": [[0, 0], [1, 0], [2, 0], [3, 0]] } }"#,
        r#"{ "at": 1, "change": "add-obstacle", "cell": [2, 0] }"#,
    );
    let answer = course.ask("unsolvable");
    assert_eq!(
        (answer.since, answer.verdict),
        (Some(1), Verdict::Necessary)
    );
    assert!(answer.reach.is_complete());
    let words = answer.words;
    assert!(words.starts_with("This is about the plan from time 1 on. There is no plan."));
    assert!(words.contains("a must go from (1, 0) to (3, 0)"), "{words}");
    assert!(
        words.contains("pass through the obstacle at (2, 0) at time 2"),
        "{words}"
    );
    let repair = answer.repairs.first().unwrap();
    assert_eq!(
        repair.text,
        "Remove the obstacle at (2, 0): makespan 3, sum of costs 3."
    );
    assert_eq!(repair.plan.paths, course.plan.paths);
    assert_eq!(repair.plan.knows, Some(1));
    // Where there is a way, that is said.
    let mut open = around();
    open.plan.paths.insert(
        "a".to_owned(),
        (0..6).map(|x| Some((x, 1).into())).collect(),
    );
    let refused = open.refused("unsolvable");
    assert!(
        refused.starts_with("There is a plan, with a makespan of 7."),
        "{refused}"
    );
}

#[test]
fn a_goal_in_an_obstacle_is_said_plainly() {
    let course = course(
        r#"{ "giveway": 1, "map": ["...."], "agents": [
            { "name": "a", "start": [0, 0], "goal": [3, 0] }] }"#,
        r#"{ "giveway": 1, "paths": { "a": [[0, 0], [1, 0], [2, 0], [3, 0]] } }"#,
        r#"{ "at": 1, "change": "add-obstacle", "cell": [3, 0] }"#,
    );
    assert_eq!(
        course.refused("unsolvable"),
        "There is no plan from time 1 on, because a has to go to (3, 0), where there is an obstacle."
    );
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

#[test]
fn no_certificate_is_made_of_what_is_about_two_worlds() {
    let course = around();
    let answer = course.ask("makespan");
    let request = CertifyRequest::of_explained(&course.instance, Some(&course.plan), &answer);
    assert!(request.bounds.is_empty() && !request.impossible);
    assert_eq!((request.plan, request.about), (None, Claim::default()));
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
