//! The plan as it is carried out when agents come late.

use giveway_model::{Path, Plan};

use crate::OrderGraph;
use crate::events::{Stay, Time, Way};
use crate::graph::step;

/// The plan in which each event begins at its time. Without lateness it is the plan itself.
pub(crate) fn late_plan(graph: &OrderGraph<'_>, begins: &[Time]) -> Plan {
    let mut plan = Plan {
        giveway: graph.plan.giveway,
        knows: graph.plan.knows,
        ..Plan::default()
    };
    for way in &graph.ways {
        let carried = Carried { graph, begins, way };
        let name = way.name().to_owned();
        plan.paths.insert(name.clone(), carried.stood());
        if graph.plan.charges.contains_key(&name) {
            plan.charges.insert(name.clone(), carried.charges());
        }
        let from = carried.from();
        if from > 0 {
            plan.from.insert(name.clone(), from);
        }
        if let Some(&until) = graph.plan.until.get(&name) {
            plan.until.insert(name.clone(), until);
        }
        let slept = carried.slept();
        if !slept.is_empty() {
            plan.slept.insert(name, slept);
        }
    }
    plan
}

/// An agent's way as it is carried out.
struct Carried<'a, 'g> {
    graph: &'a OrderGraph<'g>,
    begins: &'a [Time],
    way: &'a Way<'g>,
}

/// A stay as it is carried out: the first time and, where it ends, the last.
struct CarriedStay<'a> {
    planned: &'a Stay,
    arrives: u32,
    leaves: Option<u32>,
}

impl Carried<'_, '_> {
    fn begin(&self, event: usize) -> Time {
        self.begins.get(event).copied().unwrap_or(0)
    }

    /// The first time at which it is there: one that begins late stands at its start at 0.
    fn from(&self) -> u32 {
        match self.way.trajectory.timeline.from {
            0 => 0,
            _ => step(self.begin(self.way.first) + 1),
        }
    }

    fn stays(&self) -> impl Iterator<Item = CarriedStay<'_>> {
        let last = self.way.first + self.way.events();
        let timing = self.graph.timing();
        let stays = (self.way.first..).zip(&self.way.stays);
        stays.map(move |(event, planned)| CarriedStay {
            planned,
            arrives: if event == self.way.first {
                self.from()
            } else {
                step(timing.arrives(event, self.begin(event)))
            },
            leaves: (event + 1 < last).then(|| step(self.begin(event + 1))),
        })
    }

    /// The last time at which it is listed: its arrival, or the time before it is removed.
    fn last(&self) -> u32 {
        let arrives = self.stays().last().map_or(0, |stay| stay.arrives);
        match self.way.until() {
            Some(until) => until.saturating_sub(1),
            None => arrives.max(self.way.trajectory.end()),
        }
    }

    /// Its path; one that breaks down for good is listed up to the time from which it stands: where
    /// the plan has it, or where it is by then, late.
    fn stood(&self) -> Path {
        let mut path = self.path();
        let timeline = self.way.trajectory.timeline;
        let planned = self.graph.plan.path(self.way.name());
        let Some(stood) = timeline.stood(planned) else {
            return path;
        };
        if stood.starts_with(&path) {
            return stood;
        }
        // What it began before is completed.
        let until = self.last() + 1;
        let come = self
            .stays()
            .take_while(|stay| stay.arrives <= until)
            .count();
        let left = |stay: CarriedStay<'_>| stay.leaves.is_some_and(|leaves| leaves < until);
        let is_away = self.stays().nth(come.saturating_sub(1)).is_some_and(left);
        let cell = |place: usize| self.way.stays.get(place).map(|stay| stay.cell);
        match cell(come).filter(|_| is_away) {
            Some(head) => path.extend([None, Some(head)]),
            None => path.push(cell(come.saturating_sub(1))),
        }
        path
    }

    fn path(&self) -> Path {
        let (from, end) = (self.from(), self.last());
        let mut path = Path::new();
        for stay in self.stays() {
            let listed = from.saturating_add(path.len() as u32);
            // Half way along a slow move into the cell.
            for _ in listed..stay.arrives.min(end + 1) {
                path.push(None);
            }
            let last = stay.leaves.unwrap_or(end).min(end);
            for _ in stay.arrives..=last {
                path.push(Some(stay.planned.cell));
            }
        }
        // One that is removed while it leaves its last cell.
        if self.way.until().is_some() {
            let listed = from.saturating_add(path.len() as u32);
            path.extend((listed..=end).map(|_| None));
        }
        path
    }

    /// It charges where the plan has it, as long after its arrival, at the latest as it leaves;
    /// where it stays longer than planned it goes on charging.
    fn charges(&self) -> Vec<u32> {
        let mut times = Vec::new();
        let end = self.last();
        for stay in self.stays() {
            let planned = self.way.trajectory.charges.iter().filter_map(|&time| {
                let is_here = (stay.planned.arrives..=stay.planned.leaves).contains(&time);
                is_here.then(|| time - stay.planned.arrives)
            });
            let planned: Vec<u32> = planned.collect();
            let Some(&first) = planned.first() else {
                continue;
            };
            let length = stay.planned.leaves - stay.planned.arrives;
            let last = stay.leaves.unwrap_or(stay.arrives.saturating_add(length));
            let last = last.min(end);
            let stays = last.saturating_sub(stay.arrives);
            for after in 0..=stays {
                let is_charge = planned.contains(&after)
                    || after > length.max(first)
                    || (after == stays && after < first);
                if is_charge && stay.arrives + after <= end {
                    times.push(stay.arrives + after);
                }
            }
        }
        times
    }

    /// The spans that it slept through, from its arrival on.
    fn slept(&self) -> Vec<[u32; 2]> {
        let slept = self.graph.plan.slept(self.way.name()).iter();
        let spans = slept.filter_map(|&[from, to]| {
            let there = |stay: &CarriedStay<'_>| {
                stay.planned.arrives <= from && from <= stay.planned.leaves
            };
            let stay = self.stays().find(there)?;
            let from = from.max(stay.arrives);
            (from < to).then_some([from, to])
        });
        spans.collect()
    }
}
