//! What a lecturer sees of a hand-in: a card for each task of the lesson.

use giveway_model::tr;

use super::{HandIn, Shown, Work, answer_words};
use crate::lesson::Lesson;

/// A task of a hand-in, as it is looked at before it is handed in.
#[derive(Clone, Debug, PartialEq)]
pub struct Card {
    /// The number of the task, from 1.
    pub number: usize,
    /// The step, from 0.
    pub step: usize,
    /// What the step is called.
    pub title: String,
    /// Whether the page took it as solved.
    pub state: CardState,
    /// How often something was tried.
    pub tries: u32,
    /// The last answer in words; empty where there is none.
    pub answer: String,
    /// The first answer in words; empty where there is none, or it is the last one.
    pub first: String,
    /// The board and the plan of that answer.
    pub shown: Option<Shown>,
}

/// How far a task is, as its hand-in says.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CardState {
    /// It is solved.
    Solved,
    /// It was tried.
    NotSolved,
    /// There is no answer.
    NotTried,
}

impl CardState {
    fn of(work: Option<&Work>) -> Self {
        match work {
            Some(work) if work.solved => Self::Solved,
            Some(work) if work.answer.is_some() => Self::NotSolved,
            Some(_) | None => Self::NotTried,
        }
    }
}

impl Card {
    /// Its state and tries: `solved, 2 tries`.
    pub fn state_words(&self) -> String {
        let tries = self.tries;
        match self.state {
            CardState::Solved => tr!("solved, {n} try" | "solved, {n} tries" % tries),
            CardState::NotSolved => tr!("not solved, {n} try" | "not solved, {n} tries" % tries),
            CardState::NotTried => tr!("not tried").to_owned(),
        }
    }
}

/// A card for each task of a lesson, in its order.
pub fn cards(hand_in: &HandIn, lesson: &Lesson) -> Vec<Card> {
    let steps = lesson.steps.iter().enumerate();
    let tasks = steps.filter(|(_, step)| step.task.is_some());
    let card = |(number, (index, step)): (usize, (usize, &crate::lesson::Step))| {
        let work = hand_in.work(index);
        let answer = work.and_then(|work| work.answer.as_ref());
        let first = work.and_then(|work| work.first.as_ref());
        let words = |it| answer_words(it, index, lesson);
        Card {
            number,
            step: index,
            title: step.title.clone(),
            state: CardState::of(work),
            tries: work.map_or(0, |work| work.tries),
            answer: answer.map_or_else(String::new, words),
            first: first.map_or_else(String::new, words),
            shown: work.and_then(|work| Shown::of(work, lesson).ok()),
        }
    };
    (1..).zip(tasks).map(card).collect()
}

/// All cards in a line: `2 of 3 solved · 6 tries`.
pub fn summary(cards: &[Card]) -> String {
    let is_solved = |card: &&Card| card.state == CardState::Solved;
    let solved = cards.iter().filter(is_solved).count();
    let tries = cards
        .iter()
        .fold(0_u32, |sum, card| sum.saturating_add(card.tries));
    let tries = tr!("{n} try" | "{n} tries" % tries);
    tr!(
        "{solved} of {all} solved · {tries}",
        solved,
        all = cards.len(),
        tries
    )
}
