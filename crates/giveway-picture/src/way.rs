//! The way of an agent: behind it a line, ahead of it dots.
//!
//! Each has a part that stands still within a move, and an end that goes with
//! the agent: only the short end is drawn anew in every frame.

use std::fmt::Write;

use giveway_model::Cell;

use crate::{CELL, Point, Track};

/// From dot to dot, in units.
const DOT: f64 = 15.5;
/// Where cells are small, dots stand that often further apart: a multiple of all these distances,
/// in units.
const PHASE: f64 = 12.0 * DOT;
/// From way to way, in units, where they lie side by side; and all together at
/// most.
const APART: (f64, f64) = (11.0, 40.0);
/// How many ways lie side by side before they share a place.
const PLACES: usize = 6;

/// The cells of a path, each once as long as the agent is on it.
#[derive(Clone, Debug, PartialEq)]
pub struct Way {
    stops: Vec<Stop>,
    /// How far it lies beside the middle of its cells, in units.
    offset: f64,
}

#[derive(Clone, Copy, Debug, PartialEq)]
struct Stop {
    cell: Cell,
    arrives: u32,
}

/// The ends of a way that go with the agent.
#[derive(Clone, Debug, PartialEq)]
pub struct WayEnds {
    /// `points` of the line from where the still part ends to the agent.
    pub behind: String,
    /// `points` of the dots from the next cell to the agent.
    pub ahead: String,
    /// Where the dots go on from those of the still part: a dash offset.
    pub ahead_offset: f64,
}

impl Way {
    /// The ways of all tracks, side by side.
    pub fn of_all(tracks: &[Track]) -> Vec<Self> {
        let beside = |agent| Self::offset(agent, tracks.len());
        let tracks = tracks.iter().enumerate();
        tracks
            .map(|(agent, track)| Self::of(track, beside(agent)))
            .collect()
    }

    /// The way of a track, which lies that far beside the middle of its cells,
    /// down and to the right, in units.
    pub fn of(track: &Track, offset: f64) -> Self {
        let mut stops: Vec<Stop> = Vec::new();
        for (time, cell) in track.path().iter().enumerate() {
            let Some(cell) = *cell else { continue };
            if stops.last().is_none_or(|stop| stop.cell != cell) {
                let arrives = time as u32;
                stops.push(Stop { cell, arrives });
            }
        }
        Self { stops, offset }
    }

    /// The stop that an agent came to last.
    pub fn last_stop(&self, time: f64) -> usize {
        let came = |stop: &Stop| f64::from(stop.arrives) <= time;
        self.stops.partition_point(came).saturating_sub(1)
    }

    /// `points` of the line behind a stop. It ends half way before the stop,
    /// since there the end that moves goes on straight.
    pub fn behind(&self, stop: usize) -> String {
        let mut points = String::new();
        for stop in self.stops.iter().take(stop) {
            self.push(&mut points, middle(stop.cell));
        }
        if let Some(half) = self.half_before(stop) {
            self.push(&mut points, half);
        }
        points
    }

    /// `points` of the dots ahead of a stop. They begin at the goal, so that
    /// they stand still while the agent comes nearer.
    pub fn ahead(&self, stop: usize) -> String {
        let mut points = String::new();
        for stop in self.stops.iter().skip(stop + 1).rev() {
            self.push(&mut points, middle(stop.cell));
        }
        points
    }

    /// The ends that go with an agent at a point, after a stop.
    pub fn ends(&self, stop: usize, agent: Point) -> WayEnds {
        let (mut behind, mut ahead) = (String::new(), String::new());
        if let Some(half) = self.half_before(stop) {
            self.push(&mut behind, half);
        }
        if let Some(stop) = self.stops.get(stop) {
            self.push(&mut behind, middle(stop.cell));
        }
        self.push(&mut behind, agent);
        let still = self.stops.len().saturating_sub(stop + 2);
        if let Some(next) = self.stops.get(stop + 1) {
            self.push(&mut ahead, middle(next.cell));
            self.push(&mut ahead, agent);
        }
        WayEnds {
            behind,
            ahead,
            ahead_offset: (still as f64 * CELL).rem_euclid(PHASE),
        }
    }

    fn half_before(&self, stop: usize) -> Option<Point> {
        let (before, at) = (self.stops.get(stop.checked_sub(1)?)?, self.stops.get(stop)?);
        let (before, at) = (middle(before.cell), middle(at.cell));
        Some(Point {
            x: f64::midpoint(before.x, at.x),
            y: f64::midpoint(before.y, at.y),
        })
    }

    fn push(&self, points: &mut String, point: Point) {
        let unit = |cells: f64| (((cells + 0.5) * CELL + self.offset) * 10.0).round() / 10.0;
        let gap = if points.is_empty() { "" } else { " " };
        // Writing to a string cannot fail.
        let _ = write!(points, "{gap}{},{}", unit(point.x), unit(point.y));
    }

    /// How far an agent's way lies beside the middle of its cells, down and to
    /// the right, in units.
    pub fn offset(agent: usize, agents: usize) -> f64 {
        let places = agents.min(PLACES);
        if places < 2 {
            return 0.0;
        }
        let gaps = (places - 1) as f64;
        let apart = (APART.1 / gaps).min(APART.0);
        ((agent % places) as f64 - gaps / 2.0) * apart
    }
}

fn middle(cell: Cell) -> Point {
    Point {
        // A plan of elsewhere may lead left of the map, or above it.
        x: f64::from(cell.x.cast_signed()),
        y: f64::from(cell.y.cast_signed()),
    }
}

#[cfg(test)]
mod tests {
    use giveway_model::AtGoal;

    use super::*;

    fn way(row: &str) -> Way {
        let cell = |c: char| c.to_digit(10).map(|x| Cell::new(x, 0));
        let path = row.chars().map(cell).collect();
        Way::of(&Track::new(path, Vec::new(), None, AtGoal::Stay), 0.0)
    }

    #[test]
    fn a_wait_and_a_slow_move_are_one_stop_each() {
        let way = way("0011-2");
        let at = [0.0, 1.0, 2.0, 3.5, 4.9, 5.0, 9.0].map(|time| way.last_stop(time));
        assert_eq!(at, [0, 0, 1, 1, 1, 2, 2]);
    }

    #[test]
    fn dots_begin_at_the_goal_and_end_at_the_agent() {
        let way = way("0123");
        assert_eq!(way.ahead(0), "350,50 250,50 150,50");
        let ends = way.ends(0, Point { x: 0.25, y: 0.0 });
        assert_eq!(ends.ahead, "150,50 75,50");
        // The still part is 200 long: 12 dots, and 14 on to the next.
        assert!((ends.ahead_offset - 14.0).abs() < 1e-9);
        assert_eq!(way.ahead(3), "");
        assert_eq!(way.ends(3, Point { x: 3.0, y: 0.0 }).ahead, "");
    }

    #[test]
    fn the_line_behind_is_joined_where_it_is_straight() {
        let way = way("0123");
        assert_eq!(way.behind(2), "50,50 150,50 200,50");
        let ends = way.ends(2, Point { x: 2.5, y: 0.0 });
        assert_eq!(ends.behind, "200,50 250,50 300,50");
        assert_eq!(way.behind(0), "");
        assert_eq!(way.ends(0, Point { x: 0.0, y: 0.0 }).behind, "50,50 50,50");
    }

    #[test]
    fn ways_lie_side_by_side() {
        let beside = Way {
            offset: -5.5,
            ..way("01")
        };
        assert_eq!(beside.ahead(0), "144.5,44.5");
        assert_eq!([Way::offset(0, 2), Way::offset(1, 2)], [-5.5, 5.5]);
        assert_eq!(
            [Way::offset(0, 30), Way::offset(5, 30), Way::offset(6, 30)],
            [-20.0, 20.0, -20.0]
        );
        assert_eq!(Way::offset(0, 1), 0.0);
    }
}
