//! The agents that go on from a time on, as an instance has them.

use giveway_model::{
    Agent, Battery, Cell, Costs, Plan,
    change::{Career, History, Life, Whereabouts},
    check::{costs_until, level_over_time},
    sorting,
};

use super::{past::Share, rest::refused};
use crate::Refusal;

/// An agent that goes on.
pub(super) struct Member<'a> {
    /// As it is now.
    pub(super) agent: Agent,
    pub(super) share: Share,
    /// Its life; `None` of one that appears just now in a plan that lacks it.
    pub(super) life: Option<Life<'a>>,
}

/// A course at the time from which its rest begins.
pub(super) struct Resting<'a> {
    pub(super) history: &'a History,
    pub(super) changed: u32,
    pub(super) since: u32,
    pub(super) plan: &'a Plan,
}

impl<'a> Resting<'a> {
    pub(super) fn members(&self) -> Result<Vec<Member<'a>>, Refusal> {
        let lives = self.history.lives(self.plan, self.since);
        let careers = self.history.careers().iter();
        let there = careers.filter(|career| career.until.is_none() && career.from <= self.since);
        let mut members = Vec::new();
        for career in there {
            let life = lives
                .iter()
                .find(|life| life.career.name() == career.name());
            match life {
                Some(life) => members.extend(self.member(career, *life)?),
                None if career.from == self.changed && self.plan.path(career.name()).is_empty() => {
                    members.push(self.newcomer(career));
                }
                None => {}
            }
        }
        Ok(members)
    }

    /// An agent that appears just now, and of which the plan knows nothing.
    fn newcomer(&self, career: &Career) -> Member<'a> {
        let set = career.levels.last().map(|&(_, level)| level);
        Member {
            agent: self.history.agent_now(career, set),
            share: Share {
                base: self.since,
                idle: 0,
                spent: Costs::default(),
            },
            life: None,
        }
    }

    fn member(&self, career: &Career, life: Life<'a>) -> Result<Option<Member<'a>>, Refusal> {
        let since = self.since;
        let Whereabouts::At(here) = life.place(since) else {
            return Ok(None);
        };
        let mut waypoints: Vec<Cell> = career
            .duties()
            .filter(|duty| life.visit(duty).is_none_or(|visit| visit > since))
            .map(|duty| duty.cell)
            .collect();
        sorting::sort(&mut waypoints);
        waypoints.dedup();
        let done = here == career.goal() && waypoints.iter().all(|&cell| cell == here);
        let base = if done {
            self.arrival(career, &life)
        } else {
            since
        };
        // Up to the last change it slept; from then on it would have waited.
        let idle = since - base.max(self.changed).min(since);
        let mut agent = self.history.agent_now(career, None);
        agent.start = here;
        agent.waypoints = waypoints;
        if let Some(battery) = career.agent.battery {
            let level = level_over_time(self.history, &life, since).unwrap_or(0)
                - i64::from(idle_beyond(&life, since, idle));
            let floor = i64::from(self.history.rules().battery_floor);
            let level = u32::try_from(level)
                .ok()
                .filter(|_| !done || level >= floor);
            let Some(initial) = level else {
                return Err(refused(format!(
                    "The battery of {} is empty at time {since}. Questions about the time after \
                     that cannot be answered.",
                    career.name()
                )));
            };
            agent.battery = Some(Battery { initial, ..battery });
        }
        let spent = costs_until(self.history, &life, since - idle);
        Ok(Some(Member {
            agent,
            share: Share { base, idle, spent },
            life: Some(life),
        }))
    }

    /// When an agent has arrived that stays from now on. One that was under way
    /// at the last change, and happened to stand at its goal, arrives no sooner
    /// than that.
    fn arrival(&self, career: &Career, life: &Life<'_>) -> u32 {
        let times = self.history.times();
        let slept = life.sleeps(times.filter(|&time| career.from < time && time <= self.changed));
        let at_change = slept.iter().filter(|&&(_, to)| to == self.changed);
        let asleep = at_change.map(|&(from, _)| from).min();
        let mut plan = self.plan.clone();
        if let Some(path) = plan.paths.get_mut(career.name()) {
            let last = asleep.unwrap_or(self.since);
            path.truncate((last - career.from.min(last)) as usize + 1);
        }
        plan.knows = Some(self.changed);
        let life = Life::of(self.history, career, &plan);
        life.map_or(self.since, |life| life.end().min(self.since))
    }
}

/// Idle steps that the levels of the plan asked about do not count, since in it
/// the agent has arrived for good.
fn idle_beyond(life: &Life<'_>, since: u32, idle: u32) -> u32 {
    if life.end() < since { idle } else { 0 }
}
