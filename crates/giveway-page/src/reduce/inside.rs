//! Looking into how the plan was found: opened, stepped through, told by planners.

mod by_hand;

use std::rc::Rc;

use giveway_model::Question;
use giveway_solve::Response;

use super::{ask, play};
use crate::inside::by_hand::plan as plan_by_hand;
use crate::inside::{
    InsideAction, Looked, Looking, Method, Told, What, conflict_time, of_configuration, of_node,
    of_order, of_pibt, place, proof, wanted,
};
use crate::{PlayAction, Selection, State, Tab, Task};

pub(super) use by_hand::begin_in_lesson;

#[inline(never)]
pub(super) fn inside(state: &mut State, action: InsideAction) {
    match action {
        InsideAction::Show(on) => show(state, on),
        InsideAction::By(method) => by(state, method),
        InsideAction::Step(step) => {
            state.inside.step = Some(step);
            state.inside.is_playing = false;
        }
        InsideAction::Node(node) if state.is_by_hand() => by_hand::node(state, node),
        InsideAction::Node(node) => choose(state, |state| state.inside.node = node),
        InsideAction::Hand(action) => by_hand::hand(state, action),
        InsideAction::Order(order) => choose(state, |state| {
            state.inside.order = order;
            state.inside.robots = None;
        }),
        InsideAction::Robots(robots) => choose(state, |state| state.inside.robots = Some(robots)),
        InsideAction::First => go(state, |_, _| 0),
        InsideAction::Last => go(state, |_, last| last),
        InsideAction::Back => go(state, |at, _| at.saturating_sub(1)),
        InsideAction::Next => go(state, |at, _| at + 1),
        InsideAction::Alone(on) => alone(state, on),
        InsideAction::Reasons => ask::ask(state, &Question::Unsolvable),
        InsideAction::Play(on) => play_on(state, on),
        InsideAction::Tick if state.inside.is_playing => tick(state),
        InsideAction::Tick => {}
        InsideAction::Again => {
            let looked = state.inside.looked.as_deref();
            state.inside.looked = looked.map(|looked| Rc::new(looked.again()));
        }
        InsideAction::PlayPlan => {
            show(state, false);
            play::play(state, PlayAction::Seek(0));
            play::play(state, PlayAction::Play);
        }
    }
}

/// What steps through a plan steps through how it was found, where that is shown.
/// `false` where it is about the plan after all.
pub(super) fn plays(state: &mut State, action: PlayAction) -> bool {
    if !state.is_inside() {
        return false;
    }
    let is_proof = state.inside.method == Method::Proof;
    match action {
        PlayAction::Play => play_on(state, true),
        PlayAction::Pause => play_on(state, false),
        PlayAction::StepBack => inside(state, InsideAction::Back),
        PlayAction::StepForward => inside(state, InsideAction::Next),
        // The ruler of an order has the time of its plan.
        PlayAction::Seek(0) if is_proof => inside(state, InsideAction::First),
        PlayAction::Seek(_) if is_proof => inside(state, InsideAction::Last),
        PlayAction::Seek(_)
        | PlayAction::Difference(_)
        | PlayAction::Reach(_)
        | PlayAction::SetSpeed(_) => return false,
    }
    true
}

fn show(state: &mut State, on: bool) {
    let is_possible = if on {
        state.can_look_inside()
    } else {
        state.inside.is_open && !state.keeps_inside()
    };
    if !is_possible {
        return;
    }
    if on && !state.inside.is_open {
        state.inside.time_before = Some(state.view.playback.time);
    }
    state.inside.is_open = on;
    state.inside.is_playing = false;
    state.view.playback.playing = false;
    state.view.selection = Selection::Nothing;
    state.view.tab = Tab::Timeline;
    if on {
        // A proof is told from its beginning; that of a search that goes on, by its end.
        if state.inside.step.is_none() && !proof::is_running(state) {
            state.inside.step = Some(0);
        }
        state.view.playback.stop_at(0);
    }
    settle(state);
    if !on {
        let time = state.inside.time_before.take().unwrap_or(0);
        state.view.playback.stop_at(time.min(state.last_time()));
    }
}

/// Looks at the robots of the chosen step alone, or goes back to that step.
fn alone(state: &mut State, on: bool) {
    state.inside.is_playing = false;
    if on {
        if let Some(view) = proof::view_alone(state) {
            (state.inside.alone, state.inside.step) = (Some(view), Some(0));
        }
    } else if let Some(view) = state.inside.alone.take() {
        state.inside.step = Some(view.back);
    }
}

fn by(state: &mut State, method: Method) {
    if state.inside.method != method {
        state.inside.moment = 0;
    }
    state.inside.method = method;
    show(state, true);
}

/// Chooses something else by hand.
fn choose(state: &mut State, change: impl FnOnce(&mut State)) {
    state.inside.is_playing = false;
    change(state);
    state.view.selection = Selection::Nothing;
    settle(state);
}

fn play_on(state: &mut State, on: bool) {
    let Some((at, last, _)) = place(state) else {
        return;
    };
    state.inside.is_playing = on && last > 0;
    if on && at >= last {
        step_to(state, 0);
    }
}

fn tick(state: &mut State) {
    let Some((at, last, _)) = place(state) else {
        state.inside.is_playing = false;
        return;
    };
    step_to(state, at + 1);
    state.inside.is_playing = at + 1 < last;
}

fn go(state: &mut State, to: impl FnOnce(usize, usize) -> usize) {
    if let Some((at, last, _)) = place(state) {
        state.inside.is_playing = false;
        step_to(state, to(at, last));
    }
}

/// To the step of this number, as near as there is one.
fn step_to(state: &mut State, to: usize) {
    let Some((_, last, _)) = place(state) else {
        return;
    };
    let to = to.min(last);
    match state.inside.method {
        Method::Proof => state.inside.step = Some(to),
        Method::Tree => {
            let looked = state.looked();
            let tree = looked.and_then(|looked| looked.tree.as_ref()?.as_ref().ok());
            let node = tree.and_then(|tree| tree.opened.get(to.saturating_sub(1)));
            if let Some(&node) = node {
                state.inside.node = node;
            }
        }
        Method::Orders => state.inside.robots = Some(to.max(1)),
        Method::Pibt | Method::Lacam => state.inside.moment = to,
    }
    state.view.selection = Selection::Nothing;
    settle(state);
}

/// Puts the plan of what is chosen onto the board, at the time that tells most.
fn settle(state: &mut State) {
    let draft = Rc::clone(&state.document.draft);
    let inside = &state.inside;
    let shown = state.looked().and_then(|looked| match inside.method {
        Method::Proof => None,
        Method::Tree if inside.by_hand.is_on => plan_by_hand(state),
        Method::Tree => {
            let tree = looked.tree.as_ref()?.as_ref().ok()?;
            tree.node(inside.node).filter(|node| node.cost.is_some())?;
            let answer = of_node(&draft, tree, inside.node);
            let time = conflict_time(&answer, tree, inside.node);
            Some((answer, time))
        }
        Method::Orders => {
            let run = looked.orders.get(inside.order)?;
            let (at, ..) = place(state)?;
            let is_stuck = at > run.told.planned.len();
            let last = run.told.furthest.len().saturating_sub(1);
            let time = u32::try_from(if is_stuck { last } else { 0 }).unwrap_or(0);
            Some((of_order(&draft, run, at), time))
        }
        Method::Pibt => {
            let run = looked.pibt.as_ref()?.as_ref().ok()?;
            let (at, ..) = place(state)?;
            Some((of_pibt(&draft, run), u32::try_from(at).unwrap_or(0)))
        }
        Method::Lacam => {
            let run = looked.lacam.as_ref()?.as_ref().ok()?;
            let (at, ..) = place(state)?;
            of_configuration(&draft, run, run.configuration(at))
        }
    });
    let (shown, time) = shown.unzip();
    state.inside.shown = shown;
    state.view.playback.stop_at(time.unwrap_or(0));
}

/// Asks for what is missing, where the worker has nothing else to do.
pub(super) fn look(state: &mut State) {
    if state.inside.by_hand.is_on {
        by_hand::keep_to(state);
    }
    if let Some(looking) = wanted(state) {
        state.work.start(Task::Look(looking));
    }
}

/// A search begins: what the last one told is over.
pub(super) fn begin(state: &mut State) {
    let inside = &mut state.inside;
    (inside.step, inside.alone, inside.is_playing) = (None, None, false);
}

/// The worker answered what was asked.
pub(super) fn respond(state: &mut State, looking: &Looking, response: Response) {
    let told = match response {
        Response::Planned(answer) => Told::Planned(answer),
        Response::Together(answer) => Told::Together(answer),
        Response::Refused(refusal) => Told::Not(refusal.sentences().join(" ")),
        _ => return,
    };
    learn(state, looking, told);
}

/// What was asked will not be answered, and why, as a sentence.
pub(super) fn not_told(state: &mut State, looking: &Looking, why: &str) {
    learn(state, looking, Told::Not(why.to_owned()));
}

fn learn(state: &mut State, looking: &Looking, answer: Told) {
    let before = state.inside.looked.as_deref();
    let is_new = before.is_none_or(|looked| !looked.is_of(&state.document));
    let looked = Looked::with(before, looking, answer);
    state.inside.looked = Some(Rc::new(looked));
    if is_new {
        (state.inside.node, state.inside.order, state.inside.robots) = (0, 0, None);
        state.inside.moment = 0;
    }
    let is_by_hand = matches!(looking.what, What::ByHand(_));
    if state.is_inside() && (state.inside.shown.is_none() || is_new || is_by_hand) {
        settle(state);
    }
}
