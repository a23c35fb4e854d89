//! The table of the robots: typed, pasted, taken; rows selected and what is done with them.

mod duplicate;
mod paste;

use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;

use giveway_model::{Agent, Battery, tr_data};

use super::ask;
use super::document::edit;
use crate::robots::{Column, Given, RobotsAction, Target, Waiting, hold, take, whose};
use crate::{Edit, Notice, State};
use duplicate::duplicate;
use paste::paste;

#[inline(never)]
pub(super) fn robots(state: &mut State, action: RobotsAction) {
    if !state.can_show_robots() {
        return;
    }
    match action {
        RobotsAction::Show(on) => {
            state.view.robots.is_open = on;
            state.view.robots.held = None;
            if !on {
                state.view.robots.waiting = None;
            }
        }
        RobotsAction::Focus(row, column) => state.view.robots.at = (row, column),
        RobotsAction::Type(row, column, text) => give(state, row, column, text),
        RobotsAction::Remedy(row, column) => {
            let table = crate::robots::table(state);
            let row_now = table.as_ref().and_then(|table| table.rows.get(row));
            let fault =
                row_now.and_then(|row| row.faults.iter().find(|fault| fault.column == column));
            if let Some((_, text)) = fault.and_then(|fault| fault.remedy.clone()) {
                give(state, row, column, text);
            }
        }
        RobotsAction::Paste(text, at_cursor) => paste(state, &text, at_cursor),
        RobotsAction::Take => {
            if let Some(waiting) = state.view.robots.waiting.take() {
                let agents = take(&state.document.draft, &waiting.given).agents;
                edit(state, Edit::PutAgents(agents));
            }
        }
        RobotsAction::Drop => state.view.robots.waiting = None,
        RobotsAction::Sort(column) => {
            // What is seen as sorted counts: after an edit the same press sorts again.
            let seen = crate::robots::table(state).and_then(|table| table.sort);
            let robots = &mut state.view.robots;
            robots.held = None;
            robots.sort = match (robots.sort, seen) {
                (Some((own, is_back)), None) if own == column => Some((column, is_back)),
                (Some((own, false)), _) if own == column => Some((column, true)),
                (Some((own, true)), _) if own == column => None,
                (Some(_) | None, _) => Some((column, false)),
            };
        }
        RobotsAction::Filter(words) => {
            state.view.robots.filter = words.chars().take(60).collect();
            state.view.robots.at.0 = 0;
            state.view.robots.held = None;
        }
        RobotsAction::Select(row) => {
            let name = whose(state, row).and_then(|agent| state.document.draft.agents().get(agent));
            if let Some(name) = name.map(|agent| agent.name.clone()) {
                let selected = Rc::make_mut(&mut state.view.robots.selected);
                if !selected.remove(&name) {
                    selected.insert(name);
                }
            }
        }
        RobotsAction::SelectAll => select_all(state),
        RobotsAction::Battery(capacity) => {
            let battery = |old: Option<Battery>| {
                capacity.map(|capacity| Battery {
                    capacity,
                    initial: old.map_or(capacity, |old| old.initial.min(capacity)),
                })
            };
            change_selected(state, |agent| agent.battery = battery(agent.battery));
        }
        RobotsAction::Level(level) => begin_at(state, level),
        RobotsAction::Duplicate => duplicate(state),
        RobotsAction::Delete => {
            let gone = selected(state);
            if !gone.is_empty() {
                edit(state, Edit::RemoveAgents(gone));
            }
        }
    }
}

/// Changes all robots that are selected, in one step of undo.
fn change_selected(state: &mut State, change: impl Fn(&mut Agent)) {
    state.view.robots.held = Some(hold(state));
    let mut agents = state.document.draft.agents().to_vec();
    for index in selected(state) {
        if let Some(agent) = agents.get_mut(index) {
            change(agent);
        }
    }
    edit(state, Edit::PutAgents(agents));
}

/// The batteries of those that are selected begin at a level; none does where one cannot.
fn begin_at(state: &mut State, level: u32) {
    let agents = state.document.draft.agents();
    let chosen = selected(state).into_iter();
    let mut chosen = chosen.filter_map(|index| agents.get(index));
    let cannot = chosen.find_map(|agent| {
        let capacity = agent.battery.map_or(0, |battery| battery.capacity);
        (capacity < level).then(|| (agent.name.clone(), capacity))
    });
    match cannot {
        None => change_selected(state, |agent| {
            if let Some(battery) = &mut agent.battery {
                battery.initial = level;
            }
        }),
        Some((name, capacity)) => ask::refuse(
            state,
            tr_data!("The battery of {name} holds {capacity}.", name, capacity),
        ),
    }
}

/// The robots that are selected, by their index.
fn selected(state: &State) -> BTreeSet<usize> {
    let names = &state.view.robots.selected;
    let agents = state.document.draft.agents().iter().enumerate();
    agents
        .filter(|(_, agent)| names.contains(&agent.name))
        .map(|(index, _)| index)
        .collect()
}

fn select_all(state: &mut State) {
    let Some(table) = crate::robots::table(state) else {
        return;
    };
    let agents = state.document.draft.agents();
    let names: BTreeSet<String> = {
        let shown = table.rows.iter().filter_map(|row| agents.get(row.agent?));
        shown.map(|agent| agent.name.clone()).collect()
    };
    let is_all = names
        .iter()
        .all(|name| state.view.robots.selected.contains(name));
    state.view.robots.selected = Rc::new(if is_all { BTreeSet::new() } else { names });
}

/// Something was typed in a cell.
fn give(state: &mut State, row: usize, column: Column, text: String) {
    if column.is_result() {
        return ask::refuse(state, tr_data!("What a plan comes to is not edited."));
    }
    let mut waiting = state
        .view
        .robots
        .waiting
        .as_deref()
        .cloned()
        .unwrap_or(Waiting {
            given: Vec::new(),
            is_pasted: false,
        });
    let target = match whose(state, row) {
        Some(agent) => Target::Old(agent),
        None => Target::New,
    };
    let news_before = |given: &[Given]| {
        given
            .iter()
            .filter(|given| given.target == Target::New)
            .count()
    };
    let place = match target {
        Target::Old(_) => waiting
            .given
            .iter()
            .position(|given| given.target == target),
        Target::New => {
            // Rows that are to come stand behind those of the scene, in their order.
            let shown = crate::robots::shown(state);
            let new = shown
                .get(row)
                .map(|index| index - state.document.draft.agents().len());
            let mut news = (0..waiting.given.len()).filter(|&index| {
                waiting
                    .given
                    .get(index)
                    .is_some_and(|given| given.target == Target::New)
            });
            new.filter(|&new| new < news_before(&waiting.given))
                .and_then(|new| news.nth(new))
        }
    };
    match place.and_then(|place| waiting.given.get_mut(place)) {
        Some(given) => {
            given.cells.insert(column, text);
        }
        None => waiting.given.push(Given {
            target,
            cells: BTreeMap::from([(column, text)]),
        }),
    }
    settle_given(state, waiting);
}

/// What was given is taken where all of it fits. What was typed by itself is taken row by row.
fn settle_given(state: &mut State, waiting: Waiting) {
    state.view.robots.held = Some(hold(state));
    let taken = take(&state.document.draft, &waiting.given);
    let is_whole = taken.faults.iter().all(Vec::is_empty);
    if !is_whole && waiting.is_pasted {
        state.view.robots.waiting = Some(Rc::new(waiting));
        return;
    }
    let pasted = waiting.is_pasted.then_some(waiting.given.len());
    let bad = waiting
        .given
        .into_iter()
        .zip(&taken.faults)
        .filter(|(_, faults)| !faults.is_empty());
    let given: Vec<Given> = bad.map(|(given, _)| given).collect();
    state.view.robots.waiting = (!given.is_empty()).then(|| {
        Rc::new(Waiting {
            given,
            is_pasted: false,
        })
    });
    rename_selected(state, &taken.agents);
    edit(state, Edit::PutAgents(taken.agents));
    if let (Some(n), None) = (pasted, &state.view.notice) {
        state.view.notice = Some(Notice::information(tr_data!(
            "{n} robot pasted." | "{n} robots pasted." % n
        )));
    }
}

/// Rows stay selected under another name.
fn rename_selected(state: &mut State, agents: &[Agent]) {
    let old = state.document.draft.agents().iter();
    let names: BTreeSet<String> = {
        let kept = old
            .zip(agents)
            .filter(|(old, _)| state.view.robots.selected.contains(&old.name));
        kept.map(|(_, agent)| agent.name.clone()).collect()
    };
    state.view.robots.selected = Rc::new(names);
}

/// What waits goes where the scene is another one; rows of robots that are gone are not selected.
pub(super) fn settle(state: &mut State) {
    let agents = state.document.draft.agents();
    let robots = &state.view.robots;
    let is_there = |name: &String| agents.iter().any(|agent| agent.name == *name);
    if !robots.selected.iter().all(is_there) {
        let kept = robots
            .selected
            .iter()
            .filter(|name| is_there(name))
            .cloned()
            .collect();
        state.view.robots.selected = Rc::new(kept);
    }
    let count = state.document.draft.agents().len();
    let fits = |given: &Given| match given.target {
        Target::Old(index) => index < count,
        Target::New => true,
    };
    let waiting = state.view.robots.waiting.as_ref();
    if waiting.is_some_and(|waiting| !waiting.given.iter().all(fits)) || !state.can_show_robots() {
        state.view.robots.waiting = None;
    }
}
