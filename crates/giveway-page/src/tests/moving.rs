//! The plan as a picture that moves: begun, drawn by the page, put together by the reader.

use std::rc::Rc;

use giveway_picture::Theme;

use crate::action::IntakeAction;
use crate::intake::Reader;
use crate::intake::protocol::{Ask, Message, PictureKind, Reply, Task};
use crate::{Action, Edit, Save, SolveAction, State, reduce, sample, words};

fn begun(kind: PictureKind) -> State {
    let save = Save::Picture(kind, Theme::Dark);
    reduce(&sample::solved(), Action::Intake(IntakeAction::Save(save)))
}

/// What the reader tells of a task.
fn told(reader: &mut Reader, ask: Ask) -> Vec<Message> {
    let mut told = Vec::new();
    reader.answer(ask, &mut |message| told.push(message));
    told
}

/// The message for the reader.
fn ask(state: &State) -> Ask {
    borsh::from_slice(&state.intake.ask().unwrap().1).unwrap()
}

/// A grey frame of the size that is asked for.
fn pixels(size: (u32, u32), grey: u8) -> Vec<u8> {
    vec![grey; (4 * size.0 * size.1) as usize]
}

#[test]
fn the_animated_svg_comes_at_once() {
    let state = begun(PictureKind::Svg);
    assert_eq!(words::standing(&state).badge, words::Badge::Saving);
    assert_eq!(
        words::standing(&state).sentence,
        "Drawing the moving picture …"
    );
    let told = told(&mut Reader::default(), ask(&state));
    let [
        Message::Reply {
            id,
            reply: Reply::Drawn(name, bytes),
        },
    ] = told.as_slice()
    else {
        panic!("{told:?}");
    };
    assert_eq!((*id, name.as_str()), (1, "warehouse.svg"));
    let svg = std::str::from_utf8(bytes).unwrap();
    assert!(svg.contains("@keyframes") && svg.contains(">A1<"), "{svg}");
    assert!(svg.contains("#23272d"), "it is not dark");
    let reply = Rc::new(Reply::Drawn(name.clone(), bytes.clone()));
    let done = reduce(
        &state,
        Action::Intake(IntakeAction::Reply { job: *id, reply }),
    );
    assert!(done.intake.job().is_none() && done.view.notice.is_none());
    let saved = done.intake.packed.clone().unwrap();
    assert_eq!((&saved.name, &saved.bytes), (name, bytes));
    // The same once more is saved once more.
    let save = Save::Picture(PictureKind::Svg, Theme::Dark);
    let again = reduce(&done, Action::Intake(IntakeAction::Save(save)));
    assert!(again.intake.packed.is_none());
}

#[test]
fn a_gif_is_put_together_frame_by_frame() {
    let mut reader = Reader::default();
    let mut messages = told(&mut reader, ask(&begun(PictureKind::Gif)));
    let mut frames: u8 = 0;
    let mut sentences = Vec::new();
    let gif = loop {
        let mut next = None;
        for message in messages {
            match message {
                Message::Draw { id, shot } => {
                    assert_eq!((id, shot.ground.is_some()), (1, frames == 0));
                    frames += 1;
                    let task = Task::Pixels(pixels(shot.size, frames));
                    next = Some(Ok(Ask { id, task }));
                }
                Message::Progress { sentence, .. } => sentences.push(sentence),
                Message::Reply {
                    reply: Reply::Drawn(name, bytes),
                    ..
                } => {
                    assert_eq!(name, "warehouse.gif");
                    next = Some(Err(bytes));
                }
                message => panic!("{message:?}"),
            }
        }
        match next.unwrap() {
            Ok(ask) => messages = told(&mut reader, ask),
            Err(bytes) => break bytes,
        }
    };
    // Eight frames a step, 18 steps, and the end.
    assert_eq!(frames, 145);
    assert!(gif.starts_with(b"GIF89a"));
    assert_eq!(sentences[0], "Drawing the moving picture, frame 1 of 145 …");
    assert_eq!(sentences.len(), 29);
    // Pixels that come late are of no film.
    let late = Ask {
        id: 1,
        task: Task::Pixels(Vec::new()),
    };
    assert_eq!(told(&mut reader, late), []);
}

#[test]
fn pixels_of_another_size_end_it_with_a_sentence() {
    let mut reader = Reader::default();
    told(&mut reader, ask(&begun(PictureKind::Gif)));
    let wrong = Ask {
        id: 1,
        task: Task::Pixels(vec![0; 4]),
    };
    let last = told(&mut reader, wrong).pop().unwrap();
    let Message::Reply {
        reply: Reply::Refused(sentence, details),
        ..
    } = last
    else {
        panic!("{last:?}");
    };
    assert_eq!(sentence, "The moving picture could not be made.");
    assert!(
        details[0].starts_with("found a frame of 4 bytes"),
        "{details:?}"
    );
}

#[test]
fn it_is_cancelled_as_all_else() {
    let state = begun(PictureKind::Gif);
    assert!(state.intake.job().unwrap().is_picture());
    let ended = reduce(&state, Action::Solve(SolveAction::Cancel));
    assert!(ended.intake.job().is_none());
    assert_eq!(ended.document, state.document);
}

#[test]
fn a_reader_that_breaks_off_says_which_it_was() {
    let crash = IntakeAction::Crash {
        job: 1,
        had_started: true,
        details: vec!["out of memory".to_owned()],
    };
    let state = reduce(&begun(PictureKind::Gif), Action::Intake(crash));
    let notice = state.view.notice.unwrap();
    assert_eq!(notice.sentence(), "The moving picture could not be made.");
    assert_eq!(notice.details(), ["out of memory"]);
}

#[test]
fn without_a_plan_for_the_scene_there_is_nothing_to_draw() {
    assert!(sample::solved().can_be_drawn());
    let bare = State::new(sample::draft());
    let edit = Action::Edit(Edit::RemoveAgent(0));
    for state in [bare, reduce(&sample::solved(), edit)] {
        assert!(!state.can_be_drawn());
        let save = IntakeAction::Save(Save::Picture(PictureKind::Svg, Theme::Light));
        assert!(reduce(&state, Action::Intake(save)).intake.job().is_none());
    }
}
