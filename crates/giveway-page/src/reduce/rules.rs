//! Rules of the scene's own: written, switched, removed, priced, and lit.

use std::rc::Rc;

use giveway_model::words::Sentence;
use giveway_model::{Constraint, Question, Zone, tr_data};

use super::{ask, document, prices, solve};
use crate::gesture::Hold;
use crate::rules::{Lit, RuleAction, Slot, Value, Writing};
use crate::{Edit, RuleEdit, Selection, State, Tab, Tool};

pub(super) fn rules(state: &mut State, action: RuleAction) {
    let writing = state.view.rules.writing.clone();
    match action {
        RuleAction::Light(lit) => state.view.rules.lit = lit,
        RuleAction::List => list(state),
        RuleAction::Show(index) => {
            if state.can_write_rules() {
                list(state);
                state.view.rules.open = Some(index);
            }
            state.view.rules.lit = Some(Lit::Rule(index));
        }
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
        RuleAction::Edit(index) => edit_rule(state, index, false),
        RuleAction::Loosen(index) => edit_rule(state, index, true),
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
        }
        RuleAction::Write(rule) => change(state, |writing| writing.write(rule)),
        RuleAction::OpenSlot(slot) => change(state, |writing| {
            writing.open = slot.filter(|_| writing.open != slot);
        }),
        RuleAction::Fill(value) => change(state, |writing| writing.fill(value)),
        RuleAction::Read(text) => change(state, |writing| match Constraint::from_words(&text) {
            Ok(rule) => writing.write(Constraint {
                name: writing.rule.name.clone(),
                ..rule
            }),
            Err(fault) => writing.misread = Some(fault.to_string()),
        }),
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
        RuleAction::Cancel => state.view.rules.writing = None,
        RuleAction::Price if state.is_pricing() => solve::cancel(state),
        RuleAction::Price => prices::price(state),
    }
}

/// Shows the list of all rules.
fn list(state: &mut State) {
    ask::close(state);
    state.view.rules.writing = None;
    state.view.selection = Selection::Nothing;
    state.view.tab = Tab::Inspector;
}

fn edit(state: &mut State, edit: RuleEdit) {
    document::edit(state, Edit::Rules(edit));
}

/// Begins to write a rule, where rules can be written.
fn begin(state: &mut State, writing: Option<Writing>) {
    if !state.can_add_rules() {
        return ask::refuse(state, not_here());
    }
    ask::close(state);
    let zone = writing.as_ref().and_then(Writing::zone);
    if let Some(zone) = zone.map(str::to_owned) {
        state.view.rules.lit = Some(Lit::Zone(zone.clone()));
        state.view.rules.zone = Some(zone);
    }
    if writing.is_some() {
        state.view.notice = None;
        state.view.tab = Tab::Inspector;
    }
    state.view.rules.writing = writing.map(Rc::new);
}

/// Begins to edit a rule; in the slot in which it can ask for less, if that is wanted.
fn edit_rule(state: &mut State, index: usize, is_loosened: bool) {
    let rule = state.document.draft.scene().constraints.get(index);
    let writing = rule.map(|rule| Writing {
        open: crate::rules::loosened(rule).filter(|_| is_loosened),
        ..Writing::of(rule, index)
    });
    begin(state, writing);
}

/// Begins a question: why not a plan that keeps some rule. Rules with a weight forbid nothing.
fn question(state: &mut State) {
    if !state.can_write_rules() {
        return ask::refuse(state, not_here());
    }
    let mut offers = crate::rules::every(state);
    offers.retain(|rule| !rule.is_penalty());
    let writing = Writing::first(offers);
    let asks = writing.map(|writing| Writing {
        asks: true,
        ..writing
    });
    begin(state, asks);
}

/// Asks why a rule is not kept, as if it were in force.
fn ask_why(state: &mut State, rule: Constraint) {
    let rule = Box::new(Constraint { off: false, ..rule });
    ask::ask(state, &Question::Rule { rule });
    if state.document.mode.asking().is_some() {
        state.view.rules.writing = None;
    }
}

fn not_here() -> Sentence {
    tr_data!("Rules can be written where the scene itself is on the board.")
}

fn of_zone(state: &mut State, name: &str) {
    let zones = &state.document.draft.scene().zones;
    if zones.iter().any(|zone| zone.name == name) {
        let offers = crate::rules::of_zone(name);
        begin(state, Writing::first(offers));
    }
}

fn change(state: &mut State, change: impl FnOnce(&mut Writing)) {
    if let Some(writing) = &mut state.view.rules.writing {
        change(Rc::make_mut(writing));
    }
}

/// Gives a zone another name, here and in the rule that is being written.
fn rename(state: &mut State, zone: &str, to: &str) {
    let before: Vec<String> = names(state);
    edit(state, RuleEdit::RenameZone(zone.to_owned(), to.to_owned()));
    let new = names(state).into_iter().find(|name| !before.contains(name));
    let Some(new) = new else { return };
    let offers = crate::rules::of_zone(&new);
    change(state, |writing| {
        writing.fill(Value::Zone(new.clone()));
        if !writing.offers.is_empty() {
            writing.offers = offers;
        }
    });
    state.view.rules.lit = Some(Lit::Zone(new.clone()));
    state.view.rules.zone = Some(new);
}

fn names(state: &State) -> Vec<String> {
    let zones = state.document.draft.scene().zones.iter();
    zones.map(|zone| zone.name.clone()).collect()
}

/// Adds the rule that was written, as one step of undo.
fn add(state: &mut State, writing: &Writing) {
    let count = state.document.draft.scene().constraints.len();
    let put = RuleEdit::Put(writing.index, writing.rule.clone());
    if state.document.mode.changing().is_some() {
        state.view.notice = None;
        edit(state, put);
        if state.view.notice.is_none() {
            state.view.rules.writing = None;
        }
        return;
    }
    if let Err(notice) = document::edit_scene(state, &[Edit::Rules(put)]) {
        state.view.notice = Some(notice);
        return;
    }
    document::solve_on_change(state);
    state.view.rules.writing = None;
    state.view.rules.zone = None;
    state.view.rules.lit = Some(Lit::Rule(writing.index.unwrap_or(count)));
    if state.view.tool.is_of_rules() {
        state.view.tool = Tool::Select;
    }
    state.view.selection = Selection::Nothing;
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
