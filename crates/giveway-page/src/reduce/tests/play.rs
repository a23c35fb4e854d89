//! The time shown.

use super::{after, edit, fresh};
use crate::sample::solved;
use crate::{Action, State};

fn time(state: &State) -> (u32, bool) {
    (state.playback.time, state.playback.playing)
}

#[test]
fn steps_and_jumps_stop_playing_and_stay_within_the_plan() {
    let state = after(&solved(), [Action::StepForward]);
    assert_eq!(time(&state), (1, false));
    let state = after(&state, [Action::StepBack, Action::StepBack]);
    assert_eq!(time(&state), (0, false));
    let state = after(&state, [Action::Seek(99)]);
    assert_eq!(time(&state), (18, false));
    let state = after(&state, [Action::StepForward]);
    assert_eq!(time(&state), (18, false));
}

#[test]
fn playing_ends_at_the_end_and_begins_anew() {
    let state = after(&solved(), [Action::Reach(17)]);
    assert_eq!(time(&state), (17, true));
    let state = after(&state, [Action::Pause]);
    assert_eq!(time(&state), (17, false));
    let state = after(&state, [Action::Play, Action::Reach(18)]);
    assert_eq!(time(&state), (18, false));
    assert_eq!(time(&after(&state, [Action::Play])), (0, true));
}

#[test]
fn without_a_plan_nothing_plays() {
    let state = after(
        &fresh(),
        [Action::Play, Action::StepForward, Action::Seek(5)],
    );
    assert_eq!(time(&state), (0, false));
}

#[test]
fn a_stale_plan_can_still_be_looked_at() {
    let state = after(&solved(), edit());
    let state = after(&state, [Action::Seek(9)]);
    assert_eq!(time(&state), (9, false));
}
