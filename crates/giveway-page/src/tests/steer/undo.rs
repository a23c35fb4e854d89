//! Every step can be undone, the scene stays as it is, and a reload brings all back.

use giveway_model::{Cell, Question};

use super::{BACK, DISCARD, DOWN, RIGHT, WAIT, cells, leading, path, told};
use crate::link::{From, keep, kept, read};
use crate::reduce::tests::after;
use crate::{
    Action, AskAction, BoardAction, ChangeAction, Edit, FileAction, Phase, Tool, ask, sample,
};

#[test]
fn every_step_is_one_of_undo_and_nothing_is_lost() {
    let two = after(&leading(0, 0), [DOWN, RIGHT]);
    let one = after(&two, [Action::Undo]);
    assert_eq!(path(&one, "A1"), cells(&[(0, 0), (0, 1)]));
    assert_eq!(one.view.playback.time, 1);
    assert_eq!(
        after(&one, [Action::Redo]).document.mode.steering(),
        two.document.mode.steering()
    );
    let left = after(&one, [Action::Undo, Action::Undo]);
    assert_eq!(
        (left.document.mode.steering(), left.phase()),
        (None, Phase::Planned)
    );
    let discarded = after(&two, [DISCARD]);
    assert_eq!(discarded.phase(), Phase::Planned);
    assert_eq!(discarded.plan(), left.plan(), "the solver's plan again");
    assert_eq!(
        after(&discarded, [Action::Undo]).document.mode.steering(),
        two.document.mode.steering()
    );
    let scene = sample::draft().scene().clone();
    let opened = after(&two, [Action::File(FileAction::Open(Box::new(scene)))]);
    assert_eq!(opened.document.mode.steering(), None);
    let back = after(&opened, [Action::Undo]);
    assert_eq!(
        (back.document.mode.steering(), back.document.answer),
        (two.document.mode.steering(), two.document.answer)
    );
}

#[test]
fn the_scene_stays_as_it_is() {
    let state = after(&leading(0, 0), [DOWN]);
    let edits = [
        Action::Board(BoardAction::PickTool(Tool::Obstacle)),
        Action::Edit(Edit::BatteryFloor(1)),
        Action::Change(ChangeAction::Begin),
        Action::Ask(AskAction::Ask(Question::Makespan)),
    ];
    for edit in edits {
        let next = after(&state, [edit.clone()]);
        let why = next.view.notice.clone().map(|notice| notice.sentence());
        assert!(
            why.is_some_and(|why| why.contains("You lead A1")),
            "{edit:?}"
        );
        assert_eq!(
            (&next.document.draft, next.document.mode.steering()),
            (&state.document.draft, state.document.mode.steering())
        );
    }
    assert_eq!(ask::offers(&state), []);
    assert!(!state.can_move(Cell::new(3, 0)));
}

#[test]
fn the_plan_comes_back_after_a_reload() {
    let state = after(&leading(0, 1), [DOWN, WAIT]);
    let text = keep(&state);
    assert!(text.contains("\n=own=0!2.0!"), "{text}");
    let restored = kept(&text).unwrap();
    assert_eq!(restored.phase(), Phase::Steering);
    assert_eq!(path(&restored, "A1"), path(&state, "A1"));
    assert_eq!(told(&restored), told(&state));
    assert_eq!(restored.view.playback.time, 3);
    assert_eq!(path(&after(&restored, [BACK, BACK]), "A1").len(), 2);
    assert!(!told(&after(&restored, [BACK, BACK])).can_go_back);
    let link = crate::link::write(&state);
    assert!(!link.contains("own="), "no link has it");
    // What stands behind a link is no part of it.
    let longer = read(&format!("{link}&own=0!2.0!rdw;lll"), From::Anywhere);
    assert_eq!(longer, read(&link, From::Anywhere));
    for broken in [
        "9!2.0!rdw;lll",
        "0!0.0!rdw;lll",
        "0!99.0!rdw;lll",
        "0!2!r;l",
        "x",
    ] {
        let own = text.lines().find(|line| line.starts_with("=own=")).unwrap();
        let text = text.replace(own, &format!("=own={broken}"));
        assert!(kept(&text).is_err(), "{broken}");
    }
}
