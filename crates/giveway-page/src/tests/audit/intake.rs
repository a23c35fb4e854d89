//! Files come one after the other; what is late, missing or broken is told.

use giveway_model::format::foreign::Format;

use super::{LEGAL, MEETING, SCENE, audit, dropped, file, fresh, read_out};
use crate::action::{IntakeAction, Save};
use crate::intake::protocol::Reply;
use crate::tests::answered as answer;
use crate::{Action, FileAction, Notice, State, reduce};

const MAP: &str = "type octile\nheight 2\nwidth 3\nmap\n...\n...\n";

fn notice(state: &State) -> String {
    let Notice { sentence, details } = state.view.notice.clone().unwrap();
    format!("{sentence} {}", details.join(" "))
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
    let files = vec![file("hall.json", SCENE), file("p.json", LEGAL)];
    let second = reduce(&first, Action::Intake(IntakeAction::Read(files)));
    let late = IntakeAction::Reply {
        job: 1,
        reply: Box::new(Reply::Refused("late".to_owned(), Vec::new())),
    };
    let heard = reduce(&second, Action::Intake(late));
    assert_eq!(heard, second);
    assert_eq!(audit(&read_out(heard)).plan.file.file, "p.json");
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
    let sentence = "out of memory".to_owned();
    let state = reduce(
        &state,
        Action::Intake(IntakeAction::Crash { job: 1, sentence }),
    );
    assert!(state.intake.job().is_none());
    assert!(notice(&state).contains("out of memory"));
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
