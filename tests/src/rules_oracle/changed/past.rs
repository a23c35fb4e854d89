//! The past of each agent, read off the plan: its states at the time of the change, and what
//! it has paid by then.

use super::super::agent::{Mind, Where};
use super::super::scene::{Kind, Spot};
use super::super::steps::direction;
use super::{ChangedRules, Running, ends_at, on};

/// The costs of one agent up to a time.
#[derive(Default)]
struct Past {
    time: i64,
    charges: i64,
    moves: i64,
    waits: i64,
    penalty: i64,
}

impl ChangedRules {
    /// The costs of a past in the order of the objective.
    fn vector(&self, past: &Past) -> Vec<i64> {
        let costs = self.after.objective.iter().map(|cost| match cost.as_str() {
            "makespan" => 0,
            "sum-of-costs" => past.time,
            "charges" => past.charges,
            "moves" => past.moves,
            "waits" => past.waits,
            _ => past.penalty,
        });
        costs.collect()
    }

    fn add(&mut self, past: &Past) {
        let more = self.vector(past);
        for (cost, more) in self.past.iter_mut().zip(more) {
            *cost += more;
        }
    }

    pub(super) fn join(&mut self, agent: usize, name: &str) -> Running {
        let mut mind = self.after.fresh(agent);
        self.do_not_count(agent, &mut mind, false);
        let late = self
            .after
            .numbered(agent)
            .map(|(number, rule)| match rule.kind {
                Kind::Late(weight) if !self.is_new[number] => weight * (self.at - rule.from).max(0),
                _ => 0,
            });
        let past = Past {
            time: self.at,
            penalty: late.sum(),
            ..Past::default()
        };
        self.add(&past);
        self.latest = self.latest.max(self.at);
        let states = self.after.be_there(agent, mind, self.at, true).into_iter();
        let nothing = vec![0; self.past.len()];
        Running {
            name: name.to_owned(),
            is_old: false,
            states: states.map(|mind| (mind, nothing.clone())).collect(),
            rest: Vec::new(),
        }
    }

    /// Notes the zones in which an agent is not counted until it has left.
    fn do_not_count(&self, agent: usize, mind: &mut Mind, is_held: bool) {
        for (number, rule) in self.after.numbered(agent) {
            if let Kind::Capacity(zone, _) | Kind::Closed(zone) = &rule.kind
                && (self.is_new[number] || is_held)
                && self.after.is_in(zone, agent, mind)
            {
                mind.uncounted.insert(number);
            }
        }
    }

    /// What an agent pays for some times, by the rules as they were.
    fn penalty(&self, agent: usize, path: &[Option<Spot>], times: std::ops::Range<i64>) -> i64 {
        let stays = !self.before.vanish;
        let mut mind = self.before.fresh(agent);
        let each = times.map(|time| {
            mind.place = match on(path, time, stays) {
                Some(spot) => Where::At(spot),
                None => Where::On(
                    on(path, time - 1, stays).unwrap(),
                    on(path, time + 1, stays).unwrap(),
                ),
            };
            self.before.penalty(agent, &mind, time)
        });
        each.sum()
    }

    #[allow(clippy::too_many_lines, reason = "one agent's past, thing by thing")]
    pub(super) fn go_on(
        &mut self,
        agent: usize,
        name: &str,
        (path, charges): (&[Option<Spot>], &[i64]),
        (held, is_removed): (i64, bool),
    ) -> Running {
        let at = self.at;
        let arrival = ends_at(path);
        let stays = !self.before.vanish;
        let here = |time: i64| on(path, time, stays);
        let mut mind = self.after.fresh(agent);
        for (back, cell) in (1..).zip(&mut mind.past) {
            *cell = here(at - back);
        }
        let nothing = vec![0; self.past.len()];
        let now = at.min(arrival);
        let mut past = Past {
            charges: charges.iter().map(|&time| i64::from(time < now)).sum(),
            ..Past::default()
        };
        for time in 0..now {
            if let Some(cell) = here(time) {
                let waits = here(time + 1) == Some(cell);
                past.waits += i64::from(waits);
                past.moves += i64::from(!waits);
            }
        }
        if is_removed || !stays && arrival < at {
            mind = mind.home();
            mind.place = Where::Gone;
            if !is_removed {
                past.time = arrival;
                past.penalty = self.penalty(agent, path, 0..arrival);
                self.add(&past);
                self.latest = self.latest.max(arrival);
            }
            return Running {
                name: name.to_owned(),
                is_old: false,
                states: vec![(mind, nothing)],
                rest: Vec::new(),
            };
        }
        let old = &self.before.agents[agent];
        let been = |cell: &Spot, time: i64| (0..=time).any(|it| here(it) == Some(*cell));
        let is_done = |time: i64| {
            here(time) == Some(old.goal) && old.waypoints.iter().all(|cell| been(cell, time))
        };
        let mut since = now;
        while stays
            && is_done(now)
            && since > 0
            && is_done(since - 1)
            && !charges.contains(&(since - 1))
        {
            since -= 1;
        }
        let stood = now - since;
        let is_asleep = arrival < at;
        let has_new_goal = self.after.agents[agent].goal != old.goal;
        let mut rested = if !stays || has_new_goal {
            0
        } else if is_asleep {
            at - arrival
        } else {
            stood
        };
        if !stays {
            rested = 0;
        }
        let stood = if is_asleep || rested == 0 { 0 } else { stood };
        past.waits -= stood;
        past.time = at - rested;
        past.penalty = self.penalty(agent, path, 0..at - rested);
        let going = Past {
            time: rested,
            waits: stood,
            penalty: self.penalty(agent, path, at - rested..at),
            ..Past::default()
        };
        // What it is like.
        mind.place = match here(at) {
            Some(cell) => Where::At(cell),
            None => Where::On(here(at - 1).unwrap(), here(at + 1).unwrap()),
        };
        if let Some((capacity, initial)) = old.battery {
            let mut level = initial;
            for time in 0..now {
                level = if charges.contains(&time) {
                    capacity
                } else {
                    level - 1
                };
            }
            mind.level = Some(level);
        }
        let waypoints = &self.after.agents[agent].waypoints;
        mind.seen.clone_from(waypoints);
        mind.seen
            .retain(|cell| (0..at).any(|time| here(time) == Some(*cell)));
        let (mut sequence, mut visit, mut wait) = (0, 0, 0);
        let mut last_move = None;
        for time in 0..at {
            if let (Some(from), Some(to)) = (here(time), here(time + 1).or_else(|| here(time + 2)))
                && from != to
            {
                let end = if here(time + 1).is_some() {
                    time + 1
                } else {
                    time + 2
                };
                last_move = Some((end, direction(from, to)));
            }
        }
        for (number, rule) in self.after.numbered(agent) {
            match &rule.kind {
                Kind::Sequence(cells) => {
                    let done = &mut mind.done[sequence];
                    for time in 0..at {
                        while *done < cells.len() && here(time) == Some(cells[*done]) {
                            *done += 1;
                        }
                    }
                    sequence += 1;
                }
                Kind::Visit(cell, stay) => {
                    let run = &mut mind.stays[visit];
                    for time in 0..at {
                        if *run <= *stay {
                            let there = here(time) == Some(*cell) && rule.is_about(time);
                            *run = if there { *run + 1 } else { 0 };
                        }
                    }
                    visit += 1;
                }
                Kind::NoWaiting(_, most) => {
                    let from = if self.is_new[number] { at } else { 0 };
                    let mut time = at;
                    while time > from
                        && !is_asleep
                        && here(time - 1).is_some()
                        && here(time - 1) == here(time)
                    {
                        time -= 1;
                    }
                    mind.waited[wait] = (at - time).min(*most);
                    wait += 1;
                }
                Kind::Turns(_) => {
                    if let Some((_, facing)) = last_move {
                        mind.facing = Some(facing);
                    }
                    let end = last_move.map_or(0, |(end, _)| end);
                    mind.stood = (at - end).max(0).min(self.after.patience(agent));
                }
                _ => {}
            }
        }
        let is_along = matches!(mind.place, Where::On(..));
        mind.held = if held > 0 {
            held + i64::from(is_along)
        } else {
            0
        };
        self.do_not_count(agent, &mut mind, held > 0);
        let rest: Vec<Spot> = {
            let mut rest: Vec<Spot> = (at..=arrival.max(at)).filter_map(here).collect();
            rest.dedup();
            rest
        };
        let (going, goal) = (self.vector(&going), self.after.agents[agent].goal);
        let mut states = Vec::new();
        for mind in self.after.be_there(agent, mind, at, false) {
            if mind.place == Where::At(goal) {
                let arrived = at - rested;
                let is_in_time = self.after.numbered(agent).all(|(number, rule)| {
                    let is_old = !self.is_new[number];
                    !matches!(rule.kind, Kind::Arrive) || !is_old || rule.is_about(arrived)
                });
                let is_rest = rested > 0;
                let may_rest = if is_rest { is_in_time } else { true };
                if may_rest && self.after.may_arrive(agent, &mind, at, is_rest) {
                    states.push((mind.home(), nothing.clone()));
                }
            }
            states.push((mind, going.clone()));
        }
        self.add(&past);
        self.latest = self.latest.max(at - rested);
        Running {
            name: name.to_owned(),
            is_old: true,
            states,
            rest,
        }
    }
}
