//! Plans of the rest as whole plans: the past, and the rest behind it.

use super::{RunningAgent, Snapshot};
use crate::change::{Timeline, Trajectory, Whereabouts};
use crate::check::{Report, check_history, costs_until, penalty_until};
use crate::{Agent, Cell, Costs, Path, Plan};

impl Snapshot<'_> {
    /// A plan of the rest behind the past, in times of the whole. An agent that it leaves
    /// out is removed at the time of the snapshot.
    pub fn whole(&self, rest: &Plan) -> Plan {
        let mut plan = Plan {
            knows: Some(self.at),
            ..self.plan.clone()
        };
        plan.paths.clear();
        plan.charges.clear();
        for timeline in self.history.timelines() {
            let name = timeline.name();
            if let Some(path) = timeline.stood(self.plan.path(name)) {
                self.stand(timeline, path, &mut plan);
                continue;
            }
            let goes_on = self.number(timeline);
            let is_removed = match goes_on {
                Some(_) => !rest.paths.contains_key(name),
                None => timeline.until == Some(self.at) && !self.plan.until.contains_key(name),
            };
            if goes_on.is_none() && !is_removed {
                // It has been gone for longer, or the plan knows already that it goes.
                let trajectory = Trajectory::of(self.history, timeline, self.plan);
                let path = trajectory.map_or(self.plan.path(name), |it| it.path);
                plan.paths.insert(name.to_owned(), path.to_vec());
                let charges = self.plan.charges(name).to_vec();
                plan.charges.insert(name.to_owned(), charges);
                continue;
            }
            if timeline.from > 0 {
                plan.from.insert(name.to_owned(), timeline.from);
            }
            let (path, charges) = self.before(timeline);
            plan.paths.insert(name.to_owned(), path);
            plan.charges.insert(name.to_owned(), charges);
            match goes_on {
                Some(number) if !is_removed => self.go_on(number, timeline, rest, &mut plan),
                _ => {
                    plan.until.insert(name.to_owned(), self.at);
                }
            }
        }
        plan.charges.retain(|_, charges| !charges.is_empty());
        plan.slept.retain(|_, slept| !slept.is_empty());
        plan
    }

    /// Adds an agent that has broken down for good.
    fn stand(&self, timeline: &Timeline, path: Path, plan: &mut Plan) {
        let name = timeline.name().to_owned();
        let until = timeline.until.unwrap_or(self.at);
        let charges = self.plan.charges(&name).iter().copied();
        let charges = charges.filter(|&time| time < until).collect();
        if timeline.from > 0 {
            plan.from.insert(name.clone(), timeline.from);
        }
        plan.charges.insert(name.clone(), charges);
        plan.paths.insert(name, path);
    }

    /// The judge's verdict on a plan of the rest: that on the whole plan, in the world of
    /// each time.
    pub fn check(&self, rest: &Plan) -> Report {
        check_history(self.history, &self.whole(rest))
    }

    /// The costs of a whole plan, where those of its rest are these.
    pub fn whole_costs(&self, costs: Costs, rest: &Plan) -> Costs {
        let mut whole = costs;
        if costs.makespan > 0 {
            whole.makespan += self.at;
        }
        let mut add = |arrival: u32, spent: &Costs| {
            whole.makespan = whole.makespan.max(arrival);
            whole.sum_of_costs += arrival;
            whole.charges += spent.charges;
            whole.moves += spent.moves;
            whole.waits += spent.waits;
            whole.penalty = whole.penalty.saturating_add(spent.penalty);
        };
        for (agent, running) in self.instance.agents().iter().zip(&self.agents) {
            if rest.paths.contains_key(&agent.name) {
                add(self.rested_since(agent), &running.spent);
            }
        }
        for timeline in self.history.timelines() {
            let is_gone = timeline.until.is_none() && self.number(timeline).is_none();
            let gone = is_gone.then(|| Trajectory::of(self.history, timeline, self.plan));
            if let Some(gone) = gone.flatten() {
                let end = gone.end();
                let mut spent = costs_until(self.history, &gone, end);
                spent.penalty = penalty_until(self.history, self.plan, timeline.name(), end);
                add(end, &spent);
            }
        }
        whole
    }

    /// When an agent arrived, if it stays where it is.
    fn rested_since(&self, agent: &Agent) -> u32 {
        self.at - self.instance.start_state(&agent.name).rested
    }

    /// The path and the charges of an agent before the time of the snapshot.
    fn before(&self, timeline: &Timeline) -> (Path, Vec<u32>) {
        let mut timelines = self.past.timelines().iter();
        let old = timelines.find(|it| it.name() == timeline.name());
        let trajectory = old.and_then(|old| Trajectory::of(self.past, old, self.plan));
        let Some(trajectory) = trajectory else {
            return Default::default();
        };
        let places = (timeline.from..self.at).map(|time| match trajectory.place(time) {
            Whereabouts::At(cell) => Some(cell),
            Whereabouts::Transit { .. } | Whereabouts::Absent => None,
        });
        let charges = trajectory.charges.iter().copied();
        (
            places.collect(),
            charges.filter(|&time| time < self.at).collect(),
        )
    }

    /// Adds what an agent does from the time of the snapshot on to a plan that ends there.
    fn go_on(&self, number: usize, timeline: &Timeline, rest: &Plan, plan: &mut Plan) {
        let (Some(agent), Some(RunningAgent { asleep_since, .. })) =
            (self.instance.agents().get(number), self.agents.get(number))
        else {
            return;
        };
        let name = &agent.name;
        let own = rest.path(name);
        let arrived = self.rested_since(agent);
        let path = plan.paths.entry(name.clone()).or_default();
        path.extend(own);
        if stays(own) && arrived < self.at {
            path.truncate((arrived - timeline.from) as usize + 1);
            if let Some(slept) = plan.slept.get_mut(name) {
                slept.retain(|&[_, to]| to <= arrived);
            }
        } else if let Some(since) = *asleep_since {
            let slept = plan.slept.entry(name.clone()).or_default();
            slept.push([since, self.at]);
        }
        let charges = plan.charges.entry(name.clone()).or_default();
        charges.extend(rest.charges(name).iter().map(|time| time + self.at));
        // The path ends at the arrival.
        let cut = Trajectory::of(self.history, timeline, plan).map(|it| it.path.to_vec());
        if let Some(cut) = cut {
            plan.paths.insert(name.clone(), cut);
        }
    }
}

/// Whether a path begins where it ends, and never leaves.
fn stays(path: &[Option<Cell>]) -> bool {
    path.first()
        .is_some_and(|first| path.iter().all(|entry| entry == first))
}
