//! The table of planners: a row for each that was run on the scene.

use std::rc::Rc;

use giveway_model::words::{grouped, name};
use giveway_solve::words::headline;
use giveway_solve::{SolveAnswer, Status};

use super::{By, End, Runs};
use crate::{Answer, Mode, State};

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
    /// The proved lower bound of the first cost.
    pub at_least: Option<u32>,
    /// Whether that is the cost of the plan.
    pub is_met: bool,
    /// Whether it is proved that no plan is better.
    pub is_best: bool,
    /// Whether it is on the board.
    pub is_shown: bool,
    /// Whether it is beside the one on the board.
    pub is_beside: bool,
}

/// The table; `None` where no planner was run on the scene on the board, and while
/// something else is done with the plan.
pub fn table(state: &State) -> Option<Table> {
    let document = &state.document;
    if !matches!(document.mode, Mode::Editing) {
        return None;
    }
    let runs = Runs::of(document);
    runs.runs.first()?;
    let none = || "\u{2013}".to_owned();
    let search = runs.search.as_ref().map(|answer| Row {
        by: By::Search,
        title: "Exact search",
        plan: match answer.plan() {
            Some(_) => Ok(plan(state, answer)),
            None => {
                let objective = &document.draft.scene().objective;
                Err(headline(objective, &answer.solved).to_string())
            }
        },
        time: time(answer.solved.stats.cpu_seconds),
        steps: none(),
        what: "",
    });
    let planned = runs.runs.iter().map(|run| {
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
    let mut remark = format!("Costs: {}.", names.join(", "));
    if names.len() > 1 {
        remark += &format!(" At least: of the {first}.");
    }
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
    let first = objective.first();
    let at_least = first.and_then(|first| bounds.get(first)).copied();
    let is = |other: Option<&Rc<Answer>>| other.is_some_and(|other| Rc::ptr_eq(other, answer));
    RowPlan {
        costs: values.join(", "),
        at_least,
        is_met: at_least.is_some() && at_least == first.map(|&first| costs.get(first)),
        is_best: answer.solved.status == Status::Optimal,
        is_shown: is(state.document.answer.as_ref()),
        is_beside: is(state.beside()),
    }
}

/// `12 ms`, `3.4 s`.
fn time(seconds: f64) -> String {
    if seconds < 1.0 {
        format!("{:.0} ms", seconds * 1000.0)
    } else {
        format!("{seconds:.1} s")
    }
}
