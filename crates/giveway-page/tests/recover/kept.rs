//! What the page keeps comes back whole, and is not believed where it came from elsewhere.

use giveway_page::{Action, FileAction, Phase, PlayAction, SolveAction, State, link, reduce};

use super::{edited, opened, solved};

#[test]
fn a_kept_scene_comes_back_whole_as_one_step() {
    let mine = edited(&opened("mine"), 5);
    let text = link::keep_moment(&mine.moment());
    let moment = link::kept_moment(&text).unwrap();
    assert_eq!(moment.document, mine.document);
    let other = opened("other");
    let back = reduce(&other, Action::File(FileAction::Resume(Box::new(moment))));
    assert_eq!(back.document, mine.document);
    assert_eq!(reduce(&back, Action::Undo).document, other.document);
    // The version before kept scenes as links without a check.
    let link = link::write(&mine);
    let parts = link.split('&').filter(|part| !part.starts_with("check="));
    let unchecked = parts.collect::<Vec<_>>().join("&");
    let former = link::kept_moment(&unchecked).unwrap();
    assert_eq!(former.document.draft, mine.document.draft);
}

#[test]
fn newer_versions_are_recognised_and_damage_is_refused() {
    let text = link::keep(&opened("mine"));
    assert!(!link::is_newer(&text));
    for newer in [
        text.replacen("kept=2", "kept=3", 1),
        text.replacen("kept=2", "kept=20", 1),
        "giveway=2&map=1.f".to_owned(),
    ] {
        assert!(link::is_newer(&newer), "{newer}");
        assert!(link::kept(&newer).is_err());
        assert!(link::kept_elsewhere(&newer).is_err());
    }
    for damaged in [
        "",
        "\0",
        "{}",
        "giveway-kept=2",
        "giveway-kept=2\n+0.-.0",
        "giveway=1&map=5.7f",
    ] {
        assert!(!link::is_newer(damaged), "{damaged}");
        assert!(link::kept(damaged).is_err(), "{damaged}");
    }
    let preferences = link::preferences(&opened("mine"));
    assert!(!link::are_newer(&preferences));
    assert!(link::are_newer(&preferences.replacen('4', "5", 1)));
}

#[test]
fn what_a_kept_file_claims_is_not_believed() {
    let solved = solved(&opened("mine"));
    let text = link::keep(&solved);
    assert!(text.contains("=claim="), "{text}");
    let here = link::kept(&text).unwrap();
    assert_eq!(here.phase(), Phase::Planned);
    let linked = link::kept_elsewhere(&text).unwrap();
    let elsewhere = reduce(
        &opened("other"),
        Action::File(FileAction::OpenLink(Box::new(linked))),
    );
    assert_eq!(elsewhere.plan(), solved.plan());
    assert_ne!(
        giveway_page::words::standing(&elsewhere).badge,
        giveway_page::words::standing(&here).badge
    );
}

#[test]
fn only_what_is_kept_makes_the_page_keep_it() {
    let still = solved(&opened("mine"));
    let seek = |state: &State, time| reduce(state, Action::Play(PlayAction::Seek(time)));
    let step = |state: &State, time| reduce(state, Action::Play(PlayAction::Reach(time)));
    assert!(
        !still.is_kept_alike(&seek(&still, 1)),
        "a time that was chosen is kept"
    );
    let playing = reduce(&seek(&still, 0), Action::Play(PlayAction::Play));
    assert!(playing.view.playback.playing);
    assert!(playing.is_kept_alike(&step(&playing, 1)), "it only plays");
    assert!(!playing.is_kept_alike(&edited(&playing, 5)));
    let solving = reduce(&still, Action::Solve(SolveAction::Solve));
    assert!(still.is_kept_alike(&solving) || solving.view.playback != still.view.playback);
}
