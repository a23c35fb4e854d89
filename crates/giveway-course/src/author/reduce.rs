//! From a draft and an action to the next draft.

use giveway_model::Scene;

use super::undo::{is_of_answers, is_of_board, some};
use super::{ANSWERS, Action, Draft, KIND, MAX_FIELD, PLAN, StepDraft, Undo, Whose};
use crate::lesson::read::{MAX_ANSWERS, MAX_STEPS};

/// What becomes of a draft.
#[must_use]
pub fn reduce(mut draft: Draft, action: Action) -> Draft {
    draft.act(action);
    draft
}

impl Draft {
    fn act(&mut self, action: Action) {
        match action {
            Action::Write { whose, field, text } => self.enter(whose, field, &text),
            Action::Toggle { field, value } => self.toggle(field, &value),
            Action::Go(step) => self.at = step.min(self.steps.len().saturating_sub(1)),
            Action::Add => self.insert(self.at + 1, StepDraft::default()),
            Action::Copy(step) => {
                if let Some(copy) = self.steps.get(step).cloned() {
                    self.insert(step + 1, copy);
                }
            }
            Action::Remove(step) => self.remove(step),
            Action::Move { from, to } => {
                if from < self.steps.len() && to < self.steps.len() {
                    let step = self.steps.remove(from);
                    self.steps.insert(to, step);
                    self.at = to;
                }
            }
            Action::TakeScene(scene) => self.board(Some(*scene)),
            Action::TakePlan(plan) => {
                if let Some(step) = self.shown() {
                    step.plan = Some(*plan);
                    step.words.insert(PLAN.to_owned(), "given".to_owned());
                }
            }
            Action::TakeTime(time) => self.enter(Whose::Step, "time".to_owned(), &time.to_string()),
            Action::DropBoard => self.board(None),
            Action::AddAnswer => {
                if let Some(step) = self.shown() {
                    let count = (step.answers() + 1).min(MAX_ANSWERS);
                    step.words.insert(ANSWERS.to_owned(), count.to_string());
                }
            }
            Action::RemoveAnswer(index) => self.remove_answer(index),
            Action::Undo => self.undo(),
            Action::New => self.put(Self::default()),
            Action::Open(lesson) => self.put(Self::of(&lesson)),
            Action::Take(other) => {
                let at = other.at;
                self.put(*other);
                self.act(Action::Go(at));
            }
            Action::Before(before) => self.remember_before(*before),
            Action::Kept(kept) => {
                // What can be undone here has keys of its own.
                let (undo, next) = (std::mem::take(&mut self.undo), self.next);
                *self = *kept;
                self.undo = undo;
                self.next = next.max(self.next);
                self.mend();
            }
        }
    }

    fn shown(&mut self) -> Option<&mut StepDraft> {
        self.steps.get_mut(self.at)
    }

    fn enter(&mut self, whose: Whose, field: String, text: &str) {
        let words = match whose {
            Whose::Lesson => Some(&mut self.words),
            Whose::Step => self.steps.get_mut(self.at).map(|step| &mut step.words),
        };
        let Some(words) = words else {
            return;
        };
        if text.is_empty() {
            words.remove(&field);
        } else {
            words.insert(field, text.chars().take(MAX_FIELD).collect());
        }
    }

    fn toggle(&mut self, field: String, value: &str) {
        let Some(step) = self.shown() else {
            return;
        };
        let mut chosen: Vec<&str> = step.word(&field).lines().collect();
        match chosen.iter().position(|one| *one == value) {
            Some(index) => drop(chosen.remove(index)),
            None => chosen.push(value),
        }
        let text = chosen.join("\n");
        self.enter(Whose::Step, field, &text);
    }

    fn insert(&mut self, index: usize, mut step: StepDraft) {
        if self.steps.len() < MAX_STEPS && index <= self.steps.len() {
            step.key = self.next_key();
            self.steps.insert(index, step);
            self.at = index;
        }
    }

    fn next_key(&mut self) -> u32 {
        self.next = self.next.wrapping_add(1);
        self.next
    }

    /// The last step is not removed, but emptied.
    fn remove(&mut self, index: usize) {
        if index >= self.steps.len() {
            return;
        }
        let step = self.steps.remove(index);
        self.remember(Undo::Removed(index, Box::new(step)));
        if self.at > index || self.at >= self.steps.len() {
            self.at = self.at.saturating_sub(1);
        }
        if self.steps.is_empty() {
            self.insert(0, StepDraft::default());
        }
    }

    fn board(&mut self, scene: Option<Scene>) {
        let Some(step) = self.shown() else {
            return;
        };
        let words = some(&step.words, is_of_board);
        let before = (step.scene.take(), step.plan.take(), words);
        step.words.retain(|name, _| !is_of_board(name));
        step.scene = scene;
        let key = step.key;
        if before.0.is_some() || before.1.is_some() {
            self.remember(Undo::Board(key, Box::new(before)));
        }
    }

    fn remove_answer(&mut self, index: usize) {
        let Some(step) = self.shown() else {
            return;
        };
        let count = step.answers();
        if index >= count {
            return;
        }
        let before = some(&step.words, is_of_answers);
        step.words.retain(|name, _| !is_of_answers(name));
        for (name, word) in &before {
            let Some((of, rest)) = answer(name) else {
                continue;
            };
            let place = match of.cmp(&index) {
                std::cmp::Ordering::Less => of,
                std::cmp::Ordering::Equal => continue,
                std::cmp::Ordering::Greater => of - 1,
            };
            let name = format!("{ANSWERS}[{place}]{rest}");
            step.words.insert(name, word.clone());
        }
        step.words
            .insert(ANSWERS.to_owned(), (count - 1).to_string());
        let key = step.key;
        self.remember(Undo::Answers(key, before));
    }

    /// Another lesson takes the place of this one.
    fn put(&mut self, other: Self) {
        let is_lost = !self.is_empty() && !self.is_like(&other);
        let words = std::mem::take(&mut self.words);
        let before = (words, std::mem::take(&mut self.steps), self.at);
        self.words = other.words;
        self.steps = other.steps;
        self.at = 0;
        if is_lost {
            self.remember(Undo::Lesson(Box::new(before)));
        }
        self.mend();
    }

    /// What holds of any draft: there is a step, the one that is shown is there, and no
    /// two steps have one key.
    pub(super) fn mend(&mut self) {
        self.steps.truncate(MAX_STEPS);
        if self.steps.is_empty() {
            self.steps.push(StepDraft::default());
        }
        self.at = self.at.min(self.steps.len() - 1);
        for index in 0..self.steps.len() {
            let key = self.next_key();
            if let Some(step) = self.steps.get_mut(index) {
                step.key = key;
            }
        }
    }
}

impl StepDraft {
    /// How many answers there are.
    pub fn answers(&self) -> usize {
        let count = self.word(ANSWERS).parse().unwrap_or(0);
        // There is nothing to pick from fewer.
        let least = if self.word(KIND) == "choose" { 2 } else { 0 };
        MAX_ANSWERS.min(count).max(least)
    }
}

/// Which answer a field is of, and what follows in its name.
fn answer(name: &str) -> Option<(usize, &str)> {
    let (index, rest) = name
        .strip_prefix(ANSWERS)?
        .strip_prefix('[')?
        .split_once(']')?;
    Some((index.parse().ok()?, rest))
}
