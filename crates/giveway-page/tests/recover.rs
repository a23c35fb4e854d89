//! Nothing is lost: what a page keeps, how tabs tell their documents apart, and what
//! is said of it. By way of the public door, as the page in the browser does it.

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "a test stops at the first surprise"
)]

use giveway_model::{Agent, Cell, Scene};
use giveway_page::files::blank;
use giveway_page::link::{self, Kin};
use giveway_page::slot::{Elsewhere, Kind, Lost, Message, Press, Unkept, message};
use giveway_page::{
    Action, By, Draft, Edit, FileAction, Phase, Place, PlayAction, SlotAction, SolveAction, State,
    reduce,
};
use giveway_solve::Progress;

fn scene(name: &str) -> Scene {
    let agent = Agent {
        name: "A1".to_owned(),
        start: Cell::new(0, 0),
        goal: Cell::new(3, 0),
        waypoints: Vec::new(),
        battery: None,
    };
    Scene {
        agents: vec![agent],
        ..blank(name, 4, 2)
    }
}

fn opened(name: &str) -> State {
    State::new(Draft::new(scene(name)).unwrap())
}

fn edited(state: &State, columns: u32) -> State {
    reduce(state, Action::Edit(Edit::Resize(columns, 2)))
}

fn link_to(name: &str) -> Action {
    link::open(&link::write(&opened(name)))
}

fn title(state: &State) -> Option<&'static str> {
    message(state).map(|message| message.title)
}

fn name(state: &State) -> &str {
    &state.document.draft.scene().name
}

fn act(state: &State, name: &str) -> State {
    let Message { buttons, .. } = message(state).unwrap();
    let button = buttons.into_iter().find(|button| button.name == name);
    let Press::Act(action) = button.unwrap().press else {
        panic!("{name} is no action of the page");
    };
    reduce(state, *action)
}

#[test]
fn a_link_keeps_what_it_displaces_and_one_press_brings_it_back() {
    let mine = edited(&opened("mine"), 5);
    let linked = reduce(&mine, link_to("theirs"));
    assert_eq!(name(&linked), "theirs");
    assert_eq!(title(&linked), Some("Your own scene is kept"));
    assert!(
        message(&linked)
            .unwrap()
            .text
            .contains("\u{201c}mine\u{201d}")
    );

    let back = act(&linked, "Back to it");
    assert_eq!(back.document, mine.document);
    assert_eq!(title(&back), Some("The scene of the link is kept"));
    assert_eq!(name(&act(&back, "Back to it")), "theirs");

    // Closed or edited, it is told no longer; Undo still has it.
    let close = message(&linked).unwrap().close.unwrap();
    assert_eq!(title(&reduce(&linked, close)), None);
    assert_eq!(title(&edited(&linked, 6)), None);
    assert_eq!(reduce(&linked, Action::Undo).document, mine.document);
}

#[test]
fn a_link_displaces_nothing_where_nothing_was_done_and_a_file_is_chosen() {
    assert_eq!(title(&reduce(&opened("example"), link_to("theirs"))), None);
    let mine = edited(&opened("mine"), 5);
    let Action::File(FileAction::OpenLink(_)) = link_to("theirs") else {
        panic!("it is a link");
    };
    let file = link::kept_elsewhere(&link::keep(&opened("theirs"))).unwrap();
    let from_file = reduce(&mine, Action::File(FileAction::OpenLink(Box::new(file))));
    assert_eq!(name(&from_file), "theirs");
    assert_eq!(title(&from_file), None);
}

#[test]
fn a_reload_brings_back_undo_and_what_was_displaced() {
    let mine = edited(&edited(&opened("mine"), 5), 6);
    let back = link::kept(&link::keep(&mine)).unwrap();
    assert_eq!(back.document.draft.scene(), mine.document.draft.scene());
    let undone = reduce(&reduce(&back, Action::Undo), Action::Undo);
    assert_eq!(*undone.document.draft.scene(), scene("mine"));

    let linked = reduce(&mine, link_to("theirs"));
    let again = link::kept(&link::keep(&linked)).unwrap();
    assert_eq!(again.displaced.as_ref().unwrap().by, By::Link);
    assert_eq!(name(&act(&again, "Back to it")), "mine");
    // Once it was closed, a reload does not tell it again.
    let closed = reduce(&linked, Action::File(FileAction::Keep));
    assert_eq!(title(&link::kept(&link::keep(&closed)).unwrap()), None);
}

#[test]
fn what_was_displaced_comes_back_where_it_was_looked_at() {
    let mine = reduce(
        &solved(&edited(&opened("mine"), 5)),
        Action::Play(PlayAction::Seek(2)),
    );
    let linked = reduce(&mine, link_to("theirs"));
    assert_eq!(linked.view.playback.time, 0);
    assert_eq!(reduce(&linked, Action::Undo).view.playback.time, 2);
    assert_eq!(act(&linked, "Back to it").view.playback.time, 2);
    let again = link::kept(&link::keep(&linked)).unwrap();
    assert_eq!(act(&again, "Back to it").view.playback.time, 2);
}

#[test]
fn a_link_stays_at_its_time_when_its_plan_is_proved() {
    let sent = reduce(
        &solved(&opened("theirs")),
        Action::Play(PlayAction::Seek(2)),
    );
    let linked = reduce(&opened("mine"), link::open(&link::write(&sent)));
    assert_eq!(linked.view.playback.time, 2);
    let proved = answered(&linked);
    assert_eq!(proved.phase(), Phase::Planned);
    assert_eq!(proved.view.playback, linked.view.playback);
}

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
    // The version before kept scenes as links.
    let former = link::kept_moment(&link::write(&mine)).unwrap();
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

/// Solved as the worker does it.
fn solved(state: &State) -> State {
    answered(&reduce(state, Action::Solve(SolveAction::Solve)))
}

/// What runs is answered.
fn answered(run: &State) -> State {
    struct Alone;
    impl giveway_solve::Host for Alone {
        fn wall_seconds(&self) -> f64 {
            0.0
        }
        fn progress(&self, _: &Progress) {}
    }
    let (job, request) = run.work.request().unwrap();
    let response = Box::new(giveway_solve::serve(&request, &Alone));
    reduce(run, Action::Solve(SolveAction::Respond { job, response }))
}

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
    assert!(told.buttons.iter().all(|button| !button.is_filled));

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
        goal: Cell::new(3, 1),
        waypoints: Vec::new(),
        battery: None,
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

#[test]
fn kept_data_comes_first_and_then_a_link() {
    let linked = reduce(&edited(&opened("mine"), 5), link_to("theirs"));
    let unkept = reduce(&linked, Action::Slot(SlotAction::Unkept(Unkept::Full)));
    assert_eq!(title(&unkept), Some("Your work is not being kept"));
    let lost = reduce(&unkept, Action::Slot(SlotAction::Lose(Lost::Damaged)));
    let told = message(&lost).unwrap();
    assert_eq!((told.kind, told.close), (Kind::Alert, None));
    let presses: Vec<Press> = told
        .buttons
        .into_iter()
        .map(|button| button.press)
        .collect();
    assert_eq!(presses, [Press::Download, Press::StartAfresh]);
    // Editing is free, and does not make it go.
    assert_eq!(message(&edited(&lost, 7)).unwrap().kind, Kind::Alert);
    let settled = reduce(&lost, Action::Slot(SlotAction::Settle));
    assert_eq!(title(&settled), Some("Your work is not being kept"));
    let kept = reduce(&settled, Action::Slot(SlotAction::Kept));
    assert_eq!(title(&kept), Some("Your own scene is kept"));
}

#[test]
fn inside_another_page_nothing_is_said() {
    let mut embedded = edited(&opened("mine"), 5);
    embedded.view.place = Place::Embedded;
    let linked = reduce(&embedded, link_to("theirs"));
    assert_eq!(name(&linked), "theirs");
    assert_eq!(title(&linked), None);
    let lost = reduce(&linked, Action::Slot(SlotAction::Lose(Lost::Newer)));
    assert_eq!(title(&lost), None);
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

#[test]
fn a_worker_that_breaks_down_leaves_the_best_plan() {
    let plan = solved(&opened("mine")).plan().unwrap().clone();
    let costs = solved(&opened("mine"))
        .document
        .answer
        .as_ref()
        .unwrap()
        .solved
        .costs
        .unwrap();
    let run = reduce(&opened("mine"), Action::Solve(SolveAction::Solve));
    let job = run.work.id().unwrap();
    let event = Progress::Plan {
        costs,
        plan: plan.clone(),
    };
    let run = reduce(&run, Action::Solve(SolveAction::Progress { job, event }));
    let crash = SolveAction::Crash {
        job,
        sentence: "It panicked.".to_owned(),
        had_started: true,
    };
    let after = reduce(&run, Action::Solve(crash));
    assert!(after.work.is_idle());
    assert_eq!(after.plan(), Some(&plan));
    let notice = after.view.notice.as_ref().unwrap();
    assert!(
        notice.sentence.contains("started again"),
        "{}",
        notice.sentence
    );
    assert_eq!(notice.details, ["It panicked."]);
    // The next job is another one: what the broken worker still tells is not heard.
    let again = reduce(&after, Action::Solve(SolveAction::Solve));
    assert_ne!(again.work.id(), Some(job));
}
