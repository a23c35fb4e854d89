//! Lessons that came as a file or in a link, as a browser keeps them.

use giveway_course::lesson::{Glossary, Lesson, OwnLessons};

use super::shipped;

fn named(number: usize) -> Lesson {
    Lesson {
        title: format!("Lesson {number}"),
        ..shipped::lesson("room-to-pass")
    }
}

/// The titles of the lessons, as they are read back.
fn titles(own: &OwnLessons) -> Vec<String> {
    let again = OwnLessons::read(&own.write());
    assert_eq!(again, *own);
    let lessons = again.lessons(&shipped::glossary()).into_iter();
    lessons.map(|lesson| lesson.title).collect()
}

#[test]
fn the_last_ones_are_kept_the_latest_first() {
    let mut own = OwnLessons::default();
    assert!(titles(&own).is_empty());
    for number in 0..20 {
        own.add(&named(number));
    }
    assert_eq!(titles(&own).len(), 12);
    assert_eq!(titles(&own)[0], "Lesson 19");
    // One that is opened again comes first, and is there once.
    own.add(&named(9));
    assert_eq!(titles(&own)[..2], ["Lesson 9", "Lesson 19"]);
    own.remove(&named(9).own_id());
    assert_eq!(titles(&own)[0], "Lesson 19");
    assert_eq!(titles(&own).len(), 11);
}

#[test]
fn a_lesson_is_shown_by_its_first_board() {
    let lesson = named(3);
    let entry = lesson.entry(lesson.own_id()).unwrap();
    assert!(entry.lesson.is_own());
    assert_eq!((&*entry.title, entry.steps), ("Lesson 3", 4));
    assert_eq!(Some(&entry.picture.scene), lesson.scene(0));
}

#[test]
fn what_is_kept_is_read_back_with_distrust() {
    let glossary = shipped::glossary();
    let mut own = OwnLessons::default();
    own.add(&named(1));
    let text = format!("own-1 ~cut\nnothing\n../x ~a\nown-2 {{\n{}", own.write());
    let read = OwnLessons::read(&text);
    assert_eq!(read.lessons(&glossary), [named(1)]);
    // Large ones make room for what was opened last.
    let large = |number: u8| format!("own-{number} ~{}\n", "x".repeat(150_000));
    let text: String = (0..5).map(large).collect();
    let kept = OwnLessons::read(&text);
    assert!(kept.write().starts_with("own-0 "));
    assert_eq!(kept.write().lines().count(), 2);
    assert!(kept.lessons(&Glossary::default()).is_empty());
}
