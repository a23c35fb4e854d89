//! The course in other languages: each text is taken over, names what the English one
//! names, and is as easy to read.
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "a test that cannot go on ends with a panic"
)]

use std::fs;

use giveway_course::judge::words::{made, said};
use giveway_course::judge::{Kind, Verdict, Why};
use giveway_course::lesson::{
    Lesson, Step, Text, Worded, keys, read_course, read_glossary, read_lesson, translated,
    write_course, write_glossary, write_lesson,
};
use giveway_course::port::Evidence;
use giveway_model::words::{Catalogue, found, speak};
use giveway_model::{Cell, Cost, Fault};
use giveway_solve::Reason;
use giveway_tests::languages::{Files, Part};
use giveway_tests::source;

/// The most words of a sentence, on the mean of a lesson.
const MEAN: f64 = 15.0;
/// The most words of any sentence.
const LONGEST: usize = 28;

/// Has each language spoken, one after the other.
fn in_each(check: impl Fn(&str, &Files)) {
    let english = Files::read();
    let list = fs::read_to_string(source::root().join("static/languages/list.txt")).unwrap();
    for tag in list.lines().filter_map(|line| line.split(' ').next()) {
        let parts = Part::ALL.map(|part| {
            let path = format!("{}/{tag}.po", part.folder());
            fs::read_to_string(source::root().join(path)).unwrap()
        });
        let both = Catalogue::read(&parts.join("\n"), Box::new(|n| usize::from(n != 1)));
        speak(Some(both.unwrap().kept()));
        check(tag, &english);
        speak(None);
    }
}

fn expect_read<T>(what: &str, read: Result<T, Vec<Fault>>) -> T {
    read.unwrap_or_else(|faults| panic!("{what}: {}", faults[0]))
}

#[test]
fn every_text_names_what_the_english_one_names() {
    in_each(|tag, english| {
        let complain = |key: String| {
            let other = found(&key);
            let of_words = key.contains('\u{4}');
            let same = other.is_some_and(|other| {
                let (one, other) = (key.parse::<Text>(), other.parse::<Text>());
                of_words
                    || one.is_ok_and(|one| other.is_ok_and(|other| other.names_the_same_as(&one)))
            });
            assert!(same, "{tag}: {key}\n{}", other.unwrap_or("nothing"));
        };
        let lessons = english.lessons.iter().flat_map(|(_, lesson)| keys(lesson));
        let all = keys(&english.course)
            .into_iter()
            .chain(keys(&english.glossary));
        all.chain(lessons).for_each(complain);
    });
}

#[test]
fn it_reads_back_in_every_language() {
    in_each(|tag, english| {
        let glossary = translated(&english.glossary, found);
        let read = expect_read(tag, read_glossary(&write_glossary(&glossary)));
        assert_eq!(read, glossary);
        let course = translated(&english.course, found);
        assert_eq!(
            expect_read(tag, read_course(&write_course(&course))),
            course
        );
        for (name, lesson) in &english.lessons {
            let lesson = translated(lesson, found);
            let read = read_lesson(&write_lesson(&lesson), &glossary);
            assert_eq!(expect_read(&format!("{tag}, {name}"), read), lesson);
        }
    });
}

#[test]
fn what_there_is_to_do_stays_the_same() {
    /// The lesson with no words at all.
    fn bare(lesson: &Lesson) -> Lesson {
        fn blank(worded: &mut impl Worded) {
            worded.reword(&mut |_| Some(""));
        }
        let mut lesson = lesson.clone();
        blank(&mut lesson.title);
        for step in &mut lesson.steps {
            blank(&mut step.title);
            step.text.clear();
            step.hints.clear();
            step.reason = None;
            step.task = None;
        }
        lesson.about = Text::default();
        lesson
    }
    in_each(|_, english| {
        for (_, lesson) in &english.lessons {
            let other = translated(lesson, found);
            assert_ne!(&other, lesson);
            assert_eq!(bare(&other), bare(lesson));
            let kinds = |lesson: &Lesson| {
                let tasks = lesson.steps.iter().map(|step| step.task.as_ref());
                tasks
                    .map(|task| task.map(giveway_course::lesson::Task::kind))
                    .collect::<Vec<_>>()
            };
            assert_eq!(kinds(&other), kinds(lesson));
        }
    });
}

#[test]
fn sentences_are_short_in_every_language() {
    in_each(|tag, english| {
        for (name, lesson) in &english.lessons {
            let texts = keys(lesson).into_iter().filter_map(|key| found(&key));
            let mut lengths = Vec::new();
            for text in texts {
                let plain = text.parse::<Text>().unwrap().plain();
                for sentence in plain.split_inclusive(['.', '?', '!', ':']) {
                    let words = sentence.split_whitespace().count();
                    assert!(words <= LONGEST, "{tag}, {name}: {sentence}");
                    lengths.extend((words > 0).then_some(words));
                }
            }
            let mean = lengths.iter().sum::<usize>() as f64 / lengths.len() as f64;
            assert!(mean <= MEAN, "{tag}, {name}: {mean:.1} words a sentence");
        }
    });
}

#[test]
fn verdicts_keep_their_links_in_the_order_of_the_language() {
    let told = |why: Why| {
        let verdict = Verdict {
            kind: Kind::NotYet,
            why,
            evidence: Evidence::default(),
            seal: Vec::new(),
        };
        let said = said(&verdict, &Step::default());
        format!("{}: {}", said.head, said.text)
    };
    in_each(|tag, english| {
        if tag != "de" {
            return;
        }
        assert_eq!(
            told(Why::NotVisited("A1".into(), Some(Cell::new(3, 1)))),
            "Noch nicht: [A1](robot:A1) war noch nicht auf [(3, 1)](cell:3,1)."
        );
        assert_eq!(
            told(Why::Best {
                cost: Cost::Waits,
                value: 1
            }),
            "Noch nicht: 1 Warteschritt, und kein Plan ist besser."
        );
        assert_eq!(
            told(Why::Unknown(Some(Reason::Alone {
                agent: "A1".into(),
                rules: Vec::new(),
            }))),
            "Noch nicht: A1 kann die Aufgabe nicht einmal allein erfüllen."
        );
        assert_eq!(
            told(Why::SomeOrderWorks(vec!["A*1".into(), "[B]".into()])),
            "Noch nicht: Die Reihenfolge A\\*1 und \\[B\\] geht auf."
        );
        let start = english.lessons[1].1.scene(0).unwrap();
        let mut scene = start.clone();
        scene.map[0].replace_range(4..=4, "#");
        scene.agents[0].start = Cell::new(1, 2);
        assert_eq!(
            made(start, &scene).unwrap().to_string(),
            "Geändert: [(4, 0)](cell:4,0) gesperrt und [A1](robot:A1) nach [(1, 2)](cell:1,2) versetzt."
        );
    });
}
