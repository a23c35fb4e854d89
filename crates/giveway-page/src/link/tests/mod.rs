//! Links: round trips, and every way in which a text can be none.

mod ask;
mod beginning;
mod change;
mod kept;
mod mangled;
mod share;

use std::rc::Rc;

use giveway_model::{AtGoal, Cell, Scene, Units};
use giveway_solve::Status;

use super::*;
use crate::{Action, Draft, FileAction, Phase, PlayAction, Selection, reduce, sample};

fn scene(text: &str) -> Scene {
    let linked = read(text, From::Anywhere).unwrap();
    linked.document.draft.scene().clone()
}

/// The text of a state's link without its check.
fn bare(state: &State) -> String {
    match seal::read(&write(state)) {
        seal::Sealed::Whole(text) => text,
        other => panic!("{other:?}"),
    }
}

fn why(text: &str) -> String {
    read(text, From::Anywhere).unwrap_err().details().join(" ")
}

#[test]
fn a_scene_comes_back_as_it_was() {
    let mut scene_before = sample::draft().scene().clone();
    scene_before.name = "<b>50 % & more; \u{fc}\u{1f600}".to_owned();
    scene_before.rules.at_goal = AtGoal::Vanish;
    scene_before.rules.battery_floor = 2;
    scene_before.agents[0].battery = None;
    scene_before.agents[1].name = "A.2;!&=#".to_owned();
    scene_before.map[1] = ".##*##.##.".to_owned();
    let measure = |text: &str| crate::number::measure(text).unwrap();
    scene_before.units = Some(Units {
        cell: measure("0.8"),
        step: measure("1,5"),
    });
    let state = State::new(Draft::new(scene_before.clone()).unwrap());
    let text = write(&state);
    assert!(
        text.bytes()
            .all(|byte| byte.is_ascii_alphanumeric() || b"-%&=.;!".contains(&byte)),
        "{text}"
    );
    assert_eq!(scene(&text), scene_before);
}

#[test]
fn a_plan_comes_back_judged_and_not_believed() {
    let state = reduce(&sample::solved(), Action::Play(PlayAction::Seek(7)));
    let text = write(&state);
    assert!(text.len() < 300, "{} letters", text.len());
    let linked = read(&text, From::Anywhere).unwrap();
    let answer = linked.document.answer.clone().unwrap();
    assert_eq!(answer.plan(), state.plan());
    assert_eq!(
        answer.solved.costs,
        state.document.answer.as_ref().unwrap().solved.costs
    );
    assert_eq!(
        answer.solved.status,
        Status::Feasible,
        "no proof came with it"
    );
    assert!(answer.solved.bounds.is_empty());
    assert_eq!(linked.time, 7);
    let claimed = document::write(&state.document, From::Here);
    assert!(why(&claimed).contains("claim"), "a link has no claims");
}

#[test]
fn a_scene_with_problems_can_be_kept_and_sent() {
    let mut scene_before = sample::draft().scene().clone();
    scene_before.agents[0].goal = Some(Cell::new(1, 1));
    let state = State::new(Draft::new(scene_before.clone()).unwrap());
    assert_eq!(scene(&write(&state)), scene_before);
    let text = format!("{}&plan=;", bare(&state));
    assert!(why(&text).contains("not valid"), "{}", why(&text));
}

#[test]
fn opening_a_link_is_one_step_of_undo() {
    let before = sample::solved();
    let mut other = before.clone();
    other.document.draft = Rc::new(Draft::default());
    let text = write(&other);
    let state = reduce(&before, open(&text));
    assert_eq!(state.document.draft, other.document.draft);
    assert_eq!(state.document.answer, None);
    let undone = reduce(&state, Action::Undo);
    assert_eq!(undone.document.draft, before.document.draft);
    assert!(!undone.history.can_undo());

    let planned = reduce(
        &state,
        open(&write(&reduce(&before, Action::Play(PlayAction::Seek(7))))),
    );
    assert_eq!(
        (planned.phase(), planned.view.playback.time),
        (Phase::Solving, 7)
    );
    assert_eq!(planned.view.selection, Selection::Nothing);
}

#[test]
fn a_hostile_link_is_refused_and_the_scene_stays() {
    let good = bare(&sample::solved());
    let with = |key: &str, value: &str| {
        let parts = good.split('&').map(|part| match part.split_once('=') {
            Some((own, _)) if own == key => format!("{key}={value}"),
            _ => part.to_owned(),
        });
        parts.collect::<Vec<_>>().join("&")
    };
    let broken = |text: String, expect: &str| {
        let told = why(&text);
        assert!(told.contains(expect), "{told:?} for {text:.80}");
        let before = sample::solved();
        let state = reduce(&before, open(&text));
        assert_eq!(state.document.draft, before.document.draft);
        assert_eq!(state.document.answer, before.document.answer);
        assert!(state.view.notice.is_some());
    };
    broken(String::new(), "no scene");
    broken("<script>alert(1)</script>".to_owned(), "no scene");
    broken(with("giveway", "2"), "version 2");
    broken(format!("{good}&evil=1"), "evil");
    broken("x".repeat(LONGEST + 1), "longer");
    for map in [
        "",
        "10",
        "0.f",
        "10.x",
        "10.99999999999999999999f",
        "10.70000f",
        "5.7f",
        "300.300f",
        "10.3",
    ] {
        let text = with("map", map);
        assert!(read(&text, From::Anywhere).is_err(), "{map}");
    }
    broken(with("rules", "2.0"), "rules");
    broken(with("rules", "0"), "rules");
    for costs in ["", "9", "00", "x"] {
        broken(with("costs", costs), "costs");
    }
    for agents in [
        "A1",
        "A1.0",
        "A1.0.0",
        "A1.0.0.1",
        "A1.0.0.1.-1",
        "A1.0.0.1.1!5",
        "%.0.0.1.1",
        "%FF.0.0.1.1",
        "A1.0.0.1.1;",
    ] {
        broken(with("agents", agents), "agents");
    }
    let many = vec!["A.0.0.0.0"; 10_001].join(";");
    broken(with("agents", &many), "10001 robots");
    for plan in ["", "r", "r;l;u", "9999999r;", "x;x", "u;u", "\u{e9};"] {
        broken(with("plan", plan), "plan");
    }
    broken(with("plan", "r;l"), "breaks a rule");
    broken(format!("{good}&time=x"), "time");
}

/// Reads a good link with faults strewn over it, again and again.
fn read_noise(good: &str, seed: u64, times: u32) {
    let mut rng = fastrand::Rng::with_seed(seed);
    for _ in 0..times {
        let mut bytes = good.as_bytes().to_vec();
        for _ in 0..rng.usize(1..6) {
            let place = rng.usize(0..bytes.len());
            match rng.u8(0..3) {
                0 => bytes[place] = rng.u8(32..127),
                1 => bytes.truncate(place + 1),
                _ => bytes.insert(place, rng.u8(b'.'..b'{')),
            }
        }
        let text = String::from_utf8_lossy(&bytes);
        let _ = kept(&text);
        let _ = read(&text, From::Here);
        let _ = read(&text, From::Anywhere);
    }
}

#[test]
fn noise_is_refused_and_never_a_panic() {
    read_noise(&keep(&sample::solved()), 7, 5000);
}

#[test]
fn links_of_old_can_be_opened() {
    // Links of each form that the page ever wrote: they are in mails and papers.
    for text in [
        "giveway=1&map=1.f&rules=0.0&costs=012&agents=",
        "giveway=1&map=3.3f&name=a%20b&rules=1.2&costs=10&agents=A1.0.0.2.0.1.0!9.4&plan=2r&time=1",
        "giveway=1&map=10.2f6s3f2of2of2o4fc2fc3f&name=warehouse&rules=0.0&costs=012&\
         agents=A1.0.0.9.2.2.0.4.2.7.0!10.10;A2.9.2.0.0.5.0.1.2!10.8&\
         plan=2rR2d3rc2uR2r2d;3lc2u3L2dc3l2u&time=7",
        "giveway=1&map=3.9f&name=dynamic-3x3&rules=0.0&costs=012&agents=A1.0.0.2.2;A2.2.0.0.2&\
         changes=1aA3.2.2.1.0&plan=2r2d;d2ld;l2u&time=1",
    ] {
        let linked = read(text, From::Anywhere);
        let linked = linked.unwrap_or_else(|notice| panic!("{text}: {notice:?}"));
        assert_eq!(linked.document.answer.is_some(), text.contains("&plan="));
        // They are written so still, with a check.
        let state = reduce(
            &State::new(Draft::default()),
            Action::File(FileAction::OpenLink(Box::new(linked))),
        );
        assert_eq!(write(&state), seal::write(text));
    }
}
