//! The tip at the pointer: a cell, how often it is used, who is there and who waits there.

use giveway_model::{Cell, Ground, Units, tr};

use super::{CELL, Cast, Frame};
use crate::State;
use crate::words::{at, distance, timed};

/// What is told of the cell under the pointer, in at most three lines.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Tip {
    /// The cell, and how far it is from the robot selected where the scene has units:
    /// `(28, 8), 12.8 m`.
    pub cell: String,
    /// How often it is used: `used 10 times, by 6 robots`; empty without a plan.
    pub used: String,
    /// Who is there or comes next, and who waits there; at most two.
    pub lines: Vec<TipLine>,
}

/// A line about an agent.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TipLine {
    /// The agent, by its index on the board.
    pub agent: usize,
    /// What it does there.
    pub text: String,
}

impl Tip {
    /// All of it in one sentence, for those who do not see it.
    pub fn sentence(&self) -> String {
        let lines = self.lines.iter().map(|line| line.text.as_str());
        let parts = std::iter::once(self.used.as_str()).chain(lines);
        let parts: Vec<&str> = parts.filter(|part| !part.is_empty()).collect();
        parts.join(", ")
    }
}

/// A time that an agent spends on a cell, from its first step to its last.
struct Stay {
    agent: usize,
    from: u32,
    to: u32,
    /// Whether it stays for good.
    is_last: bool,
}

/// The lines below the first.
const LINES: usize = 2;

/// The tip of a cell at the time shown; `None` off the map.
pub fn tip(state: &State, cast: &Cast, cell: Cell) -> Option<Tip> {
    let ground = state.world().grid().ground(cell)?;
    let stays = stays(cast, cell);
    let time = state.view.playback.time;
    let units = state.world().scene().units;
    // From the robot selected, which may go there.
    let from = state.selected_agent();
    let from = from.and_then(|agent| cast.tracks.get(agent)?.cells_at(time).first().copied());
    let away = from.filter(|&from| from != cell);
    let away = away.and_then(|from| distance(units, from, cell));
    let used = if ground == Ground::Obstacle {
        tr!("what a cell is" => "obstacle").to_owned()
    } else if cast.has_plan() {
        used(&stays)
    } else {
        String::new()
    };
    let mut lines: Vec<TipLine> = if cast.has_plan() {
        let who = [
            here(cast, &stays, time, units),
            waits(cast, &stays, time, units),
        ];
        who.into_iter().flatten().collect()
    } else {
        Vec::new()
    };
    lines.extend(owners(cast, cell));
    lines.truncate(LINES);
    let place = match away {
        Some(away) => format!("{}, {away}", at(cell)),
        None => at(cell),
    };
    Some(Tip {
        cell: place,
        used,
        lines,
    })
}

fn stays(cast: &Cast, cell: Cell) -> Vec<Stay> {
    let mut stays: Vec<Stay> = Vec::new();
    let there = cast.tracks.iter().zip(&cast.is_there).enumerate();
    for (agent, (track, _)) in there.filter(|(_, (_, is_there))| **is_there) {
        for (time, _) in track
            .path()
            .iter()
            .enumerate()
            .filter(|step| *step.1 == Some(cell))
        {
            let time = time as u32;
            let is_last = time == track.arrival();
            match stays.last_mut() {
                Some(stay) if stay.agent == agent && stay.to + 1 == time => {
                    (stay.to, stay.is_last) = (time, is_last);
                }
                _ => stays.push(Stay {
                    agent,
                    from: time,
                    to: time,
                    is_last,
                }),
            }
        }
    }
    stays
}

fn used(stays: &[Stay]) -> String {
    if stays.is_empty() {
        return tr!("never used").to_owned();
    }
    let mut robots: Vec<usize> = stays.iter().map(|stay| stay.agent).collect();
    robots.dedup();
    let times = tr!("used {n} time" | "used {n} times" % stays.len());
    let robots = tr!("by {n} robot" | "by {n} robots" % robots.len());
    format!("{times}, {robots}")
}

/// Who is there at a time, or comes next.
fn here(cast: &Cast, stays: &[Stay], time: u32, units: Option<Units>) -> Option<TipLine> {
    let agent = |stay: &Stay| &cast.agents[stay.agent].name;
    let is_gone = |stay: &Stay| cast.tracks[stay.agent].cells_at(time).is_empty();
    let is_here = |stay: &&Stay| stay.from <= time && (time <= stay.to || stay.is_last);
    if let Some(stay) = stays.iter().find(|stay| is_here(stay) && !is_gone(stay)) {
        let text = tr!("{agent} is here", agent = agent(stay));
        return Some(line(stay, text));
    }
    let next = stays.iter().filter(|stay| stay.from > time);
    let next = next.min_by_key(|stay| stay.from)?;
    let text = tr!(
        "{agent} is the next here, at {time}",
        agent = agent(next),
        time = timed(units, next.from)
    );
    Some(line(next, text))
}

/// Who waits there: the wait that goes on or comes next, else the last one.
fn waits(cast: &Cast, stays: &[Stay], time: u32, units: Option<Units>) -> Option<TipLine> {
    let waits = || {
        stays
            .iter()
            .filter(|stay| stay.to > stay.from && !stay.is_last)
    };
    let coming = waits()
        .filter(|stay| stay.to > time)
        .min_by_key(|stay| stay.from);
    let stay = coming.or_else(|| waits().max_by_key(|stay| stay.from))?;
    let agent = &cast.agents[stay.agent].name;
    let (steps, time) = (stay.to - stay.from, timed(units, stay.from));
    let text = tr!(
        "{agent} waits here for {n} step, at {time}"
            | "{agent} waits here for {n} steps, at {time}" % steps,
        agent,
        time
    );
    Some(line(stay, text))
}

/// Whose goal or waypoint it is.
fn owners(cast: &Cast, cell: Cell) -> Vec<TipLine> {
    let there = cast.agents.iter().zip(&cast.is_there).enumerate();
    let there = there.filter(|(_, (_, is_there))| **is_there);
    let owner = there.filter_map(|(agent, (own, _))| {
        let name = &own.name;
        let text = if own.goal == Some(cell) {
            tr!("goal of {agent}", agent = name)
        } else if own.waypoints.contains(&cell) {
            tr!("waypoint of {agent}", agent = name)
        } else {
            return None;
        };
        Some(TipLine { agent, text })
    });
    owner.collect()
}

fn line(stay: &Stay, text: String) -> TipLine {
    let agent = stay.agent;
    TipLine { agent, text }
}

/// The upper left corner of a tip beside a cell, in pixels from the corner of what is in sight:
/// on the first side where it is in sight and covers none of some cells; both sizes in pixels.
pub fn tip_corner(
    cell: Cell,
    frame: &Frame,
    (wide, tall): (f64, f64),
    covered: impl Iterator<Item = Cell>,
) -> (f64, f64) {
    const GAP: f64 = 10.0;
    let px = frame.cell_px / CELL;
    let place = |cell: Cell| {
        let unit = |at: u32, from: f64| (f64::from(at) * CELL - from) * px;
        (unit(cell.x, frame.x), unit(cell.y, frame.y))
    };
    let (x, y) = place(cell);
    let screen = (frame.width * px, frame.height * px);
    let (right, left) = (x + frame.cell_px + GAP, x - GAP - wide);
    let (above, below) = (y - GAP - tall, y + frame.cell_px + GAP);
    let corners = [(right, above), (right, below), (left, above), (left, below)];
    let is_seen =
        |&(x, y): &(f64, f64)| x >= 0.0 && y >= 0.0 && x + wide <= screen.0 && y + tall <= screen.1;
    let seen: Vec<(f64, f64)> = corners.into_iter().filter(is_seen).collect();
    let cells: Vec<(f64, f64)> = covered.map(place).collect();
    let covers = |&(left, top): &(f64, f64)| {
        let is_under = |&(x, y): &(f64, f64)| {
            x + frame.cell_px > left && x < left + wide && y + frame.cell_px > top && y < top + tall
        };
        cells.iter().filter(|cell| is_under(cell)).count()
    };
    let best = seen.iter().min_by_key(|corner| covers(corner)).copied();
    best.unwrap_or_else(|| {
        let within = |at: f64, size: f64, screen: f64| at.min(screen - size).max(0.0);
        (within(right, wide, screen.0), within(below, tall, screen.1))
    })
}

#[cfg(test)]
mod tests;
