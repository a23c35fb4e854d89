//! One agent: its states, and the steps that begin in them.

use std::collections::BTreeSet;

use super::scene::{Kind, OracleRule, RuleScene, Spot};

/// Where an agent is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Where {
    /// At a cell.
    At(Spot),
    /// In transit.
    On(Spot, Spot),
    /// Arrived, at its goal.
    Home,
    /// Arrived, and vanished.
    Gone,
}

/// An agent at one time, with what its rules need to remember.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Mind {
    pub(super) place: Where,
    pub(super) level: Option<i64>,
    pub(super) seen: BTreeSet<Spot>,
    /// Of each of its sequences, how many cells are done.
    pub(super) done: Vec<usize>,
    /// Of each of its visits, for how many times on end it has been there; one more than the
    /// stay: made.
    pub(super) stays: Vec<i64>,
    /// Of each rule about waits, how many it has just made, as far as the rule asks.
    pub(super) waited: Vec<i64>,
    /// Wait steps since its last move, as far as turns ask.
    pub(super) stood: i64,
    pub(super) facing: Option<i64>,
    /// How long it is still broken down.
    pub(super) held: i64,
    /// The zones, by rule, in which it is not counted until it has left.
    pub(super) uncounted: BTreeSet<usize>,
    /// How far it has come on the path that it is held to.
    pub(super) progress: usize,
    /// Its cells 1, 2, ... steps ago, as far as a gap asks.
    pub(super) past: Vec<Option<Spot>>,
}

/// A step: where it leads, the directed edge in use, and what it costs: charges, moves, waits.
#[derive(Clone, Debug)]
pub(super) struct Way {
    pub(super) to: Mind,
    pub(super) edge: Option<(Spot, Spot)>,
    pub(super) costs: [i64; 3],
}

const SIDES: [(i64, i64); 4] = [(0, -1), (1, 0), (0, 1), (-1, 0)];

pub(super) fn direction(from: Spot, to: Spot) -> i64 {
    let side = (to.0 - from.0, to.1 - from.1);
    let mut sides = (0..).zip(SIDES);
    sides.find(|(_, other)| *other == side).unwrap().0
}

fn quarters(one: i64, other: i64) -> i64 {
    (one - other).rem_euclid(4).min((other - one).rem_euclid(4))
}

impl Mind {
    /// An agent that has arrived where it is.
    pub(super) fn home(&self) -> Self {
        Self {
            place: Where::Home,
            level: None,
            seen: BTreeSet::new(),
            done: Vec::new(),
            stays: Vec::new(),
            waited: Vec::new(),
            stood: 0,
            facing: None,
            held: 0,
            progress: 0,
            ..self.clone()
        }
    }
}

impl RuleScene {
    pub(super) fn of(&self, agent: usize) -> impl Iterator<Item = &OracleRule> {
        self.numbered(agent).map(|(_, rule)| rule)
    }

    /// The rules of an agent with their numbers.
    pub(super) fn numbered(&self, agent: usize) -> impl Iterator<Item = (usize, &OracleRule)> {
        let rules = self.rules.iter().enumerate();
        rules.filter(move |(_, rule)| rule.agents.contains(&agent))
    }

    /// The cell that it is at.
    pub(super) fn cell(&self, agent: usize, mind: &Mind) -> Option<Spot> {
        match mind.place {
            Where::At(spot) => Some(spot),
            Where::Home => Some(self.agents[agent].goal),
            Where::On(..) | Where::Gone => None,
        }
    }

    /// The cells that count for zones and distances.
    pub(super) fn touches(&self, agent: usize, mind: &Mind) -> Vec<Spot> {
        match mind.place {
            Where::On(from, to) => vec![from, to],
            _ => self.cell(agent, mind).into_iter().collect(),
        }
    }

    pub(super) fn is_in(&self, zone: &BTreeSet<Spot>, agent: usize, mind: &Mind) -> bool {
        self.touches(agent, mind)
            .iter()
            .any(|spot| zone.contains(spot))
    }

    /// What an agent on its way pays for a time.
    pub(super) fn penalty(&self, agent: usize, mind: &Mind, time: i64) -> i64 {
        let rules = self.of(agent).map(|rule| match &rule.kind {
            Kind::Avoid(zone, weight) if self.is_in(zone, agent, mind) => *weight,
            Kind::Late(weight) if time >= rule.from => *weight,
            _ => 0,
        });
        rules.sum()
    }

    pub(super) fn begin(&self, agent: usize) -> Vec<Mind> {
        self.be_there(agent, self.fresh(agent), 0, true)
    }

    /// An agent at its start that has done nothing yet.
    pub(super) fn fresh(&self, agent: usize) -> Mind {
        let task = &self.agents[agent];
        let count = |is: fn(&Kind) -> bool| self.of(agent).filter(|rule| is(&rule.kind)).count();
        let gaps = self.of(agent).map(|rule| match rule.kind {
            Kind::Gap(steps) => steps,
            _ => 0,
        });
        let turns = count(|kind| matches!(kind, Kind::Turns(_))) > 0;
        Mind {
            place: Where::At(task.start),
            level: task.battery.map(|(_, level)| level),
            seen: BTreeSet::new(),
            done: vec![0; count(|kind| matches!(kind, Kind::Sequence(_)))],
            stays: vec![0; count(|kind| matches!(kind, Kind::Visit(..)))],
            waited: vec![0; count(|kind| matches!(kind, Kind::NoWaiting(..)))],
            stood: 0,
            facing: task.heading.filter(|_| turns),
            held: 0,
            uncounted: BTreeSet::new(),
            progress: 0,
            past: vec![None; gaps.max().unwrap_or(0)],
        }
    }

    /// What an agent has become by being where it is: on its way, and arrived where it may.
    pub(super) fn be_there(
        &self,
        agent: usize,
        mut mind: Mind,
        time: i64,
        entered: bool,
    ) -> Vec<Mind> {
        if mind.level.is_some_and(|level| level < self.floor) {
            return Vec::new();
        }
        let here = self.cell(agent, &mind);
        let task = &self.agents[agent];
        mind.seen
            .extend(here.filter(|spot| task.waypoints.contains(spot)));
        let (mut sequence, mut visit) = (0, 0);
        for (number, rule) in self.numbered(agent) {
            match &rule.kind {
                Kind::Closed(zone) | Kind::Capacity(zone, _) => {
                    if !self.is_in(zone, agent, &mind) {
                        mind.uncounted.remove(&number);
                    } else if matches!(rule.kind, Kind::Closed(_))
                        && rule.is_about(time)
                        && !mind.uncounted.contains(&number)
                    {
                        return Vec::new();
                    }
                }
                Kind::Sequence(cells) => {
                    let done = &mut mind.done[sequence];
                    while here.is_some() && cells.get(*done).copied() == here {
                        *done += 1;
                    }
                    sequence += 1;
                }
                Kind::Visit(cell, stay) => {
                    let run = &mut mind.stays[visit];
                    if *run <= *stay {
                        let there = here == Some(*cell) && rule.is_about(time);
                        *run = if there { *run + 1 } else { 0 };
                    }
                    visit += 1;
                }
                _ => {}
            }
        }
        let arrives =
            entered && here == Some(task.goal) && self.may_arrive(agent, &mind, time, false);
        let home = mind.home();
        [mind].into_iter().chain(arrives.then_some(home)).collect()
    }

    /// Whether an agent at its goal may have arrived; `rested` where it arrived before, which
    /// no rule about arrivals looks at here.
    pub(super) fn may_arrive(&self, agent: usize, mind: &Mind, time: i64, rested: bool) -> bool {
        let task = &self.agents[agent];
        let (mut sequence, mut visit) = (0, 0);
        mind.seen == task.waypoints
            && task
                .path
                .as_ref()
                .is_none_or(|path| mind.progress + 1 == path.len())
            && self.numbered(agent).all(|(number, rule)| match &rule.kind {
                Kind::Sequence(cells) => {
                    sequence += 1;
                    mind.done[sequence - 1] == cells.len()
                }
                Kind::Visit(cell, stay) => {
                    visit += 1;
                    let run = mind.stays[visit - 1];
                    let since = if run > 0 {
                        time + 1 - run
                    } else {
                        time.max(rule.from)
                    };
                    run > *stay || !self.vanish && *cell == task.goal && since + stay <= rule.to
                }
                Kind::Arrive => rested || rule.is_about(time),
                Kind::Closed(zone) => {
                    self.vanish
                        || !zone.contains(&task.goal)
                        || rule.to < time
                        || mind.uncounted.contains(&number)
                }
                _ => true,
            })
    }

    /// The most steps that an agent stands as far as turns ask.
    pub(super) fn patience(&self, agent: usize) -> i64 {
        let counts = self.of(agent).map(|rule| match rule.kind {
            Kind::Turns(quarter) => 2 * quarter,
            _ => 0,
        });
        counts.max().unwrap_or(0)
    }

    /// The waits of an agent after one more at a cell; `None` where that is too long.
    fn wait(&self, agent: usize, mind: &Mind, here: Spot) -> Option<Vec<i64>> {
        let rules = self.of(agent).filter_map(|rule| match &rule.kind {
            Kind::NoWaiting(zone, most) => Some((zone, *most)),
            _ => None,
        });
        let after = rules.zip(&mind.waited).map(|((zone, most), &waited)| {
            if mind.held > 0 {
                Some(waited)
            } else if zone.contains(&here) && waited >= most {
                None
            } else {
                Some((waited + 1).min(most))
            }
        });
        after.collect()
    }

    /// The steps that begin in a state at a time.
    pub(super) fn ways(&self, agent: usize, mind: &Mind, time: i64) -> Vec<Way> {
        let mut past = vec![self.cell(agent, mind)];
        past.extend(&mind.past);
        past.truncate(mind.past.len());
        let next = |place: Where| Mind {
            place,
            past: past.clone(),
            held: (mind.held - 1).max(0),
            ..mind.clone()
        };
        let here = match mind.place {
            Where::Home | Where::Gone => {
                let place = if self.vanish { Where::Gone } else { mind.place };
                return vec![Way {
                    to: next(place),
                    edge: None,
                    costs: [0; 3],
                }];
            }
            Where::On(from, to) => {
                let mut there = next(Where::At(to));
                there.level = mind.level.map(|level| level - 1);
                let minds = self.be_there(agent, there, time + 1, true).into_iter();
                let way = |to_mind| Way {
                    to: to_mind,
                    edge: Some((from, to)),
                    costs: [0; 3],
                };
                return minds.map(way).collect();
            }
            Where::At(spot) => spot,
        };
        let mut ways = Vec::new();
        let mut levels = vec![(mind.level.map(|level| level - 1), 0)];
        if let Some((capacity, _)) = self.agents[agent].battery
            && self.chargers.contains(&here)
        {
            levels.push((Some(capacity), 1));
        }
        for (level, charge) in levels {
            if let Some(waited) = self.wait(agent, mind, here) {
                let mut there = next(Where::At(here));
                there.level = level;
                there.waited = waited;
                there.stood = (mind.stood + 1).min(self.patience(agent));
                for to in self.be_there(agent, there, time + 1, false) {
                    ways.push(Way {
                        to,
                        edge: None,
                        costs: [charge, 0, 1],
                    });
                }
            }
            for side in SIDES {
                let there = (here.0 + side.0, here.1 + side.1);
                if !self.may_move(agent, mind, (here, there), time) {
                    continue;
                }
                let is_slow = self.slow.contains(&here) && self.slow.contains(&there);
                let place = if is_slow {
                    Where::On(here, there)
                } else {
                    Where::At(there)
                };
                let mut moved = next(place);
                moved.level = level;
                moved.stood = 0;
                moved.waited.fill(0);
                moved.progress += usize::from(self.agents[agent].path.is_some());
                let turns = self
                    .of(agent)
                    .any(|rule| matches!(rule.kind, Kind::Turns(_)));
                moved.facing = turns.then(|| direction(here, there));
                for to in self.be_there(agent, moved, time + 1, !is_slow) {
                    ways.push(Way {
                        to,
                        edge: Some((here, there)),
                        costs: [charge, 1, 0],
                    });
                }
            }
        }
        ways
    }

    fn may_move(&self, agent: usize, mind: &Mind, step: (Spot, Spot), time: i64) -> bool {
        let path = self.agents[agent].path.as_ref();
        self.free.contains(&step.1)
            && mind.held == 0
            && path.is_none_or(|path| path.get(mind.progress + 1) == Some(&step.1))
            && self.of(agent).all(|rule| match &rule.kind {
                Kind::OneWay(back) => !back.contains(&step),
                Kind::Depart => time >= rule.from,
                Kind::Turns(quarter) => mind.facing.is_none_or(|facing| {
                    mind.stood >= quarter * quarters(facing, direction(step.0, step.1))
                }),
                _ => true,
            })
    }
}
