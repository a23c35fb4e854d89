//! The best plan so far, on the board while the search for a better one goes on.

use std::rc::Rc;

use crate::{Answer, Arrival, Solving, State};

/// Brings the best plan so far to the board. The first one plays; a better one
/// takes its place where all robots stand at their starts or at their goals, so
/// that none of them jumps.
pub(in crate::reduce) fn preview(state: &mut State) {
    let Some(answer) = next(state) else { return };
    let answer = Rc::new(answer);
    let had_plan = state.playing().is_some() && !state.shows_stale();
    let Some(run) = state.work.solving_mut() else {
        return;
    };
    run.preview = Some(Rc::clone(&answer));
    let playback = &mut state.view.playback;
    if had_plan {
        // What was shown at its end is shown at its end.
        if playback.time > 0 {
            playback.stop_at(answer.makespan());
        }
    } else {
        playback.stop_at(0);
        playback.playing = answer.makespan() > 0;
        playback.sought = false;
    }
}

/// The plan that is to come to the board, if there is a newer one and it may.
fn next(state: &State) -> Option<Answer> {
    let run = state.work.solving()?;
    let document = &state.document;
    let shown = document.fresh_answer();
    // A plan that is only proved stays what is looked at.
    let stays = shown.is_some_and(|shown| {
        run.arrival == Arrival::Quiet && shown.plan().is_some() || shown.course.is_some()
    });
    if run.planner.is_some() || run.request.pareto || stays || !document.mode.is_editing() {
        return None;
    }
    run.plan.as_ref()?;
    let is_newer = run
        .preview
        .as_ref()
        .is_none_or(|p| p.solved.costs != run.best);
    if !is_newer || is_on_its_way(state) {
        return None;
    }
    let solved = run.so_far().filter(|solved| solved.plan.is_some())?;
    Some(Answer::new(
        Rc::clone(&run.draft),
        Rc::clone(&run.request),
        solved,
    ))
}

/// Whether a plan of the scene is shown between its start and its end.
fn is_on_its_way(state: &State) -> bool {
    if state.playing().is_none() || state.shows_stale() {
        return false;
    }
    let playback = state.view.playback;
    playback.playing || (playback.time > 0 && playback.time < state.last_time())
}

impl Solving {
    /// Whether a plan is the one that the board shows already.
    pub(super) fn previews(&self, answer: &Answer) -> bool {
        let preview = self.preview.as_ref();
        preview.is_some_and(|preview| preview.plan() == answer.plan())
    }
}
