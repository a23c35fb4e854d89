//! Files as people bring them: dropped and pasted, by one recogniser.

use std::path::Path;

use super::{audit, dropped, fresh, read_out};
use crate::action::IntakeAction;
use crate::files::{Opened, Pasted, Reading, pasted, read_beside};
use crate::tests::answered;
use crate::{Action, ChangeAction, FileAction, NoticeKind, Phase, State, reduce};

fn brought(name: &str) -> Opened {
    let folder =
        Path::new(env!("CARGO_MANIFEST_DIR")).join("../giveway-formats/tests/data/brought");
    let bytes = std::fs::read(folder.join(name)).unwrap();
    let name = name.to_owned();
    Opened { name, bytes }
}

/// Opens files as the page does.
fn open(state: &State, files: Vec<Opened>) -> State {
    match read_beside(state, &files) {
        None => read_out(reduce(state, Action::Intake(IntakeAction::Read(files)))),
        Some(Ok(Reading::Scene(scene))) => reduce(state, Action::File(FileAction::Open(scene))),
        Some(Err(notice)) => reduce(state, Action::File(FileAction::Tell(notice))),
        Some(other) => panic!("{other:?}"),
    }
}

fn opened(names: &[&str]) -> State {
    open(&fresh(), names.iter().map(|name| brought(name)).collect())
}

fn told(state: &State) -> String {
    let notice = state.view.notice.clone();
    notice.map_or_else(String::new, |notice| {
        format!("{} {}", notice.sentence(), notice.details().join(" "))
    })
}

fn rows(state: &State) -> Vec<String> {
    state.document.draft.scene().map.clone()
}

#[test]
fn a_scene_with_the_result_of_a_solve_opens() {
    for plan in ["solve-result.json", "lane.plan.json"] {
        let state = opened(&["lane.json", plan]);
        assert!(state.plan().is_some(), "{plan}: {}", told(&state));
        assert_eq!(told(&state), "");
    }
    // On the board the result alone is enough.
    let board = opened(&["lane.json"]);
    assert!(
        open(&board, vec![brought("solve-result.json")])
            .plan()
            .is_some()
    );
}

#[test]
fn a_scene_with_changes_and_the_adopted_plan_opens() {
    for (changes, result) in [
        ("delay.json", "adopted.json"),
        ("changes-swap.json", "change-result.json"),
    ] {
        for more in [&[][..], &["lane.plan.json"], &["solve-result.json"]] {
            let mut names = vec!["lane.json", changes, result];
            names.extend(more);
            let state = opened(&names);
            let answer = state
                .document
                .answer
                .clone()
                .unwrap_or_else(|| panic!("{}", told(&state)));
            assert!(answer.course.is_some(), "{names:?}");
            let left_out = told(&state).contains("is left out");
            assert_eq!(left_out, !more.is_empty(), "{}", told(&state));
            assert!(
                told(&state).contains("adopted after the change"),
                "{}",
                told(&state)
            );
        }
    }
}

#[test]
fn changes_that_the_plan_does_not_know_are_told() {
    let state = opened(&["lane.json", "solve-result.json", "delay.json"]);
    assert!(state.plan().is_some(), "{}", told(&state));
    assert_lists_the_delay(&state);
    // The plan on the board is as good as one of a file.
    let board = opened(&["lane.json", "solve-result.json"]);
    assert_lists_the_delay(&open(&board, vec![brought("delay.json")]));
    let state = opened(&["lane.json", "delay.json"]);
    assert!(
        told(&state).contains("these are changes"),
        "{}",
        told(&state)
    );
    assert!(told(&opened(&["delay.json"])).contains("these are changes"));
}

/// The next step is to find new plans.
#[track_caller]
fn assert_lists_the_delay(state: &State) {
    let said = told(state);
    let changing = state.document.mode.changing().expect(&said);
    assert_eq!((changing.list.len(), state.phase()), (1, Phase::Changing));
    assert_eq!(state.view.playback.time, changing.at);
    assert!(said.contains("press Find new plans"), "{said}");
    assert_eq!(
        state.view.notice.as_ref().unwrap().kind,
        NoticeKind::Information
    );
    let found = answered(&reduce(state, Action::Change(ChangeAction::Adapt)));
    let comparing = found.document.mode.comparing().expect("new plans");
    assert!(comparing.preview().is_some());
}

#[test]
fn changes_of_several_times_are_listed_at_the_first_one() {
    let changes = br#"{ "giveway": 1, "changes": [
        { "at": 5, "change": "delay-agent", "agent": "R1", "steps": 2 },
        { "at": 3, "change": "delay-agent", "agent": "R2", "steps": 2 } ] }"#;
    let changes = Opened {
        name: "two.json".to_owned(),
        bytes: changes.to_vec(),
    };
    let state = open(&opened(&["lane.json", "solve-result.json"]), vec![changes]);
    let said = told(&state);
    let changing = state.document.mode.changing().expect(&said);
    assert_eq!((changing.at, changing.list.len()), (3, 1));
    assert!(said.contains("from time 5 on is left out"), "{said}");
}

#[test]
fn an_adopted_plan_without_its_changes_is_audited_and_says_so() {
    let state = opened(&["lane.json", "change-result.json"]);
    let notes = &audit(&state).plan.file.notes;
    assert!(notes[0].contains("file of the changes"), "{notes:?}");
}

#[test]
fn an_answer_opens_with_its_question() {
    let answer = br#"{ "giveway": 1, "question": { "kind": "wait", "agent": "R2", "from": 3, "to": 43 }, "verdict": "unknown", "alternative": null }"#;
    let file = Opened {
        name: "why.json".to_owned(),
        bytes: answer.to_vec(),
    };
    let alone = open(&fresh(), vec![file.clone()]);
    assert!(told(&alone).contains("question"), "{}", told(&alone));
    let state = open(&fresh(), vec![brought("lane.json"), file]);
    assert_eq!(rows(&state).len(), 2, "{}", told(&state));
}

#[test]
fn grids_and_instances_of_others_open_dropped_and_pasted() {
    for (name, expected) in [
        ("bare.txt", &["...", ".#.", "..#"][..]),
        ("rows.txt", &["...", ".#."]),
        ("no-type.map", &[".."]),
        ("utf16.map", &["...."]),
        ("clingo.txt", &[".."]),
    ] {
        let state = opened(&[name]);
        assert_eq!(rows(&state), expected, "{name}: {}", told(&state));
        // Named otherwise it is the same.
        let renamed = Opened {
            name: "it.map".to_owned(),
            ..brought(name)
        };
        assert_eq!(rows(&open(&fresh(), vec![renamed])), expected, "{name}");
        let text = giveway_model::format::read_text(&brought(name).bytes)
            .unwrap()
            .into_owned();
        let state = match pasted(&fresh(), &text).unwrap() {
            Pasted::File(files) => open(&fresh(), files),
            Pasted::Read(Reading::Scene(scene)) => {
                reduce(&fresh(), Action::File(FileAction::Open(scene)))
            }
            Pasted::Read(other) => panic!("{other:?}"),
        };
        assert_eq!(rows(&state), expected, "{name}: {}", told(&state));
    }
    assert!(told(&opened(&["bare.txt"])).contains("bare grid"));
    let facts = "init(object(node,1),value(at,(1,1))). init(object(robot,1),value(at,(1,1))).";
    let Ok(Pasted::File(files)) = pasted(&fresh(), facts) else {
        panic!("facts in one line are for the reader");
    };
    assert_eq!(rows(&open(&fresh(), files)), ["."]);
}

#[test]
fn files_of_the_league_wait_for_each_other() {
    let state = opened(&["problem.json"]);
    assert!(
        told(&state).contains("a.map, a.agents, a.tasks"),
        "{}",
        told(&state)
    );
    let state = dropped(
        &state,
        &[
            ("a.map", "type octile\nheight 1\nwidth 3\nmap\n...\n"),
            ("a.agents", "1\n0\n"),
            ("a.tasks", "1\n2\n"),
        ],
    );
    assert_eq!(rows(&state), ["..."], "{}", told(&state));
    assert!(told(&opened(&["summary.json"])).contains("a summary of the League"));
}

#[test]
fn what_is_no_text_is_named() {
    let picture = Opened {
        name: "a.map".to_owned(),
        bytes: b"\x89PNG\r\n\x1a\n\0".to_vec(),
    };
    assert!(told(&open(&fresh(), vec![picture])).contains("a picture (PNG)"));
    let state = dropped(
        &fresh(),
        &[(
            "geo.json",
            r#"{ "type": "FeatureCollection", "features": [] }"#,
        )],
    );
    assert!(told(&state).contains("GeoJSON"), "{}", told(&state));
}
