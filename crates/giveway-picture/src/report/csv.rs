//! A plan as tables for spreadsheets.

use giveway_model::{csv, tr};

use super::{Report, Subject};

impl Subject<'_> {
    /// Where each robot is at each time up to its arrival, and the level of its battery; in
    /// transit it has no cell.
    pub fn csv(&self) -> String {
        let heads = [
            tr!("Robot"),
            tr!("Time"),
            tr!("a coordinate" => "x"),
            tr!("a coordinate" => "y"),
            tr!("Level"),
        ];
        let heads = heads.map(csv::text).to_vec();
        let rows = self.robots.iter().flat_map(|robot| {
            let begins = self.begins(robot);
            let end = robot.arrives.or(robot.removed).unwrap_or(u32::MAX);
            let name = csv::text(&robot.agent.name);
            let cells = self.plan.path(&robot.agent.name).iter().zip(begins..=end);
            cells.map(move |(cell, time)| {
                let [x, y] = match cell {
                    Some(cell) => [cell.x.to_string(), cell.y.to_string()],
                    None => [String::new(), String::new()],
                };
                let level = robot.levels.get((time - begins) as usize);
                let level = level.map(i64::to_string).unwrap_or_default();
                vec![name.clone(), time.to_string(), x, y, level]
            })
        });
        csv::table(std::iter::once(heads).chain(rows))
    }
}

impl Report {
    /// A line for each robot.
    pub fn csv(&self) -> String {
        let mut heads = vec![
            tr!("Robot"),
            tr!("Start"),
            tr!("Waypoints"),
            tr!("Goal"),
            tr!("Arrives"),
        ];
        if self.units.is_some() {
            heads.push(tr!("Arrives, seconds"));
        }
        let has_alone = self.robots.iter().any(|row| row.alone.is_some());
        if has_alone {
            heads.extend([tr!("an arrival" => "Alone"), tr!("Delay")]);
        }
        heads.extend([
            tr!("Waits"),
            tr!("Charges"),
            tr!("Lowest level"),
            tr!("Level at the goal"),
        ]);
        if has_alone {
            heads.push(tr!("Because of"));
        }
        let heads = heads.into_iter().map(csv::text).collect();
        let rows = self.robots.iter().map(|row| {
            let cell = |cell: &giveway_model::Cell| format!("{}, {}", cell.x, cell.y);
            let waypoints: Vec<String> = row.waypoints.iter().map(|(at, _)| cell(at)).collect();
            let mut cells = vec![
                csv::text(&row.name),
                csv::text(&cell(&row.start)),
                csv::text(&waypoints.join("; ")),
                csv::text(&row.goal.as_ref().map(cell).unwrap_or_default()),
                row.arrives.map(|time| time.to_string()).unwrap_or_default(),
            ];
            if let Some(units) = self.units {
                let seconds = |time: u32| {
                    let thousandths = u64::from(time) * u64::from(units.step.thousandths());
                    decimal(thousandths)
                };
                cells.push(csv::text(&row.arrives.map(seconds).unwrap_or_default()));
            }
            let number = |level: Option<i64>| level.map(|n| n.to_string()).unwrap_or_default();
            let lone = row.alone.as_ref();
            if has_alone {
                cells.push(number(lone.map(|lone| lone.alone.into())));
                cells.push(number(lone.map(|lone| lone.delay.into())));
            }
            cells.push(row.waits.to_string());
            cells.push(row.charges.len().to_string());
            cells.push(number(row.lowest));
            cells.push(number(row.battery.as_ref().and_then(|it| it.at_goal)));
            if has_alone {
                cells.push(csv::text(lone.map_or("", |lone| &lone.passes)));
            }
            cells
        });
        csv::table(std::iter::once(heads).chain(rows))
    }
}

/// Thousandths as a number, with the mark of decimals of a language.
fn decimal(thousandths: u64) -> String {
    let (whole, rest) = (thousandths / 1000, thousandths % 1000);
    if rest == 0 {
        return whole.to_string();
    }
    let rest = format!("{rest:03}");
    let mark = tr!("decimal mark" => ".");
    format!("{whole}{mark}{}", rest.trim_end_matches('0'))
}
