//! A certificate of what was solved, of what is not so, and of what was cancelled.

use std::cell::RefCell;

use giveway_model::format::native;
use giveway_proof::Checked;

use super::*;
use crate::{Request, Response, SilentHost, SolveRequest, serve};

/// Two agents that must pass each other at a side pocket.
const SCENE: &str = r##"{ "giveway": 1, "map": ["....", "#.##"],
    "agents": [{ "name": "a", "start": [0, 0], "goal": [3, 0] },
               { "name": "b", "start": [3, 0], "goal": [0, 0] }] }"##;

fn solved() -> CertifyRequest {
    let scene = native::read_scene(SCENE).unwrap();
    let request = SolveRequest {
        scene: scene.clone(),
        ..SolveRequest::default()
    };
    match serve(&Request::Solve(request), &SilentHost) {
        Response::Solved(answer) => CertifyRequest::of_solved(scene, None, &answer),
        other => panic!("{other:?}"),
    }
}

#[derive(Default)]
struct Listening {
    told: RefCell<Vec<(String, bool)>>,
    stops: bool,
}

impl Host for Listening {
    fn wall_seconds(&self) -> f64 {
        0.0
    }

    fn cancelled(&self) -> bool {
        self.stops
    }

    fn progress(&self, event: &Progress) {
        if let Progress::Certifying { claim, checking } = event {
            self.told.borrow_mut().push((claim.clone(), *checking));
        }
    }
}

fn report(request: CertifyRequest, host: &dyn Host) -> Report {
    match serve(&Request::Certify(request), host) {
        Response::Certified(report) => *report,
        other => panic!("{other:?}"),
    }
}

#[test]
fn what_was_solved_is_proved_again_and_checked() {
    let host = Listening::default();
    let report = report(solved(), &host);
    assert!(report.accepted, "{report:?}");
    let proofs = |claim: &Checked| matches!(claim, Checked::Proof { steps, .. } if *steps > 0);
    assert!(report.claims.iter().any(proofs), "{report:?}");
    let told = host.told.into_inner();
    let made = told.iter().filter(|(_, checking)| !checking).count();
    assert!(made > 0 && told.len() > made, "{told:?}");
}

#[test]
fn what_is_not_so_is_not_confirmed() {
    let mut request = solved();
    for bound in request.bounds.values_mut() {
        *bound += 1;
    }
    request.plan = None;
    let report = report(request, &SilentHost);
    assert!(
        report
            .claims
            .iter()
            .all(|claim| matches!(claim, Checked::None { .. })),
        "{report:?}"
    );
}

#[test]
fn what_is_cancelled_or_too_large_is_said_to_be() {
    let stops = Listening {
        stops: true,
        ..Listening::default()
    };
    // A search of a few states needs no leave.
    let nothing = |report: &Report| {
        let proof = |claim: &Checked| matches!(claim, Checked::Proof { .. });
        !report.claims.is_empty() && !report.claims.iter().any(proof)
    };
    let cancelled = report(solved(), &stops);
    assert!(nothing(&cancelled), "{cancelled:?}");
    let mut small = solved();
    small.limits.memory_bytes = Some(1000);
    let small = report(small, &SilentHost);
    assert!(nothing(&small), "{small:?}");
}
