//! The time shown.

use super::solve;
use crate::{PlayAction, State, beside};

pub(super) fn play(state: &mut State, action: PlayAction) {
    let time = state.view.playback.time;
    match action {
        PlayAction::Play => begin(state),
        PlayAction::Pause => state.view.playback.playing = false,
        PlayAction::Seek(time) => seek(state, time),
        PlayAction::Difference(is_forward) => {
            if let Some(time) = beside::next(state, is_forward) {
                seek(state, time);
            }
        }
        PlayAction::StepForward => seek(state, time.saturating_add(1)),
        PlayAction::StepBack => seek(state, time.saturating_sub(1)),
        PlayAction::Reach(time) => reach(state, time),
        PlayAction::SetSpeed(speed) => state.view.playback.speed = speed,
    }
    solve::preview(state);
}

pub(super) fn begin(state: &mut State) {
    let last = state.last_time();
    if last == 0 {
        return;
    }
    let playback = &mut state.view.playback;
    if playback.time >= last {
        playback.time = 0;
    }
    playback.playing = true;
    playback.sought = false;
}

/// Shows a time that a person asked for; that ends playing.
pub(super) fn seek(state: &mut State, time: u32) {
    let time = time.min(state.last_time());
    state.view.playback.stop_at(time);
}

/// What is shown may end sooner where only one of two plans is.
pub(super) fn widen(state: &mut State, on: bool) {
    state.view.is_wide = on;
    let last = state.last_time();
    let playback = &mut state.view.playback;
    playback.time = playback.time.min(last);
}

/// The clock came to a step.
fn reach(state: &mut State, time: u32) {
    let last = state.last_time();
    let playback = &mut state.view.playback;
    if !playback.playing && playback.sought {
        // It comes late: another time was asked for since.
        return;
    }
    playback.time = time.min(last);
    if time >= last {
        playback.playing = false;
    }
}
