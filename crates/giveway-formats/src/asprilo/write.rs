//! Writes an instance and a plan as facts.
//!
//! Every robot is given one order, in turn: a product on a shelf at each of its
//! waypoints, and a picking station at its goal. So the orders come back to the same
//! robots when the file is read here. Where no robot has anything to do there are no
//! orders. The facts of a plan are written with the places of its robots, so that a
//! robot that never moves is not forgotten.

use crate::limits::refuse;
use std::collections::BTreeMap;
use std::fmt::Write as _;

use crate::loss::{Part, losses};
use crate::whole_steps::WholeSteps;
use crate::write::Job;
use crate::{Format, Move, Written};
use giveway_model::words::count;
use giveway_model::{Agent, Cell, Fault, Instance, Plan, tr};

/// Writes `STEM.lp`, `STEM-plan.lp`, or both.
///
/// # Errors
/// When there is no instance, or a path does not begin at its start, jumps, or is
/// in transit.
pub(crate) fn write(job: &Job<'_>) -> Result<Written, Fault> {
    let Some(instance) = job.instance else {
        let expected = tr!("its instance, too, since asprilo numbers the robots of a scene");
        return refuse(tr!("a plan alone"), expected);
    };
    let (ids, is_renamed) = ids(instance.agents());
    let mut written = Written::default();
    let lost = losses(&[Part::Waypoints], job.instance, job.plan).into_iter();
    let lost = lost.filter(|loss| is_renamed || loss.part != Part::Names);
    written.losses.extend(lost.map(|loss| loss.to_string()));
    written.losses.extend(lost_border(instance));
    let file = (format!("{}.lp", job.stem), scene(instance, &ids));
    written.files.push(file);
    if let Some(plan) = job.plan {
        let facts = moves(instance, plan, &ids)?;
        written.files.push((format!("{}-plan.lp", job.stem), facts));
    }
    Ok(written)
}

/// The number of each robot: that of its name where all are named `A1`, `A2` and
/// so on in ascending order, gaps allowed, else its place in the list; and whether
/// that loses names.
fn ids(agents: &[Agent]) -> (Vec<u32>, bool) {
    let named = |agent: &Agent| {
        let digits = agent.name.strip_prefix('A')?;
        let id = digits.parse::<u32>().ok()?;
        (id >= 1 && i32::try_from(id).is_ok() && id.to_string() == digits).then_some(id)
    };
    let ids: Option<Vec<u32>> = agents.iter().map(named).collect();
    match ids {
        Some(ids) if ids.is_sorted_by(|one, next| one < next) => (ids, false),
        _ => ((1..).take(agents.len()).collect(), true),
    }
}

/// Rows and columns of obstacles at the right and below: no node tells of them.
fn lost_border(instance: &Instance) -> Option<String> {
    let grid = instance.grid();
    let vertices = || grid.cells().filter(|(_, ground)| ground.is_vertex());
    let columns = vertices().map(|(cell, _)| cell.x + 1).max().unwrap_or(0);
    let rows = vertices().map(|(cell, _)| cell.y + 1).max().unwrap_or(0);
    let (columns, rows) = (grid.width() - columns, grid.height() - rows);
    match (columns, rows) {
        (0, 0) => None,
        (columns, 0) => Some(format!(
            "{} of obstacles at the right",
            count(columns, "column")
        )),
        (0, rows) => Some(format!("{} of obstacles at the bottom", count(rows, "row"))),
        (columns, rows) => Some(format!(
            "{} of obstacles at the right and {} at the bottom",
            count(columns, "column"),
            count(rows, "row")
        )),
    }
}

fn at(text: &mut String, kind: &str, id: impl std::fmt::Display, cell: Cell) {
    let (x, y) = (cell.x + 1, cell.y + 1);
    // Writing to a string does not fail.
    let _ = writeln!(text, "init(object({kind},{id}),value(at,({x},{y}))).");
}

/// Numbers cells from 1 in the order in which they are asked for.
#[derive(Default)]
struct Numbered(BTreeMap<Cell, usize>);

impl Numbered {
    fn id(&mut self, cell: Cell) -> usize {
        let next = self.0.len() + 1;
        *self.0.entry(cell).or_insert(next)
    }

    fn in_order(self) -> Vec<Cell> {
        let mut cells: Vec<(Cell, usize)> = self.0.into_iter().collect();
        cells.sort_by_key(|&(_, id)| id);
        cells.into_iter().map(|(cell, _)| cell).collect()
    }
}

fn scene(instance: &Instance, ids: &[u32]) -> String {
    let grid = instance.grid();
    let (width, height) = (grid.width(), grid.height());
    let mut text = format!("% Grid Size X: {width}\n% Grid Size Y: {height}\n#program base.\n\n");
    for (cell, ground) in grid.cells() {
        if ground.is_vertex() {
            let id = u64::from(cell.y) * u64::from(width) + u64::from(cell.x) + 1;
            at(&mut text, "node", id, cell);
        }
    }
    for (agent, id) in instance.agents().iter().zip(ids) {
        at(&mut text, "robot", id, agent.start);
    }
    let is_idle =
        |agent: &Agent| agent.goal_or_start() == agent.start && agent.waypoints.is_empty();
    if instance.agents().iter().all(is_idle) {
        return text;
    }
    let (mut shelves, mut stations) = (Numbered::default(), Numbered::default());
    let mut orders = String::new();
    let mut units: BTreeMap<usize, usize> = BTreeMap::new();
    for (i, agent) in instance.agents().iter().enumerate() {
        let order = i + 1;
        for &cell in &agent.waypoints {
            let product = shelves.id(cell);
            *units.entry(product).or_default() += 1;
            let _ = writeln!(
                orders,
                "init(object(order,{order}),value(line,({product},1)))."
            );
        }
        let station = stations.id(agent.goal_or_start());
        let _ = writeln!(
            orders,
            "init(object(order,{order}),value(pickingStation,{station}))."
        );
    }
    for (i, cell) in shelves.in_order().into_iter().enumerate() {
        at(&mut text, "shelf", i + 1, cell);
    }
    for (i, cell) in stations.in_order().into_iter().enumerate() {
        at(&mut text, "pickingStation", i + 1, cell);
    }
    for (product, units) in units {
        let _ = writeln!(
            text,
            "init(object(product,{product}),value(on,({product},{units})))."
        );
    }
    text + &orders
}

fn moves(instance: &Instance, plan: &Plan, ids: &[u32]) -> Result<String, Fault> {
    let steps = WholeSteps::new(instance, plan, Format::Asprilo)?;
    steps.some(Format::Asprilo)?;
    let mut text = String::new();
    for ((agent, id), moves) in instance
        .agents()
        .iter()
        .zip(ids)
        .zip(steps.moves(instance)?)
    {
        at(&mut text, "robot", id, agent.start);
        for (time, step) in (1..).zip(moves) {
            let (x, y) = step.offset();
            if step == Move::Wait {
                continue;
            }
            let _ = writeln!(
                text,
                "occurs(object(robot,{id}),action(move,({x},{y})),{time})."
            );
        }
    }
    Ok(text)
}
