//! The time shown.

use crate::State;

pub(super) fn play(state: &mut State) {
    let last = state.last_time();
    if last == 0 {
        return;
    }
    if state.playback.time >= last {
        state.playback.time = 0;
    }
    state.playback.playing = true;
    state.playback.sought = false;
}

/// Shows a time that a person asked for; that ends playing.
pub(super) fn seek(state: &mut State, time: u32) {
    state.playback.playing = false;
    state.playback.sought = true;
    state.playback.time = time.min(state.last_time());
}

/// What is shown may end sooner where only one of two plans is.
pub(super) fn widen(state: &mut State, on: bool) {
    state.view.is_wide = on;
    state.playback.time = state.playback.time.min(state.last_time());
}

/// The clock came to a step.
pub(super) fn reach(state: &mut State, time: u32) {
    if !state.playback.playing && state.playback.sought {
        // It comes late: another time was asked for since.
        return;
    }
    let last = state.last_time();
    state.playback.time = time.min(last);
    if time >= last {
        state.playback.playing = false;
    }
}
