//! Questions to the solver and their answers: the same question is asked once.

use std::collections::BTreeMap;

use giveway_solve::{Request, Response};

/// A question, by its place among all.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Key(usize);

/// All questions of a class.
#[derive(Clone, Debug, Default)]
pub(super) struct Answers {
    keys: BTreeMap<Vec<u8>, usize>,
    all: Vec<Asked>,
}

/// A question.
#[derive(Clone, Debug)]
enum Asked {
    /// It is not answered yet.
    Open(Box<Request>),
    /// The answer.
    Answered(Box<Response>),
    /// The solver broke down, as a sentence.
    Failed(String),
}

impl Answers {
    /// The place of a question.
    pub(super) fn key(&mut self, request: Request) -> Key {
        // Memory always takes it.
        let bytes = borsh::to_vec(&request).unwrap_or_default();
        let next = self.all.len();
        let place = *self.keys.entry(bytes).or_insert(next);
        if place == next {
            self.all.push(Asked::Open(Box::new(request)));
        }
        Key(place)
    }

    /// The question, while it is not answered.
    pub(super) fn open(&self, key: Key) -> Option<&Request> {
        match self.all.get(key.0)? {
            Asked::Open(request) => Some(request),
            Asked::Answered(_) | Asked::Failed(_) => None,
        }
    }

    pub(super) fn answer(&mut self, key: Key, response: Response) {
        self.put(key, Asked::Answered(Box::new(response)));
    }

    pub(super) fn fail(&mut self, key: Key, sentence: String) {
        self.put(key, Asked::Failed(sentence));
    }

    fn put(&mut self, key: Key, asked: Asked) {
        if let Some(slot) = self.all.get_mut(key.0) {
            *slot = asked;
        }
    }

    /// Asks again what the solver broke down at.
    pub(super) fn forget_failures(&mut self) {
        let all = &self.all;
        let is_failed = |place: usize| matches!(all.get(place), Some(Asked::Failed(_)));
        self.keys.retain(|_, place| !is_failed(*place));
    }

    /// The answers to some questions, in their order.
    ///
    /// # Errors
    /// At what the solver broke down, where it did.
    pub(super) fn responses(&self, keys: &[Key]) -> Result<Vec<Response>, String> {
        let mut responses = Vec::with_capacity(keys.len());
        for key in keys {
            match self.all.get(key.0) {
                Some(Asked::Answered(response)) => responses.push((**response).clone()),
                Some(Asked::Failed(sentence)) => return Err(sentence.clone()),
                Some(Asked::Open(_)) | None => {}
            }
        }
        Ok(responses)
    }
}
