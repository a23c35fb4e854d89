//! The time shown.

use super::{after, edit, fresh};
use crate::sample::solved;
use crate::{Action, PlayAction, State};

fn time(state: &State) -> (u32, bool) {
    (state.view.playback.time, state.view.playback.playing)
}

#[test]
fn steps_and_jumps_stop_playing_and_stay_within_the_plan() {
    let state = after(&solved(), [Action::Play(PlayAction::StepForward)]);
    assert_eq!(time(&state), (1, false));
    let state = after(
        &state,
        [
            Action::Play(PlayAction::StepBack),
            Action::Play(PlayAction::StepBack),
        ],
    );
    assert_eq!(time(&state), (0, false));
    let state = after(&state, [Action::Play(PlayAction::Seek(99))]);
    assert_eq!(time(&state), (18, false));
    let state = after(&state, [Action::Play(PlayAction::StepForward)]);
    assert_eq!(time(&state), (18, false));
}

#[test]
fn playing_ends_at_the_end_and_begins_anew() {
    let state = after(&solved(), [Action::Play(PlayAction::Reach(17))]);
    assert_eq!(time(&state), (17, true));
    let state = after(&state, [Action::Play(PlayAction::Pause)]);
    assert_eq!(time(&state), (17, false));
    let state = after(
        &state,
        [
            Action::Play(PlayAction::Play),
            Action::Play(PlayAction::Reach(18)),
        ],
    );
    assert_eq!(time(&state), (18, false));
    assert_eq!(
        time(&after(&state, [Action::Play(PlayAction::Play)])),
        (0, true)
    );
}

#[test]
fn without_a_plan_nothing_plays() {
    let state = after(
        &fresh(),
        [
            Action::Play(PlayAction::Play),
            Action::Play(PlayAction::StepForward),
            Action::Play(PlayAction::Seek(5)),
        ],
    );
    assert_eq!(time(&state), (0, false));
}

#[test]
fn a_stale_plan_can_still_be_looked_at() {
    let state = after(&solved(), edit());
    let state = after(&state, [Action::Play(PlayAction::Seek(9))]);
    assert_eq!(time(&state), (9, false));
}
