//! Charges that are not allowed.

use super::findings::{Findings, Place};
use super::walk::Walk;
use super::{Rule, sentence};
use crate::{Cell, Grid, Instance};

/// Why an agent cannot charge at a time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum NoCharge {
    /// It has no battery.
    NoBattery,
    /// It has arrived.
    Arrived,
    /// It has not come yet, or is gone.
    Absent,
    /// It is half way along a slow move.
    InTransit,
    /// There is no charger where it is.
    NoCharger(Cell),
}

/// Whether the agent may charge at the time.
pub(super) fn may_charge(grid: &Grid, walk: &Walk<'_>, time: usize) -> Result<(), NoCharge> {
    if walk.agent.battery.is_none() {
        return Err(NoCharge::NoBattery);
    }
    if time >= walk.arrival() {
        return Err(NoCharge::Arrived);
    }
    match walk.at(time) {
        None => Err(NoCharge::InTransit),
        Some(cell) if grid.is_charger(cell) => Ok(()),
        Some(cell) => Err(NoCharge::NoCharger(cell)),
    }
}

/// Finds the charges of an agent that are not allowed.
pub(super) fn find(instance: &Instance, walk: &Walk<'_>, findings: &mut Findings<'_>) {
    for &time in walk.charges {
        let time = time as usize;
        if let Err(why) = may_charge(instance.grid(), walk, time) {
            let message = sentence::charge(&walk.agent.name, time, walk.arrival(), why);
            let place = match why {
                NoCharge::NoCharger(cell) => Place::Cell(cell),
                _ => Place::Nowhere,
            };
            findings.push(Rule::Charge, time, &[walk.index], place, message);
        }
    }
}
