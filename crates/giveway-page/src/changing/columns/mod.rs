//! The methods compared: a column each, in words and numbers.

mod fixes;
mod notes;

use std::rc::Rc;

use giveway_model::change::What;
use giveway_model::words::{Later, and};
use giveway_model::{Cost, Costs, tr, tr_later};
use giveway_solve::change::{Method, MethodAnswer};

use super::compared::objective;
use super::{Changing, Tried};
use crate::words::{change, title};
use crate::{Answer, State};

pub use fixes::{Fix, fixes};

use notes::{notes, promise, time};

/// What one method makes of the change.
#[derive(Clone, Debug, PartialEq)]
pub struct Column {
    /// Its place among those that answered.
    pub index: usize,
    /// The method, and further ones that found the same plan: `Near the old paths`.
    pub titles: Vec<&'static str>,
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
    /// Whom the costs count, where that is not as before; empty without a plan.
    pub counted: Vec<String>,
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
    /// Whether both count the same robots: a robot that is gone is no gain.
    pub counts_all: bool,
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
    /// What: `New times`.
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
            index,
            titles: vec![change::method(tried.method)],
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
            counted: [left_out(changing), joined(changing)]
                .into_iter()
                .flatten()
                .filter(|_| has_plan)
                .collect(),
            notes: notes(tried),
            time: time(told.result.stats.cpu_seconds),
        }
    };
    let mut columns: Vec<Column> = Vec::new();
    for (index, tried) in compared.tried.iter().enumerate() {
        let mut column = column((index, tried));
        let before = columns.iter_mut().find(|before| {
            before
                .answer
                .as_ref()
                .is_some_and(|answer| is_same(answer, tried))
        });
        if let Some(before) = before {
            before.titles.append(&mut column.titles);
            before.is_chosen |= column.is_chosen;
            continue;
        }
        let dear = columns
            .iter()
            .find(|before| before.has_plan() && before.costs == column.costs);
        if let Some(before) = dear.filter(|_| column.has_plan()) {
            let name = before.titles.first().copied().unwrap_or_default();
            column
                .notes
                .insert(0, tr!("No better: it costs the same as “{name}”.", name));
        }
        columns.push(column);
    }
    Some(columns)
}

/// Whether a method found the plan of an answer, too: the same cells, times and charges.
fn is_same(answer: &Rc<Answer>, tried: &Tried) -> bool {
    let plans = answer
        .plan()
        .zip(tried.answer.as_ref().and_then(|other| other.plan()));
    plans.is_some_and(|(one, other)| one == other)
}

/// No two boards on the page have the same name, and each method is tried once.
const fn board(method: Method) -> Later {
    match method {
        Method::Revise => tr_later!("Plan with new times"),
        Method::Tunnel(_) => tr_later!("Plan near the old paths"),
        Method::Replan => tr_later!("Plan with everything new"),
    }
}

/// The makespan, then what the objective has else.
fn cost_changes(changing: &Changing, before: Option<Costs>, after: &Costs) -> Vec<CostChange> {
    objective(changing)
        .into_iter()
        .map(|cost| CostChange {
            title: title(cost),
            before: before.map(|costs| costs.get(cost)),
            after: after.get(cost),
            counts_all: gone(changing).is_empty(),
        })
        .collect()
}

/// The robots that are gone from now on.
fn gone(changing: &Changing) -> Vec<String> {
    let gone = changing.list.iter().filter_map(|what| match what {
        What::RemoveAgent { agent } | What::StopAgent { agent } => Some(agent.clone()),
        What::AddAgent { .. }
        | What::AddObstacle { .. }
        | What::RemoveObstacle { .. }
        | What::MoveObstacle { .. }
        | What::SetSlow { .. }
        | What::SetNormal { .. }
        | What::AddCharger { .. }
        | What::RemoveCharger { .. }
        | What::SetGoal { .. }
        | What::AddWaypoint { .. }
        | What::DropWaypoint { .. }
        | What::SetBattery { .. }
        | What::DelayAgent { .. }
        | What::AddConstraint { .. }
        | What::RemoveConstraint { .. } => None,
    });
    gone.collect()
}

/// That the sum of costs counts a robot that joins as all others.
fn joined(changing: &Changing) -> Option<String> {
    if !objective(changing).contains(&Cost::SumOfCosts) {
        return None;
    }
    let mut names = Vec::new();
    for what in &changing.list {
        if let What::AddAgent { agent } = what {
            names.push(agent.name.clone());
        }
    }
    (!names.is_empty()).then(|| {
        tr!(
            "The sum counts {robots} from time 0 on.",
            robots = and(&names)
        )
    })
}

/// That the costs of a plan are those of the robots that are left.
fn left_out(changing: &Changing) -> Option<String> {
    let gone = gone(changing);
    (!gone.is_empty()).then(|| {
        tr!(
            "Without {robots}, whose task is not done."
                | "Without {robots}, whose tasks are not done." % gone.len(),
            robots = and(&gone)
        )
    })
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
        group(tr!("robots" => "As before"), &told.kept),
        group(tr!("robots" => "New times"), &told.retimed),
        group(tr!("robots" => "New paths"), &told.rerouted),
        group(tr!("robots" => "New"), &told.added),
    ];
    if !told.freed.is_empty() {
        groups.push(group(tr!("robots" => "Freed"), &told.freed));
    }
    groups
}
