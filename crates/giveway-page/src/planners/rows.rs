//! The table of planners: a row for each that was run on the scene.

use giveway_model::tr;
use giveway_model::words::decimal;
use std::rc::Rc;

use giveway_model::words::{grouped, name};
use giveway_solve::words::headline;
use giveway_solve::{SolveAnswer, Status};

use super::{By, End, Runs};
use crate::{Answer, State};

/// The table.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    /// The rows, the search for the best plan first.
    pub rows: Vec<Row>,
    /// What its columns are, in a sentence.
    pub remark: String,
}

/// A row.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// Who planned.
    pub by: By,
    /// Their name.
    pub title: &'static str,
    /// What is told of the plan; why there is none, as a sentence.
    pub plan: Result<RowPlan, String>,
    /// The time that it took: `12 ms`.
    pub time: String,
    /// How many steps.
    pub steps: String,
    /// What these steps are; empty where there are none.
    pub what: &'static str,
}

/// What is told of the plan of a row.
#[derive(Clone, Debug, PartialEq)]
pub struct RowPlan {
    /// The costs of the objective: `18, 35, 3`.
    pub costs: String,
    /// What is proved.
    pub proved: Proved,
    /// Where it is shown.
    pub place: Place,
}

/// What is proved of a plan.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Proved {
    /// Nothing.
    Nothing,
    /// No plan has less of the first cost than this, and it may be that none has as
    /// little.
    AtLeast(u32),
    /// No plan has less of the first cost, which is this.
    Least(u32),
    /// No plan is better.
    Best,
}

/// Where a plan is shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    /// Nowhere.
    Nowhere,
    /// On the board.
    Board,
    /// Beside the one on the board.
    Beside,
}

/// The table; `None` where no planner was run on the scene on the board, and while
/// something else is done with the plan.
pub fn table(state: &State) -> Option<Table> {
    let document = &state.document;
    if !document.mode.is_editing() {
        return None;
    }
    let runs = Runs::of(document);
    runs.planned.first()?;
    let none = || "\u{2013}".to_owned();
    let search = runs.search.as_ref().map(|answer| Row {
        by: By::Search,
        title: tr!("Exact search"),
        plan: if answer.plan().is_some() {
            Ok(plan(state, answer))
        } else {
            let objective = &document.draft.scene().objective;
            Err(headline(objective, &answer.solved).to_string())
        },
        time: time(answer.solved.stats.cpu_seconds),
        steps: none(),
        what: "",
    });
    let planned = runs.planned.iter().map(|run| {
        let steps = run.stats.map(|stats| stats.steps);
        Row {
            by: By::Planner(run.planner),
            title: run.planner.title(),
            plan: match &run.end {
                End::Plan(answer) => Ok(plan(state, answer)),
                End::Nothing(sentence) => Err(sentence.clone()),
            },
            time: run.stats.map_or_else(none, |stats| time(stats.cpu_seconds)),
            steps: steps.map_or_else(none, grouped),
            what: steps.map_or("", |steps| run.planner.steps(steps)),
        }
    });
    let rows = search.into_iter().chain(planned).collect();
    let costs = document.draft.scene().objective.costs();
    let names: Vec<&str> = costs.iter().map(|&cost| name(cost)).collect();
    let first = names.first().copied().unwrap_or_default();
    let names = names.join(", ");
    let remark = tr!(
        "Costs: {costs}. At least: proved of {first}.",
        costs = names,
        first
    );
    Some(Table { rows, remark })
}

fn plan(state: &State, answer: &Rc<Answer>) -> RowPlan {
    let SolveAnswer { costs, bounds, .. } = &answer.solved;
    let costs = costs.unwrap_or_default();
    let objective = answer.draft.scene().objective.costs();
    let values: Vec<String> = objective
        .iter()
        .map(|&cost| costs.get(cost).to_string())
        .collect();
    let bound = objective
        .first()
        .and_then(|first| bounds.get_key_value(first));
    let proved = match bound {
        _ if answer.solved.status == Status::Optimal => Proved::Best,
        Some((&first, &bound)) if costs.get(first) <= bound => Proved::Least(bound),
        Some((_, &bound)) => Proved::AtLeast(bound),
        None => Proved::Nothing,
    };
    let is = |other: Option<&Rc<Answer>>| other.is_some_and(|other| Rc::ptr_eq(other, answer));
    let place = if is(state.document.answer.as_ref()) {
        Place::Board
    } else if is(state.beside()) {
        Place::Beside
    } else {
        Place::Nowhere
    };
    RowPlan {
        costs: values.join(", "),
        proved,
        place,
    }
}

/// `12 ms`, `3.4 s`.
fn time(seconds: f64) -> String {
    if seconds < 1.0 {
        format!("{} ms", decimal(seconds * 1000.0, 0))
    } else {
        format!("{} s", decimal(seconds, 1))
    }
}
