//! The course that comes with the page: its files, its tasks, its reading ease.

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "a test stops at the first surprise"
)]

mod author;
mod author_faults;
mod checked;
mod checked_tasks;
mod claims;
mod docs;
mod files;
mod forgeries;
mod grading;
mod guesses;
mod handin_noise;
mod handins;
mod judges;
mod learner;
mod looking;
mod noise;
mod outside;
mod own;
mod reading;
mod rules;
mod schema;
mod shipped;
mod tasks;
mod terms;
mod tour;
mod translate;
mod unknown;
mod words;
