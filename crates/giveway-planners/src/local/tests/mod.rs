//! One agent among others, and who meets whom, against the rules.

mod crowd;
mod plan_one;
mod reservations;
mod safe_interval;
