//! Who is on the board, with all that moves.

use std::collections::BTreeMap;
use std::rc::Rc;

use giveway_formats::Heading;
use giveway_model::check::Rule;
use giveway_model::{Agent, Cell};

use super::{Mark, Pose, Track, Way, marks_with};
use crate::{Answer, Draft, State, form, inside};
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
            match answer.and_then(|answer| headings(state, answer, &agent.name)) {
                Some(headings) => track.turning(headings),
                None => track,
            }
        };
        let tracks: Vec<Track> = agents.iter().enumerate().map(track).collect();
        let badges = badges(&agents);
        Self {
            ways: ways(&tracks, &is_there),
            marks: marks_of(&agents, &tracks, &badges, &is_there),
            badges,
            asides: answer.map_or_else(BTreeMap::new, |answer| asides(state, answer, &agents)),
            looks: state.looks(),
            tracks,
            agents,
            is_there,
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

/// A time at which an agent is on one cell with others: its place among them from the
/// left, and how many they are.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Aside {
    time: f64,
    place: usize,
    count: usize,
}

/// How much smaller two robots on one cell are drawn, and how far apart in cells.
const TWO: (f64, f64) = (0.74, 0.44);

/// The broken rules that are looked at.
const MOST_MEETINGS: usize = 1000;

/// Who is on one cell with others, by the rules that a plan of elsewhere or of one's own
/// breaks, or by the conflict of a node that is looked at.
fn asides(state: &State, answer: &Rc<Answer>, agents: &[Agent]) -> BTreeMap<usize, Vec<Aside>> {
    let mut asides: BTreeMap<usize, Vec<Aside>> = BTreeMap::new();
    if let Some((pair, time)) = inside::two_on_a_cell(state, answer) {
        for (place, agent) in pair.into_iter().enumerate() {
            let (time, count) = (f64::from(time), pair.len());
            asides.insert(agent, vec![Aside { time, place, count }]);
        }
        return asides;
    }
    let plans = state.audit().into_iter().flat_map(|audit| &audit.plans);
    let mut own = plans.filter(|dropped| Rc::ptr_eq(&dropped.answer, answer));
    let led = state.document.mode.steering();
    let led = led.filter(|led| Rc::ptr_eq(&led.answer, answer));
    let of_led = led.into_iter().flat_map(|led| &led.violations);
    let violations = own
        .next()
        .into_iter()
        .flat_map(|dropped| &dropped.violations)
        .chain(of_led);
    let meets = violations
        .filter(|violation| violation.rule == Rule::Vertex)
        .take(MOST_MEETINGS);
    let mut groups: BTreeMap<(u32, Option<Cell>), Vec<usize>> = BTreeMap::new();
    for violation in meets {
        let group = groups.entry((violation.time, violation.cell)).or_default();
        let index = |name: &String| agents.iter().position(|agent| agent.name == *name);
        for agent in violation.agents.iter().filter_map(index) {
            if !group.contains(&agent) {
                group.push(agent);
            }
        }
    }
    for ((time, _), group) in &groups {
        for (place, &agent) in group.iter().enumerate() {
            asides.entry(agent).or_default().push(Aside {
                time: f64::from(*time),
                place,
                count: group.len(),
            });
        }
    }
    asides
}

/// How far an agent makes way at a time: wholly when both are on the cell, and the
/// less the further away that time is.
fn aside(times: &[Aside], time: f64) -> Option<(f64, f64)> {
    let share = |aside: &Aside| 1.0 - 2.0 * (time - aside.time).abs();
    let near = times.iter().max_by(|a, b| share(a).total_cmp(&share(b)))?;
    let share = share(near);
    let gaps = near.count.saturating_sub(1).max(1) as f64;
    let side = near.place as f64 / gaps - 0.5;
    // More than two share the room of two.
    let (scale, apart) = (TWO.0 / gaps.sqrt(), TWO.1 * (2.0 - 1.0 / gaps).min(1.3));
    (share > 0.0).then_some((side * apart * share, 1.0 - (1.0 - scale) * share))
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
