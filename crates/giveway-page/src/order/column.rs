//! The order at a cell as the inspector shows it.

use giveway_model::constraint::ConstraintKind;
use giveway_model::tr;
use giveway_order::{Order, words};
use giveway_solve::order::OrderAnswer;

use super::crossing::{Pass, between, busiest, index, passes};
use super::lanes::out;
use super::late::{LateCard, card};
use super::links::{Links, links};
use super::{OrderExport, OrderKnown};
use crate::State;
use crate::words::at;

/// At most so many rotations are told.
const MOST_TOLD: usize = 6;

/// All that is told of the order.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Column {
    /// The title: `Order at (4, 2)`.
    pub title: String,
    /// What it is, and how many pass the cell.
    pub lead: String,
    /// What is still looked for, as a quiet line.
    pub pending: Option<&'static str>,
    /// Who passes the cell, in order.
    pub rows: Vec<PassRow>,
    /// How many links there are in all.
    pub links: Option<String>,
    /// The button that shows all of them; nothing where there are none.
    pub all: Option<String>,
    /// All of them as a table, where they are shown.
    pub table: Option<Links>,
    /// How many of them have no slack, and what that means.
    pub tight: Option<String>,
    /// The button that adds the rule `gap`.
    pub gap: Option<String>,
    /// Robots that rotate, a sentence each.
    pub rotations: Vec<String>,
    /// Moves that begin later than in the plan, and what the order alone does not keep.
    pub losses: Vec<String>,
    /// What follows if a robot is late, where that is asked.
    pub late: Option<LateCard>,
    /// The files that can be saved; none before the order is known.
    pub exports: Vec<ExportRow>,
    /// The format that was saved last.
    pub export: OrderExport,
}

/// A robot that passes the cell.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PassRow {
    /// Its index.
    pub agent: Option<usize>,
    /// Its name.
    pub name: String,
    /// When it is there first, in words.
    pub comes: String,
    /// When it is out, in words.
    pub leaves: String,
    /// The slack before the next one; nothing at the last one.
    pub slack: String,
    /// Whether the next one follows in the same step.
    pub is_tight: bool,
    /// Whether it is in the cell at the time shown.
    pub is_in: bool,
}

/// A file that can be saved.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ExportRow {
    /// Which.
    pub export: OrderExport,
    /// Its name.
    pub name: &'static str,
    /// What is in it.
    pub detail: &'static str,
}

/// The order, where it is open.
pub fn column(state: &State) -> Option<Column> {
    let known = state.order_known()?;
    let mut column = Column {
        title: tr!("Order").to_owned(),
        lead: String::new(),
        pending: None,
        rows: Vec::new(),
        links: None,
        all: None,
        table: None,
        tight: None,
        gap: None,
        rotations: Vec::new(),
        losses: Vec::new(),
        late: None,
        exports: Vec::new(),
        export: state.view.order.export,
    };
    match known.told.as_deref() {
        None => column.pending = Some(tr!("Finding who passes whom")),
        Some(told) => fill(&mut column, state, known, told),
    }
    Some(column)
}

fn fill(column: &mut Column, state: &State, known: &OrderKnown, told: &OrderAnswer) {
    let Some(order) = &told.order else {
        column.lead.clone_from(&told.words);
        return;
    };
    at_cell(column, state, order);
    column.late = card(state);
    let is_asked = column.late.as_ref().is_some_and(|it| it.title.is_none());
    column.pending = (is_asked && state.is_ordering()).then(|| tr!("Finding who is pushed"));
    column.links = Some(words::links(order));
    let count = order.links.len() as u32;
    column.all = (count > 0).then(|| tr!("Show {n} link" | "Show all {n} links" % count));
    column.table = links(state, order);
    column.tight = words::without_slack(order);
    column.gap = gap(state, order).map(|steps| tr!("Add the rule \"gap\" {steps}", steps));
    let rotations = order.rotations.iter().take(MOST_TOLD);
    column.rotations = rotations.map(words::rotation).collect();
    column.losses = words::later(order);
    column.losses.extend(words::losses(&told.losses));
    if known.about.draft.scene().units.is_none() {
        column.losses.push(words::no_units());
    }
    let row = |export: OrderExport| ExportRow {
        export,
        name: export.name(),
        detail: export.detail(),
    };
    column.exports = OrderExport::ALL.map(row).to_vec();
}

/// Who passes the cell.
fn at_cell(column: &mut Column, state: &State, order: &Order) {
    let Some(cell) = state.order_cell() else {
        column.lead = words::links(order);
        return;
    };
    column.title = tr!("Order at {cell}", cell = at(cell));
    let passes = passes(state, cell);
    let n = passes.len() as u32;
    let pass = match n {
        0 => tr!("No robot passes here. Press a cell that robots pass.").to_owned(),
        1 => tr!("One robot passes here, so none waits for another one.").to_owned(),
        _ if busiest(order) == Some(cell) => tr!(
            "The busiest cell: robots pass it {n} times. If each waits for the one before, no two meet, however late they are.",
            n
        ),
        _ => tr!(
            "Robots pass here {n} times. If each waits for the one before, no two meet, however late they are.",
            n
        ),
    };
    column.lead = pass;
    let time = state.view.playback.time;
    let next = passes.iter().skip(1).map(Some).chain([None]);
    let row = |(pass, next): (&Pass, Option<&Pass>)| {
        let step = next.and_then(|next| between(state, cell, pass, next));
        PassRow {
            agent: index(state, &pass.name),
            name: pass.name.clone(),
            comes: pass.arrives.to_string(),
            leaves: out(pass).map_or_else(
                || tr!("a robot" => "stays").to_owned(),
                |out| out.to_string(),
            ),
            slack: step
                .as_ref()
                .map_or_else(String::new, |step| step.slack.to_string()),
            is_tight: step.is_some_and(|step| step.is_tight),
            is_in: pass.arrives <= time && pass.leaves.is_none_or(|leaves| time <= leaves),
        }
    };
    column.rows = passes.iter().zip(next).map(row).collect();
}

/// The steps of the rule `gap` under which no link is without slack; `None` where none is, and
/// where the scene has that rule already or takes no rules.
pub(crate) fn gap(state: &State, order: &Order) -> Option<u32> {
    let steps = if order.has_slow_moves() { 2 } else { 1 };
    let rules = &state.document.draft.scene().constraints;
    let has_it = rules.iter().any(|rule| {
        let is_gap = matches!(rule.kind, ConstraintKind::Gap { steps: has } if has >= steps);
        is_gap && !rule.off && rule.agents.is_none()
    });
    let is_wanted = order.without_slack() > 0 && !has_it && state.can_write_rules();
    is_wanted.then_some(steps)
}
