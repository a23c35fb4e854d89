//! How long a search may take.

use giveway_solve::Ended;

use crate::{Answer, State};

/// The longest that a search takes because it goes on, in seconds.
const LONGEST: f64 = 3_600.0;

/// How long a search may take, in seconds: as a person has it set. One that its time limit cut off
/// proves again what it had proved before it comes further, so it has twice as long as before.
pub(super) fn seconds(state: &State, from: Option<&Answer>) -> f64 {
    let set = f64::from(state.settings.seconds);
    let is_cut = |from: &&Answer| from.solved.ended == Some(Ended::Time);
    let before = from.filter(is_cut).and_then(|it| it.request.limits.seconds);
    before.map_or(set, |before| set.max((2.0 * before).min(LONGEST)))
}

impl State {
    /// How long the search for a best plan goes on that is let go on now, in seconds.
    pub fn seconds_to_go_on(&self) -> f64 {
        seconds(self, self.document.fresh_answer().map(std::rc::Rc::as_ref))
    }
}
