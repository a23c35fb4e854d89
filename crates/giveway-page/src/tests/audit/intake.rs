//! Files come one after the other; what is late, missing or broken is told.

use std::rc::Rc;

use giveway_formats::Format;

use super::{LEGAL_PATHS, MEETING, SCENE, audit, dropped, file, fresh, read_out};
use crate::action::IntakeAction;
use crate::intake::protocol::Reply;
use crate::tests::answered as answer;
use crate::{Action, FileAction, Save, State, reduce};

const MAP: &str = "type octile\nheight 2\nwidth 3\nmap\n...\n...\n";

fn notice(state: &State) -> String {
    let notice = state.view.notice.as_ref().unwrap();
    format!("{} {}", notice.sentence(), notice.details().join(" "))
}

#[test]
fn what_is_read_is_said_and_a_late_answer_is_not_heard() {
    let first = reduce(
        &fresh(),
        Action::Intake(IntakeAction::Read(vec![file("a.txt", "?")])),
    );
    assert_eq!(
        crate::words::standing(&first).badge,
        crate::words::Badge::Reading
    );
    let files = vec![file("hall.json", SCENE), file("p.txt", LEGAL_PATHS)];
    let second = reduce(&first, Action::Intake(IntakeAction::Read(files)));
    let late = IntakeAction::Reply {
        job: 1,
        reply: Rc::new(Reply::Refused("late".to_owned(), Vec::new())),
    };
    let heard = reduce(&second, Action::Intake(late));
    assert_eq!(heard, second);
    assert_eq!(audit(&read_out(heard)).plan.file.file, "p.txt");
}

#[test]
fn a_file_of_no_format_is_refused_with_its_place() {
    let state = dropped(&fresh(), &[("notes.txt", "good morning")]);
    let told = notice(&state);
    assert!(told.contains("notes.txt, line 1, column 1"), "{told}");
}

#[test]
fn the_reader_breaking_off_is_told() {
    let state = reduce(
        &fresh(),
        Action::Intake(IntakeAction::Read(vec![file("a.txt", "?")])),
    );
    let crash = |had_started: bool| {
        let details = vec!["out of memory".to_owned()];
        let crash = IntakeAction::Crash {
            job: 1,
            had_started,
            details,
        };
        reduce(&state, Action::Intake(crash))
    };
    let broke = crash(true);
    assert!(broke.intake.job().is_none());
    assert!(notice(&broke).contains("broke off") && notice(&broke).contains("out of memory"));
    // Where workers are not allowed nothing ever started.
    let never = notice(&crash(false));
    assert!(never.starts_with("The file cannot be read here"), "{never}");
    assert!(!never.contains("broke off"), "{never}");
}

#[test]
fn a_plan_is_saved_in_another_format_after_its_losses_are_told() {
    let state = answer(&dropped(
        &fresh(),
        &[("hall.json", SCENE), ("p.json", MEETING)],
    ));
    let save = |format| {
        read_out(reduce(
            &state,
            Action::Intake(IntakeAction::Save(Save::As(format))),
        ))
    };
    let written = save(Format::Giveway).intake.written.unwrap();
    let names: Vec<&str> = written
        .files
        .iter()
        .map(|(name, _)| name.as_str())
        .collect();
    assert_eq!(names, ["hall.json", "hall-plan.json"]);
    let map = save(Format::MovingAi).intake.written.unwrap();
    assert_eq!(map.files[0].1, MAP);
    let done = reduce(&save(Format::MovingAi), Action::Intake(IntakeAction::Saved));
    assert!(done.intake.written.is_none());
}

#[test]
fn what_the_page_reads_itself_is_left_to_it() {
    let state = dropped(&fresh(), &[("hall.map", MAP)]);
    assert!(state.intake.job().is_none() && state.view.notice.is_none());
    let opened = reduce(&state, Action::File(FileAction::Keep));
    assert!(opened.audit().is_none());
}

/// The plans of two makers for the same hall, without its map.
const PATHS: &str =
    "Agent 0: (0,0)->(0,1)->(0,2)->\nAgent 1: (0,2)->(1,2)->(1,1)->(1,0)->(0,0)->\n";

#[test]
fn a_plan_waits_for_its_map() {
    let waiting = dropped(&fresh(), &[("paths.txt", PATHS)]);
    assert!(
        notice(&waiting).contains("paths.txt does not name its map"),
        "{}",
        notice(&waiting)
    );
    assert_eq!(waiting.intake.waiting().len(), 1);
    // The map alone is for the reader now, and completes it.
    let map = [file("hall.map", MAP)];
    assert!(crate::intake::is_for_reader(&waiting, &map));
    assert!(!crate::intake::is_for_reader(&fresh(), &map));
    let state = dropped(&waiting, &[("hall.map", MAP)]);
    let facts = crate::audit::facts(&state).unwrap();
    assert_eq!(facts.verdict.word, "Legal");
    assert!(state.intake.waiting().is_empty() && state.view.notice.is_none());
    assert_eq!(facts.facts[1].what, "Row first, then column, from 0");
    assert!(facts.choices.len() > 1 && facts.can_read_again);
}

#[test]
fn a_plan_that_fits_the_board_is_read_on_it() {
    let hall = dropped(&fresh(), &[("hall.json", SCENE), ("p.json", MEETING)]);
    let state = dropped(&hall, &[("paths.txt", PATHS)]);
    assert_eq!(audit(&state).plan.file.file, "paths.txt");
    assert!(audit(&state).plan.is_legal());
    let facts = crate::audit::facts(&state).unwrap();
    // Another reading is read anew, and undone by one step.
    let other = facts
        .choices
        .iter()
        .find(|choice| !choice.is_chosen)
        .unwrap();
    let read = crate::audit::AuditAction::ReadAs(other.conventions);
    let other = read_out(reduce(&state, Action::Audit(read)));
    assert_eq!(
        audit(&other).plan.file.conventions,
        facts.choices[1].conventions
    );
    assert!(!audit(&other).plan.is_legal());
}

#[test]
fn the_pages_own_maps_are_named() {
    let tracker = "\"agents\",\"lower_cost\",\"lower_date\",\"solution_cost\",\"solution_date\",\"path\"\n\"1\",\"1\",\"2022-11-29\",\"1\",\"2022-11-29\",\"rr\"\n";
    let name = "empty-8-8_random-1_1.tracker.csv";
    let state = reduce(
        &fresh(),
        Action::Intake(IntakeAction::Read(vec![file(name, tracker)])),
    );
    let (job, bytes) = state.intake.ask().unwrap();
    let ask: crate::intake::protocol::Ask = borsh::from_slice(&bytes).unwrap();
    let reply = Rc::new(crate::intake::work(ask.task));
    let state = reduce(&state, Action::Intake(IntakeAction::Reply { job, reply }));
    let fetches = state.intake.job().map(|job| job.fetches.clone());
    let names = ["empty-8-8.map", "empty-8-8-random-1.scen"].map(str::to_owned);
    assert_eq!(fetches, Some(names.to_vec()), "{:?}", state.view.notice);
    // They are files of the page.
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../static/maps");
    let files = names.map(|name| {
        let bytes = std::fs::read(folder.join(&name)).unwrap();
        crate::files::Opened { name, bytes }
    });
    let job = state.intake.job().unwrap().id;
    let fetched = IntakeAction::Fetched {
        job,
        files: files.to_vec(),
    };
    let state = read_out(reduce(&state, Action::Intake(fetched)));
    assert_eq!(audit(&state).plan.file.file, name);
}

#[test]
fn every_map_of_the_page_is_there_with_its_scenarios() {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../static/maps");
    let mut maps = 0;
    for entry in std::fs::read_dir(&folder).unwrap() {
        let name = entry.unwrap().file_name().into_string().unwrap();
        if let Some(map) = name.strip_suffix(".map") {
            maps += 1;
            for kind in ["even-1", "random-1"] {
                let file = format!("{map}_{kind}_9.csv");
                let found = crate::intake::beside(None, &[&file]);
                assert_eq!(found, [name.clone(), format!("{map}-{kind}.scen")]);
                assert!(
                    found.iter().all(|name| folder.join(name).exists()),
                    "{found:?}"
                );
            }
        }
    }
    assert_eq!(maps, 9);
}
