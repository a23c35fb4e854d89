//! The table of times, cells and battery levels, as the papers print it: a
//! column a time, wrapped into blocks; for each agent a row of cells and, where
//! it has a battery, a row of levels.

mod blocks;
mod rows;
#[cfg(test)]
mod tests;

use std::fmt::Write as _;

use giveway_model::{
    Instance, Plan,
    change::{History, Trajectory},
    check::{arrivals, levels_over_time},
};

use super::plain;
use blocks::{blocks, legend};
use rows::{agent_rows, life_rows, rows, tell_apart};

/// With more agents, only the arrivals are listed.
const MAX_AGENTS: usize = 40;
/// Names are cut to so many columns.
const NAME_COLUMNS: usize = 16;
/// Longer plans are not told step by step.
const MAX_TIMES: usize = 2000;
const TOO_LARGE: &str =
    "The plan is too large for a table of times; --format json shows all of it.\n";

/// Draws the table of a plan, in lines of at most so many columns.
///
/// The plan may be broken: what it has is drawn as it is.
pub(crate) fn draw(instance: &Instance, plan: &Plan, columns: usize) -> String {
    let mut plan = plan.clone();
    plan.cut_trailing_goals(instance);
    let mut rows = if instance.agents().len() > MAX_AGENTS {
        Vec::new()
    } else {
        rows(instance, &plan)
    };
    tell_apart(&mut rows);
    let times = rows.iter().map(|row| row.entries.len()).max().unwrap_or(0);
    if instance.agents().is_empty() {
        String::new()
    } else if rows.is_empty() || times > MAX_TIMES {
        summary(instance, &plan)
    } else {
        blocks(&rows, times, columns) + &legend(&rows)
    }
}

/// Draws the table of a plan around which the world changes, in absolute times.
pub(crate) fn draw_over_time(history: &History, plan: &Plan, columns: usize) -> String {
    let timelines = history.timelines();
    let mut rows = Vec::new();
    for trajectory in timelines
        .iter()
        .filter_map(|timeline| Trajectory::of(history, timeline, plan))
    {
        let timeline = trajectory.timeline;
        let from = timeline.from as usize;
        let levels = levels_over_time(history, &trajectory);
        rows.append(&mut life_rows(
            timeline.name(),
            from,
            trajectory.path,
            trajectory.charges,
            &levels,
        ));
    }
    tell_apart(&mut rows);
    let times = rows.iter().map(|row| row.entries.len()).max().unwrap_or(0);
    if timelines.is_empty() {
        String::new()
    } else if timelines.len() > MAX_AGENTS || times > MAX_TIMES {
        TOO_LARGE.to_owned()
    } else {
        blocks(&rows, times, columns) + &legend(&rows)
    }
}

/// Draws a plan with another one beside it: agents that do something else have
/// their other row below their own, what differs marked.
pub(crate) fn beside(instance: &Instance, plan: &Plan, other: &Plan, columns: usize) -> String {
    let cut = |plan: &Plan| {
        let mut plan = plan.clone();
        plan.cut_trailing_goals(instance);
        plan
    };
    let (plan, other) = (cut(plan), cut(other));
    if instance.agents().len() > MAX_AGENTS {
        return summary(instance, &other);
    }
    let mut rows = Vec::new();
    for i in 0..instance.agents().len() {
        let mut own = agent_rows(instance, i, &plan);
        let mut others = agent_rows(instance, i, &other);
        let same = own.len() == others.len()
            && own.iter().zip(&others).all(|(a, b)| a.entries == b.entries);
        if !same {
            for (k, row) in others.iter_mut().enumerate() {
                let before = own.get(k).map_or(&[][..], |row| row.entries.as_slice());
                // Levels differ all the time; of their row only charges count.
                row.mark_differences(before, k > 0);
                let label = if k > 0 { "    level" } else { "  other" };
                label.clone_into(&mut row.label);
            }
            own.append(&mut others);
        }
        rows.append(&mut own);
    }
    tell_apart(&mut rows);
    let times = rows.iter().map(|row| row.entries.len()).max().unwrap_or(0);
    if times > MAX_TIMES {
        return summary(instance, &other);
    }
    let differ = rows.iter().any(|row| row.label == "  other");
    let words = if differ {
        "  other: what the robot does in the other plan; ! marks a difference\n"
    } else {
        ""
    };
    blocks(&rows, times, columns) + &legend(&rows) + words
}

/// Where each agent starts and ends, and when it arrives.
fn summary(instance: &Instance, plan: &Plan) -> String {
    let mut text = format!(
        "{:NAME_COLUMNS$} {:>11} {:>11} {:>8} {:>8}\n",
        "robot", "start", "goal", "arrival", "charges"
    );
    for (agent, arrival) in instance.agents().iter().zip(arrivals(instance, plan)) {
        let name = plain::cut_middle(&plain::text(&agent.name), NAME_COLUMNS);
        let _ = writeln!(
            text,
            "{} {:>11} {:>11} {:>8} {:>8}",
            plain::pad_right(&name, NAME_COLUMNS),
            agent.start.to_string(),
            agent.goal.map_or("any".to_owned(), |goal| goal.to_string()),
            arrival.map_or("none".to_owned(), |t| t.to_string()),
            plan.charges(&agent.name).len(),
        );
    }
    format!("{text}\n{TOO_LARGE}")
}
