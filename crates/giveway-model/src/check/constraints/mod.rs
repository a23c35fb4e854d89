//! The rules of a scene's own, judged from the plan's table alone.

mod alone;
mod between;

use super::findings::Findings;
use super::walk::Walk;
use crate::constraint::{ConstraintKind, InForce};
use crate::{Cell, Grid, Instance, Zone};

/// Finds all that a plan breaks of the rules of the scene's own.
///
/// A rule that is broken at several times has a violation for each, up to the later of
/// the makespan and the last time that a rule names.
pub(super) fn find(instance: &Instance, walks: &[Walk<'_>], findings: &mut Findings<'_>) {
    let arrivals = walks.iter().map(|walk| walk.arrival() as u32);
    let named = instance.constraints_in_force();
    let last = named.map(|rule| rule.constraint.last_time());
    let makespan = arrivals.clone().max().unwrap_or(0);
    let table = Table {
        instance,
        walks,
        makespan,
        last: makespan.max(last.max().unwrap_or(0)),
    };
    for rule in instance.constraints_in_force() {
        table.judge(&rule, findings);
    }
}

/// What the rules of the scene's own make the walks of a plan cost.
pub(super) fn penalty(instance: &Instance, walks: &[Walk<'_>]) -> u32 {
    let table = Table {
        instance,
        walks,
        makespan: 0,
        last: 0,
    };
    let rules = instance.constraints_in_force();
    let penalties = rules.map(|rule| match &rule.constraint.kind {
        ConstraintKind::Avoid { zone, weight } => {
            let area = table.area(zone);
            let times = |row: Row<'_>| {
                let times = 0..row.walk.arrival() as u32;
                times
                    .filter(|&time| row.touches(time).any(|cell| area.has(cell)))
                    .count() as u32
            };
            let times = table.rows(&rule).into_iter().map(times);
            times.fold(0, u32::saturating_add).saturating_mul(*weight)
        }
        ConstraintKind::Late { by, weight } => {
            let late = |row: Row<'_>| (row.walk.arrival() as u32).saturating_sub(*by);
            let late = table.rows(&rule).into_iter().map(late);
            late.fold(0, u32::saturating_add).saturating_mul(*weight)
        }
        ConstraintKind::Capacity { .. }
        | ConstraintKind::Closed { .. }
        | ConstraintKind::OneWay { .. }
        | ConstraintKind::Gap { .. }
        | ConstraintKind::Apart { .. }
        | ConstraintKind::Sequence { .. }
        | ConstraintKind::Visit { .. }
        | ConstraintKind::Arrive { .. }
        | ConstraintKind::Depart { .. }
        | ConstraintKind::Before { .. }
        | ConstraintKind::NoWaiting { .. }
        | ConstraintKind::Turns { .. } => 0,
    });
    penalties.fold(0, u32::saturating_add)
}

/// The plan as a table: where each agent is at each time.
struct Table<'a> {
    instance: &'a Instance,
    walks: &'a [Walk<'a>],
    makespan: u32,
    /// The last time that is judged.
    last: u32,
}

/// A row of the table.
#[derive(Clone, Copy)]
struct Row<'a> {
    /// The agent's number in the instance.
    agent: usize,
    walk: &'a Walk<'a>,
    /// Whether it stays where it arrives.
    stays: bool,
    /// Where it comes from, where it is in transit at time 0.
    before: Option<Cell>,
}

impl Row<'_> {
    /// The cell that it is at; `None` in transit, and once it is gone.
    fn at(&self, time: u32) -> Option<Cell> {
        let time = time as usize;
        if time <= self.walk.arrival() {
            self.walk.at(time)
        } else {
            self.walk.end().filter(|_| self.stays)
        }
    }

    /// The cells that count for a zone or a distance: both ends of its edge in transit.
    fn touches(&self, time: u32) -> impl Iterator<Item = Cell> + '_ {
        let is_gone = time as usize > self.walk.arrival() && !self.stays;
        let here = self.at(time);
        let is_along = here.is_none() && !is_gone;
        let before = match time.checked_sub(1) {
            Some(before) => self.at(before),
            None => self.before,
        };
        let ends = [before, self.at(time.saturating_add(1))];
        here.into_iter()
            .chain(ends.into_iter().flatten().filter(move |_| is_along))
    }
}

impl<'a> Table<'a> {
    /// The rows of the agents that a rule binds.
    fn rows(&self, rule: &InForce<'_>) -> Vec<Row<'a>> {
        let rows = self.walks.iter().map(|walk| Row {
            agent: walk.index,
            walk,
            stays: self.instance.keeps(walk.agent),
            before: self.instance.start_state(&walk.agent.name).transit_from,
        });
        rows.filter(|row| rule.agents.contains(&row.agent))
            .collect()
    }

    fn row(&self, agent: &str) -> Option<Row<'a>> {
        let walk = self.walks.iter().find(|walk| walk.agent.name == agent)?;
        Some(Row {
            agent: walk.index,
            walk,
            stays: self.instance.keeps(walk.agent),
            before: self.instance.start_state(agent).transit_from,
        })
    }

    fn area(&self, zone: &str) -> Area<'a> {
        Area::new(self.instance.grid(), self.instance.zone(zone))
    }

    fn judge(&self, rule: &InForce<'_>, findings: &mut Findings<'_>) {
        let rows = self.rows(rule);
        let mut broken = Broken { rule, findings };
        match &rule.constraint.kind {
            ConstraintKind::Capacity { zone, most, times } => {
                self.crowded(&rows, &self.area(zone), (*most, *times), &mut broken);
            }
            ConstraintKind::Closed { zone, times } => {
                self.entered(&rows, &self.area(zone), *times, &mut broken);
            }
            ConstraintKind::OneWay { lane } => self.against(&rows, lane, &mut broken),
            ConstraintKind::Gap { steps } => self.too_soon(&rows, *steps, &mut broken),
            ConstraintKind::Apart { distance, times } => {
                self.too_near(&rows, (*distance, *times), &mut broken);
            }
            ConstraintKind::Sequence { cells, .. } => out_of_order(&rows, cells, &mut broken),
            ConstraintKind::Visit { cell, stay, times } => {
                alone::not_visited(&rows, *cell, (*stay, *times), &mut broken);
            }
            ConstraintKind::Arrive { times } => alone::arrived(&rows, *times, &mut broken),
            ConstraintKind::Depart { from } => self.departed(&rows, *from, &mut broken),
            ConstraintKind::Before { first, second } => {
                if let (Some(one), Some(other)) = (self.row(&first.agent), self.row(&second.agent))
                {
                    self.not_before((one, first.cell), (other, second.cell), &mut broken);
                }
            }
            ConstraintKind::NoWaiting { zone, most } => {
                self.waited(&rows, &self.area(zone), *most, &mut broken);
            }
            ConstraintKind::Turns { quarter } => self.turned(&rows, *quarter, &mut broken),
            // These forbid nothing.
            ConstraintKind::Late { .. } | ConstraintKind::Avoid { .. } => {}
        }
    }
}

use alone::out_of_order;

/// The cells of a zone, by row.
struct Area<'a> {
    grid: &'a Grid,
    inside: Vec<bool>,
}

impl<'a> Area<'a> {
    fn new(grid: &'a Grid, zone: Option<&Zone>) -> Self {
        let mut inside = vec![false; grid.width() as usize * grid.height() as usize];
        for cell in zone.into_iter().flat_map(Zone::cells) {
            let index = cell.y as usize * grid.width() as usize + cell.x as usize;
            if let Some(inside) = inside.get_mut(index) {
                *inside = true;
            }
        }
        Self { grid, inside }
    }

    fn has(&self, cell: Cell) -> bool {
        let index = cell.y as usize * self.grid.width() as usize + cell.x as usize;
        cell.x < self.grid.width() && self.inside.get(index) == Some(&true)
    }
}

/// Where violations of one rule go.
struct Broken<'r, 'f, 'n> {
    rule: &'r InForce<'r>,
    findings: &'f mut Findings<'n>,
}

impl Broken<'_, '_, '_> {
    fn at(&mut self, time: u32, agents: &[usize], cells: Vec<Cell>) {
        self.findings
            .push_constraint(self.rule, time, agents, cells);
    }

    fn is_full(&self) -> bool {
        self.findings.is_full()
    }
}
