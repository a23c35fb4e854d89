//! A hand-in as text: a mail survives it, it is small, its faults say where and what.

use giveway_course::handin::{HandIn, Sum, hand_in, link, read, write};
use giveway_course::learner::Progress;
use giveway_course::lesson::{Id, translated};

use super::super::schema::with_definition;
use super::super::{judges, shipped};
use super::solved;

#[test]
fn a_mail_survives_it() {
    for (name, lesson) in shipped::lessons() {
        let mut made = solved(&name, &lesson, "Zoë \\ > \"From\" 猫 a b c d e f");
        made.hand_in.title = "a ".repeat(29) + "b";
        let text = write(&made);
        assert!(text.is_ascii());
        for line in text.lines() {
            assert!(line.len() <= 72, "{line}");
            assert_eq!(line.trim_end(), line);
            assert!(!line.starts_with([' ', '>']), "{line}");
        }
        let lines: Vec<&str> = text.lines().collect();
        let quoted = format!("> > {}  \r\n", lines.join("  \r\n> > "));
        let mailed = format!("\u{feff}Hello,\r\nhere it is:\r\n{quoted}\r\n-- \r\nZoë\r\n");
        assert_eq!(read(&text).as_ref(), Ok(&made), "{name}");
        assert_eq!(read(&mailed).as_ref(), Ok(&made), "{name}");
        if let Some(letters) = link::write(&made) {
            assert!(letters.len() <= 2000);
            assert_eq!(read(&letters).as_ref(), Ok(&made));
            let quoted = format!(
                "> <https://example.org/x/#hand-in%3D%7E{}>.\n",
                &letters[1..]
            );
            assert_eq!(read(&quoted).as_ref(), Ok(&made));
        }
    }
}

#[test]
fn the_schema_tells_what_is_in_it() {
    let all: Vec<HandIn> = shipped::lessons()
        .iter()
        .map(|(name, lesson)| solved(name, lesson, "Ada"))
        .collect();
    with_definition("handIn", |validator| {
        for made in &all {
            let value = serde_json::to_value(made).unwrap();
            let errors = validator.iter_errors(&value);
            let errors: Vec<String> = errors.map(|error| error.to_string()).collect();
            assert!(errors.is_empty(), "{}: {errors:?}", made.hand_in.lesson);
            let mut other = value.clone();
            other["scene"] = serde_json::json!({});
            assert!(!validator.is_valid(&other));
        }
    });
}

#[test]
fn it_is_small() {
    let (mut largest, mut links) = (0, 0);
    for (name, lesson) in shipped::lessons() {
        let made = solved(&name, &lesson, "Somebody with a name of some length");
        let bytes = write(&made).len();
        let tasks = made.tasks.len().max(1);
        assert!(
            bytes * 5 / tasks < 20_000,
            "{name}: {bytes} bytes, {tasks} tasks"
        );
        largest = largest.max(bytes);
        links += usize::from(link::write(&made).is_some());
    }
    assert!(largest < 20_000, "{largest}");
    assert!(links >= 10, "{links}");
}

#[test]
fn a_lesson_has_one_sum_in_all_languages() {
    for (name, lesson) in shipped::lessons() {
        let mut texts = 0;
        let other = translated(&lesson, |key| {
            texts += 1;
            (!key.contains('[')).then_some("Wort")
        });
        assert_ne!(other, lesson);
        assert_eq!(Sum::of(&other), Sum::of(&lesson), "{name}");
        for step in 0..lesson.steps.len() {
            assert_eq!(Sum::of_step(&other, step), Sum::of_step(&lesson, step));
        }
    }
    let mut sums: Vec<Sum> = shipped::lessons()
        .iter()
        .map(|(_, it)| Sum::of(it))
        .collect();
    let count = sums.len();
    sums.sort_unstable();
    sums.dedup();
    assert_eq!(sums.len(), count);
}

/// A sum that changes from version to version would make strangers of all hand-ins.
#[test]
fn a_sum_stays_what_it_is() {
    let task = serde_json::json!({ "kind": "paint", "until": { "is": "solvable" } });
    let open = judges::scene(&["....", "...."], &[("A1", [0, 0], [3, 0])]);
    let lesson = judges::lesson(&open, &serde_json::json!({ "tools": ["obstacle"] }), &task);
    assert_eq!(Sum::of(&lesson).to_string(), "eff62e3a2b6ce3ef");
    let mut other = lesson.clone();
    other.steps[0].edits = Some(1);
    assert_ne!(Sum::of(&other), Sum::of(&lesson));
}

#[test]
fn faults_say_where_and_what() {
    let lesson = shipped::lesson("room-to-pass");
    let text = write(&solved("room-to-pass", &lesson, "Ada"));
    let told = |from: &str, to: &str| {
        assert!(text.contains(from), "{text}");
        read(&text.replacen(from, to, 1)).unwrap_err()
    };
    assert_eq!(told("\"step\": 3", "\"step\": 2").place, "tasks[1].step");
    assert_eq!(told("\"step\": 2", "\"step\": 99").place, "tasks[0].step");
    assert_eq!(told("\"Ada\"", "\"A\\u202eda\"").place, "name");
    assert_eq!(
        told("\"Ada\"", &format!("\"{}\"", "a".repeat(61))).place,
        "name"
    );
    assert_eq!(
        told("\"solved\"", "\"scene\"").found,
        "the unknown key \"scene\""
    );
    let cut = read(&text[..text.len() / 2]).unwrap_err();
    assert_eq!(
        (cut.found.as_str(), cut.line.is_some()),
        ("the end of the text", true)
    );
    let two = read(&format!("{text}\n{text}")).unwrap_err();
    assert_eq!(two.found, "a second hand-in");
    let scene = giveway_model::format::native::write_scene(lesson.scene(1).unwrap());
    let other = read(&scene).unwrap_err();
    assert!(other.found.starts_with("an instance"), "{other}");
    let pdf = read("%PDF-1.4 nothing").unwrap_err();
    assert!(pdf.to_string().contains("a hand-in"), "{pdf}");
}

#[test]
fn a_file_is_json_where_its_texts_have_room_in_a_line() {
    let name = "room-to-pass";
    let lesson = shipped::lesson(name);
    let id: Id = name.parse().unwrap();
    let made = hand_in(&Progress::default(), &id, &lesson, "Ada Lovelace");
    let text = write(&made);
    assert!(text.lines().all(|line| line.len() <= 72), "{text}");
    let json: serde_json::Value = serde_json::from_str(&text).unwrap();
    assert_eq!(json["name"], "Ada Lovelace");
    // A longer text goes on in the next line, and is read all the same.
    let long = HandIn {
        name: Some("\u{e9}".repeat(60)),
        ..made
    };
    assert!(serde_json::from_str::<serde_json::Value>(&write(&long)).is_err());
    assert_eq!(read(&write(&long)).unwrap(), long);
}
