//! The methods compared: a column each, in words and numbers.

mod fixes;
mod notes;

use giveway_model::words::Later;
use std::rc::Rc;

use giveway_model::{Cost, Costs, tr, tr_later};
use giveway_solve::change::{Method, MethodAnswer};

use super::{Changing, Tried};
use crate::words::{change, title};
use crate::{Answer, State};

pub use fixes::{Fix, fixes};

use notes::{notes, promise, time};

/// What one method makes of the change.
#[derive(Clone, Debug, PartialEq)]
pub struct Column {
    /// The method: `Tunnel 1`.
    pub title: String,
    /// What became of the old paths; without a plan, what it promises.
    pub promise: String,
    /// Whether no other method has lower costs.
    pub is_least: bool,
    /// Whether it is previewed.
    pub is_chosen: bool,
    /// Its plan, to preview and to adopt.
    pub answer: Option<Rc<Answer>>,
    /// The name of its board.
    pub board: Later,
    /// The costs, those of the objective; empty without a plan.
    pub costs: Vec<CostChange>,
    /// What became of the agents; empty without a plan.
    pub groups: Vec<Group>,
    /// What else there is to say.
    pub notes: Vec<String>,
    /// How long it took.
    pub time: String,
}

impl Column {
    /// Whether it has a plan to preview and to adopt.
    pub const fn has_plan(&self) -> bool {
        self.answer.is_some()
    }
}

/// A cost before and after.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CostChange {
    /// Its name.
    pub title: &'static str,
    /// Of the plan before.
    pub before: Option<u32>,
    /// Of the method's plan.
    pub after: u32,
}

impl CostChange {
    /// The difference as it is shown: `+1`, `same`.
    pub fn difference(&self) -> Option<String> {
        let by = i64::from(self.after) - i64::from(self.before?);
        Some(match by {
            0 => tr!("a cost is the" => "same").to_owned(),
            by => format!("{by:+}").replace('-', "\u{2212}"),
        })
    }
}

/// Agents of which the same became.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Group {
    /// What: `Re-timed`.
    pub title: &'static str,
    /// Who: index and name.
    pub agents: Vec<(usize, String)>,
}

/// The methods side by side; `None` while nothing is compared.
pub fn columns(state: &State) -> Option<Vec<Column>> {
    let compared = state.document.mode.comparing()?;
    let changing = &compared.changing;
    let column = |(index, tried): (usize, &Tried)| {
        let told = &tried.told;
        let has_plan = tried.answer.is_some();
        Column {
            title: change::method(tried.method),
            promise: promise(tried),
            is_least: tried.is_least,
            is_chosen: compared.chosen == Some(index),
            answer: tried.answer.clone(),
            board: board(tried.method),
            costs: told
                .result
                .costs
                .filter(|_| has_plan)
                .map_or_else(Vec::new, |costs| {
                    cost_changes(changing, compared.before, &costs)
                }),
            groups: if has_plan {
                groups(changing, told)
            } else {
                Vec::new()
            },
            notes: notes(tried),
            time: time(told.result.stats.cpu_seconds),
        }
    };
    Some(compared.tried.iter().enumerate().map(column).collect())
}

/// No two boards on the page have the same name, and each method is tried once.
const fn board(method: Method) -> Later {
    match method {
        Method::Revise => tr_later!("Plan by revise"),
        Method::Tunnel(_) => tr_later!("Plan by tunnel"),
        Method::Replan => tr_later!("Plan by replan"),
    }
}

/// The makespan, then what the objective has else.
fn cost_changes(changing: &Changing, before: Option<Costs>, after: &Costs) -> Vec<CostChange> {
    let request = &changing.about.request;
    let objective = request
        .objective
        .as_ref()
        .unwrap_or(&request.scene.objective);
    let others = objective.costs().iter().copied();
    let others = others.filter(|&cost| cost != Cost::Makespan);
    let costs = [Cost::Makespan].into_iter().chain(others);
    costs
        .map(|cost| CostChange {
            title: title(cost),
            before: before.map(|costs| costs.get(cost)),
            after: after.get(cost),
        })
        .collect()
}

fn groups(changing: &Changing, told: &MethodAnswer) -> Vec<Group> {
    let agents = changing.draft().agents();
    let index = |name: &String| agents.iter().position(|agent| agent.name == *name);
    let group = |title: &'static str, names: &[String]| Group {
        title,
        agents: names
            .iter()
            .filter_map(|name| Some((index(name)?, name.clone())))
            .collect(),
    };
    let mut groups = vec![
        group(tr!("robots" => "Kept"), &told.kept),
        group(tr!("robots" => "Re-timed"), &told.retimed),
        group(tr!("robots" => "Re-routed"), &told.rerouted),
        group(tr!("robots" => "New"), &told.added),
    ];
    if !told.freed.is_empty() {
        groups.push(group(tr!("robots" => "Freed"), &told.freed));
    }
    groups
}
