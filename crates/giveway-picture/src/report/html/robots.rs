//! The table of the robots of a report, and their sums.

use std::fmt::Write as _;

use giveway_model::tr;
use giveway_model::words::{duration, grouped};

use super::heading;
use super::tables::{N, begin, cell, end, note, visit};
use crate::report::{Report, RobotRow};
use crate::xml::Escaped;

impl Report {
    pub(super) fn robots_table(&self, html: &mut String) {
        heading(html, tr!("Robots"));
        let has = |is: fn(&RobotRow) -> bool| self.robots.iter().any(is);
        let (waypoints, alone) = (
            has(|row| !row.waypoints.is_empty()),
            has(|row| row.alone.is_some()),
        );
        let mut heads = vec![(tr!("Robot"), ""), (tr!("Start"), "")];
        if waypoints {
            heads.push((tr!("Waypoints, with their times"), "wide"));
        }
        heads.extend([(tr!("Goal"), ""), (tr!("Arrives"), N)]);
        if self.units.is_some() {
            heads.push((tr!("after"), N));
        }
        if alone {
            heads.extend([(tr!("an arrival" => "Alone"), N), (tr!("Delay"), N)]);
        }
        heads.push((tr!("Waits"), N));
        if alone {
            heads.push((tr!("Because of"), "wide"));
        }
        begin(html, "report-robots", &heads);
        for row in &self.robots {
            let _ = write!(html, "<tr><th scope=\"row\">{}</th>", Escaped(&row.name));
            let start = format!("{}, {}", row.start.x, row.start.y);
            let start = match row.begins {
                0 => start,
                time => tr!("{cell} at {time}", cell = start, time),
            };
            cell(html, "", &start);
            if waypoints {
                cell(html, "wide", &visits(row));
            }
            let goal = row.goal.map(|goal| format!("{}, {}", goal.x, goal.y));
            cell(
                html,
                "",
                &goal.unwrap_or_else(|| tr!("anywhere").to_owned()),
            );
            let arrives = match (row.arrives, row.removed) {
                (Some(time), _) => time.to_string(),
                (None, Some(time)) => tr!("removed at {time}", time),
                (None, None) => "\u{2013}".to_owned(),
            };
            cell(html, N, &format!("<b>{}</b>", Escaped(&arrives)));
            if self.units.is_some() {
                let time = row.arrives.and_then(|time| duration(self.units, time));
                cell(html, N, &time.unwrap_or_default());
            }
            let lone = row.alone.as_ref();
            if alone {
                let number = |n: Option<u32>| n.map(|n| n.to_string()).unwrap_or_default();
                cell(html, N, &number(lone.map(|lone| lone.alone)));
                cell(html, N, &number(lone.map(|lone| lone.delay)));
            }
            cell(html, N, &row.waits);
            if alone {
                let passes = lone.map_or("", |lone| &lone.passes);
                cell(html, "wide", &Escaped(passes));
            }
            html.push_str("</tr>\n");
        }
        self.total(html, alone);
        end(html);
        if alone {
            let text = if self.changes.is_empty() {
                tr!(
                    "Alone: the earliest that the robot could arrive, by way of its waypoints, if no other robot were there; it charges only where it must. Because of: which robots, or rules among them, are in the way that it would take then. They share the delay evenly, and need not be those for which it waits in this plan."
                )
            } else {
                tr!(
                    "Alone: the earliest that the robot could arrive, by way of its waypoints, if no other robot were there from the last change on; it charges only where it must. Because of: which robots, or rules among them, are in the way that it would take then. They share the delay evenly, and need not be those for which it waits in this plan."
                )
            };
            note(html, text);
        }
    }

    /// The sums of what is added up, where there is more than one robot; that of the arrivals is
    /// the sum of costs.
    fn total(&self, html: &mut String, alone: bool) {
        if self.robots.len() < 2 {
            return;
        }
        let sum = |of: &dyn Fn(&RobotRow) -> Option<u32>| {
            let each = self.robots.iter().map(of);
            let all: Option<Vec<u32>> = each.collect();
            let sum = all.map(|all| all.into_iter().map(u64::from).sum());
            sum.map(grouped).unwrap_or_default()
        };
        let before = if self.robots.iter().any(|row| !row.waypoints.is_empty()) {
            3
        } else {
            2
        };
        let _ = write!(
            html,
            "</tbody>\n<tbody class=\"total\"><tr><th scope=\"row\">{}</th><td colspan=\"{before}\"></td>",
            Escaped(tr!("of a column" => "Sum"))
        );
        cell(html, N, &sum(&|row| row.arrives));
        if self.units.is_some() {
            cell(html, "", &"");
        }
        if alone {
            cell(
                html,
                N,
                &sum(&|row| row.alone.as_ref().map(|lone| lone.alone)),
            );
            cell(
                html,
                N,
                &sum(&|row| row.alone.as_ref().map(|lone| lone.delay)),
            );
        }
        cell(html, N, &sum(&|row| Some(row.waits)));
        if alone {
            cell(html, "", &"");
        }
        html.push_str("</tr>\n");
    }
}

/// Waypoints with the times of their visits: `10, 5 at 56; 20, 5 at 66`.
fn visits(row: &RobotRow) -> String {
    let visits = row.waypoints.iter().map(|&(cell, time)| match time {
        Some(time) => visit(&(cell, time)),
        None => tr!("{cell} never", cell = format!("{}, {}", cell.x, cell.y)),
    });
    let visits: Vec<String> = visits.collect();
    visits.join("; ")
}
