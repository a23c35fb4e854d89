//! What a learner sees before a lesson is handed in, and what a lecturer sees of a class.

use std::rc::Rc;

use giveway_course::grade::{Chosen, Class, Given, LookAction, Looking, Order};
use giveway_course::handin::{
    Answer, Card, CardState, Done, Edits, Form, FormAction, FormEffect, Subject, Work, cards, link,
    read, summary, write,
};
use giveway_course::learner::Progress;
use giveway_course::lesson::{Id, Value};
use giveway_model::{Cell, Ground};

use super::grading::judge;
use super::handins::handed;
use super::shipped;

fn guess(number: u32, solved: bool) -> Work {
    let value = Value::Number(number);
    Work {
        step: 1,
        answer: Some(Answer::Value { value }),
        solved,
        tries: 2,
        ..Work::default()
    }
}

fn blocked(x: u32, y: u32, solved: bool) -> Work {
    let mut edits = Edits::default();
    let cell = Cell::new(x, y);
    let ground = Ground::Obstacle;
    edits
        .cells
        .push(giveway_course::handin::CellEdit { cell, ground });
    Work {
        step: 3,
        answer: Some(Answer::Edits(edits)),
        solved,
        tries: 1,
        ..Work::default()
    }
}

#[test]
fn cards_show_what_the_lecturer_sees() {
    let lesson = shipped::lesson("room-to-pass");
    let made = handed(
        "room-to-pass",
        &lesson,
        "Ada",
        vec![guess(9, true), blocked(3, 1, false)],
    );
    let all = cards(&made, &lesson);
    let states: Vec<String> = all.iter().map(Card::state_words).collect();
    assert_eq!(
        states,
        ["solved, 2 tries", "not tried", "not solved, 1 try"]
    );
    assert_eq!(all[1].state, CardState::NotTried);
    assert_eq!(all[2].number, 3);
    assert_eq!(all[2].answer, "(3, 1) an obstacle");
    let shown = all[2].shown.as_ref().unwrap();
    assert_ne!(shown.scene, shown.start);
    assert_eq!(summary(&all), "1 of 3 solved · 3 tries");
}

#[test]
fn the_form_saves_a_file_and_copies_a_link() {
    let lesson = shipped::lesson("room-to-pass");
    let id: Id = "room-to-pass".parse().unwrap();
    let progress = Progress::default();
    let of = Subject {
        progress: &progress,
        id: &id,
        lesson: &lesson,
    };
    let form = Form::default();
    assert!(form.name_hint(of).is_some());
    let (form, none) = form.reduce(FormAction::Name("Ada L.".into()), of);
    assert_eq!(
        (none, form.name_hint(of), form.no_link(of)),
        (None, None, None)
    );
    let (long, _) = form.clone().reduce(FormAction::Name("a".repeat(61)), of);
    let hint = long.name_hint(of).unwrap();
    assert!(hint.contains(&format!("“{}”", "a".repeat(60))) && hint.contains("60 letters"));
    let (form, effect) = form.reduce(FormAction::Save, of);
    let Some(FormEffect::Save { name, text }) = effect else {
        panic!("{effect:?}");
    };
    assert_eq!(name, "room-to-pass-ada-l.json");
    assert_eq!(read(&text).unwrap(), form.made(of));
    assert_eq!(form.done, Some(Done::Saved));
    let (form, effect) = form.reduce(FormAction::Copy, of);
    let Some(FormEffect::Copy(letters)) = effect else {
        panic!("{effect:?}");
    };
    assert!(letters.starts_with(link::KEY));
    assert_eq!(read(&letters).unwrap(), form.made(of));
    assert!(form.done_words().unwrap().contains("lecturer"));
}

#[test]
fn a_class_is_looked_at_cell_by_cell() {
    let lesson = shipped::lesson("room-to-pass");
    let given = Given::new("room-to-pass".parse().unwrap(), Rc::new(lesson.clone()));
    let mut class = Class::new([given]);
    let mut add = |who: &str, works: Vec<Work>| {
        class.add(
            who,
            None,
            &write(&handed("room-to-pass", &lesson, who, works)),
        );
    };
    add("Student 1", vec![guess(9, true), blocked(3, 1, true)]);
    add("Student 2", vec![guess(7, true), blocked(1, 2, true)]);
    judge(&mut class);
    let looking = Looking::default();
    let lies = looking.to_look_at(&class);
    assert_eq!(
        lies,
        [Chosen { file: 1, step: 1 }, Chosen { file: 1, step: 3 }]
    );
    let next = LookAction::LookAt(true);
    let looking = looking.reduce(next, &class).reduce(next, &class);
    assert_eq!(looking.chosen, Some(lies[1]));
    let said = looking.said(&class).unwrap();
    assert_eq!(
        (said.head.as_str(), said.who.as_str()),
        ("Says solved, is not", "Student 2")
    );
    assert_eq!(said.answer, "(1, 2) an obstacle");
    assert!(!said.reason.is_empty());
    let shown = looking.shown(&class).unwrap();
    assert!(
        shown.scene.map[2].starts_with(".#"),
        "{:?}",
        shown.scene.map
    );
    let back = looking.reduce(LookAction::LookAt(false), &class);
    assert_eq!(back.chosen, Some(lies[0]));
    let back = back.reduce(LookAction::LookAt(false), &class);
    assert_eq!(back.chosen, Some(lies[1]));
    // What was not tried has no board of its own.
    let at = |file, step| LookAction::Choose(Some(Chosen { file, step }));
    let looking = looking.reduce(LookAction::Order(Order::Name), &class);
    let looking = looking.reduce(at(0, 1), &class);
    assert_eq!(looking.said(&class).unwrap().head, "Solved");
    let looking = looking.reduce(at(1, 2), &class);
    assert_eq!(looking.said(&class).unwrap().head, "Not tried");
    assert_eq!(looking.shown(&class), None);
    let none = looking.reduce(LookAction::Choose(None), &class);
    assert_eq!(none.said(&class), None);
}

/// Who looks at a class may change the language: what was judged stays judged, in other words.
#[test]
fn a_lesson_of_a_class_is_told_in_other_words() {
    let lesson = Rc::new(shipped::lesson("room-to-pass"));
    let id: Id = "room-to-pass".parse().unwrap();
    let given = Given::new(id.clone(), Rc::clone(&lesson));
    let asked = given.asked(1).unwrap().plain();
    assert!(
        given.asked(0).is_none(),
        "a step without a task asks nothing"
    );
    let mut class = Class::new([given]);
    let made = handed("room-to-pass", &lesson, "Ada", vec![guess(9, true)]);
    class.add("ada.json", None, &write(&made));
    judge(&mut class);
    let solved = |class: &Class| class.rows(0, Order::Name)[0].solved();
    assert_eq!(solved(&class), 1);
    let mut other = (*lesson).clone();
    other.title = "Platz zum Ausweichen".to_owned();
    class.reword(&id, &Rc::new(other));
    assert_eq!(class.lessons()[0].lesson.title, "Platz zum Ausweichen");
    assert_eq!(solved(&class), 1);
    assert_eq!(class.lessons()[0].asked(1).unwrap().plain(), asked);
}

#[test]
fn what_is_given_back_says_why_and_nothing_of_others() {
    let lesson = Rc::new(shipped::lesson("room-to-pass"));
    let id: Id = "room-to-pass".parse().unwrap();
    let mut class = Class::new([Given::new(id, Rc::clone(&lesson))]);
    let dan = vec![guess(9, true), blocked(5, 2, true)];
    for (name, works) in [("Dan", dan), ("Ada", vec![guess(7, false)])] {
        let made = handed("room-to-pass", &lesson, name, works);
        class.add(&format!("{name}.json"), None, &write(&made));
    }
    judge(&mut class);
    let place = class.rows(0, Order::Name)[1].place();
    let chosen = Some(Chosen {
        file: place,
        step: 3,
    });
    let looking = Looking::default().reduce(LookAction::Choose(chosen), &class);
    let text = looking.to_give_back(&class).unwrap();
    let lines: Vec<&str> = text.lines().collect();
    assert_eq!(lines[0], "Dan: Room to pass");
    assert_eq!(lines[1], "1 How long will they need?: solved.");
    assert_eq!(lines[2], "2 Who gives way?: not tried.");
    let told = "3 Block one cell: not solved. Your answer: (5, 2) an obstacle. ";
    assert!(
        lines[3].starts_with(told) && lines[3].len() > told.len(),
        "{}",
        lines[3]
    );
    assert!(lines.len() == 4 && !text.contains("Ada") && !text.contains("says"));
    assert_eq!(Looking::default().to_give_back(&class), None);
}
