//! Links with changes of the world.

use giveway_model::{Cell, format::native};
use giveway_solve::Status;

use super::{bare, read_noise, why};
use crate::link::{From, change, keep, kept, open, read, write};
use crate::{Action, BoardAction, ChangeAction, Draft, Phase, PlayAction, State, reduce};

/// A3 joined at time 1 and a charger appears at time 2; something else is listed.
fn changed() -> State {
    let stroke = |tool, x, y| {
        let cell = Cell::new(x, y);
        [
            Action::Board(BoardAction::PickTool(tool)),
            Action::Board(BoardAction::Press(cell)),
            Action::Board(BoardAction::Release),
        ]
    };
    let state = crate::tests::adopted();
    let state = reduce(&state, Action::Play(PlayAction::Seek(2)));
    let actions = [Action::Change(ChangeAction::Begin)].into_iter();
    let actions = actions.chain(stroke(crate::Tool::Charger, 0, 0));
    actions.fold(state, |state, action| reduce(&state, action))
}

#[test]
fn a_course_comes_back_judged_with_its_changes() {
    let state = crate::tests::adopted();
    let text = write(&state);
    assert!(text.contains("&changes=1aA3.2.2.1.0&plan="), "{text}");
    let linked = read(&text, From::Anywhere).unwrap();
    let answer = linked.document.answer.unwrap();
    assert_eq!(answer.plan(), state.plan());
    let course = answer.course.as_deref().unwrap();
    let before = state.document.answer.as_ref().unwrap();
    assert_eq!(course.changes, before.course.as_deref().unwrap().changes);
    assert_eq!(course.steps[0].method, None, "a link is not believed");
    assert_eq!(answer.solved.status, Status::Feasible);
    assert_eq!(answer.arrivals, before.arrivals);
    // It came from elsewhere: no search was stopped here.
    let opened = reduce(&State::new(Draft::default()), open(&text));
    let standing = crate::words::standing(&opened);
    assert_eq!(standing.badge, crate::words::Badge::Shared);
    let open = "Nobody has checked here whether it is the best.";
    assert!(standing.sentence.ends_with(open), "{}", standing.sentence);
    assert_eq!(opened.phase(), Phase::Found);
}

#[test]
fn what_the_browser_kept_of_a_course_is_as_it_was() {
    let state = changed();
    let restored = kept(&keep(&state)).unwrap();
    assert_eq!(restored.phase(), Phase::Changing);
    assert_eq!(restored.view.playback.time, 2);
    let list = |state: &State| {
        state
            .document
            .mode
            .changing()
            .as_ref()
            .unwrap()
            .list
            .clone()
    };
    assert_eq!(list(&restored), list(&state));
    let course = |state: &State| state.document.answer.as_ref().unwrap().course.clone();
    assert_eq!(course(&restored), course(&state));
    let left = kept(&keep(&crate::tests::adopted())).unwrap();
    assert_eq!(left.phase(), Phase::Planned);
}

#[test]
fn every_kind_of_change_comes_back() {
    let text = "0aA%2E.0.0.1.1.0.1!9.4;1rA1;2o1.2;2f1.2;3m1.2.3.4;4s0.0.1.1;4n0.0;5c1.0;\
        5k1.0;6gA1.2.2;6wA1.0.2;7dA1.0.2;8bA1.5;9pA1.3";
    let changes = change::read(text, 2).unwrap();
    assert_eq!(changes.changes.len(), 14);
    assert_eq!(change::write(&changes.changes), text);
}

#[test]
fn hostile_changes_are_refused() {
    let good = bare(&crate::tests::adopted());
    for (changes, expect) in [
        ("1", "changes"),
        ("x", "changes"),
        ("1zA3", "changes"),
        ("1o1", "changes"),
        ("1o1.2.3", "changes"),
        ("99999999999o1.1", "changes"),
        ("100001aA3.2.2.1.0", "changes"),
        ("1aA3.2.2.1.0;1o1.0", "do not fit"),
        ("1aA3.9.9.1.0", "do not fit"),
        ("1aA1.2.2.1.0", "do not fit"),
        ("", "plan is broken"),
    ] {
        let text = good.replace("1aA3.2.2.1.0", changes);
        assert!(why(&text).contains(expect), "{changes}: {}", why(&text));
    }
    let many: Vec<String> = (1..=300).map(|at| format!("{at}o0.0")).collect();
    assert!(change::read(&many.join(";"), 2).is_none(), "too many times");
    let late: Vec<String> = (0..11).map(|n| format!("100000aB{n}.0.0.1.1")).collect();
    assert!(change::read(&late.join(";"), 2).is_none(), "too many steps");
}

#[test]
fn noise_about_changes_is_never_a_panic() {
    read_noise(&keep(&changed()), 8, 3000);
}

/// `A1` arrives at time 1, sleeps there, and at time 3 gets another goal.
fn woken() -> crate::Document {
    let instance = native::read_instance(
        r#"{ "giveway": 1, "map": ["..."], "agents": [
            { "name": "A1", "start": [0, 0], "goal": [1, 0] }] }"#,
    );
    let plan = native::read_plan(
        r#"{ "giveway": 1, "knows": 3, "slept": { "A1": [[1, 3]] },
            "paths": { "A1": [[0, 0], [1, 0], [1, 0], [1, 0], [2, 0]] } }"#,
    );
    let changes = native::read_changes(
        r#"{ "giveway": 1, "changes": [
            { "at": 3, "change": "set-goal", "agent": "A1", "cell": [2, 0] }] }"#,
    );
    let draft = Draft::new(instance.unwrap().to_scene()).unwrap();
    let judged = super::super::judged(draft, plan.unwrap(), changes.ok());
    judged.unwrap().document
}

#[test]
fn who_slept_has_slept_after_a_reload_too() {
    let document = woken();
    let plan = document.answer.as_ref().unwrap().plan().unwrap().clone();
    let costs = document.answer.as_ref().unwrap().solved.costs;
    assert_eq!(costs.map(|costs| costs.waits), Some(0));
    for whom in [From::Anywhere, From::Here] {
        let text = super::super::document::write(&document, whom);
        assert!(text.contains("&knows=3&slept=1.3"), "{text}");
        let answer = read(&text, whom).unwrap().document.answer.unwrap();
        assert_eq!(answer.plan(), Some(&plan));
        assert_eq!(answer.solved.costs, costs);
    }
}

#[test]
fn what_a_plan_knows_is_read_with_distrust() {
    let text = super::super::document::write(&woken(), From::Anywhere);
    for (part, broken) in [
        ("knows=3", "knows=x"),
        ("knows=3", "knows=100001"),
        ("slept=1.3", "slept="),
        ("slept=1.3", "slept=1"),
        ("slept=1.3", "slept=3.1"),
        ("slept=1.3", "slept=0.3"),
        ("slept=1.3", "slept=1.100001"),
        ("slept=1.3", "slept=1.3;1.3"),
    ] {
        let text = text.replacen(part, broken, 1);
        let read = read(&text, From::Anywhere);
        let told = read.map(|linked| linked.document.answer.unwrap().solved.costs);
        let waits = match broken {
            // Where nobody slept, it waited.
            "slept=" => 2,
            // It slept as far as it was there.
            "slept=0.3" => 0,
            _ => {
                assert!(told.is_err(), "{broken}");
                continue;
            }
        };
        assert_eq!(told.unwrap().map(|costs| costs.waits), Some(waits));
    }
}
