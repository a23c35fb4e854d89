//! Plans around which the world changes that were gone on with wrongly once.
//! `data/wrong/README.md` names the cases.
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "a test that cannot go on ends with a panic"
)]

mod waits;

use giveway_model::check::{Report, check_changes};
use giveway_model::format::native;
use giveway_model::{Cost, Costs, Plan, Scene};
use giveway_solve::change::{ChangeAnswer, ChangeRequest, Method, MethodAnswer};
use giveway_solve::{
    Host, Limits, Progress, Reason, Refusal, Request, Response, SilentHost, Status, Stop, serve,
};
use giveway_tests::wrong::{instance, plan, text};

use giveway_model::change::Changes;

fn changes(name: &str) -> Changes {
    native::read_changes(&text(name)).unwrap_or_else(|fault| panic!("{name}: {fault}"))
}

/// The files of a case: a folder with `i.json`, `p.json` and `c.json`, or files
/// of its name.
fn files(case: &str) -> [String; 3] {
    match case {
        "contradiction-070" => ["instance", "plan", "changes"].map(|f| format!("{case}.{f}.json")),
        "c2b-fault-revise-unknown" => {
            ["instance", "plan", "changes"].map(|f| format!("{case}/{f}.json"))
        }
        _ => ["i", "p", "c"].map(|f| format!("{case}/{f}.json")),
    }
}

/// The request for these methods, and nothing else asked for.
fn request_of(scene: Scene, plan: Plan, changes: Changes, methods: &[Method]) -> ChangeRequest {
    ChangeRequest {
        scene,
        plan,
        changes,
        since: None,
        methods: methods.to_vec(),
        objective: None,
        within: None,
        limits: Limits::default(),
    }
}

fn request(case: &str) -> ChangeRequest {
    let [i, p, c] = files(case);
    request_of(
        instance(&i).to_scene(),
        plan(&p),
        changes(&c),
        &[Method::Revise, Method::Replan],
    )
}

fn answer(request: ChangeRequest) -> Result<ChangeAnswer, Refusal> {
    match serve(&Request::Change(request), &SilentHost) {
        Response::Changed(answer) => Ok(*answer),
        Response::Refused(refusal) => Err(refusal),
        other => panic!("{other:?}"),
    }
}

/// How to go on in a case. Each plan is what the judge says it is.
fn go_on(case: &str) -> ChangeAnswer {
    let request = request(case);
    let (scene, list) = (request.scene.clone(), request.changes.clone());
    let answer = answer(request).unwrap_or_else(|refusal| panic!("{case}: {refusal:?}"));
    let instance = giveway_model::Instance::new(scene).unwrap();
    for (method, found) in &answer.methods.0 {
        if let Some(plan) = &found.result.plan {
            let report = check_changes(&instance, &list, plan).unwrap();
            assert!(
                report.is_valid(),
                "{case} {method}: {:?}",
                report.violations
            );
            assert_eq!(report.costs, found.result.costs, "{case} {method}");
        }
    }
    answer
}

fn optimal(answer: &ChangeAnswer, method: Method) -> Costs {
    let found = answer.methods.get(method).unwrap();
    assert_eq!(found.result.status, Status::Optimal, "{method}: {found:?}");
    found.result.costs.unwrap()
}

fn judge(case: &str, plan_file: &str) -> Report {
    let [i, _, c] = files(case);
    check_changes(&instance(&i), &changes(&c), &plan(plan_file)).unwrap()
}

#[test]
fn a_cost_is_no_time_and_who_goes_on_has_not_arrived() {
    for (case, makespan, sum, waits) in [
        ("contradiction-070", Some(20), None, None),
        ("d1-woken", Some(7), Some(20), None),
        ("c2-fault-revise-at-goal", Some(4), Some(4), Some(2)),
        ("c2b-fault-revise-unknown", None, None, None),
    ] {
        let answer = go_on(case);
        for method in [Method::Revise, Method::Replan] {
            let costs = optimal(&answer, method);
            if method == Method::Revise || case == "d1-woken" || case == "contradiction-070" {
                let same = |said: Option<u32>, found: u32| said.is_none_or(|said| said == found);
                assert!(same(makespan, costs.makespan), "{case} {method} {costs:?}");
                assert!(same(sum, costs.sum_of_costs), "{case} {method} {costs:?}");
                assert!(same(waits, costs.waits), "{case} {method} {costs:?}");
            }
        }
    }
}

#[test]
fn who_is_removed_at_its_goal_slept() {
    let answer = go_on("c1-removed-sleeper");
    for method in [Method::Revise, Method::Replan] {
        assert_eq!(optimal(&answer, method), Costs::default());
    }
    for file in ["legal.json", "legal2.json"] {
        let report = judge("c1-removed-sleeper", &format!("c1-removed-sleeper/{file}"));
        assert!(report.is_valid(), "{file}: {:?}", report.violations);
    }
}

#[test]
fn who_vanishes_later_still_stands_at_its_goal() {
    let case = "c3-vanish-at-goal";
    let answer = go_on(case);
    let costs = optimal(&answer, Method::Replan);
    assert_eq!((costs.makespan, costs.waits), (3, 2));
    // What is past is as it was.
    let old = plan("c3-vanish-at-goal/p.json");
    for (_, found) in &answer.methods.0 {
        let new = found.result.plan.as_ref().unwrap();
        assert_eq!(new.path("A").get(..4), old.path("A").get(..4));
    }
    let costs = optimal(&answer, Method::Revise);
    assert_eq!((costs.makespan, costs.moves, costs.waits), (5, 3, 2));
}

#[test]
fn nobody_is_in_transit_where_no_edge_is_slow() {
    let report = judge("c4-check-transit", "c4-check-transit/p.json");
    assert_eq!(report.violations.len(), 1, "{:?}", report.violations);
}

/// The judge and the search agree on the battery of who stood at its goal and
/// was about to go on.
#[test]
fn a_rest_that_is_none_gives_no_energy_back() {
    let report = judge("c5-battery-refund", "c5-battery-refund/spliced.json");
    assert!(!report.is_valid());
    let answer = go_on("c5-battery-refund");
    for (method, found) in &answer.methods.0 {
        assert_eq!(found.result.status, Status::Impossible, "{method}");
        let cause = found.cause.as_ref().unwrap();
        assert_eq!(cause.agent, "A");
        assert_eq!(
            found.result.reason,
            Some(Reason::Cause(Box::new(cause.clone())))
        );
    }
}

/// What a plan knows is past: it is not played again.
#[test]
fn the_changes_that_a_plan_knows_are_past() {
    let case = "c6-replay";
    let old = plan("c6-replay/p.json");
    let knowing = Plan {
        knows: Some(16),
        ..old.clone()
    };
    for (since, given) in [(Some(18), old.clone()), (None, knowing)] {
        let mut request = request(case);
        (request.since, request.plan) = (since, given);
        let answer = answer(request).unwrap();
        assert_eq!((answer.at, answer.history.len()), (Some(18), 0));
        let adopted = answer.adopted().unwrap();
        let new = adopted.result.plan.as_ref().unwrap();
        assert_eq!(new.knows, Some(18));
        for agent in ["A", "B"] {
            let (new, old) = (new.path(agent), old.path(agent));
            let past = old.len().min(18);
            assert_eq!(new.get(..past), old.get(..past), "{agent}");
        }
    }
    // One that says nothing knows nothing, where it is valid without.
    assert_eq!(go_on(case).history.len(), 2);
}

/// A plan goes on across changes: what was adopted says what it knows.
#[test]
fn an_adopted_plan_is_gone_on_with() {
    let case = "d1-woken";
    let adopted = go_on(case).adopted().unwrap().result.plan.clone().unwrap();
    assert_eq!(adopted.knows, Some(3));
    let mut request = request(case);
    request.plan = adopted;
    assert_eq!(answer(request).unwrap().at, None);
}

#[test]
fn all_sets_of_freed_agents_are_compared() {
    let answer = go_on("e1-thirteen-sets");
    let costs = optimal(&answer, Method::Revise);
    assert_eq!(costs.makespan, 3);
    let found = answer.methods.get(Method::Revise).unwrap();
    assert_eq!(found.freed, ["A0", "A1", "A2", "A3"]);
}

/// A clock that goes on by a step each time that somebody looks.
struct Ticking {
    step: f64,
    now: std::cell::Cell<f64>,
}

impl Host for Ticking {
    fn wall_seconds(&self) -> f64 {
        self.now.set(self.now.get() + self.step);
        self.now.get()
    }

    fn progress(&self, _: &Progress) {}
}

/// Wherever the time runs out, nothing is called optimal that is not, and no
/// fault of the program is made of it.
#[test]
fn running_out_of_time_is_neither_a_fault_nor_a_proof() {
    let case = "e2-time";
    let mut request = request(case);
    request.methods = vec![Method::Revise];
    let costs = |answer: &MethodAnswer| answer.result.costs.map(|costs| costs.makespan);
    let whole = answer(request.clone()).unwrap();
    let whole = whole.methods.get(Method::Revise).unwrap().clone();
    let mut seen = std::collections::BTreeSet::new();
    request.limits.seconds = Some(1.0);
    for n in 0..24_i32 {
        let host = Ticking {
            step: 1.5_f64.powi(-n),
            now: std::cell::Cell::new(0.0),
        };
        let response = serve(&Request::Change(request.clone()), &host);
        let Response::Changed(answer) = response else {
            panic!("{response:?}");
        };
        let found = answer.methods.get(Method::Revise).unwrap();
        let reason = found.result.reason.as_ref();
        assert_ne!(reason, Some(&Reason::Stopped(Stop::Contradiction)), "{n}");
        seen.insert(format!("{:?}", found.result.status));
        match found.result.status {
            Status::Optimal => assert_eq!(costs(found), costs(&whole), "{n}"),
            Status::Impossible => assert_eq!(whole.result.status, Status::Impossible, "{n}"),
            Status::Feasible | Status::Unknown => assert!(reason.is_some(), "{n}"),
        }
    }
    assert!(seen.len() > 1, "{seen:?}");
}

#[test]
fn a_delay_of_a_million_steps_is_refused() {
    let mut request = request("s1-delay");
    request.methods = vec![Method::Replan];
    let refusal = answer(request).unwrap_err();
    let sentences = refusal.sentences().join(" ");
    assert!(
        sentences.contains("a delay of 1000000 steps"),
        "{sentences}"
    );
    assert!(sentences.contains("at most 10000"), "{sentences}");
}

#[test]
fn bounds_are_no_more_than_costs() {
    for case in [
        "contradiction-070",
        "d1-woken",
        "c2-fault-revise-at-goal",
        "c3-vanish-at-goal",
    ] {
        for (method, found) in &go_on(case).methods.0 {
            let costs = found.result.costs.unwrap();
            for cost in Cost::USUAL {
                let bound = found.result.bounds.get(&cost).copied();
                assert!(
                    bound.is_none_or(|bound| bound <= costs.get(cost)),
                    "{case} {method} {cost:?}"
                );
            }
        }
    }
}
