//! A running plan at one time: what is past, and the rest of it as an instance.
//!
//! The rest of a plan around which the world changes is an ordinary instance. Its time 0
//! is the time of the change, its map that of the changed world, and its agents have
//! [start states](crate::StartState). The solver looks at that instance alone. A plan of
//! it, put behind the past, is a whole plan again, which the judge looks at in the world
//! of each time.

mod agent;
mod rules;
mod whole;

use crate::change::{History, Timeline, Trajectory};
use crate::constraint::TimedConstraint;
use crate::{Instance, Plan, sorting};
pub use agent::RunningAgent;
use rules::{RestOfRules, Resumed};

/// A running plan at the time of a change.
///
/// ```
/// use giveway_model::{change::History, format::native, snapshot::Snapshot};
/// let instance = native::read_instance(r#"{
///     "giveway": 1,
///     "map": ["...."],
///     "agents": [{ "name": "A1", "start": [0, 0], "goal": [3, 0] }]
/// }"#).unwrap();
/// let plan = native::read_plan(
///     r#"{ "giveway": 1, "paths": { "A1": [[0, 0], [1, 0], [2, 0], [3, 0]] } }"#,
/// ).unwrap();
/// let history = History::new(&instance);
/// let snapshot = Snapshot::new(2, &instance, (&history, &history), &plan);
/// assert_eq!(snapshot.instance.agents()[0].start, (2, 0).into());
/// let rest = snapshot.rest();
/// assert_eq!(rest.path("A1").len(), 2);
/// assert_eq!(snapshot.whole(&rest).paths, plan.paths);
/// ```
#[derive(Clone, Debug)]
pub struct Snapshot<'a> {
    /// The time, in steps of the whole plan.
    pub at: u32,
    /// The world in which the plan went on up to that time.
    pub past: &'a History,
    /// The world from that time on: the changes of that time are in it.
    pub history: &'a History,
    /// The running plan.
    pub plan: &'a Plan,
    /// The rest as an instance, in times from 0.
    pub instance: Instance,
    /// The past and the next steps of the agents of that instance, in its order.
    pub agents: Vec<RunningAgent>,
}

impl<'a> Snapshot<'a> {
    /// A plan of an instance at a time. The worlds are the one in which the plan went on
    /// up to then, and the one from then on; they may be the same, where the plan knows
    /// the changes of that time already.
    pub fn new(
        at: u32,
        instance: &Instance,
        (past, history): (&'a History, &'a History),
        plan: &'a Plan,
    ) -> Self {
        let trajectories = past.trajectories(plan, at);
        let mut resumed: Vec<Resumed<'_>> = Vec::new();
        for (index, timeline) in history.timelines().iter().enumerate() {
            if timeline.until.is_some() {
                continue;
            }
            let is_new = past.timelines().len() <= index || plan.path(timeline.name()).is_empty();
            let mut there = trajectories.iter();
            let there = there.find(|trajectory| trajectory.timeline.name() == timeline.name());
            let found = match there {
                Some(trajectory) => RunningAgent::old(timeline, trajectory, past, at),
                None if is_new => {
                    let trajectory = Trajectory::of(history, timeline, plan);
                    Some(RunningAgent::new(timeline, trajectory, at))
                }
                None => None, // it has vanished
            };
            if let Some((agent, state, running)) = found {
                resumed.push(Resumed {
                    timeline,
                    past: there.copied(),
                    agent,
                    state,
                    running,
                });
            }
        }
        let rules = RestOfRules::new(at, (past, history), plan, &resumed);
        let constraints = rules.rewrite(&mut resumed);
        let (mut states, mut agents) = (Vec::new(), Vec::new());
        for it in resumed {
            states.push((it.agent, it.state));
            agents.push(it.running);
        }
        Self {
            at,
            past,
            history,
            plan,
            instance: {
                let grid = history.grid(at).clone();
                let assumptions = history.assumptions().iter();
                let assumptions = assumptions.map(|it| it.from_time_on(at)).collect();
                let rules = (constraints, history.constraints());
                instance.resumed(grid, states, rules, assumptions)
            },
            agents,
        }
    }

    /// The rest as it is after an edit of the rules. A rule that is added last, at the time of
    /// the snapshot, has the next number.
    pub fn with_rules(&self, edit: impl FnOnce(&mut Vec<TimedConstraint>)) -> Instance {
        let history = self.history.with_rules(edit);
        Snapshot::new(self.at, &self.instance, (self.past, &history), self.plan).instance
    }

    /// The rest of the running plan, in times from 0. It may be no plan in the changed
    /// world.
    pub fn rest(&self) -> Plan {
        let agents = || self.instance.agents().iter().zip(&self.agents);
        let paths = agents().filter(|(_, it)| !it.path.is_empty());
        let charges = agents().filter(|(_, it)| !it.charges.is_empty());
        Plan {
            paths: sorting::map(paths.map(|(agent, it)| (agent.name.clone(), it.path.clone()))),
            charges: sorting::map(
                charges.map(|(agent, it)| (agent.name.clone(), it.charges.clone())),
            ),
            ..Plan::default()
        }
    }

    /// The number of an agent in the instance; `None` of one that is gone.
    fn number(&self, timeline: &Timeline) -> Option<usize> {
        let mut agents = self.instance.agents().iter();
        agents.position(|agent| agent.name == timeline.name())
    }
}
