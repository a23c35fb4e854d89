//! The letters of a bare grid: starts and goals of robots.

use std::collections::BTreeMap;

use crate::lines::Line;
use crate::marks::Mark;
use giveway_model::{Agent, Cell, Fault, tr, tr_later};

/// Where letters stand.
#[derive(Default)]
pub(super) struct Letters<'a> {
    all: BTreeMap<char, (Cell, Line<'a>, &'a str)>,
}

impl<'a> Letters<'a> {
    pub(super) fn is_empty(&self) -> bool {
        self.all.is_empty()
    }

    /// Takes the letters of a row.
    ///
    /// # Errors
    /// When a letter stands for the second time.
    pub(super) fn take(
        &mut self,
        y: usize,
        line: Line<'a>,
        marks: &[Mark<'a>],
    ) -> Result<(), Fault> {
        for (x, mark) in marks
            .iter()
            .enumerate()
            .filter(|(_, mark)| !mark.is_ground())
        {
            let side = |side: usize| u32::try_from(side).unwrap_or(u32::MAX);
            let cell = Cell::new(side(x), side(y));
            if let Some((_, other, _)) = self.all.insert(mark.letter, (cell, line, mark.part)) {
                let letter = mark.letter;
                let found = tr!(
                    "the letter {letter}, which line {line} has, too",
                    letter,
                    line = other.number
                );
                let expected = tr_later!(
                    "one start (a) and one goal (A) for each robot; obstacles are # or @"
                );
                return Err(line.fault_saying(mark.part, found, expected));
            }
        }
        Ok(())
    }

    /// The robots, and how their letters were read, a sentence.
    ///
    /// # Errors
    /// When a start has no goal, or a goal no start.
    pub(super) fn agents(&self) -> Result<(Vec<Agent>, String), Fault> {
        let letters: String = self.all.keys().collect();
        if let "GS" | "gs" = &*letters
            && let [(goal, ..), (start, ..)] = *self.all.values().collect::<Vec<_>>()
        {
            let note = tr!("S is the start of the robot, G its goal.").to_owned();
            return Ok((vec![agent("A1".to_owned(), *start, *goal)], note));
        }
        for (&letter, (_, line, part)) in &self.all {
            let other = if letter.is_ascii_lowercase() {
                letter.to_ascii_uppercase()
            } else {
                letter.to_ascii_lowercase()
            };
            if self.all.contains_key(&other) {
                continue;
            }
            let (found, expected) = if letter.is_ascii_lowercase() {
                (
                    tr!("the start {letter} without a goal", letter),
                    tr!("{other}, the goal of this robot, in the grid", other),
                )
            } else {
                (
                    tr!("the goal {letter} without a start", letter),
                    tr!(
                        "{other}, the start of this robot, in the grid; a map of the benchmark, in which {letter} is a kind of ground, begins with lines \"height\", \"width\" and \"map\"",
                        other,
                        letter
                    ),
                )
            };
            return Err(line.fault_saying(part, found, expected));
        }
        let starts = self
            .all
            .iter()
            .filter(|(letter, _)| letter.is_ascii_lowercase());
        let agents = starts.filter_map(|(letter, (start, ..))| {
            let name = letter.to_ascii_uppercase();
            let (goal, ..) = self.all.get(&name)?;
            Some(agent(name.to_string(), *start, *goal))
        });
        let note = tr!("A small letter is the start of a robot, its capital the goal.").to_owned();
        Ok((agents.collect(), note))
    }
}

fn agent(name: String, start: Cell, goal: Cell) -> Agent {
    Agent::new(name, start, Some(goal))
}
