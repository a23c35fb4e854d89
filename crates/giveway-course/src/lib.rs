//! The course as plain data: lessons, what judges their tasks, what a learner has done.
//!
//! A [`lesson`] is a file that anyone can write. Each of its tasks is judged by the
//! solver or by the judge of plans ([`judge`]), never by a stored answer alone. What a
//! person does in a lesson is a state with a pure reducer ([`learner`]), and so is the
//! [`tour`] of the page. It can be handed in ([`handin`]), and a class's hand-ins are
//! judged anew ([`grade`]). The lesson and the playground's page are two programs; they talk
//! in messages ([`port`]). A lesson while somebody writes it is a draft ([`author`]).
//! Nothing here draws, waits, or knows that there is a browser.

pub mod author;
pub mod grade;
pub mod handin;
pub mod judge;
pub mod learner;
pub mod lesson;
pub mod port;
pub mod tour;
