//! The parts of a rule that can be changed, whatever its kind.

use giveway_model::condition::Times;
use giveway_model::{Cell, constraint::ConstraintKind};

/// The parts of a rule that can be changed.
#[derive(Default)]
pub(crate) struct Parts<'a> {
    /// Its zone.
    pub(crate) zone: Option<&'a mut String>,
    /// Its numbers; the last one stands in the sentence with its plural.
    pub(crate) numbers: Vec<&'a mut u32>,
    /// The least that each of them can be.
    pub(crate) least: u32,
    /// When it holds.
    pub(crate) times: Option<&'a mut Times>,
    /// Its cells.
    pub(crate) cells: Vec<&'a mut Cell>,
    /// The robots that the kind itself names.
    pub(crate) agents: Vec<&'a mut String>,
    /// Whether it binds all robots or those of a list.
    pub(crate) has_who: bool,
}

/// The parts of a kind.
pub(crate) fn parts(kind: &mut ConstraintKind) -> Parts<'_> {
    let bound = Parts {
        has_who: true,
        least: 1,
        ..Parts::default()
    };
    match kind {
        ConstraintKind::Capacity { zone, most, times } => Parts {
            zone: Some(zone),
            numbers: vec![most],
            times: Some(times),
            least: 0,
            ..bound
        },
        ConstraintKind::Closed { zone, times } => Parts {
            zone: Some(zone),
            times: Some(times),
            ..bound
        },
        ConstraintKind::NoWaiting { zone, most } => Parts {
            zone: Some(zone),
            numbers: vec![most],
            least: 0,
            ..bound
        },
        ConstraintKind::Avoid { zone, weight } => Parts {
            zone: Some(zone),
            numbers: vec![weight],
            ..bound
        },
        ConstraintKind::Gap { steps: number } | ConstraintKind::Turns { quarter: number } => {
            Parts {
                numbers: vec![number],
                ..bound
            }
        }
        ConstraintKind::Apart { distance, times } => Parts {
            numbers: vec![distance],
            times: Some(times),
            least: 2,
            ..bound
        },
        ConstraintKind::Visit { cell, stay, times } => Parts {
            numbers: vec![stay],
            times: Some(times),
            cells: vec![cell],
            least: 0,
            ..bound
        },
        ConstraintKind::Arrive { times } => Parts {
            times: Some(times),
            ..bound
        },
        ConstraintKind::Late { by, weight } => Parts {
            numbers: vec![by, weight],
            ..bound
        },
        ConstraintKind::Depart { from } => Parts {
            numbers: vec![from],
            ..bound
        },
        ConstraintKind::OneWay { .. } => bound,
        ConstraintKind::Sequence { agent, cells } => Parts {
            cells: cells.iter_mut().collect(),
            agents: vec![agent],
            ..Parts::default()
        },
        ConstraintKind::Before { first, second } => Parts {
            cells: vec![&mut first.cell, &mut second.cell],
            agents: vec![&mut first.agent, &mut second.agent],
            ..Parts::default()
        },
    }
}
