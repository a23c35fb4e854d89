//! Two tabs with one document: what goes on in one of them is taken, or asked about.

use giveway_model::{Agent, Cell, Scene};
use giveway_page::link::Kin;
use giveway_page::slot::{Elsewhere, Kind, Weight, message};
use giveway_page::{Action, Draft, SlotAction, SolveAction, State, link, reduce};

use super::{act, edited, opened, scene, solved, title};

#[test]
fn tabs_tell_their_documents_apart() {
    let start = opened("mine");
    let one = edited(&start, 5);
    let other = edited(&start, 6);
    let kin = |here: &State, there: &State| link::kin(&link::keep(here), &link::keep(there));
    assert_eq!(kin(&start, &start), Kin::Same);
    assert_eq!(kin(&start, &one), Kin::Ahead);
    assert_eq!(kin(&one, &start), Kin::Behind);
    assert_eq!(kin(&one, &other), Kin::Apart);
    assert_eq!(kin(&one, &edited(&opened("another"), 5)), Kin::Strange);
    // An answer is no edit: the solver gives it again.
    assert_eq!(kin(&start, &solved(&start)), Kin::Same);
    assert_eq!(kin(&solved(&start), &one), Kin::Ahead);
    assert_eq!(link::title(&link::keep(&one)).as_deref(), Some("mine"));
    assert!(link::is_touched(&link::keep(&one)));
    assert!(!link::is_touched(&link::keep(&start)));
}

/// What the page in the browser makes of what another tab kept.
fn hear(here: &State, there: &State) -> State {
    let text = link::keep(there);
    let is_ahead = match link::kin(&link::keep(here), &text) {
        Kin::Ahead => true,
        Kin::Apart => false,
        _ => return reduce(here, Action::Slot(SlotAction::Agree)),
    };
    let elsewhere = Elsewhere {
        tab: "7".to_owned(),
        moment: link::kept_moment(&text).unwrap(),
        is_ahead,
    };
    reduce(here, Action::Slot(SlotAction::Differ(Box::new(elsewhere))))
}

#[test]
fn what_goes_on_from_here_is_taken_without_asking() {
    let start = opened("mine");
    let there = edited(&start, 5);
    let here = hear(&start, &there);
    assert_eq!(here.document.draft.scene(), there.document.draft.scene());
    let told = message(&here).unwrap();
    assert_eq!(told.kind, Kind::Changed);
    assert!(
        told.text.starts_with("There the map is 5 \u{d7} 2. "),
        "{}",
        told.text
    );
    assert_eq!(act(&here, "Undo it here").document, start.document);
    assert_eq!(title(&edited(&here, 7)), None, "an edit makes it old news");
    // The other tab hears of what it has itself.
    assert_eq!(hear(&there, &here), there);
}

#[test]
fn what_went_on_on_both_sides_is_asked() {
    let start = opened("mine");
    let (mine, theirs) = (edited(&start, 5), edited(&start, 6));
    let asked = hear(&mine, &theirs);
    assert_eq!(asked.document, mine.document);
    let told = message(&asked).unwrap();
    assert!(told.boards.is_some());
    assert!(told.close.is_none());
    assert!(
        told.buttons
            .iter()
            .all(|button| button.weight != Weight::Filled)
    );

    let taken = act(&asked, "Take theirs");
    assert_eq!(taken.document.draft.scene(), theirs.document.draft.scene());
    assert_eq!(title(&taken), None);
    assert_eq!(reduce(&taken, Action::Undo).document, mine.document);

    let kept = act(&asked, "Keep mine");
    assert_eq!(kept.document, mine.document);
    let undone = reduce(&kept, Action::Undo);
    assert_eq!(undone.document.draft.scene(), theirs.document.draft.scene());
    // It is not asked again.
    assert_eq!(title(&hear(&kept, &edited(&theirs, 8))), None);
    // Where both agree again there is nothing to ask.
    assert_eq!(title(&hear(&asked, &mine)), None);
}

#[test]
fn nobody_is_interrupted() {
    let start = opened("mine");
    let there = edited(&start, 5);
    let solving = reduce(&start, Action::Solve(SolveAction::Solve));
    let asked = hear(&solving, &there);
    assert_eq!(asked.document, start.document);
    assert!(message(&asked).unwrap().boards.is_some());
    // Who took it back does not get it again unasked.
    let undone = reduce(&hear(&start, &there), Action::Undo);
    assert_eq!(hear(&undone, &edited(&there, 6)).document, start.document);
}

#[test]
fn differences_are_told_in_one_sentence() {
    let start = opened("mine");
    let told = |scene: Scene| {
        let there = State::new(Draft::new(scene).unwrap());
        let moment = there.moment();
        let elsewhere = Elsewhere {
            tab: String::new(),
            moment,
            is_ahead: false,
        };
        let asked = reduce(
            &start,
            Action::Slot(SlotAction::Differ(Box::new(elsewhere))),
        );
        let text = message(&asked).unwrap().text;
        text.strip_suffix(" Undo brings back the one you do not take.")
            .unwrap()
            .to_owned()
    };
    let map = |rows: [&str; 2]| Scene {
        map: rows.map(str::to_owned).to_vec(),
        ..scene("mine")
    };
    assert_eq!(told(map(["..#.", "...."])), "There (2, 0) is an obstacle.");
    assert_eq!(
        told(map(["....", ".++."])),
        "There (1, 1) and (2, 1) are chargers."
    );
    assert_eq!(
        told(map(["~...", "...#"])),
        "There (0, 0) is in the slow zone and (3, 1) is an obstacle."
    );
    assert_eq!(told(map(["....", ".+#~"])), "There 3 cells are different.");
    let mut two = scene("mine");
    two.agents.push(Agent {
        name: "A2".to_owned(),
        start: Cell::new(0, 1),
        goal: Some(Cell::new(3, 1)),
        waypoints: Vec::new(),
        battery: None,
        heading: None,
    });
    assert_eq!(told(two.clone()), "There A2 is one more robot.");
    two.map = vec!["..#.".to_owned(), "....".to_owned()];
    assert_eq!(
        told(two),
        "There (2, 0) is an obstacle, and A2 is one more robot."
    );
    assert_eq!(
        told(Scene {
            agents: Vec::new(),
            ..scene("mine")
        }),
        "There the robot A1 is missing."
    );
    assert_eq!(
        told(scene("mine")),
        "There the scene is the same, but the plan is not."
    );
}
