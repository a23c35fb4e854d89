//! The tables of a report but for that of the robots.

use std::fmt::{Display, Write as _};

use giveway_model::words::{and, grouped};
use giveway_model::{Cell, Cost, tr};

use super::heading;
use crate::report::{CostRow, Report};
use crate::xml::Escaped;

impl Report {
    pub(super) fn costs_table(&self, html: &mut String) {
        if self.costs.is_empty() {
            return;
        }
        let has = |is: fn(&CostRow) -> bool| self.costs.iter().any(is);
        let (times, bounds, before) = (
            has(|row| row.time.is_some()),
            has(|row| row.at_least.is_some()),
            has(|row| row.before.is_some()),
        );
        let mut heads = vec![(tr!("Cost"), ""), (tr!("This plan"), N)];
        if times {
            heads.push((tr!("In time"), N));
        }
        if bounds {
            heads.push((tr!("Proved at least"), N));
        }
        if before {
            heads.push((tr!("Before the change"), N));
        }
        begin(html, "report-costs", &heads);
        let number = |n: Option<u32>| n.map(|n| grouped(n.into())).unwrap_or_default();
        for row in &self.costs {
            let _ = write!(html, "<tr><th scope=\"row\">{}</th>", title(row.cost));
            cell(html, N, &format!("<b>{}</b>", number(Some(row.value))));
            if times {
                cell(html, N, &row.time.as_deref().unwrap_or_default());
            }
            if bounds {
                cell(html, N, &number(row.at_least));
            }
            if before {
                cell(html, N, &number(row.before));
            }
            html.push_str("</tr>\n");
        }
        end(html);
        if before {
            self.left_out(html);
        }
    }

    /// That the costs are those of the robots that were not removed.
    fn left_out(&self, html: &mut String) {
        let gone = self.robots.iter().filter(|row| row.removed.is_some());
        let gone: Vec<&str> = gone.map(|row| row.name.as_str()).collect();
        if gone.is_empty() {
            return;
        }
        let text = tr!(
            "Without {robots}, whose task is not done."
                | "Without {robots}, whose tasks are not done." % gone.len(),
            robots = and(&gone)
        );
        note(html, &text);
    }

    pub(super) fn changes_table(&self, html: &mut String) {
        if self.changes.is_empty() {
            return;
        }
        heading(html, tr!("Changes"));
        let methods = self.changes.iter().any(|row| row.method.is_some());
        let mut heads = vec![(tr!("At"), ""), (tr!("What changed"), "")];
        if methods {
            heads.push((tr!("Plan used since"), ""));
        }
        begin(html, "report-changes", &heads);
        for row in &self.changes {
            let _ = write!(html, "<tr><th scope=\"row\">{}</th>", row.at);
            cell(html, "", &Escaped(&row.what));
            if methods {
                cell(
                    html,
                    "",
                    &Escaped(row.method.as_deref().unwrap_or_default()),
                );
            }
            html.push_str("</tr>\n");
        }
        end(html);
    }

    pub(super) fn batteries_table(&self, html: &mut String) {
        let with_battery = || {
            let rows = self.robots.iter();
            rows.filter_map(|row| Some((row, row.battery.as_ref()?)))
        };
        if with_battery().next().is_none() {
            return;
        }
        heading(html, tr!("Batteries, in steps"));
        let heads = [
            (tr!("Robot"), ""),
            (tr!("a battery" => "Holds"), N),
            (tr!("a battery" => "At the start"), N),
            (tr!("Least on the way"), N),
            (tr!("where, and when"), ""),
            (tr!("At the goal"), N),
            (tr!("Charges"), N),
            (tr!("Charges at"), "wide"),
        ];
        begin(html, "report-batteries", &heads);
        for (row, battery) in with_battery() {
            let _ = write!(html, "<tr><th scope=\"row\">{}</th>", Escaped(&row.name));
            cell(html, N, &battery.capacity);
            cell(html, N, &battery.initial);
            cell(html, N, &format!("<b>{}</b>", battery.least));
            let least_at = battery.least_at.as_ref().map(visit);
            cell(html, "", &least_at.unwrap_or_default());
            let at_goal = battery.at_goal.map(|level| level.to_string());
            cell(html, N, &at_goal.unwrap_or_default());
            cell(html, N, &row.charges.len());
            let charges: Vec<String> = row.charges.iter().map(visit).collect();
            cell(html, "wide", &charges.join("; "));
            html.push_str("</tr>\n");
        }
        end(html);
        if let Some(rule) = &self.battery_rule {
            note(html, rule);
        }
    }

    pub(super) fn busiest_table(&self, html: &mut String) {
        if self.busiest.is_empty() {
            return;
        }
        heading(html, tr!("Busiest cells"));
        let heads = [
            ("", ""),
            (tr!("Cell"), ""),
            (tr!("Passes"), N),
            (tr!("Robots"), N),
            (tr!("Steps waited there"), N),
        ];
        begin(html, "report-busiest", &heads);
        for busy in &self.busiest {
            let _ = write!(html, "<tr><th scope=\"row\">{}</th>", busy.letter);
            cell(html, "", &format!("{}, {}", busy.cell.x, busy.cell.y));
            cell(html, N, &format!("<b>{}</b>", busy.passes));
            cell(html, N, &busy.robots);
            cell(html, N, &busy.waits);
            html.push_str("</tr>\n");
        }
        end(html);
        let waited = |&(Cell { x, y }, n): &(Cell, u32)| {
            tr!("{x}, {y} ({n} step)" | "{x}, {y} ({n} steps)" % n, x, y)
        };
        let cells: Vec<String> = self.waited.iter().map(waited).collect();
        if !cells.is_empty() {
            note(
                html,
                &tr!("Robots wait longest at {cells}.", cells = and(&cells)),
            );
        }
    }
}

/// The class of numbers.
pub(super) const N: &str = "n";

/// What a cost is called.
fn title(cost: Cost) -> &'static str {
    match cost {
        Cost::Makespan => tr!("Last arrival (makespan)"),
        Cost::SumOfCosts => tr!("Sum of costs"),
        Cost::Charges => tr!("Charges"),
        Cost::Moves => tr!("Moves"),
        Cost::Waits => tr!("Waits"),
        Cost::Penalty => tr!("Penalty"),
    }
}

/// A cell with the time at which a robot is there: `20, 5 at 66`.
pub(super) fn visit((cell, time): &(Cell, u32)) -> String {
    let cell = format!("{}, {}", cell.x, cell.y);
    tr!("{cell} at {time}", cell, time)
}

pub(super) fn note(html: &mut String, text: &str) {
    let _ = writeln!(html, "<p class=\"note\">{}</p>", Escaped(text));
}

/// A table with its heads, which stand on each page anew.
pub(super) fn begin(html: &mut String, class: &str, heads: &[(&str, &str)]) {
    let _ = write!(html, "<table class=\"{class}\"><thead><tr>");
    for (head, class) in heads {
        if head.is_empty() {
            html.push_str("<td></td>");
        } else {
            let _ = write!(
                html,
                "<th scope=\"col\"{}>{}</th>",
                of(class),
                Escaped(head)
            );
        }
    }
    html.push_str("</tr></thead>\n<tbody>\n");
}

pub(super) fn end(html: &mut String) {
    html.push_str("</tbody></table>\n");
}

pub(super) fn cell(html: &mut String, class: &str, text: &dyn Display) {
    let _ = write!(html, "<td{}>{text}</td>", of(class));
}

fn of(class: &str) -> String {
    match class {
        "" => String::new(),
        class => format!(" class=\"{class}\""),
    }
}
