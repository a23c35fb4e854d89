//! Two plans side by side as text.

use std::fmt::Write as _;

use giveway_model::compare::{AgentComparison, Difference, Divergence};
use giveway_model::words::{count, name};
use giveway_model::{Cell, Cost, Instance};

use super::title;
use crate::output::{Compared, plain};

/// So many robots are listed; the rest is counted.
const LISTED: usize = 100;

/// The costs of both, and every robot that differs.
pub(crate) fn compare(instance: &Instance, compared: &Compared) -> String {
    [title(instance), costs(compared), robots(compared)].join("\n")
}

fn costs(compared: &Compared) -> String {
    let names = compared
        .plans
        .each_ref()
        .map(|plan| plain::text(&plan.file));
    let legal = compared.plans.each_ref().map(|plan| match plan.violations {
        0 => "yes".to_owned(),
        n => count(n, "violation"),
    });
    let wide = names.iter().map(|name| plain::width(name).min(40));
    let wide = wide.chain(legal.iter().map(|legal| plain::width(legal)));
    let wide = wide.max().unwrap_or_default().max(8) + 2;
    let mut text = plain::pad_right("", 14);
    for name in &names {
        text += &plain::pad_left(&plain::cut_middle(name, wide - 2), wide);
    }
    text += "  difference\n";
    text += &plain::pad_right("legal", 14);
    for legal in &legal {
        text += &plain::pad_left(legal, wide);
    }
    text.push('\n');
    for cost in Cost::USUAL {
        text += &plain::pad_right(name(cost), 14);
        for costs in &compared.comparison.costs {
            let value = costs.map_or("-".to_owned(), |costs| costs.get(cost).to_string());
            text += &plain::pad_left(&value, wide);
        }
        if let Some(delta) = compared.comparison.deltas.get(&cost) {
            let sign = if *delta == 0 {
                "0".to_owned()
            } else {
                format!("{delta:+}")
            };
            let _ = write!(text, "{sign:>12}");
        }
        text.push('\n');
    }
    text
}

fn robots(compared: &Compared) -> String {
    let agents = &compared.comparison.agents;
    let of = |difference| compared.comparison.with(difference);
    let mut text = format!(
        "{}: {} the same, {} retimed, {} rerouted.\n",
        count(agents.len(), "robot"),
        of(Difference::Same).count(),
        of(Difference::Retimed).count(),
        of(Difference::Rerouted).count()
    );
    let differing = || of(Difference::Rerouted).chain(of(Difference::Retimed));
    for agent in differing().take(LISTED) {
        let _ = writeln!(text, "  {}", plain::text(&sentence(agent)));
    }
    let more = differing().count().saturating_sub(LISTED);
    if more > 0 {
        let _ = writeln!(text, "  and {more} more; --format json shows them all");
    }
    text
}

/// What differs for a robot: `A1 is rerouted from time 3 on: (1, 0), then (0, 1) ...`.
fn sentence(agent: &AgentComparison) -> String {
    let how = match agent.difference {
        Difference::Same => "is the same",
        Difference::Retimed => "is retimed",
        Difference::Rerouted => "is rerouted",
    };
    let parts = agent
        .first
        .map_or(String::new(), |Divergence { time, cells }| {
            let [one, other] = cells.map(place);
            if one == other {
                return format!(": at time {time} it charges in one of the plans only");
            }
            format!(": at time {time} it is {one} in the first plan and {other} in the second")
        });
    let arrives = match agent.arrivals {
        [Some(one), Some(other)] if one == other => format!("; it arrives at time {one} in both"),
        [Some(one), Some(other)] => format!("; it arrives at time {one} and at time {other}"),
        _ => String::new(),
    };
    format!("{} {how}{parts}{arrives}.", agent.agent)
}

fn place(cell: Option<Cell>) -> String {
    cell.map_or("nowhere or in transit".to_owned(), |cell| {
        format!("at {cell}")
    })
}
