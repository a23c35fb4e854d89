//! The files of the course agree with each other, and are as they would be written.

use std::collections::BTreeSet;
use std::fs;

use giveway_course::lesson::{Lesson, Picture, write_course, write_glossary, write_lesson};
use giveway_model::Instance;
use giveway_model::check::check;

use super::shipped;

/// Whether files are to be written anew as the writer would.
fn rewrites() -> bool {
    std::env::var_os("GIVEWAY_WRITE_COURSE").is_some()
}

fn as_written(name: &str, written: &str) {
    if rewrites() {
        fs::write(shipped::folder().join(format!("{name}.json")), written).unwrap();
    }
    assert_eq!(
        shipped::text(name),
        written,
        "{name}.json is laid out otherwise; GIVEWAY_WRITE_COURSE=1 writes it anew"
    );
}

#[test]
fn files_are_laid_out_as_they_would_be_written() {
    as_written("index", &write_course(&shipped::course()));
    as_written("glossary", &write_glossary(&shipped::glossary()));
    for (name, lesson) in shipped::lessons() {
        as_written(&name, &write_lesson(&lesson));
    }
}

#[test]
fn the_index_says_what_the_lessons_say() {
    let course = shipped::course();
    for entry in course.lessons() {
        let lesson = shipped::lesson(entry.lesson.as_str());
        assert_eq!(entry.title, lesson.title, "{}", entry.lesson);
        assert_eq!(entry.minutes, lesson.minutes, "{}", entry.lesson);
        assert_eq!(entry.steps as usize, lesson.steps.len(), "{}", entry.lesson);
    }
}

#[test]
fn every_file_is_in_the_index() {
    let course = shipped::course();
    let mut listed: BTreeSet<String> = course
        .lessons()
        .map(|e| format!("{}.json", e.lesson))
        .collect();
    listed.extend(["index.json", "glossary.json"].map(str::to_owned));
    let files = fs::read_dir(shipped::folder()).unwrap();
    let found: BTreeSet<String> = files
        .map(|file| file.unwrap().file_name().into_string().unwrap())
        .collect();
    assert_eq!(found, listed);
}

#[test]
fn every_lesson_has_two_tasks_and_takes_an_evening_at_most() {
    for (name, lesson) in shipped::lessons() {
        let tasks = lesson.steps.iter().filter(|step| step.task.is_some());
        assert!(tasks.count() >= 2, "{name}");
        assert!((4..=7).contains(&lesson.minutes), "{name}");
        assert!(lesson.steps.len() <= 8, "{name}");
    }
    assert!(shipped::course().minutes() <= 120);
}

/// Plans are legal where nothing says that they are not.
#[test]
fn plans_that_are_shown_are_legal() {
    use giveway_course::lesson::Task;
    for (name, lesson) in shipped::lessons() {
        for (index, step) in lesson.steps.iter().enumerate() {
            let is_about_faults = match &step.task {
                Some(Task::Spot(_) | Task::Lead(_) | Task::Choose(_)) => true,
                Some(_) => false,
                // Before a task about a plan, the plan may be looked at.
                None => lesson
                    .steps
                    .get(index + 1)
                    .is_some_and(|next| matches!(next.task, Some(Task::Choose(_) | Task::Spot(_)))),
            };
            if let (Some(plan), false) = (&step.plan, is_about_faults) {
                let scene = lesson.scene(index).unwrap();
                let instance = Instance::new(scene.clone()).unwrap();
                let report = check(&instance, plan);
                assert!(
                    report.is_valid(),
                    "{name}, step {index}: {:?}",
                    report.violations
                );
            }
        }
    }
}

#[test]
fn boards_are_small() {
    let crowds = ["hundreds-at-once"];
    for (name, lesson) in shipped::lessons() {
        for scene in lesson.steps.iter().filter_map(|step| step.scene.as_ref()) {
            let width = scene.map[0].chars().count();
            let is_small = width <= 10 && scene.map.len() <= 7;
            assert!(
                is_small || crowds.contains(&name.as_str()),
                "{name}: {:?}",
                scene.map
            );
        }
    }
}

#[test]
fn pictures_show_a_moment_of_their_plan() {
    let course = shipped::course();
    let glossary = shipped::glossary();
    let pictures = course.lessons().map(|entry| &entry.picture);
    let pictures = pictures.chain(glossary.terms.iter().filter_map(|t| t.picture.as_ref()));
    for Picture { scene, plan, time } in pictures {
        let longest = plan
            .iter()
            .flat_map(|plan| plan.paths.values())
            .map(Vec::len);
        let longest = longest.max().unwrap_or(1);
        assert!((*time as usize) < longest, "{}: time {time}", scene.name);
    }
}

#[test]
fn pictures_of_the_glossary_break_only_the_rules_that_they_show() {
    for term in shipped::glossary().terms {
        let Some(Picture { scene, plan, .. }) = &term.picture else {
            continue;
        };
        let Some(plan) = plan else {
            continue;
        };
        let instance = Instance::new(scene.clone()).unwrap();
        let report = check(&instance, plan);
        let is_of_conflicts = term.term.as_str().contains("conflict");
        assert_eq!(
            report.is_valid(),
            !is_of_conflicts,
            "{}: {:?}",
            term.name,
            report.violations
        );
    }
}

#[test]
fn a_lesson_reads_back_as_it_was_written() {
    for (name, lesson) in shipped::lessons() {
        let text = write_lesson(&lesson);
        let read: Lesson = giveway_model::format::native::read_object(&text).unwrap();
        assert_eq!(read, lesson, "{name}");
    }
}
