//! What a person is told is of a kind: information looks and sounds calm.

use std::rc::Rc;

use giveway_model::words::{Catalogue, speak};
use giveway_model::{Question, Scene};

use super::{after, fresh, stroke};
use crate::action::IntakeAction;
use crate::files::Opened;
use crate::intake::protocol::{Found, Reply, Run};
use crate::sample::{draft, solved};
use crate::{
    Action, AskAction, Draft, FileAction, NoticeKind, SolveAction, State, Tool, WorkerAction,
};

fn kind(state: &State) -> (NoticeKind, String) {
    let notice = state.view.notice.as_ref().expect("a notice");
    (notice.kind, notice.sentence())
}

/// The reader answers a file that was opened.
fn read(reply: Reply) -> State {
    let file = Opened {
        name: "a.json".to_owned(),
        bytes: b"{}".to_vec(),
    };
    let begun = after(&fresh(), [Action::Intake(IntakeAction::Read(vec![file]))]);
    let job = begun.intake.job().unwrap().id;
    let reply = IntakeAction::Reply {
        job,
        reply: Rc::new(reply),
    };
    crate::reduce(&begun, Action::Intake(reply))
}

fn found(notes: Vec<String>) -> Reply {
    Reply::Found(Box::new(Found {
        scene: draft().scene().clone(),
        plans: Vec::new(),
        notes,
        files: Vec::new(),
    }))
}

fn run(notes: Vec<String>) -> Reply {
    Reply::Run(Box::new(Run {
        scene: draft().scene().clone(),
        plan: None,
        changes: None,
        listed: None,
        question: None,
        notes,
    }))
}

#[test]
fn what_went_well_is_information() {
    let note = || vec!["The map is named otherwise.".to_owned()];
    let is = |state: &State, sentence: &str| {
        assert_eq!(kind(state), (NoticeKind::Information, sentence.to_owned()));
    };
    is(&read(found(note())), "The scene was read.");
    is(&read(run(note())), "The files were read.");
    let missing = Reply::Missing {
        sentence: "Open a.map, too.".to_owned(),
        files: Vec::new(),
        map: None,
        on_board: None,
    };
    is(&read(missing), "One file more is needed.");
    let idle = after(&solved(), stroke(Tool::Erase, &[(2, 2)]));
    is(&idle, "There is nothing to erase here.");
    // Where there is nothing to know nothing is said.
    assert_eq!(read(found(Vec::new())).view.notice, None);
}

#[test]
fn what_was_refused_or_failed_is_none() {
    let is = |state: &State| assert_eq!(kind(state).0, NoticeKind::Refusal);
    let refused = "it is no scene".to_owned();
    is(&read(Reply::Refused(refused, Vec::new())));
    is(&after(&fresh(), [crate::link::open("giveway=1&map=")]));
    let unsolved = Action::Ask(AskAction::Ask(Question::Makespan));
    is(&after(&fresh(), [unsolved]));
    let crash = |job| WorkerAction::Crash {
        job,
        sentence: "out of memory".to_owned(),
        had_started: true,
    };
    let begun = after(&fresh(), [Action::Solve(SolveAction::Solve)]);
    let job = begun.work.id().unwrap();
    is(&after(&begun, [Action::Worker(crash(job))]));
    // A scene in which a robot starts in an obstacle cannot be solved.
    let mut scene: Scene = draft().scene().clone();
    scene.map[0].replace_range(0..1, "#");
    let faulty = State::new(Draft::new(scene.clone()).unwrap());
    is(&after(&faulty, [Action::Solve(SolveAction::Solve)]));
    is(&after(
        &fresh(),
        [Action::File(FileAction::Open(Box::new(scene)))],
    ));
}

#[test]
fn each_kind_is_shown_and_read_aloud_in_its_own_way() {
    let (calm, refusal) = (NoticeKind::Information, NoticeKind::Refusal);
    assert_eq!((calm.role(), refusal.role()), ("status", "alert"));
    assert_ne!(calm.icon(), refusal.icon());
    assert_ne!(calm.class(), refusal.class());
}

#[test]
fn a_notice_is_said_in_the_language_that_is_spoken_when_it_is_shown() {
    let state = after(&fresh(), stroke(Tool::Goal, &[(4, 2), (3, 2)]));
    let said = "Press a robot first, then the cell of its goal.";
    assert_eq!(kind(&state).1, said);
    let german = r#"
        msgid "Press a robot first, then the cell of its {what}."
        msgstr "Zuerst einen Roboter anklicken, dann die Zelle für: {what}."
        msgctxt "the cell of its"
        msgid "goal"
        msgstr "Ziel"
    "#;
    let german = Catalogue::read(german, Box::new(|n| usize::from(n != 1)));
    speak(Some(german.unwrap().kept()));
    let told = kind(&state).1;
    speak(None);
    assert_eq!(
        told,
        "Zuerst einen Roboter anklicken, dann die Zelle für: Ziel."
    );
}
