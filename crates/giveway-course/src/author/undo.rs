//! What can be undone of a draft: what is lost otherwise.
//!
//! Words that are typed are undone by the field itself; to undo what was removed must
//! not take them back.

use giveway_model::{Plan, Scene, tr};

use super::{Draft, StepDraft, Words};
use crate::lesson::read::MAX_STEPS;

/// The most that is kept to be undone.
const MOST: usize = 40;

/// Something that can be undone.
#[derive(Clone, Debug, PartialEq)]
pub enum Undo {
    /// A step was removed from this place.
    Removed(usize, Box<StepDraft>),
    /// A step had another board before.
    Board(u32, Box<(Option<Scene>, Option<Plan>, Words)>),
    /// A step had other answers before.
    Answers(u32, Words),
    /// There was another lesson before.
    Lesson(Box<(Words, Vec<StepDraft>, usize)>),
}

impl Undo {
    /// What has happened, as a sentence.
    pub fn sentence(&self) -> String {
        match self {
            Self::Removed(index, _) => tr!("Step {number} removed.", number = index + 1),
            Self::Board(..) => tr!("Another board.").to_owned(),
            Self::Answers(..) => tr!("Answer removed.").to_owned(),
            Self::Lesson(_) => tr!("Another lesson.").to_owned(),
        }
    }
}

impl Draft {
    /// Remembers what is lost otherwise.
    pub(super) fn remember(&mut self, undo: Undo) {
        if self.undo.len() >= MOST {
            self.undo.remove(0);
        }
        self.undo.push(undo);
    }

    /// Undoes the last thing that can be.
    pub(super) fn undo(&mut self) {
        match self.undo.pop() {
            None => {}
            Some(removed @ Undo::Removed(..)) if self.steps.len() >= MAX_STEPS => {
                // There is no room for it now.
                self.undo.push(removed);
            }
            Some(Undo::Removed(index, step)) => {
                if matches!(&*self.steps, [only] if only.is_empty()) {
                    // It took the place of the last one.
                    self.steps.clear();
                }
                let index = index.min(self.steps.len());
                self.steps.insert(index, *step);
                self.at = index;
            }
            Some(Undo::Board(key, before)) => {
                if let Some(step) = self.show_key(key) {
                    let (scene, plan, words) = *before;
                    step.scene = scene;
                    step.plan = plan;
                    step.words.retain(|name, _| !is_of_board(name));
                    step.words.extend(words);
                }
            }
            Some(Undo::Answers(key, words)) => {
                if let Some(step) = self.show_key(key) {
                    step.words.retain(|name, _| !is_of_answers(name));
                    step.words.extend(words);
                }
            }
            Some(Undo::Lesson(before)) => {
                // What took its place may be worth as much: it can be undone, too.
                let was_empty = self.is_empty();
                let (words, steps, at) = *before;
                let words = std::mem::replace(&mut self.words, words);
                let steps = std::mem::replace(&mut self.steps, steps);
                let at = std::mem::replace(&mut self.at, at);
                if !was_empty {
                    self.remember(Undo::Lesson(Box::new((words, steps, at))));
                }
            }
        }
    }

    /// The lesson that was there before this one, if there is a way back to it.
    pub fn before(&self) -> Option<Self> {
        let mut undo = self.undo.iter().rev();
        let before = undo.find_map(|undo| match undo {
            Undo::Lesson(before) => Some((**before).clone()),
            _ => None,
        });
        before.map(|(words, steps, at)| Self {
            words,
            steps,
            at,
            ..Self::default()
        })
    }

    /// There is a way back to a lesson that was there before, where there is none yet.
    pub(super) fn remember_before(&mut self, mut before: Self) {
        if self.before().is_none() && !before.is_empty() && !self.is_like(&before) {
            // No key of a step is there twice.
            before.next = self.next;
            before.mend();
            self.next = before.next;
            let lesson = (before.words, before.steps, before.at);
            self.undo.insert(0, Undo::Lesson(Box::new(lesson)));
        }
    }

    fn show_key(&mut self, key: u32) -> Option<&mut StepDraft> {
        let at = self.steps.iter().position(|step| step.key == key)?;
        self.at = at;
        self.steps.get_mut(at)
    }
}

/// Whether a field comes with the board.
pub(super) fn is_of_board(name: &str) -> bool {
    matches!(name, super::PLAN | "time")
}

/// Whether a field is one of the answers.
pub(super) fn is_of_answers(name: &str) -> bool {
    name.starts_with(super::ANSWERS)
}

/// What is written in some fields.
pub(super) fn some(words: &Words, which: fn(&str) -> bool) -> Words {
    let words = words.iter().filter(|(name, _)| which(name));
    words
        .map(|(name, word)| (name.clone(), word.clone()))
        .collect()
}
