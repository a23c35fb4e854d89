//! A robot that breaks down, as a sentence with slots: who, when, and for how long; and what that
//! leads to while everyone else goes on as planned.

mod arrives;

use giveway_model::change::{MAX_DELAY, What};
use giveway_model::words::Sentence;
use giveway_model::words::and;
use giveway_model::{Cell, tr, tr_data};

use super::Changing;
use super::meets::{met_by, stands};
use crate::Edit;
use crate::timeline::Lane;
use crate::words::at;

/// A slot of the sentence.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Blank {
    /// Which robot.
    Robot,
    /// At which time.
    Time,
    /// For how many steps, or for good.
    Steps,
}

/// What a person fills into a slot.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Filled {
    /// A robot, by its index among all that there ever are.
    Robot(usize),
    /// A time, in steps.
    Time(u32),
    /// So many steps; `None` is for good.
    Steps(Option<u32>),
}

/// A part of the sentence.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Piece {
    /// Words.
    Words(String),
    /// A slot with what stands in it.
    Slot(Blank, String),
}

/// A listed breakdown.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Breakdown {
    /// Its place in the list of changes.
    pub index: usize,
    /// The robot, by its index among all that there ever are.
    pub agent: usize,
    /// The sentence.
    pub pieces: Vec<Piece>,
    /// The time, and the least and the largest one that is possible.
    pub time: (u32, (u32, u32)),
    /// The steps; `None` is for good.
    pub steps: Option<u32>,
    /// The robots to choose from: their indices and names.
    pub robots: Vec<(usize, String)>,
    /// Who would run into it, in a sentence; `None` where nobody would.
    pub met: Option<String>,
    /// What becomes of its battery, and who cannot arrive any more, in sentences; whether each is
    /// bad news.
    pub told: Vec<(bool, String)>,
}

/// The breakdowns among the changes that are listed.
pub(super) fn breakdowns(changing: &Changing) -> Vec<Breakdown> {
    let all = 0..changing.list.len();
    all.filter_map(|index| breakdown(changing, index)).collect()
}

/// Whose breakdown a listed change is, and for how many steps; `None` of steps is for good.
fn listed_breakdown(changing: &Changing, index: usize) -> Option<(String, Option<u32>)> {
    match changing.list.get(index)? {
        What::DelayAgent { agent, steps } => Some((agent.clone(), Some(*steps))),
        What::StopAgent { agent } => Some((agent.clone(), None)),
        _ => None,
    }
}

fn breakdown(changing: &Changing, index: usize) -> Option<Breakdown> {
    let (name, steps) = listed_breakdown(changing, index)?;
    let agents = changing.draft().agents();
    let agent = agents.iter().position(|own| own.name == name)?;
    let lane = lanes(changing).find(|lane| lane.name == name)?;
    let (cell, from) = stands(&lane, changing.at);
    let to = steps.map_or(u32::MAX, |steps| from.saturating_add(steps));
    let met = met_by(changing, Some(&name), cell, (from, to));
    let met = (!met.is_empty()).then(|| {
        let who: Vec<String> = met
            .iter()
            .map(|(time, name)| tr!("{name} at {time}", name, time))
            .collect();
        tr!(
            "{n} robot would run into it: {who}"
                | "{n} robots would run into it: {who}" % met.len(),
            who = and(&who)
        )
    });
    let told = arrives::told(changing, &lane, (cell, from), steps);
    let is_there = |index: &usize| changing.world.is_there.get(*index) == Some(&true);
    let robots = lanes(changing).filter_map(|lane| {
        let index = agents.iter().position(|own| own.name == lane.name)?;
        (is_there(&index) || index == agent).then_some((index, lane.name))
    });
    Some(Breakdown {
        index,
        agent,
        pieces: pieces(&name, changing.at, cell, steps),
        time: (changing.at, changing.times()),
        steps,
        robots: robots.collect(),
        met,
        told,
    })
}

/// The plans of all robots.
fn lanes(changing: &Changing) -> impl Iterator<Item = Lane> {
    let agents = 0..changing.about.agents().len();
    let lanes = agents.filter_map(|agent| Lane::of(&changing.about, agent));
    lanes.filter(|lane| lane.removed.is_none())
}

/// The sentence, cut at its slots: a language may put them in another order.
fn pieces(name: &str, time: u32, cell: Cell, steps: Option<u32>) -> Vec<Piece> {
    const MARKS: [char; 3] = ['\u{1}', '\u{2}', '\u{3}'];
    let [robot, when, long] = MARKS;
    let sentence = match steps {
        Some(_) => tr!(
            "{robot} breaks down at {when} at {cell} for {long}.",
            robot,
            when,
            cell = at(cell),
            long
        ),
        None => tr!(
            "{robot} breaks down at {when} at {cell} {long}.",
            robot,
            when,
            cell = at(cell),
            long
        ),
    };
    let mut pieces = Vec::new();
    let mut words = String::new();
    for c in sentence.chars() {
        let slot = match MARKS.iter().position(|&mark| mark == c) {
            Some(0) => Piece::Slot(Blank::Robot, name.to_owned()),
            Some(1) => Piece::Slot(Blank::Time, time.to_string()),
            Some(_) => Piece::Slot(
                Blank::Steps,
                match steps {
                    Some(n) => tr!("{n} step" | "{n} steps" % n),
                    None => tr!("a robot breaks down" => "for good").to_owned(),
                },
            ),
            None => {
                words.push(c);
                continue;
            }
        };
        if !words.is_empty() {
            pieces.push(Piece::Words(std::mem::take(&mut words)));
        }
        pieces.push(slot);
    }
    pieces.push(Piece::Words(words));
    pieces
}

impl Changing {
    /// The same with another robot, time or length of a listed breakdown.
    ///
    /// # Errors
    /// Why it cannot be.
    pub(crate) fn with_breakdown(&self, index: usize, filled: Filled) -> Result<Self, Sentence> {
        let Some((mut name, mut steps)) = listed_breakdown(self, index) else {
            return Ok(self.clone());
        };
        let mut base = self.without(index).0;
        match filled {
            Filled::Robot(agent) => {
                if let Some(own) = self.draft().agents().get(agent) {
                    name.clone_from(&own.name);
                }
            }
            Filled::Time(time) => {
                let (first, last) = self.times();
                let time = time.min(last).max(first);
                let settled =
                    || tr_data!("What happened up to time {last} is settled.", last = time);
                let begun = Self::begin(&self.about, time).ok_or_else(settled)?;
                base = begun.with(base.list.clone()).map_err(|faults| {
                    let fault = faults.first();
                    let why = fault.map(super::facts::contradiction).unwrap_or_default();
                    Sentence::from(why)
                })?;
            }
            Filled::Steps(new) => steps = new.map(|steps| steps.clamp(1, MAX_DELAY)),
        }
        let mut agents = base.draft().agents().iter();
        let Some(agent) = agents.position(|own| own.name == name) else {
            return Ok(self.clone());
        };
        let edit = match steps {
            Some(steps) => Edit::Delay(agent, steps),
            None => Edit::Stop(agent),
        };
        match base.with_edits(&[edit]) {
            (_, Some(refused)) => Err(refused),
            (after, None) => Ok(after),
        }
    }

    /// The first and the last time at which the world can change around the plan.
    fn times(&self) -> (u32, u32) {
        let first = self.about.changed_last().map_or(0, |last| last + 1);
        (first, self.about.makespan().max(first))
    }

    /// Whether a listed change is a breakdown.
    pub(super) fn is_breakdown(&self, index: usize) -> bool {
        listed_breakdown(self, index).is_some()
    }

    /// The robot of the last breakdown of the list, by its index.
    pub(crate) fn breaks_last(&self) -> Option<usize> {
        let mut last = (0..self.list.len()).rev();
        let name = last.find_map(|index| listed_breakdown(self, index))?.0;
        let mut agents = self.draft().agents().iter();
        agents.position(|own| own.name == name)
    }
}
