//! Every message is read as it was written.

use giveway_model::{Cell, Cost, Costs, Fault, Plan, Scene, Version, format::native};
use giveway_proof::{Checked, Claim, Report};
use giveway_solve::audit::AuditRequest;
use giveway_solve::change::{ChangeRequest, Method};
use giveway_solve::plan::{PlanRequest, Planner};
use giveway_solve::together::TogetherRequest;
use giveway_solve::trace::{Core, SearchEvent};
use giveway_solve::{
    CertifyRequest, CheckAnswer, CheckRequest, FrontAnswer, Limits, Progress, Refusal, Request,
    Response, SilentHost, SolveRequest, Status, serve,
};

use super::{Ask, Message};

/// A scene with a battery and a name that is awkward in JSON.
fn scene() -> Scene {
    let text = r#"{ "giveway": 1, "map": ["..+", "~#."], "agents": [
        { "name": "a \"1\"\n{", "start": [0, 0], "goal": [2, 1], "waypoints": [[2, 0]],
          "battery": { "capacity": 9, "initial": 9 } }] }"#;
    native::read_scene(text).unwrap()
}

fn check_ask(request: Request) {
    let ask = Ask { id: 7, request };
    assert_eq!(Ask::from_bytes(&ask.to_bytes()), Ok(ask));
}

fn check_message(message: &Message) {
    assert_eq!(
        Message::from_bytes(&message.to_bytes()).as_ref(),
        Ok(message)
    );
}

fn check_response(response: Response) {
    let response = Box::new(response);
    check_message(&Message::Answer { id: 7, response });
}

fn some_plan() -> Plan {
    Plan {
        paths: [("A1".to_owned(), vec![Some(Cell::new(0, 1)), None])].into(),
        ..Plan::default()
    }
}

fn solve_request() -> SolveRequest {
    SolveRequest {
        scene: scene(),
        objective: Some("moves,waits".parse().unwrap()),
        pareto: true,
        within: Some(30),
        start: Some(some_plan()),
        trace: true,
        limits: Limits {
            seconds: Some(0.5),
            conflicts: Some(u64::MAX),
            work: Some(9_000_000),
            memory_bytes: None,
        },
        as_found: false,
    }
}

#[test]
fn certificates_come_back() {
    let request = CertifyRequest {
        scene: scene(),
        about: Claim::at_most([(Cost::Charges, 2)]).within(Some(9)),
        bounds: [(Cost::Makespan, 4)].into(),
        plan: Some(Plan::default()),
        ..CertifyRequest::default()
    };
    check_ask(Request::Certify(request));
    let claim = Claim::default();
    let text = claim.sentence();
    let (variables, clauses, steps) = (1, 2, 3);
    let claims = vec![
        Checked::Proof {
            text: text.clone(),
            claim: claim.clone(),
            variables,
            clauses,
            steps,
        },
        Checked::None {
            text,
            claim,
            why: "It is \"large\".".to_owned(),
        },
    ];
    check_response(Response::Certified(Box::new(Report {
        giveway: Version,
        accepted: true,
        certified: giveway_proof::Certified::Proved,
        conclusion: None,
        concluded: None,
        reason: None,
        stopped: false,
        claims,
    })));
}

#[test]
fn changes_come_back() {
    let seed = |name: &str| {
        let folder = concat!(
            env!("CARGO_MANIFEST_DIR"),
            "/../../tests/data/seed/dynamic-3x3"
        );
        std::fs::read_to_string(folder.to_owned() + name).unwrap()
    };
    let request = Request::Change(ChangeRequest {
        scene: native::read_scene(&seed(".json")).unwrap(),
        plan: native::read_plan(&seed(".plan-t1.json")).unwrap(),
        changes: native::read_changes(&seed(".changes.json")).unwrap(),
        since: Some(2),
        methods: vec![Method::Revise, Method::Tunnel(1), Method::Replan],
        objective: None,
        within: Some(9),
        limits: Limits::default(),
    });
    let response = serve(&request, &SilentHost);
    let Response::Changed(answer) = &response else {
        panic!("{response:?}");
    };
    assert_eq!(answer.adopted, Some(Method::Revise));
    check_ask(request);
    check_response(response);
    let faults = vec![Fault::at("changes[0]", "an obstacle", "a free cell")];
    check_response(Response::Refused(Refusal::Changes { faults }));
}

#[test]
fn requests_come_back() {
    check_ask(Request::Solve(solve_request()));
    check_ask(Request::Check(CheckRequest {
        changes: None,
        scene: scene(),
        plan: Plan::default(),
    }));
    check_ask(Request::Audit(AuditRequest {
        scene: scene(),
        within: Some(4),
        ..AuditRequest::default()
    }));
}

#[test]
fn audits_come_back() {
    let request = AuditRequest {
        scene: scene(),
        ..AuditRequest::default()
    };
    let response = serve(&Request::Audit(request), &SilentHost);
    assert!(matches!(&response, Response::Audited(answer) if !answer.legal));
    check_response(response);
}

#[test]
fn plans_of_the_textbook_come_back() {
    for planner in Planner::ALL {
        let request = Request::Plan(PlanRequest {
            trace: true,
            order: Some(Vec::new()),
            ..PlanRequest::new(scene(), planner)
        });
        let response = serve(&request, &SilentHost);
        assert!(matches!(&response, Response::Planned(_)), "{response:?}");
        check_ask(request);
        check_response(response);
    }
}

#[test]
fn traces_and_their_steps_come_back() {
    let text = r#"{ "giveway": 1, "map": [".##.", "....", ".##."], "agents": [
        { "name": "A", "start": [0, 1], "goal": [3, 1] },
        { "name": "B", "start": [3, 1], "goal": [0, 1] }] }"#;
    let scene = native::read_scene(text).unwrap();
    let request = Request::Solve(SolveRequest {
        scene: scene.clone(),
        trace: true,
        ..SolveRequest::default()
    });
    let response = serve(&request, &SilentHost);
    let Response::Solved(answer) = &response else {
        panic!("{response:?}");
    };
    let events = answer.trace.clone().unwrap().events;
    let cores = events.iter().filter_map(|event| match &event.event {
        SearchEvent::Core(core) => Some(core),
        _ => None,
    });
    let cores: Vec<&Core> = cores.collect();
    assert!(!cores.is_empty());
    for core in cores {
        let request = Request::Together(TogetherRequest::about(core, scene.clone()));
        let response = serve(&request, &SilentHost);
        assert!(matches!(&response, Response::Together(_)), "{response:?}");
        check_ask(request);
        check_response(response);
    }
    check_message(&Message::Progress {
        id: 7,
        event: Progress::Traced { events },
    });
    check_response(response);
}

#[test]
fn responses_come_back() {
    let mut request = solve_request();
    request.pareto = false;
    let response = serve(&Request::Solve(request), &SilentHost);
    let Response::Solved(answer) = &response else {
        panic!("{response:?}");
    };
    assert_eq!(answer.status, Status::Optimal);
    let (plan, answer) = (answer.plan.clone().unwrap(), answer.clone());
    check_response(response);
    check_response(Response::Front(FrontAnswer {
        giveway: Version,
        status: Status::Feasible,
        ended: Some(giveway_solve::Ended::Work),
        reach: serde_json::from_str(r#"{ "complete": false, "within": 3 }"#).unwrap(),
        front: vec![answer],
    }));
    let scene = scene();
    check_response(serve(
        &Request::Check(CheckRequest {
            scene,
            plan,
            changes: None,
        }),
        &SilentHost,
    ));
    check_response(Response::Checked(CheckAnswer {
        giveway: Version,
        valid: false,
        costs: None,
        violations: Vec::new(),
    }));
    let faults = vec![Fault::at("agents[0].goal", "a \"text\"", "a cell").in_text(3, 4)];
    check_response(Response::Refused(Refusal::Scene { faults }));
    let fault = Fault::at("", "one cost", "two");
    check_response(Response::Refused(Refusal::Request { fault }));
}

#[test]
fn what_is_told_on_the_way_comes_back() {
    let progress = |event| {
        check_message(&Message::Progress {
            id: u32::MAX,
            event,
        });
    };
    progress(Progress::Bound {
        cost: Cost::SumOfCosts,
        at_least: 3,
    });
    progress(Progress::Plan {
        costs: Costs::default(),
        plan: some_plan(),
    });
    progress(Progress::Certifying {
        claim: "There is no plan.".to_owned(),
        checking: true,
    });
    progress(Progress::Size {
        variables: 1,
        clauses: u64::MAX,
        conflicts: 0,
    });
    check_message(&Message::Ready);
    check_message(&Message::Failed {
        id: None,
        sentence: "It broke.".to_owned(),
    });
}

#[test]
fn what_is_no_message_is_told() {
    let longer = [Message::Ready.to_bytes(), vec![0]].concat();
    for bytes in [
        &[][..],
        &[9; 9],
        b"\xff\xff\xff\xff\xff\xff\xff\xff",
        &longer,
    ] {
        assert!(!Ask::from_bytes(bytes).unwrap_err().is_empty(), "{bytes:?}");
        assert!(
            !Message::from_bytes(bytes).unwrap_err().is_empty(),
            "{bytes:?}"
        );
    }
}
