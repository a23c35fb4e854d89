//! The rules of a scene's own, judged from the plan's table alone.

mod alone;
mod between;
mod penalty;
mod row;

use super::findings::Findings;
use super::walk::Walk;
use crate::condition::Times;
use crate::constraint::{ConstraintKind, InForce};
use crate::{Cell, Grid, Instance, Zone};

use alone::out_of_order;
pub(super) use penalty::penalty;
pub(super) use row::{Move, Row, Start, Wait};

/// Finds all that a plan breaks of the rules of the scene's own.
///
/// A rule that is broken at several times has a violation for each, up to the later of
/// the makespan and the last time that a rule names.
pub(super) fn find(instance: &Instance, walks: &[Walk<'_>], findings: &mut Findings<'_>) {
    let rules: Vec<Judged<'_>> = instance
        .constraints_in_force()
        .map(Judged::always)
        .collect();
    let starts = instance.agents().iter();
    let mut starts = starts.map(|agent| instance.start_state(&agent.name));
    if rules.is_empty() && starts.all(|start| start.closed_cells.is_empty()) {
        return;
    }
    let rows = walks.iter().map(|walk| Row::of_walk(instance, walk));
    let table = Table::new((instance.grid(), instance.zones()), rows.collect(), &rules);
    for rule in &rules {
        table.judge(rule, findings);
    }
    table.judge_closed_cells(instance, findings);
}

/// A rule, and the times at which it is judged.
pub(super) struct Judged<'a> {
    /// The rule, with the agents that it binds.
    pub(super) rule: InForce<'a>,
    /// The times.
    pub(super) span: Times,
    /// The time at which a change added it; who is in its zone then is not counted there
    /// until it has left.
    pub(super) since: Option<u32>,
}

impl<'a> Judged<'a> {
    /// A rule that holds at all times.
    pub(super) fn always(rule: InForce<'a>) -> Self {
        Self {
            rule,
            span: Times::default(),
            since: None,
        }
    }
}

/// The plan as a table: where each agent is at each time.
pub(super) struct Table<'a> {
    grid: &'a Grid,
    zones: &'a [Zone],
    rows: Vec<Row<'a>>,
    /// The time from which on all stay where they are, and nothing changes.
    settled: u32,
    /// The last time that is judged.
    last: u32,
}

impl<'a> Table<'a> {
    /// The table of some agents, judged as long as rules name times.
    pub(super) fn new(
        (grid, zones): (&'a Grid, &'a [Zone]),
        rows: Vec<Row<'a>>,
        rules: &[Judged<'_>],
    ) -> Self {
        let ends = rows.iter().map(Row::settled);
        let settled = ends.chain(rules.iter().filter_map(|rule| rule.since));
        let settled = settled.max().unwrap_or(0);
        let named = rules.iter().map(|rule| {
            let rule = rule.rule.constraint;
            // One that begins with the last time that can be named holds from then on.
            let begin = rule.times().and_then(|times| times.from);
            rule.last_time().max(begin.unwrap_or(0))
        });
        let closed = rows.iter().flat_map(|row| &row.start.closed_cells);
        let closed = closed
            .map(|closed| closed.until)
            .filter(|&until| until < u32::MAX);
        let last = named.chain(closed).fold(settled, u32::max);
        Self {
            grid,
            zones,
            rows,
            settled,
            last,
        }
    }

    /// The rows of the agents that a rule binds.
    fn rows(&self, rule: &InForce<'_>) -> Vec<&Row<'a>> {
        let rows = self.rows.iter();
        rows.filter(|row| rule.agents.contains(&row.agent))
            .collect()
    }

    fn row(&self, name: &str) -> Option<&Row<'a>> {
        self.rows.iter().find(|row| row.name == name)
    }

    fn area(&self, zone: &str) -> Area<'a> {
        Area::new(self.grid, self.zones.iter().find(|it| it.name == zone))
    }

    /// Finds all that breaks one rule.
    pub(super) fn judge(&self, judged: &Judged<'_>, findings: &mut Findings<'_>) {
        let rule = &judged.rule;
        let rows = self.rows(rule);
        let mut broken = Broken { judged, findings };
        match &rule.constraint.kind {
            ConstraintKind::Capacity { zone, most, times } => {
                self.crowded(&rows, &self.area(zone), (*most, *times), &mut broken);
            }
            ConstraintKind::Closed { zone, times } => {
                self.entered(&rows, &self.area(zone), *times, &mut broken);
            }
            ConstraintKind::OneWay { lane } => alone::against(&rows, lane, &mut broken),
            ConstraintKind::Gap { steps } => self.too_soon(&rows, *steps, &mut broken),
            ConstraintKind::Apart { distance, times } => {
                self.too_near(&rows, (*distance, *times), &mut broken);
            }
            ConstraintKind::Sequence { cells, .. } => out_of_order(&rows, cells, &mut broken),
            ConstraintKind::Visit { cell, stay, times } => {
                alone::not_visited(&rows, *cell, (*stay, *times), &mut broken);
            }
            ConstraintKind::Arrive { times } => alone::arrived(&rows, *times, &mut broken),
            ConstraintKind::Depart { from } => alone::departed(&rows, *from, &mut broken),
            ConstraintKind::Before { first, second } => {
                if let (Some(one), Some(other)) = (self.row(&first.agent), self.row(&second.agent))
                {
                    self.not_before((one, first.cell), (other, second.cell), &mut broken);
                }
            }
            ConstraintKind::NoWaiting { zone, most } => {
                alone::waited(&rows, &self.area(zone), *most, &mut broken);
            }
            ConstraintKind::Turns { quarter } => alone::turned(&rows, *quarter, &mut broken),
            // These forbid nothing.
            ConstraintKind::Late { .. } | ConstraintKind::Avoid { .. } => {}
        }
    }

    /// Finds agents at cells that are closed to them for what others did before time 0.
    fn judge_closed_cells(&self, instance: &Instance, findings: &mut Findings<'_>) {
        for row in &self.rows {
            for closed in &row.start.closed_cells {
                let Some(constraint) = instance.constraints().get(closed.rule) else {
                    continue;
                };
                let judged = Judged::always(InForce {
                    index: closed.rule,
                    constraint,
                    agents: vec![row.agent],
                });
                let mut broken = Broken {
                    judged: &judged,
                    findings,
                };
                for time in 0..=closed.until.min(self.last) {
                    if row.at(time) == Some(closed.cell) {
                        broken.at(time, &[row.agent], vec![closed.cell]);
                    }
                }
            }
        }
    }
}

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
    judged: &'r Judged<'r>,
    findings: &'f mut Findings<'n>,
}

impl Broken<'_, '_, '_> {
    /// Notes a violation, where the rule is judged at its time.
    fn at(&mut self, time: u32, agents: &[usize], cells: Vec<Cell>) {
        if self.judged.span.contains(time) {
            let rule = &self.judged.rule;
            self.findings.push_constraint(rule, time, agents, cells);
        }
    }

    /// Whether nothing that an agent does after the rule is gone can make up for what it did
    /// not do before.
    fn is_settled(&self, row: &Row<'_>) -> bool {
        let until = self.judged.span.to.map(|last| last.saturating_add(1));
        until.is_none_or(|until| row.gone.is_some_and(|gone| gone <= until))
    }

    /// Notes what was never done, up to an arrival: a rule that was added later is judged
    /// from then on.
    fn never_done(&mut self, row: &Row<'_>, cell: Cell) {
        let time = row.arrival.max(self.judged.span.first());
        if self.is_settled(row) {
            self.at(time, &[row.agent], vec![cell]);
        }
    }

    fn is_full(&self) -> bool {
        self.findings.is_full()
    }
}
