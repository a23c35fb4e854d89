//! The rule that is being written: begun, filled, asked about, added.

use std::rc::Rc;

use giveway_model::words::Sentence;
use giveway_model::{Constraint, Question, tr_data};

use super::super::{ask, document};
use super::{edit, list};
use crate::rules::{Lit, Outdated, Value, Writing, zone_of};
use crate::{Edit, Notice, RuleEdit, Selection, State, Tab, Tool};

/// Begins to write a rule, where rules can be written.
pub(super) fn begin(state: &mut State, writing: Option<Writing>) {
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

/// Begins to edit a rule.
pub(super) fn edit_rule(state: &mut State, index: usize) {
    let rule = state.document.draft.scene().constraints.get(index);
    let writing = rule.map(|rule| Writing::of(rule, index));
    begin(state, writing);
}

/// Begins a question: why not a plan that keeps some rule. Rules with a weight forbid nothing.
pub(super) fn question(state: &mut State) {
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
pub(super) fn ask_why(state: &mut State, rule: Constraint) {
    if shows_twin(state, &rule, None) {
        return;
    }
    let rule = Box::new(Constraint { off: false, ..rule });
    ask::ask(state, &Question::Rule { rule });
    if state.document.mode.asking().is_some() {
        state.view.rules.writing = None;
    }
}

fn not_here() -> Sentence {
    tr_data!("Rules can be written where the scene itself is on the board.")
}

pub(super) fn of_zone(state: &mut State, name: &str) {
    let zones = &state.document.draft.scene().zones;
    if zones.iter().any(|zone| zone.name == name) {
        let offers = crate::rules::of_zone(name);
        begin(state, Writing::first(offers));
    }
}

pub(super) fn change(state: &mut State, change: impl FnOnce(&mut Writing)) {
    if let Some(writing) = &mut state.view.rules.writing {
        change(Rc::make_mut(writing));
    }
}

/// Gives a zone another name, here and in the rule that is being written.
pub(super) fn rename(state: &mut State, zone: &str, to: &str) {
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

/// Says that a rule is in force already, and shows it.
fn shows_twin(state: &mut State, rule: &Constraint, but: Option<usize>) -> bool {
    let Some(index) = crate::rules::twin(state, rule, but) else {
        return false;
    };
    if state.document.mode.changing().is_none() {
        list(state);
        state.view.rules.lit = Some(Lit::Rule(index));
    }
    let sentence = rule.sentence();
    let told = tr_data!("This rule is in force already: {rule}.", rule = sentence);
    state.view.notice = Some(Notice::information(&told));
    true
}

/// Leaves the rule that was written out. A zone that is new stays, which is said.
pub(super) fn cancel(state: &mut State) {
    let writing = state.view.rules.writing.take();
    if state.view.tool.is_of_rules() {
        // A press on the board looks at something again.
        state.view.tool = Tool::Select;
    }
    let zone = writing.as_deref().and_then(Writing::zone);
    let scene = state.document.draft.scene();
    let is_used = |zone: &str| {
        let mut rules = scene.constraints.iter();
        rules.any(|rule| zone_of(&rule.kind) == Some(zone))
    };
    if let Some(zone) = zone.filter(|zone| !is_used(zone)) {
        let told = tr_data!(
            "{zone} stays marked. Without a rule it changes nothing; Undo takes it back.",
            zone = zone.to_owned()
        );
        state.view.notice = Some(Notice::information(&told));
    }
}

/// Adds the rule that was written, as one step of undo.
pub(super) fn add(state: &mut State, writing: &Writing) {
    if !writing.rule.off && shows_twin(state, &writing.rule, writing.index) {
        return;
    }
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
    // Where the plan breaks it, that is seen at once.
    if let Some(first) = Outdated::of(&state.document).and_then(|it| it.first_time()) {
        state.view.playback.stop_at(first);
    }
    state.view.rules.writing = None;
    state.view.rules.zone = None;
    state.view.rules.lit = Some(Lit::Rule(writing.index.unwrap_or(count)));
    if state.view.tool.is_of_rules() {
        state.view.tool = Tool::Select;
    }
    state.view.selection = Selection::Nothing;
}
