//! What rules between agents have to remember of joint states, and whether they are kept.

use giveway_planners::rules::{Shared, SharedKind, touched};

use super::{Joint, agent::Single};
use crate::{single::Place, terrain::Vertex};

/// The most vertices of an agent's past that are remembered.
const LONGEST_TRAIL: u32 = 8;
/// Stands for no vertex.
const NOWHERE: u32 = u32::MAX;

/// What is remembered beside the agents' own states, as numbers of a joint state's key: the
/// time, as far as rules between agents look at it; whether the first agent of each
/// precedence has been at its vertex; whether each agent that a zone does not count until it
/// has left has left; and where each agent was 1, 2, ... steps ago, as far as gaps look back
/// beyond the last step.
pub(super) struct Memory {
    /// Later times are alike; `None` where all are.
    last: Option<u32>,
    /// The number of precedences.
    precedences: usize,
    /// The rules with a limit that do not count an agent, by the number of the rule and the
    /// agent's place in joint states.
    uncounted: Vec<(usize, usize)>,
    /// The vertices remembered of each agent.
    trail: usize,
}

impl Memory {
    /// What has to be remembered; `None` where that is too much.
    pub(super) fn new(joint: &Joint<'_>) -> Option<Self> {
        let between = &joint.problem.between;
        let gap = between.gap();
        (gap <= LONGEST_TRAIL).then(|| Self {
            last: between.last_time(),
            precedences: joint.problem.precedences.len(),
            uncounted: joint.uncounted(),
            trail: gap.saturating_sub(1) as usize,
        })
    }

    /// The numbers at time 0.
    pub(super) fn first(&self, joint: &Joint<'_>, state: &[Single]) -> Vec<u32> {
        let mut numbers = Vec::from_iter(self.last.map(|_| 0));
        numbers.extend(
            (0..self.precedences).map(|number| u32::from(joint.is_first_there(number, state))),
        );
        numbers.extend(self.left(joint, &vec![0; self.uncounted.len()], state));
        numbers.extend(std::iter::repeat_n(NOWHERE, self.trail * state.len()));
        numbers
    }

    /// The numbers one step after those of a state, in the state that follows it.
    pub(super) fn next(
        &self,
        joint: &Joint<'_>,
        numbers: &[u32],
        (before, after): (&[Single], &[Single]),
    ) -> Vec<u32> {
        let (time, numbers) = self.split(numbers);
        let (been, rest) = numbers.split_at(self.precedences);
        let (left, trails) = rest.split_at(self.uncounted.len());
        let mut next = Vec::from_iter(self.last.map(|last| (time + 1).min(last + 1)));
        next.extend(
            been.iter()
                .enumerate()
                .map(|(number, &been)| been.max(u32::from(joint.is_first_there(number, after)))),
        );
        next.extend(self.left(joint, left, after));
        if self.trail > 0 {
            for (trail, &single) in trails.chunks(self.trail).zip(before) {
                next.push(Joint::stands(single).unwrap_or(NOWHERE));
                next.extend(trail.iter().take(self.trail - 1));
            }
        }
        next
    }

    /// The time, 0 where all are alike, and the other numbers.
    fn split<'n>(&self, numbers: &'n [u32]) -> (u32, &'n [u32]) {
        match (self.last, numbers) {
            (Some(_), [time, rest @ ..]) => (*time, rest),
            _ => (0, numbers),
        }
    }

    /// Whether a state may follow another one.
    pub(super) fn may_follow(
        &self,
        joint: &Joint<'_>,
        numbers: &[u32],
        (before, after): (&[Single], &[Single]),
    ) -> bool {
        let (time, numbers) = self.split(numbers);
        let (been, rest) = numbers.split_at(self.precedences);
        let (left, trails) = rest.split_at(self.uncounted.len());
        let left = self.left(joint, left, after);
        let is_counted = |rule: usize, i: usize| self.is_counted(&left, (rule, i));
        joint.keeps_order(been, after)
            && joint
                .rules()
                .enumerate()
                .all(|(number, rule)| match rule.kind {
                    SharedKind::Gap { steps } => {
                        let trail = |j: usize| trails.get(j * self.trail..(j + 1) * self.trail);
                        joint.keeps_gap(rule, steps, (before, after), trail)
                    }
                    SharedKind::Capacity { .. } | SharedKind::Apart { .. } => {
                        let is_counted = |i| is_counted(number, i);
                        joint.keeps_now(rule, self.time_after(time), after, is_counted)
                    }
                })
    }

    /// The time after one, as far as it matters.
    fn time_after(&self, time: u32) -> u32 {
        self.last.map_or(0, |last| (time + 1).min(last + 1))
    }

    /// Whether a state may be the first.
    pub(super) fn may_begin(&self, joint: &Joint<'_>, state: &[Single]) -> bool {
        let left = self.left(joint, &vec![0; self.uncounted.len()], state);
        joint.keeps_order(&vec![0; self.precedences], state)
            && joint.rules().enumerate().all(|(number, rule)| {
                joint.keeps_now(rule, 0, state, |i| self.is_counted(&left, (number, i)))
            })
    }

    /// Whether agents that have all arrived may rest for ever.
    pub(super) fn may_end(&self, joint: &Joint<'_>, numbers: &[u32], state: &[Single]) -> bool {
        let (time, numbers) = self.split(numbers);
        let Some(last) = self.last else { return true };
        let left = numbers.get(self.precedences..).unwrap_or_default();
        // An agent that vanishes holds its vertex for this time only.
        let rest = state.iter().map(|single| match single {
            Single::Leaving(_) => Single::Arrived(None),
            single => *single,
        });
        let rest: Vec<Single> = rest.collect();
        let mut times = time + 1..=last + 1;
        times.all(|time| {
            joint.rules().enumerate().all(|(number, rule)| {
                joint.keeps_now(rule, time, &rest, |i| self.is_counted(left, (number, i)))
            })
        })
    }

    /// Whether each agent that a zone does not count has left it, in the state that follows.
    fn left(&self, joint: &Joint<'_>, before: &[u32], after: &[Single]) -> Vec<u32> {
        let pairs = self.uncounted.iter().zip(before);
        let left = pairs.map(|(&(rule, i), &before)| {
            let is_outside = !joint.is_inside(rule, after[i]);
            before.max(u32::from(is_outside))
        });
        left.collect()
    }

    /// Whether a rule counts an agent in its zone.
    fn is_counted(&self, left: &[u32], pair: (usize, usize)) -> bool {
        let mut uncounted = self.uncounted.iter().zip(left);
        !uncounted.any(|(&other, &left)| other == pair && left == 0)
    }
}

impl Joint<'_> {
    fn rules(&self) -> impl Iterator<Item = &Shared> {
        self.problem.between.rules.iter()
    }

    /// The rules that do not count agents until they have left a zone, with the places of
    /// these agents in joint states.
    fn uncounted(&self) -> Vec<(usize, usize)> {
        let rules = self.rules().enumerate();
        let pairs = rules.flat_map(|(number, rule)| {
            let agents = self.agents.iter().enumerate();
            let agents = agents.filter(|&(_, &agent)| rule.begins_uncounted(agent));
            agents.map(move |(i, _)| (number, i))
        });
        pairs.collect()
    }

    /// Whether an agent is in the area of a rule, by its number.
    fn is_inside(&self, number: usize, single: Single) -> bool {
        let rule = self.problem.between.rules.get(number);
        match rule.map(|rule| &rule.kind) {
            Some(SharedKind::Capacity { area, .. }) => self.touched(single).any(|v| area.has(v)),
            Some(SharedKind::Gap { .. } | SharedKind::Apart { .. }) | None => false,
        }
    }

    /// The vertices that an agent counts at.
    fn touched(&self, single: Single) -> impl Iterator<Item = Vertex> {
        let place = match single {
            Single::Going { place, .. } => Some(place),
            Single::Leaving(v) | Single::Arrived(Some(v)) => Some(Place::At(v)),
            Single::Arrived(None) => None,
        };
        let terrain = &self.problem.terrain;
        place.into_iter().flat_map(|place| touched(terrain, place))
    }

    /// The agents that a rule binds, by their places in joint states.
    fn bound<'a>(&'a self, rule: &'a Shared) -> impl Iterator<Item = usize> + 'a {
        (0..self.agents.len()).filter(|&i| rule.binds(self.agents[i]))
    }

    /// Whether the first agent of a precedence is at its vertex; one that is not among the
    /// agents of the search always is.
    fn is_first_there(&self, number: usize, state: &[Single]) -> bool {
        let (agent, v) = self.problem.precedences[number].first;
        let place = self.agents.iter().position(|&other| other == agent);
        place.is_none_or(|i| Self::stands(state[i]) == Some(v))
    }

    /// Whether the second agents of precedences are at their vertices only where the first
    /// have been at theirs.
    fn keeps_order(&self, been: &[u32], state: &[Single]) -> bool {
        let mut orders = self.problem.precedences.iter().zip(been);
        orders.all(|(precedence, &been)| {
            let place = |agent| self.agents.iter().position(|&other| other == agent);
            let (first, second) = (place(precedence.first.0), place(precedence.second.0));
            let is_there = |i: usize| Self::stands(state[i]) == Some(precedence.second.1);
            been > 0 || first.is_none() || !second.is_some_and(is_there)
        })
    }

    fn keeps_gap<'t>(
        &self,
        rule: &Shared,
        steps: u32,
        (before, after): (&[Single], &[Single]),
        trail: impl Fn(usize) -> Option<&'t [u32]>,
    ) -> bool {
        let was_there = |j: usize, v: Vertex| {
            let earlier = trail(j).unwrap_or_default().iter();
            Self::stands(before[j]) == Some(v)
                || earlier.take(steps as usize - 1).any(|&there| there == v)
        };
        self.bound(rule).all(|i| {
            let Some(v) = Self::stands(after[i]) else {
                return true;
            };
            !self.bound(rule).any(|j| i != j && was_there(j, v))
        })
    }

    /// Whether a rule about single times is kept in a state at a time. A zone does not count
    /// some of the agents.
    fn keeps_now(
        &self,
        rule: &Shared,
        time: u32,
        state: &[Single],
        is_counted: impl Fn(usize) -> bool,
    ) -> bool {
        let terrain = &self.problem.terrain;
        let touches = |i: usize| self.touched(state[i]);
        match &rule.kind {
            SharedKind::Capacity { area, most, times } => {
                let inside = self
                    .bound(rule)
                    .filter(|&i| is_counted(i) && touches(i).any(|v| area.has(v)));
                !times.contains(time) || inside.count() <= *most as usize
            }
            SharedKind::Apart { distance, times } => {
                let is_near = |u: Vertex, v: Vertex| {
                    let (a, b) = (terrain.cell(u), terrain.cell(v));
                    a.x.abs_diff(b.x) + a.y.abs_diff(b.y) < *distance
                };
                !times.contains(time)
                    || self.bound(rule).all(|i| {
                        let mut others = self.bound(rule).filter(|&j| j < i);
                        !others.any(|j| touches(i).any(|u| touches(j).any(|v| is_near(u, v))))
                    })
            }
            SharedKind::Gap { .. } => true,
        }
    }
}
