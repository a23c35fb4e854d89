//! `giveway grade`: a class's hand-ins judged anew.

use std::fs;
use std::path::{Path, PathBuf};
use std::time::{Duration, SystemTime};

use giveway_course::handin::{Answer, HandIn, Work, hand_in, link, write};
use giveway_course::learner::Progress;
use giveway_course::lesson::{
    Glossary, Lesson, Value, link as lesson_link, read_course, read_glossary, read_lesson,
    write_lesson,
};
use giveway_model::Cell;
use jsonschema::Registry;

use crate::run::Folder;

fn static_course() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../static/course")
}

fn text(name: &str) -> String {
    fs::read_to_string(static_course().join(format!("{name}.json"))).unwrap()
}

fn glossary() -> Glossary {
    read_glossary(&text("glossary")).unwrap()
}

fn lesson(name: &str) -> Lesson {
    read_lesson(&text(name), &glossary()).unwrap()
}

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
    let edits = serde_json::json!({ "is": "edits", "cells": [[x, y, "#"]] });
    Work {
        step: 3,
        answer: Some(serde_json::from_value(edits).unwrap()),
        solved,
        tries: 1,
        ..Work::default()
    }
}

fn room(who: &str, works: Vec<Work>) -> HandIn {
    let lesson = lesson("room-to-pass");
    let id = "room-to-pass".parse().unwrap();
    let mut made = hand_in(&Progress::default(), &id, &lesson, who);
    made.tasks = works;
    made
}

fn folder(hand_ins: &[(&str, HandIn)]) -> Folder {
    let files: Vec<(&str, String)> = hand_ins
        .iter()
        .map(|(name, it)| (*name, write(it)))
        .collect();
    Folder::with(&files)
}

/// The lessons that the command holds are those of the page: `GIVEWAY_UPDATE=1` writes them
/// anew.
#[test]
fn the_command_holds_the_course() {
    let glossary = glossary();
    let terms: Vec<&str> = glossary
        .terms
        .iter()
        .map(|term| term.term.as_str())
        .collect();
    let mut held = terms.join(" ") + "\n";
    let course = read_course(&text("index")).unwrap();
    for entry in course.lessons() {
        let letters = lesson_link::write(&lesson(entry.lesson.as_str()), None);
        held = format!("{held}{} {letters}\n", entry.lesson);
    }
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/course.txt");
    if std::env::var_os("GIVEWAY_UPDATE").is_some() {
        fs::write(&path, &held).unwrap();
    }
    let is_held = fs::read_to_string(path).unwrap() == held;
    assert!(is_held, "GIVEWAY_UPDATE=1 writes src/course.txt anew");
}

#[test]
fn a_class_is_judged_whatever_it_claims() {
    let folder = folder(&[
        (
            "ada.json",
            room("Ada", vec![guess(9, true), blocked(3, 1, true)]),
        ),
        (
            "bo.json",
            room("Bo", vec![guess(7, true), blocked(0, 0, false)]),
        ),
    ]);
    fs::write(folder.path("homework.pdf"), "%PDF-1.4").unwrap();
    let run = folder.run("grade ada.json bo.json homework.pdf gone.json");
    assert_eq!((run.exit, run.err.as_str()), (Some(1), ""));
    let out = run.out;
    for line in [
        "Room to pass: 2 hand-ins",
        "Bo   FALSE 2   -         no 1      0 of 3",
        "Ada  yes 2     -         yes 1     2 of 3",
        "Bo, task 1 ",
        "says solved, is not. Not this: it is 9.",
        "homework.pdf: ",
        "gone.json: found no file of this name, expected a file",
        "1 claim is false.",
    ] {
        assert!(out.contains(line), "{line}\n{out}");
    }
    let right = folder.run("grade ada.json");
    assert_eq!(right.exit, Some(0), "{}", right.out);
    assert!(right.out.ends_with("No claim is false.\n"), "{}", right.out);
    let none = folder.run("grade homework.pdf");
    assert_eq!(none.exit, Some(1));
    assert!(
        none.out.ends_with("No file could be judged.\n"),
        "{}",
        none.out
    );
}

#[test]
fn json_fits_its_schema() {
    let folder = folder(&[
        (
            "ada.json",
            room("Ada", vec![guess(9, true), blocked(3, 1, true)]),
        ),
        ("bo.json", room("", vec![guess(7, true)])),
    ]);
    let run = folder.run("grade ada.json bo.json none.json --order name --format json");
    assert_eq!((run.exit, run.err.as_str()), (Some(1), ""));
    let report: serde_json::Value = serde_json::from_str(&run.out).unwrap();
    assert_eq!(report["false_claims"], 1);
    let students = &report["lessons"][0]["students"];
    assert_eq!(students[0]["name"], "Ada");
    assert_eq!(students[1]["file"], "bo.json");
    assert_eq!(students[1]["tasks"][0]["judged"], "not-solved");
    assert_eq!(report["unread"][0]["file"], "none.json");
    fits("gradeResult", &report);
    fits(
        "handIn",
        &serde_json::to_value(room("Ada", vec![blocked(3, 1, true)])).unwrap(),
    );
}

/// Holds a value against a definition of the schema of lessons.
fn fits(definition: &str, value: &serde_json::Value) {
    let model: serde_json::Value = serde_json::from_str(giveway_model::format::schema()).unwrap();
    let registry = Registry::new().add("urn:giveway:format:1", model).unwrap();
    let registry = registry.prepare().unwrap();
    let mut schema: serde_json::Value = serde_json::from_str(Lesson::schema()).unwrap();
    schema.as_object_mut().unwrap().remove("anyOf");
    schema["$ref"] = format!("#/$defs/{definition}").into();
    let options = jsonschema::options()
        .with_registry(&registry)
        .build(&schema);
    let options = options.unwrap();
    let errors = options.iter_errors(value);
    let errors: Vec<String> = errors
        .map(|error| format!("{error} at {}", error.instance_path()))
        .collect();
    assert!(errors.is_empty(), "{}", errors.join("\n"));
}

#[test]
fn csv_has_a_row_for_each_task_and_no_formula() {
    let evil = "=HYPERLINK(\"http://example.org\")";
    let folder = folder(&[("-x.json", room(evil, vec![guess(9, true)]))]);
    let run = folder.run("grade --csv ./-x.json");
    assert_eq!((run.exit, run.err.as_str()), (Some(0), ""));
    let lines: Vec<&str> = run.out.lines().collect();
    assert_eq!(
        lines[0].trim_start_matches('\u{feff}'),
        "name,lesson,task,judged,said,tries,answer,reason,file"
    );
    assert_eq!(lines.len(), 4, "{}", run.out);
    let name = "\"'=HYPERLINK(\"\"http://example.org\"\")\"";
    assert!(
        lines[1].starts_with(&format!("{name},Room to pass,1 ")),
        "{}",
        run.out
    );
    assert!(lines[2].contains(",not tried,,0,,,"), "{}", run.out);
    for line in lines {
        let cells = line.trim_start_matches('\u{feff}').split(',');
        for cell in cells {
            assert!(!cell.starts_with(['=', '+', '-', '@', '\t']), "{line}");
        }
    }
    let both = folder.run("grade --csv --format json ./-x.json");
    assert_eq!(both.exit, Some(2));
}

#[test]
fn a_lesson_of_ones_own_is_given() {
    let mut own = lesson("room-to-pass");
    own.steps[3].cells = Some(vec![Cell::new(3, 1)]);
    let mut made = hand_in(&Progress::default(), &own.own_id(), &own, "Ada");
    made.tasks = vec![blocked(3, 1, true)];
    let folder = folder(&[("ada.json", made)]);
    fs::write(folder.path("own.json"), write_lesson(&own)).unwrap();
    let without = folder.run("grade ada.json");
    assert_eq!(without.exit, Some(1));
    assert!(
        without.out.contains("of another lesson, \"Room to pass\""),
        "{}",
        without.out
    );
    let with = folder.run("grade ada.json --lesson own.json");
    assert_eq!(with.exit, Some(0), "{}", with.out);
    let bad = folder.run("grade ada.json --lesson ada.json");
    assert_eq!(bad.exit, Some(1));
    assert!(bad.err.starts_with("ada.json: "), "{}", bad.err);
}

#[test]
fn links_and_dates_count() {
    let letters = |works| link::write(&room("Ada", works)).unwrap();
    let links = format!(
        "https://example.org/#hand-in={}\n\n{}\n",
        letters(vec![guess(7, false)]),
        letters(vec![guess(9, true)])
    );
    let folder = folder(&[
        ("new.json", room("Bo", vec![guess(9, true)])),
        ("old.json", room("Bo", vec![guess(7, true)])),
    ]);
    fs::write(folder.path("links.txt"), links).unwrap();
    let dated = |name: &str, days: u64| {
        let file = fs::File::options()
            .write(true)
            .open(folder.path(name))
            .unwrap();
        let date = SystemTime::UNIX_EPOCH + Duration::from_secs(days * 86_400);
        file.set_modified(date).unwrap();
    };
    dated("new.json", 20_000);
    dated("old.json", 19_999);
    let run = folder.run("grade new.json old.json links.txt --order name");
    assert_eq!(run.exit, Some(0), "{}", run.out);
    assert!(run.out.contains("Ada (2 files)  yes 2"), "{}", run.out);
    assert!(run.out.contains("Bo (2 files)   yes 2"), "{}", run.out);
    let mailed = folder.run_with("grade -", &write(&room("Cy", vec![guess(9, true)])));
    assert!(mailed.out.contains("Cy   yes 2"), "{}", mailed.out);
}
