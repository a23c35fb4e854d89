//! The lessons that the command knows: those of the course, and a lecturer's own.

use std::path::PathBuf;
use std::rc::Rc;

use giveway_course::grade::Given;
use giveway_course::lesson::{Glossary, Id, Term, Text, link, read_lesson};

use crate::{failure::Failure, input::Source};

/// The course of this version: the terms of its glossary, then each lesson as a link.
/// `GIVEWAY_UPDATE=1` and the tests of the command write it anew.
const COURSE: &str = include_str!("../../course.txt");

/// The lessons given by a lecturer, and those of the course behind them.
pub(super) fn lessons(own: &[PathBuf]) -> Result<Vec<Given>, Failure> {
    let mut lines = COURSE.lines();
    let terms = lines.next().unwrap_or_default().split(' ');
    let glossary = Glossary {
        terms: terms.filter_map(term).collect(),
        ..Glossary::default()
    };
    let mut lessons = Vec::new();
    for path in own {
        let source = Source::read(path)?;
        let lesson = read_lesson(&source.text, &glossary);
        let lesson = lesson.map_err(|faults| source.faults(faults))?;
        lessons.push(Given::new(lesson.own_id(), Rc::new(lesson)));
    }
    let shipped = lines.filter_map(|line| {
        let (id, letters) = line.split_once(' ')?;
        let (lesson, _) = link::read(letters, &glossary).ok()?;
        Some(Given::new(id.parse().ok()?, Rc::new(lesson)))
    });
    lessons.extend(shipped);
    Ok(lessons)
}

/// A term of which only its short name matters.
fn term(id: &str) -> Option<Term> {
    let term: Id = id.parse().ok()?;
    Some(Term {
        name: id.to_owned(),
        term,
        also: Vec::new(),
        text: Text::default(),
        picture: None,
        source: None,
        lesson: None,
    })
}
