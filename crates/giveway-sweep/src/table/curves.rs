//! The curves of plots, as points.

use std::collections::BTreeMap;

use super::{Sheet, budget, has_budgets, objective};
use crate::{Row, RowStatus};

/// One curve: of one planner, and one objective and one budget where there are several.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    /// Its name in the legend.
    pub name: String,
    /// Its points, from left to right.
    pub points: Vec<(f64, f64)>,
}

/// The success rate: the share of tasks that succeeded, against the number of agents: a curve for
/// each planner and objective, over all maps. Tasks without an instance, such as those with
/// more agents than a scenario has, are not counted: nobody could succeed.
pub fn success(rows: &[Row]) -> Vec<Curve> {
    let curve = |rows: &[&Row]| {
        let mut counts: BTreeMap<usize, (u32, u32)> = BTreeMap::new();
        for row in rows {
            if let Some(agents) = row.agents {
                let (closed, tasks) = counts.entry(agents).or_default();
                *closed += u32::from(row.is_success());
                *tasks += 1;
            }
        }
        let share =
            |(agents, (closed, tasks))| (agents as f64, f64::from(closed) / f64::from(tasks));
        counts.into_iter().map(share).collect()
    };
    curves(rows, curve)
}

/// The cactus plot: within how many CPU seconds each how many tasks succeeded.
pub fn cactus(rows: &[Row]) -> Vec<Curve> {
    let curve = |rows: &[&Row]| {
        let closed = rows.iter().filter(|row| row.is_success());
        let mut seconds: Vec<f64> = closed.map(|row| row.took.cpu_seconds).collect();
        seconds.sort_by(f64::total_cmp);
        let point = |(index, seconds)| ((index + 1) as f64, seconds);
        seconds.into_iter().enumerate().map(point).collect()
    };
    curves(rows, curve)
}

fn curves(rows: &[Row], curve: impl Fn(&[&Row]) -> Vec<(f64, f64)>) -> Vec<Curve> {
    let mut named: BTreeMap<[String; 3], Vec<&Row>> = BTreeMap::new();
    for row in rows.iter().filter(|row| row.status != RowStatus::Error) {
        let key = [row.planner.to_string(), objective(row), budget(row)];
        named.entry(key).or_default().push(row);
    }
    let mut objectives = named.keys().map(|[_, objective, _]| objective);
    let first = objectives.next();
    let has_objectives = objectives.any(|objective| Some(objective) != first);
    let is_told = [true, has_objectives, has_budgets(rows)];
    let name = |key: &[String; 3]| {
        let parts = key.iter().zip(is_told).filter(|(_, is_told)| *is_told);
        let parts: Vec<&str> = parts.map(|(part, _)| part.as_str()).collect();
        parts.join(", ")
    };
    let named = named.iter().map(|(key, rows)| Curve {
        name: name(key),
        points: curve(rows),
    });
    named.collect()
}

impl Sheet {
    /// The points of curves.
    pub fn of_curves(curves: &[Curve], x: &'static str, y: &'static str) -> Self {
        let mut sheet = Self::new(&["curve", x, y]);
        for curve in curves {
            for (x, y) in &curve.points {
                sheet.push(vec![curve.name.clone(), x.to_string(), format!("{y:.3}")]);
            }
        }
        sheet
    }
}
