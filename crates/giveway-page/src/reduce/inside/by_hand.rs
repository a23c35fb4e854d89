//! Search by hand: chosen, split, taken back. The worker makes the tree of all splits anew.

use std::rc::Rc;

use giveway_course::lesson::Layer;
use giveway_solve::plan::{HandSplit, MOST_SPLITS, NodeFate, ToldBranch, words};

use super::{choose, settle, show};
use crate::inside::by_hand::{HandRun, is_done};
use crate::inside::{ByHand, HandAction, InsideAction, Method, What};
use crate::lesson::Lesson;
use crate::{State, Tab, Task};

#[inline(never)]
pub(super) fn hand(state: &mut State, action: HandAction) {
    match action {
        HandAction::Show(false) if state.is_by_hand() && !state.can_show_planners_tree() => {}
        HandAction::Show(on) => by_hand(state, on),
        HandAction::Read(on) => {
            state.inside.by_hand.reads = on;
            state.view.tab = Tab::Inspector;
        }
        _ if !state.is_by_hand() => {}
        HandAction::Conflict(conflict) => {
            let is_there = state
                .hand_run()
                .is_some_and(|run| run.choice(conflict).is_some());
            if is_there {
                look(state, |own| (own.conflict, own.robot) = (conflict, 0));
            }
        }
        HandAction::Robot(robot) => look(state, |own| own.robot = robot.min(1)),
        HandAction::Split => split(state),
        HandAction::TakeBack => take_back(state),
        HandAction::Again => again(state),
        HandAction::Restart => {
            if !state.inside.by_hand.splits.is_empty() {
                look(state, |own| {
                    own.splits.clear();
                    own.taken_back.clear();
                    (own.node, own.conflict, own.robot) = (0, 0, 0);
                });
            }
        }
    }
}

/// A lesson begins with the tree by hand, beside its text.
#[inline(never)]
pub(in crate::reduce) fn begin_in_lesson(state: &mut State) {
    super::inside(state, InsideAction::By(Method::Tree));
    by_hand(state, true);
    state.inside.by_hand.reads = true;
    state.view.tab = Tab::Inspector;
    let shows = |lesson: &Lesson| lesson.board.show.contains(&Layer::Trails);
    state.view.layers.trails = state.lesson().is_some_and(shows);
}

/// A person splits, or the planner's tree is shown.
fn by_hand(state: &mut State, on: bool) {
    state.inside.by_hand.is_on = on;
    state.inside.is_playing = false;
    if on && is_planning(state) {
        // The planner may take long; nothing is known of its tree before the end.
        state.work.end();
    }
    keep_to(state);
    if state.inside.method == Method::Tree && state.is_inside() {
        settle(state);
    } else {
        state.inside.method = Method::Tree;
        show(state, true);
    }
}

/// Whether the planner's tree is on its way.
fn is_planning(state: &State) -> bool {
    match state.work.task() {
        Some(Task::Look(looking)) => looking.what == What::Tree,
        _ => false,
    }
}

/// Splits are of one scene and one horizon: those of another are gone.
pub(super) fn keep_to(state: &mut State) {
    let document = &state.document;
    let is_same = state
        .inside
        .by_hand
        .of
        .as_ref()
        .is_some_and(|(draft, within)| {
            Rc::ptr_eq(draft, &document.draft) && *within == document.within
        });
    if !is_same {
        let own = &state.inside.by_hand;
        state.inside.by_hand = ByHand {
            is_on: own.is_on,
            reads: own.reads,
            of: Some((Rc::clone(&document.draft), document.within)),
            ..ByHand::default()
        };
    }
}

/// Chooses a node.
pub(super) fn node(state: &mut State, node: u64) {
    if state
        .hand_run()
        .is_some_and(|run| run.tree.node(node).is_some())
    {
        look(state, |own| {
            if own.node != node {
                (own.node, own.conflict, own.robot) = (node, 0, 0);
            }
        });
    }
}

/// Chooses something else: the board shows it, and the column of a lesson, too.
fn look(state: &mut State, change: impl FnOnce(&mut ByHand)) {
    choose(state, |state| {
        change(&mut state.inside.by_hand);
        state.inside.by_hand.reads = false;
    });
}

fn split(state: &mut State) {
    // What is proved needs no more splits.
    if is_done(state) {
        return;
    }
    let own = &state.inside.by_hand;
    let Some(run) = state.hand_now() else { return };
    let Some(choice) = run.choice(own.conflict) else {
        return;
    };
    let (Some(agent), Some(branches)) = (
        words::parties(&choice.conflict).get(own.robot),
        choice.branches.get(own.robot),
    ) else {
        return;
    };
    if own.splits.len() >= MOST_SPLITS {
        return;
    }
    let split = HandSplit {
        node: own.node,
        conflict: u32::try_from(own.conflict).unwrap_or(u32::MAX),
        agent: agent.clone(),
    };
    let next = next(run, own.node, branches);
    look(state, |own| {
        own.splits.push(split);
        own.taken_back.clear();
        (own.node, own.conflict, own.robot) = (next, 0, 0);
    });
}

/// The node that is looked at after a split: its cheaper branch that can be split and costs less
/// than any plan; else the cheapest such node; else the plan.
fn next(run: &HandRun, split: u64, branches: &[ToldBranch; 2]) -> u64 {
    let made = run.tree.nodes.len() as u64;
    let others = run.tree.nodes.iter().rev().filter(|node| node.id != split);
    let others = others.filter(|node| matches!(node.fate, NodeFate::Open));
    let others = others.filter_map(|node| Some((node.id, node.cost?, node.conflicts)));
    let own = branches.iter().enumerate();
    let own = own.filter_map(|(place, own)| Some((made + place as u64, own.cost?, own.conflicts)));
    let own: Vec<(u64, u32, u64)> = own.collect();
    let others: Vec<(u64, u32, u64)> = others.collect();
    let plans = own.iter().chain(&others);
    let plans = plans.filter(|(.., conflicts)| *conflicts == 0);
    let plan = plans.map(|&(id, cost, _)| (cost, id)).min();
    let cheapest = |nodes: &[(u64, u32, u64)]| {
        let open = nodes.iter().filter(|(_, cost, conflicts)| {
            *conflicts > 0 && plan.is_none_or(|(least, _)| *cost < least)
        });
        open.min_by_key(|(_, cost, _)| *cost).map(|(id, ..)| *id)
    };
    let open = cheapest(&own).or_else(|| cheapest(&others));
    open.or(plan.map(|(_, id)| id)).unwrap_or(split)
}

fn take_back(state: &mut State) {
    look(state, |own| {
        if let Some(last) = own.splits.pop() {
            (own.node, own.conflict) = (last.node, last.conflict as usize);
            own.robot = 0;
            own.taken_back.push(last);
        }
    });
}

/// Splits again what was taken back last.
fn again(state: &mut State) {
    let next = state
        .inside
        .by_hand
        .taken_back
        .last()
        .and_then(|last| after_again(state, last));
    look(state, |own| {
        if let Some(last) = own.taken_back.pop() {
            // Its branches are the last two nodes.
            own.node = next.unwrap_or(2 * own.splits.len() as u64 + 1);
            (own.conflict, own.robot) = (0, 0);
            own.splits.push(last);
        }
    });
}

/// The node that is looked at when a split is made again; `None` where its branches are not told.
fn after_again(state: &State, split: &HandSplit) -> Option<u64> {
    let run = state
        .hand_now()
        .filter(|run| run.asked.node == split.node)?;
    let choice = run.choice(split.conflict as usize)?;
    let parties = words::parties(&choice.conflict).iter();
    let robot = parties.into_iter().position(|name| *name == split.agent)?;
    Some(next(run, split.node, choice.branches.get(robot)?))
}
