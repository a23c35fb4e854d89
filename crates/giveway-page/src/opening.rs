//! The scene that the page opens on, with its plan: they come with the page, so that
//! robots move before the solver has arrived. They are written as the browser keeps a
//! document; a test holds the answer to be the solver's own.

use std::rc::Rc;

use crate::{Answer, Draft, link};

const TEXT: &str = include_str!("../../../static/opening.txt");

/// The answer to the scene, with the scene; `None` never, as a test holds.
///
/// ```
/// use giveway_solve::Status;
/// let answer = giveway_page::opening::answer().unwrap();
/// assert_eq!(answer.solved.status, Status::Optimal);
/// ```
pub fn answer() -> Option<Rc<Answer>> {
    link::kept_moment(TEXT).ok()?.document.answer
}

/// The scene.
pub fn draft() -> Draft {
    let answer = answer();
    answer.map_or_else(Draft::default, |answer| (*answer.draft).clone())
}
