//! Who is on the board, with all that moves.

mod aside;

use std::collections::BTreeMap;
use std::rc::Rc;

use giveway_formats::Heading;
use giveway_model::Agent;

use super::{Mark, Pose, Track, Way, marks_with, nose};
use crate::{Answer, Draft, State, form};
use aside::{Aside, aside, asides};
use giveway_model::sorting::sort;

/// The agents of a draft and what they do by the plan shown, if any.
#[derive(Clone, Debug)]
pub struct Cast {
    /// The agents, in the order of the scene.
    pub agents: Vec<Agent>,
    /// The look of each.
    pub looks: Vec<usize>,
    /// What stands on the form of each: no two have the same.
    pub badges: Vec<String>,
    /// What stands on the form of each, or beside it, where cells are small.
    pub numbers: Vec<String>,
    /// What each does.
    pub tracks: Vec<Track>,
    /// The way of each.
    pub ways: Vec<Way>,
    /// Goals and waypoints.
    pub marks: Vec<Mark>,
    /// Whether each is there at the time shown: where the world changes, some
    /// come later, and some are removed.
    pub is_there: Vec<bool>,
    /// Who is on one cell with others, and when: of a plan of elsewhere.
    asides: BTreeMap<usize, Vec<Aside>>,
    /// The steps of a quarter turn of each; 0 where turns are free.
    quarters: Vec<u32>,
    /// The answer that holds the plan.
    answer: Option<Rc<Answer>>,
    /// Where each agent stands in that plan; `None` for one of which it has none.
    planned: Vec<Option<usize>>,
}

impl PartialEq for Cast {
    /// A plan is compared by the answer that it came with.
    fn eq(&self, other: &Self) -> bool {
        self.agents == other.agents
            && self.looks == other.looks
            && self.is_there == other.is_there
            && self.planned == other.planned
            && self.quarters == other.quarters
            && same(self.answer.as_ref(), other.answer.as_ref())
    }
}

fn same(one: Option<&Rc<Answer>>, other: Option<&Rc<Answer>>) -> bool {
    match (one, other) {
        (None, None) => true,
        (Some(one), Some(other)) => Rc::ptr_eq(one, other),
        _ => false,
    }
}

impl Cast {
    /// The cast of a state: of the plan that it shows.
    pub fn of(state: &State) -> Self {
        Self::by(state, state.shown())
    }

    /// The cast of a state by the plan of an answer; without a plan, or with one
    /// that cannot be drawn on the map, agents stand at their starts.
    pub fn by(state: &State, answer: Option<&Rc<Answer>>) -> Self {
        let draft = state.world_of(answer);
        let answer = answer.filter(|answer| is_drawn(answer, draft));
        let agents = draft.agents().to_vec();
        let planned = answer.map_or_else(Vec::new, |answer| answer.agents_of(draft));
        let is_there = there(state);
        let rules = state.document.draft.scene().rules;
        let track = |(index, agent): (usize, &Agent)| {
            let solved = planned.get(index).copied().flatten();
            let plan = answer.filter(|_| solved.is_some());
            let plan = plan.and_then(|answer| answer.plan());
            let mut path = plan.map_or_else(Vec::new, |plan| plan.path(&agent.name).to_vec());
            let mut charges = plan.map_or_else(Vec::new, |plan| plan.charges(&agent.name).to_vec());
            sort(&mut charges);
            if path.is_empty() {
                path.push(Some(agent.start));
            }
            let battery = agent.battery.map(|battery| {
                let levels = answer.zip(solved);
                let levels = levels.and_then(|(answer, index)| answer.levels.get(index));
                let levels = levels.filter(|levels| !levels.is_empty()).cloned();
                let initial = || vec![i64::from(battery.initial)];
                (levels.unwrap_or_else(initial), battery.capacity)
            });
            let from = plan.and_then(|plan| plan.from.get(&agent.name)).copied();
            let from = from.unwrap_or_else(|| joins(state, index));
            let until = answer.zip(solved);
            let until = until.and_then(|(answer, index)| answer.removed(index));
            let track = Track::new(path, charges, battery, rules.at_end_of(agent));
            let breakdowns = answer.zip(solved);
            let breakdowns = breakdowns.map_or(&[][..], |(answer, index)| answer.breakdowns(index));
            let track = track
                .between(from, until)
                .breaking_down(breakdowns.to_vec());
            if let Some(headings) = answer.and_then(|answer| headings(state, answer, &agent.name)) {
                return track.turning(headings);
            }
            match nose::headings(draft.scene(), agent, track.path()) {
                Some(headings) => track.facing(headings),
                None => track,
            }
        };
        let quarters = nose::quarters(draft);
        let tracks: Vec<Track> = agents.iter().enumerate().map(track).collect();
        let badges = badges(&agents);
        Self {
            ways: ways(&tracks, &is_there),
            marks: marks_of(&agents, &tracks, &badges, &is_there),
            numbers: numbers(&agents),
            badges,
            asides: answer.map_or_else(BTreeMap::new, |answer| asides(state, answer, &agents)),
            looks: state.looks(),
            tracks,
            agents,
            is_there,
            quarters,
            answer: answer.cloned(),
            planned,
        }
    }

    /// Whether this is still the cast of a state by the plan of an answer.
    pub fn is_by(&self, state: &State, answer: Option<&Rc<Answer>>) -> bool {
        let draft = state.world_of(answer);
        let answer = answer.filter(|answer| is_drawn(answer, draft));
        self.agents == draft.agents()
            && self.looks == state.looks()
            && self.is_there == there(state)
            && self.quarters == nose::quarters(draft)
            && same(self.answer.as_ref(), answer)
            && answer.is_none_or(|answer| answer.agents_of(draft) == self.planned)
    }

    /// An agent at a time that need not be whole.
    pub fn pose(&self, agent: usize, time: f64) -> Option<Pose> {
        let pose = self.tracks.get(agent)?.pose(time)?;
        let aside = self.asides.get(&agent).and_then(|at| aside(at, time));
        Some(Pose { aside, ..pose })
    }

    /// Whether there is a plan to show.
    pub const fn has_plan(&self) -> bool {
        self.answer.is_some()
    }
}

/// Where an agent of a plan of elsewhere looks at each time, where it turns in
/// place.
fn headings(state: &State, answer: &Rc<Answer>, name: &str) -> Option<Vec<f64>> {
    let plans = &state.audit()?.plans;
    let mut plans = plans.iter();
    let dropped = plans.find(|dropped| Rc::ptr_eq(&dropped.answer, answer))?;
    let degrees = |heading: &Heading| match heading {
        Heading::East => 0.0,
        Heading::South => 90.0,
        Heading::West => 180.0,
        Heading::North => 270.0,
    };
    let headings = dropped.file.headings.get(name)?.iter().map(degrees);
    Some(headings.collect())
}

fn there(state: &State) -> Vec<bool> {
    let agents = 0..state.world().agents().len();
    agents.map(|agent| state.is_there(agent)).collect()
}

/// When an agent joins that no plan knows yet.
fn joins(state: &State, agent: usize) -> u32 {
    let changing = state.document.mode.changing();
    let changing = changing.filter(|changing| agent >= changing.about.agents().len());
    changing.map_or(0, |changing| changing.at)
}

/// The ways of those who are there.
fn ways(tracks: &[Track], is_there: &[bool]) -> Vec<Way> {
    let shown = tracks.iter().zip(is_there);
    let shown = shown.map(|(track, is_there)| match is_there {
        true => track.clone(),
        false => Track::default(),
    });
    Way::of_all(&shown.collect::<Vec<Track>>())
}

fn numbers(agents: &[Agent]) -> Vec<String> {
    let names: Vec<&str> = agents.iter().map(|agent| agent.name.as_str()).collect();
    form::numbers(&names)
}

/// What stands on the forms of some agents.
pub fn badges(agents: &[Agent]) -> Vec<String> {
    let names: Vec<&str> = agents.iter().map(|agent| agent.name.as_str()).collect();
    form::badges(&names, |_| true)
}

/// The marks of those who are there.
fn marks_of(agents: &[Agent], tracks: &[Track], badges: &[String], is_there: &[bool]) -> Vec<Mark> {
    let there: Vec<usize> = (0..agents.len()).filter(|&agent| is_there[agent]).collect();
    let own: Vec<Agent> = there.iter().map(|&agent| agents[agent].clone()).collect();
    let tracks: Vec<Track> = there.iter().map(|&agent| tracks[agent].clone()).collect();
    let badges: Vec<String> = there.iter().map(|&agent| badges[agent].clone()).collect();
    let mut marks = marks_with(&own, &tracks, &badges);
    for mark in &mut marks {
        mark.agent = there[mark.agent];
    }
    marks
}

fn is_drawn(answer: &Answer, draft: &Draft) -> bool {
    answer.plan().is_some() && fits(answer, draft)
}

/// Whether a plan can be drawn on a draft: it may be stale, but not of a map of
/// another size, or of other agents altogether.
fn fits(answer: &Answer, draft: &Draft) -> bool {
    let size = |draft: &Draft| (draft.grid().width(), draft.grid().height());
    let mut agents = 0..draft.agents().len();
    size(&answer.draft) == size(draft)
        && (agents.is_empty() || agents.any(|agent| answer.agent(draft, agent).is_some()))
}
