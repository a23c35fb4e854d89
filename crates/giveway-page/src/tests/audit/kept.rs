//! A plan of elsewhere comes back after a reload, and by a link.

use giveway_formats::link::audited;
use giveway_formats::{Options, Source, combine};

use super::{LEGAL_PATHS, MEETING, SCENE, audit, dropped, fresh};
use crate::audit::facts;
use crate::tests::answered as answer;
use crate::{Action, Edit, link, reduce};

#[test]
fn the_browser_brings_it_back_and_a_link_carries_it() {
    for plan in [MEETING, LEGAL_PATHS] {
        let state = answer(&dropped(
            &fresh(),
            &[("hall.json", SCENE), ("p.json", plan)],
        ));
        let kept = link::kept(&link::keep(&state)).unwrap();
        let (one, two) = (audit(&state), audit(&kept));
        assert_eq!((&one.plan, &one.plans), (&two.plan, &two.plans));
        assert_eq!(
            one.ours.as_ref().map(|ours| &ours.solved.bounds),
            two.ours.as_ref().map(|ours| &ours.solved.bounds)
        );
        assert_eq!(
            facts(&state).unwrap().verdict,
            facts(&kept).unwrap().verdict
        );
        let opened = reduce(&fresh(), link::open(&link::write(&state)));
        let shared = audit(&opened);
        assert_eq!(shared.plan, one.plan);
        // Nobody believes what a link claims: the search begins anew.
        assert!(shared.ours.is_none() && opened.work.solving().is_some());
    }
}

#[test]
fn a_search_that_was_cut_off_begins_anew() {
    let state = dropped(&fresh(), &[("hall.json", SCENE), ("p.json", MEETING)]);
    let kept = link::kept(&link::keep(&state)).unwrap();
    assert!(kept.work.solving().is_some());
    assert_eq!(
        facts(&answer(&kept)).unwrap().verdict,
        facts(&answer(&state)).unwrap().verdict
    );
    // What is proved is not proved again.
    let done = link::kept(&link::keep(&answer(&state))).unwrap();
    assert!(done.work.is_idle());
    let edited = reduce(&state, Action::Edit(Edit::Resize(4, 2)));
    let back = reduce(&edited, Action::Undo);
    assert!(back.work.solving().is_some());
}

#[test]
fn the_link_of_a_report_opens_the_plan() {
    for plan in [MEETING, LEGAL_PATHS] {
        let files = [("hall.json", SCENE), ("p.json", plan)];
        let read = combine(
            &files.map(|(name, text)| Source { name, text }),
            &Options::default(),
        )
        .unwrap();
        let scene = read.instance.to_scene();
        let text = audited(&scene, &read.plans[0], &read.notes).unwrap();
        let opened = audit(&reduce(&fresh(), link::open(&text)));
        let here = audit(&dropped(&fresh(), &files));
        assert_eq!(opened.plan.file, here.plan.file);
        assert_eq!(opened.plan.violations, here.plan.violations);
        assert_eq!(opened.notes, here.notes);
    }
}

#[test]
fn a_plan_that_starts_elsewhere_is_kept_and_shared_as_it_is() {
    let far = r#"{"giveway": 1, "paths": {
        "A1": [[1, 1], [1, 0], [2, 0]], "A2": [[2, 0], [1, 0], [0, 0]]}}"#;
    let state = dropped(&fresh(), &[("hall.json", SCENE), ("p.json", far)]);
    let told = facts(&state).unwrap();
    assert_eq!(told.verdict.word, "Not for this scene");
    assert_eq!(
        told.verdict.sentence,
        "A1 starts elsewhere: 1 of 2 robots fit."
    );
    let opened = reduce(&fresh(), link::open(&link::write(&state)));
    assert_eq!(audit(&opened).plan, audit(&state).plan);
}
