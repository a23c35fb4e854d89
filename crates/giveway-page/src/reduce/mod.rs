//! From a state and an action to the next state.

mod area;
mod ask;
mod audit;
mod board;
mod change;
mod delete;
mod document;
mod file;
mod find;
mod fleet;
mod floor_plan;
mod freedom;
mod grow;
mod inside;
mod intake;
mod job;
mod ledger;
mod lesson;
mod order;
mod planners;
mod play;
mod press;
mod prices;
mod proof;
mod robots;
mod rules;
mod sizing;
mod slot;
mod solve;
mod steer;
mod stroke;
#[cfg(test)]
pub(crate) mod tests;
mod view;

pub(crate) use area::copies;
pub(crate) use audit::go_on as go_on_auditing;
pub(crate) use document::settle;

use crate::{Action, BoardAction, FileAction, SolveAction, State, ViewAction};

/// The next state. Pure: the same state and action always give the same.
///
/// ```
/// use giveway_model::Scene;
/// use giveway_page::{Action, Draft, SolveAction, State, reduce};
/// let scene = Scene { map: vec!["..".into()], ..Scene::default() };
/// let state = State::new(Draft::new(scene).unwrap());
/// let state = reduce(&state, Action::Solve(SolveAction::Solve));
/// assert!(state.work.solving().is_some());
/// ```
#[must_use]
pub fn reduce(state: &State, action: Action) -> State {
    let mut next = state.clone();
    if !next.is_embedded() || only_looks(&action) {
        if let Some(action) = lesson::admit(&mut next, action) {
            let action = sizing::admit(&mut next, action);
            if let Some(action) = action.and_then(|action| order::admit(&mut next, action)) {
                step(&mut next, action);
            }
        }
        lesson::settle(&mut next);
        // What runs is always about what there is.
        let had_plan = next.so_far().is_some();
        next.work.keep_to(&next.document);
        if had_plan && next.so_far().is_none() {
            document::keep_to_plan(&mut next);
        }
        area::settle(&mut next);
        robots::settle(&mut next);
        sizing::settle(&mut next);
        order::settle(&mut next);
        grow::settle(&mut next);
        rules::settle(&mut next);
        inside::look(&mut next);
    }
    next
}

fn step(state: &mut State, action: Action) {
    match action {
        Action::File(action) => file::file(state, action),
        Action::Edit(edit) => document::edit(state, edit),
        Action::Undo => document::undo(state),
        Action::Redo => document::redo(state),
        Action::Board(action) => board::board(state, action),
        Action::Solve(action) => solve::solve(state, &action),
        Action::Worker(action) => job::worker(state, action),
        Action::Ask(action) => ask::questions(state, action),
        Action::Change(action) => change::change(state, action),
        Action::Steer(lead) => steer::steer(state, lead),
        Action::Audit(action) => audit::audit(state, action),
        Action::Find(action) => find::find(state, action),
        Action::Area(action) => area::area(state, action),
        Action::Grow(action) => grow::grow(state, action),
        Action::Robots(action) => robots::robots(state, action),
        Action::Fleet(action) => fleet::fleet(state, action),
        Action::Sizing(action) => sizing::sizing(state, action),
        Action::FloorPlan(action) => floor_plan::floor_plan(state, &action),
        Action::Freedom(action) => freedom::freedom(state, action),
        Action::Ledger(action) => ledger::ledger(state, action),
        Action::Order(action) => order::order(state, action),
        Action::Intake(action) => intake::intake(state, action),
        Action::Inside(action) => inside::inside(state, action),
        Action::Play(action) => {
            if !inside::plays(state, action) {
                play::play(state, action);
            }
        }
        Action::View(action) => view::view(state, &action),
        Action::Rules(action) => rules::rules(state, action),
        Action::Slot(action) => slot::slot(state, action),
        Action::Lesson(action) => lesson::lesson(state, action),
    }
}

/// Whether an action only looks at what there is: inside another page nothing
/// else happens.
pub(crate) const fn only_looks(action: &Action) -> bool {
    match action {
        Action::View(action) => !matches!(action, ViewAction::Present(_)),
        Action::Play(_) | Action::Worker(_) => true,
        Action::Board(action) => matches!(action, BoardAction::StepCursor { carries: false, .. }),
        Action::File(action) => matches!(
            action,
            FileAction::OpenLink(_) | FileAction::Tell(_) | FileAction::RefuseLink(_)
        ),
        Action::Solve(action) => matches!(action, SolveAction::Cancel),
        Action::Edit(_)
        | Action::Undo
        | Action::Redo
        | Action::Ask(_)
        | Action::Change(_)
        | Action::Steer(_)
        | Action::Audit(_)
        | Action::Inside(_)
        | Action::Rules(_)
        | Action::Find(_)
        | Action::Area(_)
        | Action::Robots(_)
        | Action::Grow(_)
        | Action::Fleet(_)
        | Action::Sizing(_)
        | Action::FloorPlan(_)
        | Action::Freedom(_)
        | Action::Ledger(_)
        | Action::Order(_)
        | Action::Intake(_)
        | Action::Slot(_)
        | Action::Lesson(_) => false,
    }
}
