//! All best plans of a small instance, by exhausting the joint states time by time.
//!
//! A *moment* is a joint state with the costs spent so far. Time by time, all moments
//! that can be reached are written down, but for those that have spent more of a cost
//! than the best plan does in all; then, backwards, those are crossed out that lead to
//! no best plan. What is left is a graph whose paths are the best plans, each once:
//! counting paths counts plans.

use std::collections::{BTreeMap, BTreeSet};

use giveway_model::{Cell, Cost, Instance, Plan};

use super::joint::{Code, Joint};
use super::law::Place;
use super::price::{Vector, after, nowhere_higher};

/// Where an agent is at a time, as plans are told apart.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Where {
    /// At a cell.
    At(Cell),
    /// In transit from one cell to another.
    Between(Cell, Cell),
    /// Vanished.
    Gone,
}

/// One plan: where each agent is at each time, and who charges in the step from it.
pub type Course = Vec<(Vec<Where>, Vec<bool>)>;

type Moment = (Code, Vector);

/// A way from a moment to the next: where to, and who charges.
type Onward = BTreeSet<(Moment, u32)>;

/// All best plans.
pub struct Every {
    joint: Joint,
    /// By time: the moments on best plans, each with the ways on.
    layers: Vec<BTreeMap<Moment, Onward>>,
    /// By time: the number of best plans up to each moment, and from there.
    before: Vec<BTreeMap<Moment, u64>>,
    behind: Vec<BTreeMap<Moment, u64>>,
}

impl Every {
    /// All plans of these costs, in the order of the objective, with a makespan of at
    /// most `latest`; `None` where there are more moments than the cap allows.
    pub fn of(instance: &Instance, best: &[u32], latest: u32, cap: usize) -> Option<Self> {
        let joint = Joint::new(instance);
        let costs: Vec<Cost> = instance.objective().costs().to_vec();
        let mut limit = Vector::default();
        limit[..best.len()].copy_from_slice(best);
        let mut layers: Vec<BTreeMap<Moment, Onward>> = Vec::new();
        let first = joint.first().into_iter();
        let in_time = |code: Code, time: u32| time + joint.to_go(&joint.decode(code)) <= latest;
        let mut now: BTreeSet<Moment> = first
            .filter(|&code| in_time(code, 0))
            .map(|code| (code, Vector::default()))
            .collect();
        let mut size = 0;
        for time in 0..latest {
            let mut layer = BTreeMap::new();
            let mut next = BTreeSet::new();
            for moment in now {
                let mut onward = Onward::new();
                joint.each_step(&joint.decode(moment.0), |to, price, charging| {
                    let vector = after(moment.1, price, &costs);
                    if nowhere_higher(&vector, &limit) && in_time(to, time + 1) {
                        onward.insert(((to, vector), charging));
                        next.insert((to, vector));
                    }
                });
                size += onward.len();
                if size > cap {
                    return None;
                }
                layer.insert(moment, onward);
            }
            layers.push(layer);
            now = next;
        }
        let ends = now
            .into_iter()
            .filter(|&(code, vector)| vector == limit && joint.is_done(&joint.decode(code)));
        layers.push(ends.map(|moment| (moment, Onward::new())).collect());
        let (before, behind) = count(&mut layers);
        Some(Self {
            joint,
            layers,
            before,
            behind,
        })
    }

    /// The number of best plans.
    pub fn count(&self) -> u64 {
        self.behind[0].values().sum()
    }

    /// In how many best plans an agent is somewhere at a time.
    pub fn visits(&self, agent: usize, time: usize) -> BTreeMap<Where, u64> {
        let mut visits = BTreeMap::new();
        let time = time.min(self.layers.len() - 1);
        for moment in self.layers[time].keys() {
            let here = self.place(agent, moment.0);
            *visits.entry(here).or_default() += self.through(time, moment);
        }
        visits
    }

    /// In how many best plans an agent charges at a time.
    pub fn charges(&self, agent: usize, time: usize) -> u64 {
        let mut count = 0;
        for (moment, onward) in self.layers.get(time).into_iter().flatten() {
            for (to, charging) in onward {
                if charging & (1 << agent) != 0 {
                    count += self.before[time][moment] * self.behind[time + 1][to];
                }
            }
        }
        count
    }

    /// The latest arrival of an agent in any best plan.
    pub fn latest_arrival(&self, agent: usize) -> u32 {
        let under_way = |moments: &BTreeMap<Moment, Onward>| {
            let mut moments = moments.keys();
            moments.any(|moment| {
                let state = self.joint.decode(moment.0)[agent];
                !self.joint.agents[agent].is_done(state)
            })
        };
        let last = self.layers.iter().rposition(under_way);
        last.map_or(0, |last| last as u32 + 1)
    }

    /// All best plans one by one; only where they are few.
    pub fn courses(&self) -> Vec<Course> {
        let mut found = Vec::new();
        for &moment in self.layers[0].keys() {
            self.follow(0, moment, &mut Course::new(), &mut found);
        }
        found
    }

    /// The least sum over the steps of a best plan, where a step costs what the price says
    /// of the places of all agents before and after it; `None` where there is no plan.
    pub fn least(&self, price: impl Fn(&[Where], &[Where]) -> u32) -> Option<u32> {
        let agents = self.joint.agents.len();
        let places =
            |code: Code| -> Vec<Where> { (0..agents).map(|a| self.place(a, code)).collect() };
        let (last, layers) = self.layers.split_last()?;
        let mut rest: BTreeMap<Moment, u32> = last.keys().map(|&moment| (moment, 0)).collect();
        for layer in layers.iter().rev() {
            let mut now = BTreeMap::new();
            for (&moment, onward) in layer {
                let here = places(moment.0);
                let costs = onward
                    .iter()
                    .filter_map(|(to, _)| Some(rest.get(to)? + price(&here, &places(to.0))));
                now.extend(costs.min().map(|least| (moment, least)));
            }
            rest = now;
        }
        rest.into_values().min()
    }

    fn follow(&self, time: usize, moment: Moment, so_far: &mut Course, found: &mut Vec<Course>) {
        let agents = self.joint.agents.len();
        let places: Vec<Where> = (0..agents).map(|a| self.place(a, moment.0)).collect();
        if time + 1 == self.layers.len() {
            let mut course = so_far.clone();
            course.push((places, vec![false; agents]));
            found.push(course);
            return;
        }
        for &(to, charging) in &self.layers[time][&moment] {
            let charges = (0..agents).map(|a| charging & (1 << a) != 0).collect();
            so_far.push((places.clone(), charges));
            self.follow(time + 1, to, so_far, found);
            so_far.pop();
        }
    }

    fn through(&self, time: usize, moment: &Moment) -> u64 {
        self.before[time][moment] * self.behind[time][moment]
    }

    fn place(&self, agent: usize, code: Code) -> Where {
        let lone = &self.joint.agents[agent];
        let state = self.joint.decode(code)[agent];
        match lone.states[state].place {
            Place::At(cell) | Place::Arrived(cell) => Where::At(cell),
            Place::Between(from, to) => Where::Between(from, to),
            Place::Gone => Where::Gone,
        }
    }
}

type Counts = Vec<BTreeMap<Moment, u64>>;

/// Crosses out what leads to no end, and counts paths from both sides.
fn count(layers: &mut [BTreeMap<Moment, Onward>]) -> (Counts, Counts) {
    let mut behind: Counts = vec![BTreeMap::new(); layers.len()];
    for time in (0..layers.len()).rev() {
        let last = time + 1 == layers.len();
        let after = behind.get(time + 1).cloned().unwrap_or_default();
        layers[time].retain(|&moment, onward| {
            onward.retain(|(to, _)| after.contains_key(to));
            let paths = if last {
                1
            } else {
                let each = onward.iter().map(|(to, _)| after[to]);
                each.fold(0, u64::saturating_add)
            };
            behind[time].insert(moment, paths);
            last || !onward.is_empty()
        });
        let kept = &layers[time];
        behind[time].retain(|moment, _| kept.contains_key(moment));
    }
    let mut before: Counts = vec![BTreeMap::new(); layers.len()];
    before[0] = layers[0].keys().map(|&moment| (moment, 1)).collect();
    for time in 1..layers.len() {
        let mut now: BTreeMap<Moment, u64> = BTreeMap::new();
        for (moment, onward) in &layers[time - 1] {
            let paths = before[time - 1][moment];
            for &(to, _) in onward {
                let sum = now.entry(to).or_default();
                *sum = sum.saturating_add(paths);
            }
        }
        // What is reached only by what was crossed out is crossed out, too.
        layers[time].retain(|moment, _| now.contains_key(moment));
        before[time] = now;
    }
    (before, behind)
}

/// Whether a plan breaks no rule, its paths ending at the arrivals.
pub fn is_legal(instance: &Instance, plan: &Plan) -> bool {
    let joint = Joint::new(instance);
    let agents = instance.agents();
    let end = agents
        .iter()
        .map(|a| plan.path(&a.name).len())
        .max()
        .unwrap_or(0);
    // Whether the states are where the plan has the agents.
    let fits = |code: Code, time: usize| {
        let states = joint.decode(code);
        agents.iter().enumerate().all(|(i, agent)| {
            let path = plan.path(&agent.name);
            let (lone, state) = (&joint.agents[i], states[i]);
            match path.get(time) {
                Some(cell) => {
                    let gone = lone.states[state].place == Place::Gone;
                    let arrives = time + 1 == path.len();
                    !gone && lone.occupies(state) == *cell && lone.is_done(state) == arrives
                }
                None => lone.is_done(state),
            }
        })
    };
    let charging = |time: usize| {
        let each = agents.iter().enumerate();
        let now = each.filter(|(_, a)| plan.charges(&a.name).contains(&(time as u32)));
        now.fold(0, |set, (i, _)| set | 1 << i)
    };
    let first = joint.first().into_iter();
    let mut now: BTreeSet<Code> = first.filter(|&code| fits(code, 0)).collect();
    for time in 0..end.saturating_sub(1) {
        let mut next = BTreeSet::new();
        for code in now {
            joint.each_step(&joint.decode(code), |to, _, charges| {
                if charges == charging(time) && fits(to, time + 1) {
                    next.insert(to);
                }
            });
        }
        now = next;
    }
    now.into_iter()
        .any(|code| joint.is_done(&joint.decode(code)))
}
