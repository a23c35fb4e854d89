//! The steps of one agent: waits, moves and charges that its rules allow.

use super::agent::{Mind, Where};
use super::scene::{Kind, RuleScene, Spot};

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

impl RuleScene {
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
