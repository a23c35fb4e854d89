//! Rules of the scene's own: written, switched, removed, priced, and lit.

mod write;

use std::rc::Rc;

use giveway_model::{Constraint, Zone};

use super::{ask, document, prices, solve};
use crate::gesture::Hold;
use crate::rules::{Lit, RuleAction, Slot, Value, Writing};
use crate::{Edit, RuleEdit, Selection, State, Tab};
use write::{add, ask_why, begin, cancel, change, edit_rule, of_zone, question, rename};

#[inline(never)]
pub(super) fn rules(state: &mut State, action: RuleAction) {
    let writing = state.view.rules.writing.clone();
    match action {
        RuleAction::Light(lit) => state.view.rules.lit = lit,
        RuleAction::OverZone(name, is_over) => over_zone(state, &name, is_over),
        RuleAction::List => list(state),
        RuleAction::Show(index) => show_rule(state, index),
        RuleAction::AllTimes(all) => state.view.rules.shows_all_times = all,
        RuleAction::Open(index) => {
            let open = &mut state.view.rules.open;
            *open = (*open != Some(index)).then_some(index);
            state.view.rules.lit = Some(Lit::Rule(index));
        }
        RuleAction::Switch(index) => edit(state, RuleEdit::Switch(index)),
        RuleAction::Remove(index) => {
            state.view.rules.open = None;
            edit(state, RuleEdit::Remove(index));
        }
        RuleAction::Begin => {
            let offers = crate::rules::offered(state);
            begin(state, Writing::first(offers));
        }
        RuleAction::OfZone(name) => of_zone(state, &name),
        RuleAction::OfTab(name) => of_tab(state, &name),
        RuleAction::Edit(index) => edit_rule(state, index),
        RuleAction::Loosen(index) if state.loosens_rule() == Some(index) => solve::cancel(state),
        RuleAction::Loosen(index) => prices::loosen(state, index),
        RuleAction::TakeLooser(place) => prices::take_looser(state, place),
        RuleAction::Question => question(state),
        RuleAction::Ask => {
            if let Some(writing) = writing {
                ask_why(state, writing.rule.clone());
            }
        }
        RuleAction::AskAbout(index) => {
            let rule = state.document.draft.scene().constraints.get(index).cloned();
            if let Some(rule) = rule {
                ask_why(state, rule);
            }
        }
        RuleAction::Without(rule) => {
            let without = rule.and_then(|rule| crate::rules::without(state, rule));
            state.view.rules.without = without;
            // It begins where the plans begin to differ.
            if let Some(first) = state.differences().first() {
                super::play::seek(state, first.time);
            }
        }
        RuleAction::Write(rule) => change(state, |writing| writing.write(rule)),
        RuleAction::OpenSlot(slot) => change(state, |writing| {
            writing.open = slot.filter(|_| writing.open != slot);
        }),
        RuleAction::Fill(value) => change(state, |writing| writing.fill(value)),
        RuleAction::Read(text) => {
            let read = read(state, &text);
            change(state, |writing| match read {
                Ok(rule) => writing.write(Constraint {
                    name: writing.rule.name.clone(),
                    ..rule
                }),
                Err(fault) => writing.misread = Some((text, fault.to_string())),
            });
        }
        RuleAction::RenameZone(to) => {
            if let Some(zone) = writing.as_deref().and_then(Writing::zone) {
                rename(state, zone, &to);
            }
        }
        RuleAction::RemoveZone => {
            if let Some(zone) = writing.as_deref().and_then(Writing::zone) {
                edit(state, RuleEdit::RemoveZone(zone.to_owned()));
            }
        }
        RuleAction::Add => {
            if let Some(writing) = writing {
                add(state, &writing);
            }
        }
        RuleAction::Cancel => cancel(state),
        RuleAction::Price if state.is_pricing() => solve::cancel(state),
        RuleAction::Price => prices::price(state),
    }
}

/// A rule from typed words, in which names of zones may stand without quotes.
fn read(state: &State, text: &str) -> Result<Constraint, giveway_model::Fault> {
    let agents = &state.document.draft.scene().agents;
    let named = crate::rules::with_names(text, agents);
    let text = named.as_deref().unwrap_or(text);
    let fault = match Constraint::from_words(text) {
        Err(fault) if !text.contains('\'') => fault,
        read => return read,
    };
    let zones = state.document.draft.scene().zones.iter();
    let quoted = zones
        .filter(|zone| text.contains(&zone.name))
        .max_by_key(|zone| zone.name.len())
        .map(|zone| text.replace(&zone.name, &format!("'{}'", zone.name)));
    match quoted.map(|text| Constraint::from_words(&text)) {
        Some(Ok(rule)) => Ok(rule),
        Some(Err(_)) | None => Err(fault),
    }
}

/// Shows a rule in the list, open.
fn show_rule(state: &mut State, index: usize) {
    if state.can_write_rules() {
        list(state);
        state.view.rules.open = Some(index);
    }
    state.view.rules.lit = Some(Lit::Rule(index));
}

/// Shows a rule of a zone: the one after that which is open. A zone without any begins one.
fn of_tab(state: &mut State, name: &str) {
    let rules = state.document.draft.scene().constraints.iter().enumerate();
    let own = rules.filter(|(_, rule)| crate::rules::zone_of(&rule.kind) == Some(name));
    let own: Vec<usize> = own.map(|(index, _)| index).collect();
    let open = state.view.rules.open;
    let after = open.filter(|open| own.contains(open));
    let next = own
        .iter()
        .find(|&&index| after.is_none_or(|open| index > open));
    match next.or(own.first()) {
        Some(&index) => show_rule(state, index),
        None => of_zone(state, name),
    }
}

/// A zone is looked at, or no longer. A rule of it that is lit stays lit.
fn over_zone(state: &mut State, name: &str, is_over: bool) {
    let rules = &state.document.draft.scene().constraints;
    let is_of_it = |index: usize| {
        let rule = rules.get(index);
        rule.is_some_and(|rule| crate::rules::zone_of(&rule.kind) == Some(name))
    };
    let lit = match &state.view.rules.lit {
        Some(Lit::Rule(index)) if is_of_it(*index) => return,
        Some(Lit::Zone(lit)) if !is_over && lit != name => return,
        Some(Lit::Rule(_)) | None if !is_over => return,
        Some(Lit::Rule(_) | Lit::Zone(_)) | None => is_over.then(|| Lit::Zone(name.to_owned())),
    };
    state.view.rules.lit = lit;
}

/// Shows the list of all rules.
pub(super) fn list(state: &mut State) {
    ask::close(state);
    state.view.rules.writing = None;
    state.view.selection = Selection::Nothing;
    state.view.tab = Tab::Inspector;
}

fn edit(state: &mut State, edit: RuleEdit) {
    document::edit(state, Edit::Rules(edit));
}

/// Marks a zone and adds a rule as one step of undo, as a person would do it by hand.
pub(super) fn show(state: &mut State, zone: &Zone, rule: Constraint) {
    let name = || zone.name.clone();
    let paint = |cell| Edit::Rules(RuleEdit::PaintZone(name(), cell, true));
    let mut edits: Vec<Edit> = zone.cells().map(paint).collect();
    edits.push(Edit::Rules(RuleEdit::Put(None, rule)));
    match document::edit_scene(state, &edits) {
        Ok(()) => {
            list(state);
            document::solve_on_change(state);
        }
        Err(notice) => state.view.notice = Some(notice),
    }
}

/// A stroke over cells has ended: a zone that is new gets its first rule.
pub(super) fn marked(state: &mut State, hold: &Hold) {
    let (Hold::Zone(name, on) | Hold::Rect(name, on)) = hold else {
        return;
    };
    let scene = state.document.draft.scene();
    if !scene.zones.iter().any(|zone| zone.name == *name) {
        state.view.rules.zone = None;
        return;
    }
    let has_rule = |rule: &Constraint| crate::rules::zone_of(&rule.kind) == Some(name);
    let is_ruled = scene.constraints.iter().any(has_rule);
    state.view.rules.zone = Some(name.clone());
    state.view.rules.lit = Some(Lit::Zone(name.clone()));
    let writing = state.view.rules.writing.as_deref();
    if *on && !is_ruled && writing.is_none_or(|writing| writing.zone() != Some(name)) {
        of_zone(state, name);
    }
}

/// A cell that is pressed while the rule that is being written asks for one; else what is
/// selected ends the writing.
pub(super) fn takes_cell(state: &mut State, selection: Selection) -> bool {
    let Some(writing) = &state.view.rules.writing else {
        return false;
    };
    if let Some(Slot::Cell(index)) = writing.open
        && selection != Selection::Nothing
    {
        let cell = match selection {
            Selection::Cell(cell) => cell,
            Selection::Agent(_) | Selection::Nothing => state.view.cursor,
        };
        let cell = state.document.draft.clamp(cell);
        change(state, |writing| writing.fill(Value::Cell(index, cell)));
        return true;
    }
    state.view.rules.writing = None;
    false
}

/// What is written and lit is about what there is.
pub(super) fn settle(state: &mut State) {
    state.view.rules.outdated.keep_to(&state.document);
    let scene = state.document.draft.scene();
    let can_write = state.can_add_rules();
    let has_zone = |name: &String| scene.zones.iter().any(|zone| zone.name == *name);
    let view = &mut state.view.rules;
    let lost = view.zone.take_if(|name| !has_zone(name));
    let fits = |writing: &Rc<Writing>| {
        let is_lost = lost.is_some() && writing.zone() == lost.as_deref();
        can_write && !is_lost && writing.fits(scene)
    };
    view.writing = view.writing.take().filter(fits);
    view.lit = view.lit.take().filter(|lit| match lit {
        Lit::Rule(index) => *index < scene.constraints.len(),
        Lit::Zone(name) => has_zone(name),
    });
    let of_rules = view.without.take();
    view.without = of_rules.filter(|without| without.rule < scene.constraints.len());
    view.open = view.open.filter(|&index| index < scene.constraints.len());
}
