//! A lane as SVG path data, in pixels from its left end.

mod path;
#[cfg(test)]
mod tests;

use std::fmt::Write as _;
use std::ops::Range;

use giveway_model::Cell;

use super::{Axis, Lane, Row, Step, Way};
use path::{arrow, clock, px};
pub(crate) use path::{rounded, stripes};

/// What is drawn of a lane; an empty path draws nothing.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Shapes {
    /// The moves, filled.
    pub moves: String,
    /// The slow moves, filled pale and outlined.
    pub slow: String,
    /// The stripes on them, stroked.
    pub stripes: String,
    /// The waits, outlined.
    pub waits: String,
    /// The pause on each wait, stroked.
    pub pauses: String,
    /// The arrow on each wait in which it turns, stroked.
    pub turns: String,
    /// The clock on each wait that a rule asks for, stroked.
    pub clocks: String,
    /// The waits of an agent that is broken down, outlined.
    pub broken: String,
    /// The cross on each of them, stroked.
    pub crosses: String,
    /// The line after the arrival, stroked.
    pub after: String,
    /// Below the battery's level, filled pale.
    pub area: String,
    /// The battery's level, stroked.
    pub level: String,
    /// The middles of the charges.
    pub charges: Vec<f64>,
    /// The radius of a charge.
    pub charge_radius: f64,
    /// Where the flag of the arrival stands, if that is drawn.
    pub flag: Option<f64>,
    /// Where the arrow of a late entry points to, if there is one.
    pub entry: Option<f64>,
}

/// The steps as they are drawn: where columns are narrow, steps of one kind that follow each other
/// are one.
fn joined<'a>(steps: impl Iterator<Item = &'a Step>, axis: Axis) -> Vec<Step> {
    let mut joined: Vec<Step> = Vec::new();
    for step in steps {
        match joined.last_mut() {
            Some(last) if axis.is_narrow() && last.way == step.way && last.ends == step.begins => {
                (last.ends, last.to) = (step.ends, step.to);
            }
            _ => joined.push(*step),
        }
    }
    joined
}

/// What a lane shows of a robot that broke down for good: its last move, which no plan counts, and
/// that it stands.
fn after_stop(lane: &Lane, at: u32, cell: Cell, last: u32) -> Vec<Step> {
    let step = |way, begins, ends, from| Step {
        way,
        begins,
        ends,
        from,
        to: cell,
    };
    let way = if lane.end() == cell {
        Way::Wait
    } else {
        Way::Move
    };
    let way_there = (lane.arrival < at).then(|| step(way, lane.arrival, at, lane.end()));
    let stands = (at..last).map(|time| step(Way::Broken, time, time + 1, cell));
    way_there.into_iter().chain(stands).collect()
}

impl Shapes {
    /// The shapes of a lane at the columns that are drawn.
    pub fn of(lane: &Lane, axis: Axis, row: Row, seen: &Range<u32>) -> Self {
        let mut shapes = Self::default();
        let drawn = |step: &&Step| step.ends >= seen.start && step.begins < seen.end;
        for step in joined(lane.steps.iter().filter(drawn), axis) {
            shapes.add(&step, axis, row);
        }
        if let Some(stopped) = lane.stopped {
            shapes.add_stop(lane, stopped, (axis, row), seen);
        }
        let is_seen = |time: &u32| seen.contains(time);
        let x = |time: u32| axis.x(f64::from(time));
        shapes.charges = lane
            .charges
            .iter()
            .copied()
            .filter(is_seen)
            .map(x)
            .collect();
        shapes.charge_radius = (axis.column * 0.6).clamp(7.0, row.thick * 0.8);
        let arrives = lane.arrives && is_seen(&lane.arrival);
        shapes.flag = arrives.then(|| x(lane.arrival));
        let late = lane.begins > 0 && is_seen(&lane.begins);
        shapes.entry = late.then(|| x(lane.begins));
        shapes.add_after(lane, axis, row);
        shapes.add_level(lane, axis, row, seen);
        shapes
    }

    /// Frames around the steps of a lane that are not so in another plan.
    pub fn frames(lane: &Lane, other: &Lane, axis: Axis, row: Row, seen: &Range<u32>) -> String {
        const BEYOND: f64 = 2.5;
        let mut frames = String::new();
        let drawn = |step: &&Step| step.ends >= seen.start && step.begins < seen.end;
        let differs = |step: &&Step| drawn(step) && other.differs_from(step);
        // Whatever a step is: frames of neighbours are one where they have no room.
        let way = Way::Move;
        let differing = lane
            .steps
            .iter()
            .filter(differs)
            .map(|step| Step { way, ..*step });
        let differing: Vec<Step> = differing.collect();
        for step in joined(differing.iter(), axis) {
            let left = axis.x(f64::from(step.begins)) + 1.0 - BEYOND;
            let width = axis.x(f64::from(step.ends)) - 1.0 + BEYOND - left;
            let (top, tall) = (row.bar - 4.0, row.thick + 8.0);
            rounded(&mut frames, left, top, width, tall, 5.0);
        }
        frames
    }

    fn add(&mut self, step: &Step, axis: Axis, row: Row) {
        // A gap at each end parts a bar from the next.
        let gap = if axis.is_narrow() { 0.5 } else { 1.0 };
        let left = axis.x(f64::from(step.begins)) + gap;
        let width = (axis.x(f64::from(step.ends)) - gap - left).max(1.0);
        let (top, tall) = (row.bar, row.thick);
        match step.way {
            Way::Move => rounded(&mut self.moves, left, top, width, tall, 4.0),
            Way::Slow => {
                rounded(
                    &mut self.slow,
                    left + 0.75,
                    top + 0.75,
                    width - 1.5,
                    tall - 1.5,
                    3.25,
                );
                stripes(&mut self.stripes, left, top, width, tall);
            }
            Way::Broken => {
                rounded(
                    &mut self.broken,
                    left + 0.75,
                    top + 0.75,
                    width - 1.5,
                    tall - 1.5,
                    3.25,
                );
                let (middle, half) = (left + width / 2.0, (width / 4.0).clamp(1.5, 3.0));
                let (x, y) = (middle - half, row.middle() - half);
                let side = px(2.0 * half);
                let _ = write!(self.crosses, "M{} {}l{side} {side}", px(x), px(y));
                let _ = write!(
                    self.crosses,
                    "M{} {}l-{side} {side}",
                    px(x + 2.0 * half),
                    px(y)
                );
            }
            Way::Turn(turn) => {
                rounded(
                    &mut self.waits,
                    left + 0.75,
                    top + 0.75,
                    width - 1.5,
                    tall - 1.5,
                    3.25,
                );
                arrow(
                    &mut self.turns,
                    turn,
                    left + width / 2.0,
                    row.middle(),
                    width,
                );
            }
            Way::Stay => {
                rounded(
                    &mut self.waits,
                    left + 0.75,
                    top + 0.75,
                    width - 1.5,
                    tall - 1.5,
                    3.25,
                );
                clock(
                    &mut self.clocks,
                    left + width / 2.0,
                    row.middle(),
                    width.min(tall),
                );
            }
            Way::Wait => {
                rounded(
                    &mut self.waits,
                    left + 0.75,
                    top + 0.75,
                    width - 1.5,
                    tall - 1.5,
                    3.25,
                );
                let (middle, apart) = (left + width / 2.0, (width / 5.0).clamp(1.5, 3.0));
                // One bar where two would run together.
                let bars = if width < 9.0 && step.ends - step.begins == 1 {
                    &[0.0][..]
                } else {
                    &[-apart, apart]
                };
                for x in bars.iter().map(|by| middle + by) {
                    let _ = write!(self.pauses, "M{} {}v6", px(x), px(row.middle() - 3.0));
                }
            }
        }
    }

    #[inline(never)]
    fn add_stop(
        &mut self,
        lane: &Lane,
        (at, cell): (u32, Cell),
        (axis, row): (Axis, Row),
        seen: &Range<u32>,
    ) {
        let rest = after_stop(lane, at, cell, axis.times.saturating_sub(1));
        let drawn = |step: &&Step| step.ends >= seen.start && step.begins < seen.end;
        for step in joined(rest.iter().filter(drawn), axis) {
            self.add(&step, axis, row);
        }
    }

    fn add_after(&mut self, lane: &Lane, axis: Axis, row: Row) {
        // The flag needs some room before the line begins.
        let from = axis.x(f64::from(lane.arrival)) + 14.0;
        let to = axis.x(f64::from(axis.times - 1));
        if lane.stays && from < to {
            let _ = write!(self.after, "M{} {}H{}", px(from), px(row.middle()), px(to));
        }
    }

    fn add_level(&mut self, lane: &Lane, axis: Axis, row: Row, seen: &Range<u32>) {
        let Some(capacity) = lane.capacity.filter(|_| row.tall > 0.0) else {
            return;
        };
        let capacity = f64::from(capacity.max(1));
        let bottom = row.level + row.tall;
        // One more on each side, for the line goes on there.
        let times = seen.start.saturating_sub(1)..seen.end.saturating_add(1);
        let levels = (lane.begins..).zip(&lane.levels);
        let drawn = levels.filter(|(time, _)| times.contains(time));
        let (mut first, mut last) = (None, 0.0);
        for (time, &level) in drawn {
            let x = axis.x(f64::from(time));
            let y = bottom - row.tall * (f64::from(level) / capacity).min(1.0);
            let letter = if first.is_none() { 'M' } else { 'L' };
            let _ = write!(self.level, "{letter}{} {}", px(x), px(y));
            first.get_or_insert(x);
            last = x;
        }
        if let Some(first) = first {
            let (first, last, bottom) = (px(first), px(last), px(bottom));
            self.area = format!("{}L{last} {bottom}L{first} {bottom}Z", self.level);
        }
    }
}
