//! A link takes the place of a scene: one press brings that back.

use giveway_page::slot::{Lost, message};
use giveway_page::{Action, By, FileAction, Phase, Place, PlayAction, SlotAction, link, reduce};

use super::{act, answered, edited, link_to, name, opened, scene, solved, title};

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
fn inside_another_page_nothing_is_said() {
    let mut embedded = edited(&opened("mine"), 5);
    embedded.view.place = Place::Embedded;
    let linked = reduce(&embedded, link_to("theirs"));
    assert_eq!(name(&linked), "theirs");
    assert_eq!(title(&linked), None);
    let lost = reduce(&linked, Action::Slot(SlotAction::Lose(Lost::Newer)));
    assert_eq!(title(&lost), None);
}
