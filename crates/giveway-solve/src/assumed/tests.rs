//! No claim of a scene is one of the file's problem where that may have other plans.

use giveway_model::format::native;
use giveway_model::{Plan, Question, Scene};

use crate::{
    Reason, Request, Response, SilentHost, Status,
    change::{ChangeRequest, Method},
    explain::{Core, ExplainRequest},
    freedom::FreedomRequest,
    plan::{PlanEnd, PlanRequest, Planner},
    serve,
};

const OTHERS: [&str; 3] = [
    r#"{ "assumes": "goals-chosen" }"#,
    r#"{ "assumes": "rule-left-out", "rule": "turning" }"#,
    r#"{ "assumes": "unknown-key", "key": "doors" }"#,
];

fn scene(map: &str, agents: &str, assumption: &str) -> Scene {
    let text = format!(
        r#"{{ "giveway": 1, "map": {map}, "agents": {agents}, "assumptions": [{assumption}] }}"#
    );
    native::read_scene(&text).unwrap()
}

fn open(assumption: &str) -> Scene {
    let agents = r#"[{ "name": "A1", "start": [0, 0], "goal": [2, 0] }]"#;
    scene(r#"["...", "..."]"#, agents, assumption)
}

fn walled(assumption: &str) -> Scene {
    let agents = r#"[{ "name": "A1", "start": [0, 0], "goal": [2, 0] }]"#;
    scene(r#"[".#."]"#, agents, assumption)
}

fn plan(path: &str) -> Plan {
    let text = format!(r#"{{ "giveway": 1, "paths": {{ "A1": {path} }} }}"#);
    native::read_plan(&text).unwrap()
}

#[test]
fn questions_and_best_plans_claim_nothing_for_every_horizon() {
    for assumption in OTHERS {
        for (scene, question) in [
            (walled(assumption), Question::Unsolvable),
            (open(assumption), Question::Plan),
        ] {
            let request = Request::Explain(ExplainRequest {
                scene,
                plan: None,
                changes: None,
                at: None,
                question,
                objective: None,
                within: None,
                proved: None,
                known: None,
                layers: Vec::new(),
                limits: crate::Limits::default(),
            });
            let Response::Explained(answer) = serve(&request, &SilentHost) else {
                panic!("{assumption}");
            };
            assert!(!answer.reach.is_complete(), "{assumption}");
            let mut sets = answer.core.iter().flat_map(Core::sets);
            assert!(sets.all(|core| !core.reach.is_complete()), "{assumption}");
        }
        let request = Request::Freedom(FreedomRequest {
            scene: open(assumption),
            ..FreedomRequest::default()
        });
        let Response::Freedom(answer) = serve(&request, &SilentHost) else {
            panic!("{assumption}");
        };
        assert!(!answer.reach.is_complete(), "{assumption}");
    }
}

#[test]
fn planners_prove_nothing_of_the_file() {
    let ended = |scene: Scene| {
        let request = Request::Plan(PlanRequest::new(scene, Planner::Cbs));
        match serve(&request, &SilentHost) {
            Response::Planned(answer) => answer.ended,
            other => panic!("{other:?}"),
        }
    };
    let [chosen, left_out, unknown] = OTHERS;
    assert_eq!(
        ended(walled(chosen)),
        PlanEnd::Stopped {
            reason: Reason::ChosenGoals
        }
    );
    assert!(matches!(ended(walled(left_out)), PlanEnd::Alone { .. }));
    assert!(matches!(ended(walled(unknown)), PlanEnd::Stopped { .. }));
    assert_eq!(ended(open(left_out)), PlanEnd::Found);
    assert_eq!(ended(open(unknown)), PlanEnd::Found);
    assert!(matches!(ended(open(chosen)), PlanEnd::Best { .. }));
}

#[test]
fn a_change_has_no_optimal_plan_where_a_rule_is_left_out() {
    for assumption in &OTHERS[1..] {
        let changes = r#"{ "giveway": 1, "changes": [{ "at": 1, "change": "add-obstacle", "cell": [2, 1] }] }"#;
        let request = Request::Change(ChangeRequest {
            scene: open(assumption),
            plan: plan("[[0, 0], [1, 0], [2, 0]]"),
            changes: native::read_changes(changes).unwrap(),
            since: None,
            methods: vec![Method::Replan],
            objective: None,
            within: None,
            limits: crate::Limits::default(),
        });
        let Response::Changed(answer) = serve(&request, &SilentHost) else {
            panic!("{assumption}");
        };
        let found = &answer.methods.get(Method::Replan).unwrap().result;
        assert_eq!(found.status, Status::Feasible, "{assumption}");
        assert!(!found.reach.is_complete(), "{assumption}");
    }
}
