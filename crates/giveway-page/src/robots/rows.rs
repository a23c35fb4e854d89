//! The rows of the table as they are shown: sorted, filtered, with what was given.

use giveway_model::{Agent, csv, tr};

use super::given::written;
use super::order::{is_sorted, shown};
use super::{Column, Fault, Given, Target, take};
use crate::State;
use crate::timeline::Lane;

/// The table of the robots.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    /// The rows that are shown.
    pub rows: Vec<Row>,
    /// How many of all that is, and how many are selected.
    pub count: String,
    /// The words of the filter.
    pub filter: String,
    /// The column that rows are sorted by, and whether the other way round; `None` while an edit
    /// keeps them in an order that is none of these.
    pub sort: Option<(Column, bool)>,
    /// The cell of the keyboard: a row as it is shown, and a column.
    pub at: (usize, Column),
    /// How many rows are selected.
    pub selected: usize,
    /// What waits to be taken.
    pub banner: Option<Banner>,
}

/// What is said of a pasted table that does not fit as a whole.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Banner {
    /// How many rows fit.
    pub told: String,
    /// The button that takes these; `None` where none fits.
    pub take: Option<String>,
}

/// A row of the table.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// The robot, by its index in the scene; `None` where it is to come.
    pub agent: Option<usize>,
    /// Its texts, in the order of [`Column::ALL`].
    pub cells: Vec<Cell>,
    /// Whether it is selected.
    pub is_selected: bool,
    /// What cannot be so.
    pub faults: Vec<Fault>,
}

/// A cell of the table.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Cell {
    /// Its text.
    pub text: String,
    /// Whether it was given and is not taken yet.
    pub is_new: bool,
    /// Whether it cannot be so.
    pub is_faulty: bool,
}

/// The table; `None` where it is not shown.
pub fn table(state: &State) -> Option<Table> {
    if !state.shows_robots() {
        return None;
    }
    let view = &state.view.robots;
    let all = all_rows(state);
    let count = all.len();
    let rows: Vec<Row> = shown(state)
        .into_iter()
        .filter_map(|index| all.get(index).cloned())
        .collect();
    let selected = view.selected.len();
    let shown = rows.len();
    let banner = view
        .waiting
        .as_ref()
        .filter(|waiting| waiting.is_pasted)
        .map(|waiting| {
            let taken = take(&state.document.draft, &waiting.given);
            let all = waiting.given.len();
            let bad = taken
                .faults
                .iter()
                .filter(|faults| !faults.is_empty())
                .count();
            let fits = all - bad;
            Banner {
                told: tr!(
                    "{n} row pasted: {fits} fit, {bad} to look at. Nothing has changed yet."
                        | "{n} rows pasted: {fits} fit, {bad} to look at. Nothing has changed yet."
                            % all,
                    fits,
                    bad
                ),
                take: (fits > 0).then(|| tr!("Take the {fits}", fits)),
            }
        });
    Some(Table {
        count: match selected {
            0 => tr!("{shown} of {count}", shown, count),
            selected => tr!(
                "{shown} of {count}, {selected} selected",
                shown,
                count,
                selected
            ),
        },
        sort: view.sort.filter(|&sort| is_sorted(&rows, sort)),
        rows,
        filter: view.filter.clone(),
        at: view.at,
        selected,
        banner,
    })
}

/// The rows that are copied: those selected, else all that are shown; tabs between their cells.
pub fn copied(state: &State) -> String {
    let Some(table) = table(state) else {
        return String::new();
    };
    let mut lines = vec![Column::ALL.map(Column::name).join("\t")];
    let rows = table
        .rows
        .iter()
        .filter(|row| table.selected == 0 || row.is_selected);
    lines.extend(rows.map(|row| {
        let cells: Vec<&str> = row.cells.iter().map(|cell| cell.text.as_str()).collect();
        cells.join("\t")
    }));
    lines.join("\n")
}

/// All robots of the scene as a table for a file, for spreadsheets.
pub(crate) fn csv(state: &State) -> String {
    let heads = Column::ALL.map(|column| csv::text(column.name())).to_vec();
    let results = results(state);
    let agents = state.document.draft.agents().iter().enumerate();
    let rows = agents.map(|(index, agent)| {
        let result = results.get(index).copied().flatten();
        let written = row(state, Some((index, agent)), result, None).cells;
        written.iter().map(|it| csv::text(&it.text)).collect()
    });
    csv::table(std::iter::once(heads).chain(rows))
}

impl Row {
    pub(super) fn text(&self, column: Column) -> Option<&str> {
        let place = Column::ALL.iter().position(|&other| other == column)?;
        self.cells.get(place).map(|cell| cell.text.as_str())
    }
}

/// Each robot of the scene and each that was given, in a row.
pub(super) fn all_rows(state: &State) -> Vec<Row> {
    let draft = &state.document.draft;
    let waiting = state.view.robots.waiting.as_ref();
    let given = waiting.map_or(&[][..], |waiting| &waiting.given);
    let faults = if given.is_empty() {
        Vec::new()
    } else {
        take(draft, given).faults
    };
    let of = |target: Target| {
        let at = given.iter().position(|given| given.target == target)?;
        Some((given.get(at)?, faults.get(at)?))
    };
    let results = results(state);
    let old = draft.agents().iter().enumerate().map(|(index, agent)| {
        let result = results.get(index).copied().flatten();
        row(state, Some((index, agent)), result, of(Target::Old(index)))
    });
    let news = given
        .iter()
        .zip(&faults)
        .filter(|(given, _)| given.target == Target::New);
    let news = news.map(|pair| row(state, None, None, Some(pair)));
    old.chain(news).collect()
}

fn row(
    state: &State,
    old: Option<(usize, &Agent)>,
    result: Option<(u32, usize)>,
    given: Option<(&Given, &Vec<Fault>)>,
) -> Row {
    let faults = given.map_or_else(Vec::new, |(_, faults)| faults.clone());
    let cell = |&column: &Column| {
        let typed = given.and_then(|(given, _)| given.cells.get(&column));
        let own = old.map_or_else(String::new, |(_, agent)| own_text(agent, column));
        let text = match column {
            Column::Arrives => result.map(|(arrival, _)| arrival.to_string()),
            Column::Waits => result.map(|(_, waits)| waits.to_string()),
            _ => typed.cloned(),
        };
        Cell {
            is_new: typed.is_some_and(|typed| *typed != own),
            is_faulty: faults.iter().any(|fault| fault.column == column),
            text: text.unwrap_or(own),
        }
    };
    let name = old.map(|(_, agent)| &agent.name);
    Row {
        agent: old.map(|(index, _)| index),
        cells: Column::ALL.iter().map(cell).collect(),
        is_selected: name.is_some_and(|name| state.view.robots.selected.contains(name)),
        faults,
    }
}

/// What a robot has in a column, as the table writes it.
pub(crate) fn own_text(agent: &Agent, column: Column) -> String {
    let number = |n: Option<u32>| n.map(|n| n.to_string()).unwrap_or_default();
    match column {
        Column::Name => agent.name.clone(),
        Column::Start => written(agent.start),
        Column::Goal => agent.goal.map(written).unwrap_or_default(),
        Column::Waypoints => {
            let cells: Vec<String> = agent.waypoints.iter().copied().map(written).collect();
            cells.join("; ")
        }
        Column::Battery => number(agent.battery.map(|battery| battery.capacity)),
        Column::Level => number(agent.battery.map(|battery| battery.initial)),
        Column::Arrives | Column::Waits => String::new(),
    }
}

/// When each robot arrives in the plan of the scene, and how long it waits.
fn results(state: &State) -> Vec<Option<(u32, usize)>> {
    let Some(answer) = state.document.fresh_answer() else {
        return Vec::new();
    };
    let draft = &state.document.draft;
    let result = |index: usize| {
        let lane = Lane::of(answer, answer.agent(draft, index)?)?;
        Some((lane.arrival, lane.waits()))
    };
    (0..draft.agents().len()).map(result).collect()
}
