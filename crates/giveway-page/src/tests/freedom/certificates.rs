//! Certificates of what must be so: asked for, made, packed, saved.

use std::rc::Rc;

use giveway_model::Cell;
use giveway_proof::bundle::archive::unpack;
use giveway_proof::{Budget, verify};
use giveway_solve::Request;
use giveway_solve::freedom::Known;

use super::{SHOW, act, page, solved, told};
use crate::certificate::offer;
use crate::freedom::FreedomAction;
use crate::intake::Packed;
use crate::intake::protocol::Task;
use crate::intake::work;
use crate::reduce::tests::after;
use crate::tests::{answered, saying, select};
use crate::{Action, BoardAction, IntakeAction, Notice, Selection, SolveAction, State, reduce};

const SAVE: Action = Action::Solve(SolveAction::SaveProof);

/// The reader does what it is asked.
fn packed(state: &State) -> (State, Rc<Packed>) {
    let job = state.intake.job().expect("something is to be packed");
    assert!(matches!(*job.task, Task::Pack { .. }), "{:?}", job.task);
    let reply = Rc::new(work((*job.task).clone()));
    let state = reduce(
        state,
        Action::Intake(IntakeAction::Reply { job: job.id, reply }),
    );
    let packed = state.intake.packed.clone().expect("it is packed");
    (state, packed)
}

/// The names of the certificates that are saved; each of them holds.
fn saved(state: &State) -> (Vec<String>, Notice) {
    let (state, packed) = packed(&answered(&after(state, [SAVE])));
    let bundles = unpack(&packed.bytes).unwrap();
    for (name, bundle) in &bundles {
        let report = verify(bundle, &Budget::default());
        assert!(report.accepted, "{name}: {report:?}");
    }
    let told = state.view.notice.clone().expect("it is told");
    assert_eq!(told.sentence(), format!("{} is saved.", packed.name));
    let done = after(&state, [Action::Intake(IntakeAction::Saved)]);
    assert_eq!((&done.intake.packed, done.intake.job()), (&None, None));
    (bundles.into_keys().collect(), told)
}

#[test]
fn all_claims_are_saved_each_with_files_that_hold() {
    let state = told();
    assert_eq!(offer(&state), Some("Save all certificates"));
    let (names, told) = saved(&state);
    assert!(names.contains(&"best".to_owned()), "{names:?}");
    assert!(names.contains(&"without-1-3".to_owned()), "{names:?}");
    let freedom = state.freedom().unwrap().told.clone().unwrap();
    let visits = freedom
        .backbone
        .iter()
        .flat_map(|all| all.values().flatten());
    let fixed = visits.filter(|visit| visit.time > 0 && visit.always == Known::Yes);
    let robots = names.iter().filter(|name| name.starts_with("robot-"));
    assert_eq!(robots.count(), fixed.count(), "{names:?}");
    assert_eq!(
        told.details(),
        [
            format!("It holds {} certificates, all checked.", names.len()),
            "Anyone can check it again without this page: \
             giveway verify three-ways-certificate.zip"
                .to_owned()
        ]
    );
}

#[test]
fn a_robot_and_a_cell_have_certificates_of_their_own() {
    let agent = after(&told(), [select(1)]);
    assert_eq!(offer(&agent), Some("Save its certificates"));
    let (names, _) = saved(&agent);
    assert!(!names.is_empty(), "it has no choice");
    assert!(
        names.iter().all(|name| name.starts_with("robot-2-at-")),
        "{names:?}"
    );
    let cell = |x, y| Action::Board(BoardAction::Select(Selection::Cell(Cell::new(x, y))));
    let (names, _) = saved(&after(&told(), [cell(3, 1)]));
    assert!(names.contains(&"without-3-1".to_owned()), "{names:?}");
    assert_eq!(
        offer(&after(&told(), [cell(7, 4)])),
        None,
        "nobody is there"
    );
}

#[test]
fn it_is_offered_where_something_is_proved_and_cancelled_at_once() {
    assert_eq!(offer(&page(&["..."], &[[(0, 0), (2, 0)]])), None);
    assert_eq!(offer(&solved()), None, "it is not checked yet");
    let checking = after(&solved(), [Action::Solve(SolveAction::CheckProof)]);
    assert_eq!(offer(&checking), None, "it is being checked");
    let checked = answered(&checking);
    assert_eq!(offer(&checked), Some("Save the certificate"));
    assert_eq!(saved(&checked).0, ["best"]);

    let saving = after(&told(), [SAVE]);
    assert!(matches!(
        saving.work.request(),
        Some((_, Request::Export(_)))
    ));
    assert!(
        saying(&saving).starts_with("Certificate 1 of "),
        "{}",
        saying(&saving)
    );
    assert_eq!(offer(&saving), None);
    let cancelled = after(&saving, [Action::Solve(SolveAction::Cancel)]);
    assert!(cancelled.work.is_idle());
    assert_eq!(offer(&cancelled), Some("Save all certificates"));
    // What it is about goes: so does the job.
    let undone = after(&saving, [Action::Undo]);
    assert!(undone.work.is_idle());
    let hidden = after(&told(), [act(FreedomAction::Show(false))]);
    assert_eq!(offer(&hidden), None);
    assert_eq!(
        offer(&after(&hidden, [SHOW])),
        Some("Save all certificates")
    );
}
