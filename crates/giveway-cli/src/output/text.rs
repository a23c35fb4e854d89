//! Answers as text for people.

mod audit;
mod change;
mod check;
mod compare;
mod delays;
mod explain;
mod freedom;
mod front;
mod grade;
mod order;
mod planned;
mod price;
mod sizing;
mod solve;
mod verify;

pub(crate) use audit::audit;
pub(crate) use change::change;
pub(crate) use check::{check, check_over_time};
pub(crate) use compare::compare;
pub(crate) use delays::delays;
pub(crate) use explain::{explain, explain_over_time};
pub(crate) use freedom::freedom;
pub(crate) use front::front;
pub(crate) use grade::grade;
pub(crate) use order::order;
pub(crate) use planned::planned;
pub(crate) use price::price;
pub(crate) use sizing::sizing;
pub(crate) use solve::solve;
pub(crate) use verify::{verify, verify_all};

use anstyle::{AnsiColor, Style};
use giveway_model::words::count;
use giveway_model::{Instance, Plan};
use giveway_solve::Status;

use super::{map, plain, table};

/// `warehouse: 10 x 3 cells, 2 robots`.
fn title(instance: &Instance) -> String {
    let grid = instance.grid();
    let name = if instance.name().is_empty() {
        "unnamed".to_owned()
    } else {
        plain::text(instance.name())
    };
    let vanish = if instance.stays() {
        ""
    } else {
        ", which vanish at their goals"
    };
    let floor = match instance.rules().battery_floor {
        0 => String::new(),
        floor => format!(", battery floor {floor}"),
    };
    format!(
        "{}: {} x {} cells, {}{vanish}{floor}\n",
        bold(&name),
        grid.width(),
        grid.height(),
        count(instance.agents().len(), "robot")
    )
}

/// The map, and the plan below it.
fn drawings(instance: &Instance, plan: Option<&Plan>, columns: usize) -> String {
    let map = map::draw(instance, columns);
    let table = plan.map_or(String::new(), |plan| table::draw(instance, plan, columns));
    if table.is_empty() {
        map
    } else {
        format!("{map}\n{table}")
    }
}

/// Bold text; the stream takes it away where there is no terminal.
fn bold(text: &str) -> String {
    paint(Style::new().bold(), text)
}

/// The word of a status in its colour.
fn status_word(status: Status, word: &str) -> String {
    let colour = match status {
        Status::Optimal => AnsiColor::Green,
        Status::Feasible | Status::Unknown => AnsiColor::Yellow,
        Status::Impossible => AnsiColor::Red,
    };
    paint(colour.on_default().bold(), word)
}

fn paint(style: Style, text: &str) -> String {
    format!("{style}{text}{style:#}")
}

/// How far a claim reaches: up to a makespan, or for every horizon.
#[cfg(test)]
fn reach_of(within: Option<u32>) -> giveway_solve::Reach {
    let written = serde_json::json!({ "complete": within.is_none(), "within": within });
    serde_json::from_value(written).unwrap()
}

/// What a test compares: the text as it reads without a terminal.
#[cfg(test)]
fn unpainted(text: &str) -> String {
    anstream::adapter::strip_str(text).to_string()
}
