//! A person's own page while a lesson is on the board.

use std::rc::Rc;

use giveway_course::lesson::Layer;
use giveway_course::port::{BoardPlan, Happened, ToPage};
use giveway_model::Cost;
use giveway_solve::{Progress, Status};

use super::{board, heard, opened, say, scene, told};
use crate::files::Opened;
use crate::intake::protocol::{Found, Reply};
use crate::keys::{Key, command};
use crate::lesson::LessonAction;
use crate::present::{END, third};
use crate::reduce::tests::{after, stroke};
use crate::tests::{answered, seek, select};
use crate::{
    Action, AskAction, BoardAction, Edit, FileAction, IntakeAction, Phase, SolveAction, State,
    Tool, ViewAction, WorkerAction, ask, freedom, link, reduce, sample,
};

const LEAVE: Action = Action::Lesson(LessonAction::Leave);

/// A page with a plan, an edit that was undone, and something selected.
pub(super) fn own() -> State {
    let edited = after(&sample::solved(), stroke(Tool::Obstacle, &[(8, 2)]));
    after(&edited, [Action::Undo, select(1), seek(3)])
}

#[test]
fn it_is_put_aside_and_back_as_it_was() {
    let own = own();
    let lesson = opened(&own, board(1));
    assert_eq!(lesson.document.draft.scene(), &scene());
    assert!(!lesson.history.can_undo() && !lesson.history.can_redo());
    let edited = after(&lesson, stroke(Tool::Obstacle, &[(1, 1)]));
    assert_ne!(edited.document.draft.scene(), &scene());
    let next = opened(&edited, board(2));
    assert_eq!(next.document.draft.scene(), &scene());
    let (back, said) = heard(&next, [LEAVE]);
    assert_eq!(said, [told(2, Happened::Closed)]);
    assert!(back.lesson().is_none());
    assert_eq!(back.document, own.document);
    assert_eq!(back.history, own.history);
    assert_eq!(back.view.selection, own.view.selection);
    assert_eq!(back.view.playback, own.view.playback);
    assert!(back.history.can_redo(), "what was undone is there still");
}

#[test]
fn the_browser_keeps_it_and_not_the_lesson() {
    let own = own();
    let kept = link::keep(&own);
    let lesson = after(&opened(&own, board(1)), stroke(Tool::Obstacle, &[(1, 1)]));
    assert_eq!(link::keep(&lesson), kept);
}

#[test]
fn what_ran_for_it_is_over_and_comes_too_late() {
    let solving = after(
        &after(&sample::solved(), stroke(Tool::Obstacle, &[(8, 2)])),
        [Action::Solve(SolveAction::Solve)],
    );
    let job = solving.work.id().unwrap();
    let best = crate::tests::answer(&solving);
    let lesson = opened(
        &solving,
        super::Board {
            plan: BoardPlan::Best,
            ..board(1)
        },
    );
    assert!(lesson.work.id().unwrap() > job, "it is another job");
    let late = after(&lesson, [best.clone()]);
    assert_eq!(late.document, lesson.document);
    let shown = answered(&lesson);
    let answer = shown.document.answer.clone().unwrap();
    assert_eq!(answer.solved.status, Status::Optimal);
    assert!(!shown.history.can_undo(), "it is part of the board");
    let back = after(&lesson, [LEAVE, best]);
    assert!(back.document.is_stale() && back.work.solving().is_some());
}

#[test]
fn a_search_goes_on_where_it_was_when_the_lesson_ends() {
    let solving = after(
        &State::new(sample::draft()),
        [Action::Solve(SolveAction::Solve)],
    );
    let bound = Progress::Bound {
        cost: Cost::Makespan,
        at_least: 17,
    };
    let job = solving.work.id().unwrap();
    let told = Action::Worker(WorkerAction::Progress { job, event: bound });
    let lesson = opened(&opened(&after(&solving, [told]), board(1)), board(2));
    assert_eq!(lesson.own().phase(), Phase::Stopped);
    let back = after(&lesson, [LEAVE]);
    let run = back.work.solving().unwrap();
    assert_eq!(run.bounds.get(&Cost::Makespan), Some(&17));
    let done = answered(&back);
    assert_eq!(done.document.answer.unwrap().solved.status, Status::Optimal);
    // Who had stopped it, or asked for nothing, gets nothing.
    let stopped = after(&solving, [Action::Solve(SolveAction::Cancel)]);
    let back = after(&opened(&stopped, board(1)), [LEAVE]);
    assert!(back.work.is_idle());
}

#[test]
fn a_file_that_cannot_be_read_leaves_the_lesson_as_it_is() {
    let lesson = after(&opened(&own(), board(1)), stroke(Tool::Obstacle, &[(1, 1)]));
    let read = |name: &str| {
        let bytes = b"{ no".to_vec();
        let name = name.to_owned();
        let files = vec![Opened { name, bytes }];
        after(&lesson, [Action::Intake(IntakeAction::Read(files))])
    };
    let reading = read("bad.json");
    assert!(reading.lesson().is_some() && reading.intake.job().is_some());
    let job = reading.intake.job().unwrap().id;
    // The reply is taken out of it: nobody else may hold it.
    let answer = |reply| {
        let reply = Rc::new(reply);
        reduce(&reading, Action::Intake(IntakeAction::Reply { job, reply }))
    };
    let refused = answer(Reply::Refused("It cannot be read.".to_owned(), Vec::new()));
    assert_eq!(refused.document, lesson.document);
    assert_eq!(refused.lesson, lesson.lesson);
    let notice = refused.view.notice.as_ref().unwrap();
    assert_eq!(notice.sentence(), "It cannot be read.");
    assert!(refused.intake.job().is_none());
    // A scene that nobody can solve is refused likewise.
    let found = |scene| {
        Reply::Found(Box::new(Found {
            scene,
            plans: Vec::new(),
            notes: Vec::new(),
            files: Vec::new(),
        }))
    };
    let mut bad = scene();
    bad.map = vec!["..".to_owned(), "...".to_owned()];
    let refused = answer(found(bad));
    assert!(refused.lesson().is_some() && refused.view.notice.is_some());
    // What can be read takes the lesson's place, and is one step on one's own page.
    let come = answer(found(scene()));
    assert!(come.lesson().is_none());
    assert_eq!(come.document.draft.scene(), &scene());
    let undone = after(&come, [Action::Undo]);
    assert_eq!(undone.document, own().document);
}

#[test]
fn what_a_person_sets_in_a_lesson_stays() {
    let lesson = opened(&own(), board(1));
    let set = after(
        &lesson,
        [
            Action::View(ViewAction::SetTheme(crate::Theme::Dark)),
            Action::View(ViewAction::ShowTrails(false)),
        ],
    );
    let back = after(&set, [LEAVE]);
    assert_eq!(back.view.theme, crate::Theme::Dark);
    assert!(back.view.layers.trails, "that was about the board");
}

#[test]
fn a_file_or_a_link_ends_the_lesson_and_can_be_undone() {
    let own = own();
    let lesson = opened(&own, board(1));
    let scene = Box::new(scene());
    let open = after(&lesson, [Action::File(FileAction::Open(scene.clone()))]);
    assert!(open.lesson().is_none());
    assert_eq!(open.document.draft.scene(), &*scene);
    let undone = after(&open, [Action::Undo]);
    assert_eq!(undone.document, own.document);
    let resumed = after(
        &lesson,
        [Action::File(FileAction::Resume(Box::new(
            State::new(crate::Draft::default()).moment(),
        )))],
    );
    assert_eq!(
        resumed.document, lesson.document,
        "another tab does not end it"
    );
    assert_ne!(link::keep(&resumed), link::keep(&lesson));
}

#[test]
fn what_a_step_does_without_is_refused_with_why() {
    let lesson = opened(&own(), board(1));
    let picks = |tool| Action::Board(BoardAction::PickTool(tool));
    assert_eq!(after(&lesson, [picks(Tool::Obstacle)]).view.notice, None);
    let refused = after(&lesson, [picks(Tool::Erase)]);
    assert_eq!(refused.view.tool, Tool::Select);
    assert_eq!(
        refused.view.notice.unwrap().sentence(),
        "This step does without that tool."
    );
    let question = ask::offers(&sample::solved())[0].offers[0].question.clone();
    for closed in [
        Action::Solve(SolveAction::Solve),
        Action::Edit(Edit::RemoveAgent(0)),
        Action::Ask(AskAction::Ask(question)),
    ] {
        let refused = after(&lesson, [closed]);
        assert_eq!(refused.document, lesson.document);
        assert!(refused.work.is_idle());
        assert_eq!(
            refused.view.notice.unwrap().sentence(),
            "Leave the lesson before you do this."
        );
    }
    let moved = [
        Action::Board(BoardAction::Press(super::at(0, 0))),
        Action::Board(BoardAction::Drag(vec![super::at(1, 1)])),
        Action::Board(BoardAction::Release),
    ];
    let moved = after(&lesson, moved);
    assert_eq!(
        moved.document.draft.scene(),
        &scene(),
        "nothing may be moved"
    );
}

#[test]
fn a_board_that_is_no_scene_changes_nothing() {
    let own = own();
    let mut bad = board(1);
    bad.scene.map = vec!["..".to_owned(), "...".to_owned()];
    let refused = opened(&own, bad);
    assert!(refused.lesson().is_none());
    assert_eq!(refused.document, own.document);
    assert!(refused.view.notice.is_some());
    assert_eq!(say(&own, ToPage::Close).document, own.document);
}

#[test]
fn what_must_be_so_is_offered_where_a_step_shows_it() {
    let keys_it = |state: &State| {
        let key = Key {
            name: "m",
            ..Key::default()
        };
        command(key, state).is_some()
    };
    let own = own();
    assert!(freedom::is_offered(&own) && keys_it(&own));
    let without = opened(&own, board(1));
    assert!(!freedom::is_offered(&without) && !keys_it(&without));
    assert!(!without.can_look_inside());
    let mut shows = board(2);
    shows.show.extend([Layer::Freedom, Layer::Inside]);
    let with = opened(&without, shows);
    assert!(freedom::is_offered(&with) && keys_it(&with));
    assert!(with.can_look_inside());
}

#[test]
fn a_room_goes_from_board_to_board() {
    let lesson = opened(&own(), board(1));
    let presented = say(&lesson, ToPage::Present);
    assert!(presented.is_presented());
    assert_eq!(third(&presented), None, "the lesson tells by itself");
    let next = opened(&presented, board(2));
    assert!(next.is_presented());
    let left = say(&next, ToPage::Close);
    assert!(left.is_presented() && left.lesson().is_none());
    // Who presents a page of their own comes back to it without.
    let ended = after(&next, [END]);
    assert!(!say(&ended, ToPage::Close).is_presented());
}
