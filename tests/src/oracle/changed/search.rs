//! The joint states from a change on, by cost.

use std::cmp::Reverse;
use std::collections::{BTreeSet, BinaryHeap};

use giveway_model::{Cell, Cost};

use super::robot::{Place, Robot, State, Step, UNLIMITED};
use super::{Changed, Known};

impl Changed {
    pub(super) fn search(&self, cap: usize) -> Known {
        let mut heap = BinaryHeap::new();
        let mut settled: BTreeSet<(u32, Vec<State>)> = BTreeSet::new();
        let firsts: Vec<Vec<Step>> = self.robots.iter().map(|robot| self.first(robot)).collect();
        let zero = vec![0; self.costs.len() + 1];
        self.combine(&firsts, &zero, &mut |states, vector| {
            heap.push(Reverse((vector, 0, states)));
        });
        while let Some(Reverse((vector, tick, states))) = heap.pop() {
            if !settled.insert((tick, states.clone())) {
                continue;
            }
            if settled.len() > cap || heap.len() > 8 * cap {
                return Known::Capped;
            }
            if states
                .iter()
                .all(|s| matches!(s.place, Place::Done(_) | Place::Gone))
            {
                return Known::Best(vector);
            }
            let robots = self.robots.iter().zip(&states);
            let steps: Vec<Vec<Step>> = robots.map(|(r, &s)| self.steps(r, s, tick)).collect();
            // After the old plan's end only whether it was kept to matters.
            let longest = self.robots.iter().map(|r| r.old.len() as u32).max();
            let next = (tick + 1).min(longest.unwrap_or(0));
            self.combine(&steps, &vector, &mut |states, vector| {
                if !settled.contains(&(next, states.clone())) {
                    heap.push(Reverse((vector, next, states)));
                }
            });
        }
        Known::None
    }

    /// All choices of one step an agent in which no two collide.
    fn combine(
        &self,
        choices: &[Vec<Step>],
        before: &[u32],
        each: &mut impl FnMut(Vec<State>, Vec<u32>),
    ) {
        let mut chosen: Vec<Vec<Step>> = vec![Vec::new()];
        for steps in choices {
            let mut longer = Vec::new();
            for list in &chosen {
                for step in steps {
                    let free = list.iter().all(|other| {
                        let here = Self::cell(step.to);
                        let meet = here.is_some() && here == Self::cell(other.to);
                        let back = other.edge.map(|(u, v)| (v, u));
                        !meet && (step.edge.is_none() || step.edge != back)
                    });
                    if free {
                        let mut list = list.clone();
                        list.push(*step);
                        longer.push(list);
                    }
                }
            }
            chosen = longer;
        }
        for list in chosen {
            let sum = |part: fn(&Step) -> u32| list.iter().map(part).sum::<u32>();
            let mut vector = before.to_vec();
            for (value, cost) in vector.iter_mut().zip(&self.costs) {
                *value += match cost {
                    Cost::Makespan => u32::from(list.iter().any(|step| step.time > 0)),
                    Cost::SumOfCosts => sum(|step| step.steps),
                    Cost::Charges => sum(|step| step.charges),
                    Cost::Moves => sum(|step| step.moves),
                    Cost::Waits => sum(|step| step.waits),
                    Cost::Penalty => 0,
                };
            }
            if let Some(last) = vector.last_mut() {
                *last += sum(|step| step.disturbed);
            }
            each(list.iter().map(|step| step.to).collect(), vector);
        }
    }

    const fn cell(state: State) -> Option<Cell> {
        match state.place {
            Place::At(cell) | Place::Done(cell) => Some(cell),
            Place::Between(..) | Place::Gone => None,
        }
    }

    /// Where an agent may be at the time of the change, as steps from nowhere.
    fn first(&self, robot: &Robot) -> Vec<Step> {
        let state = State {
            place: robot.first,
            seen: 0,
            level: robot.level,
            progress: 0,
            held: robot.held,
            same: robot.is_old,
        };
        let states = match robot.first {
            Place::At(cell) => robot.enter(state, cell),
            _ => vec![state],
        };
        let steps = states.into_iter().map(|state| Step {
            steps: if matches!(state.place, Place::Done(_)) {
                0
            } else {
                robot.rested
            },
            waits: if matches!(state.place, Place::Done(_)) {
                0
            } else {
                robot.stood
            },
            ..robot.step(state, 0)
        });
        // Below the floor only who sleeps on may be.
        let lasts = |step: &Step| {
            robot.level >= self.floor
                || (robot.rested > 0 && matches!(step.to.place, Place::Done(_)))
        };
        steps.filter(lasts).collect()
    }

    fn spend(&self, level: u32) -> Option<u32> {
        match level {
            UNLIMITED => Some(UNLIMITED),
            level if level > self.floor => Some(level - 1),
            _ => None,
        }
    }

    fn steps(&self, robot: &Robot, state: State, tick: u32) -> Vec<Step> {
        let later = State {
            held: state.held.saturating_sub(1),
            ..state
        };
        let mut found = Vec::new();
        let mut go = |state: State, edge, [charges, moves, waits]: [u32; 3]| {
            let step = robot.step(state, tick + 1);
            let recharged = state.same && (robot.charges.contains(&tick) != (charges > 0));
            let same = step.to.same && !recharged;
            found.push(Step {
                to: State { same, ..step.to },
                edge,
                time: 1,
                steps: 1,
                charges,
                moves,
                waits,
                disturbed: u32::from(state.same && !same),
            });
        };
        match state.place {
            Place::Done(_) | Place::Gone => {
                let stays = self.stays || robot.agent.goal.is_none();
                let place = if stays { state.place } else { Place::Gone };
                return vec![Step {
                    steps: 0,
                    ..robot.step(State { place, ..state }, tick + 1)
                }];
            }
            Place::Between(u, v) => {
                if let Some(level) = self.spend(state.level) {
                    for state in robot.enter(State { level, ..later }, v) {
                        go(state, Some((u, v)), [0, 0, 0]);
                    }
                }
            }
            Place::At(u) => {
                let mut levels = vec![(self.spend(state.level), 0)];
                if let Some(battery) = robot.agent.battery
                    && self.world.is_charger(u)
                    && battery.capacity >= self.floor
                {
                    levels.push((Some(battery.capacity), 1));
                }
                for (level, charges) in levels {
                    let Some(level) = level else { continue };
                    let later = State { level, ..later };
                    go(later, None, [charges, 0, 1]);
                    for v in self.world.neighbours(u) {
                        let Some(progress) = robot.may_go(state, v) else {
                            continue;
                        };
                        let later = State { progress, ..later };
                        let edge = Some((u, v));
                        if self.world.is_slow(u, v) {
                            let place = Place::Between(u, v);
                            go(State { place, ..later }, edge, [charges, 1, 0]);
                        } else {
                            for state in robot.enter(later, v) {
                                go(state, edge, [charges, 1, 0]);
                            }
                        }
                    }
                }
            }
        }
        found
    }
}
