//! A plan of one's own: agents that a person leads by hand, step by step, while
//! the judge tells at each step what is against the rules.
//!
//! It begins with the plan that is there. An agent that is led keeps its path up
//! to the time at which that began; all others go on as planned.

mod facts;
mod judged;
mod step;

use std::rc::Rc;

use giveway_model::check::Violation;
use giveway_model::words::Sentence;
use giveway_model::{Agent, AtGoal, Cell, Grid, Plan, Scene};

use crate::Answer;

pub use facts::{Facts, facts};

/// What a person does while leading an agent.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Lead {
    /// Leads the agent that is selected, from the time shown.
    Begin,
    /// The agent goes so many cells right and down; neither is a wait.
    Step((i32, i32)),
    /// The agent goes to a cell beside it; on a cell further away, the agent that
    /// stands there is selected.
    To(Cell),
    /// The agent charges in its next step, or does not.
    Charge,
    /// The last step was none.
    Back,
    /// Leaves the plan of one's own.
    Discard,
}

/// A plan of one's own, and which of its agents is led.
#[derive(Clone, Debug, PartialEq)]
pub struct Steering {
    /// The plan that it began with.
    pub about: Rc<Answer>,
    /// Who is led, by its index in the scene.
    pub agent: usize,
    /// The plan of one's own, as the page shows plans; it may break any rule.
    pub answer: Rc<Answer>,
    /// What is against the rules, by time. What only follows from an agent that
    /// has not been led to its goal yet is not among it.
    pub violations: Vec<Violation>,
    /// What is not done yet: goals that are not reached, waypoints that are left out.
    pub to_do: Vec<Violation>,
    /// How many problems there are only while agents stay where they have been led to.
    pub(crate) follows: usize,
    /// What the last step brought, or why it was not made; empty where there is
    /// nothing to tell.
    pub told: Sentence,
    /// Every step as it was led: waits at a goal stay, as it may be left again.
    plan: Plan,
    /// From which time on each agent is led.
    from: Vec<Option<u32>>,
}

impl Steering {
    /// Leads an agent of a plan from a time on; `None` where [`Steering::can_begin`]
    /// says no.
    pub(crate) fn begin(about: &Rc<Answer>, agent: usize, time: u32) -> Option<Self> {
        if !Self::can_begin(about, agent, time) {
            return None;
        }
        let from = vec![None; about.draft.agents().len()];
        Self::taking(about, about.plan()?.clone(), from, agent, time)
    }

    /// Whether an answer has a plan in one world, and in it the agent is not gone
    /// by a time.
    pub(crate) fn can_begin(about: &Answer, agent: usize, time: u32) -> bool {
        let plan = about.plan().filter(|_| about.course.is_none());
        plan.is_some_and(|plan| end(about.draft.scene(), plan, agent, time).is_some())
    }

    /// Leads another agent, or this one anew, from a time on.
    pub(crate) fn lead(&self, agent: usize, time: u32) -> Option<Self> {
        let (plan, from) = (self.plan.clone(), self.from.clone());
        Self::taking(&self.about, plan, from, agent, time)
    }

    fn taking(
        about: &Rc<Answer>,
        mut plan: Plan,
        mut from: Vec<Option<u32>>,
        agent: usize,
        time: u32,
    ) -> Option<Self> {
        let scene = about.draft.scene();
        let who = scene.agents.get(agent)?;
        let end = end(scene, &plan, agent, time)?;
        let path = plan.paths.get_mut(&who.name)?;
        let rest = who.goal.or_else(|| path.last().copied().flatten());
        path.resize(end + 1, rest);
        let end = u32::try_from(end).ok()?;
        if let Some(charges) = plan.charges.get_mut(&who.name) {
            charges.retain(|&charge| charge < end);
        }
        let from_now = from.get_mut(agent)?;
        *from_now = Some(from_now.map_or(end, |before| before.min(end)));
        Self::judged(about, plan, from, agent)
    }

    /// The same with why a step was not made.
    pub(crate) fn refusing(&self, told: Sentence) -> Self {
        Self {
            told,
            ..self.clone()
        }
    }

    /// The plan as it was led so far, for what the browser keeps.
    pub(crate) const fn led(&self) -> (&Plan, &[Option<u32>]) {
        (&self.plan, self.from.as_slice())
    }

    /// What the browser kept of it; `None` where that does not fit the plan.
    pub(crate) fn kept(
        about: &Rc<Answer>,
        plan: Plan,
        from: Vec<Option<u32>>,
        agent: usize,
    ) -> Option<Self> {
        let agents = about.draft.agents();
        let ends = |(agent, from): (&Agent, &Option<u32>)| {
            let path = plan.path(&agent.name);
            path.last().copied().flatten().is_some()
                && from.is_none_or(|from| (from as usize) < path.len())
        };
        let fits = about.plan().is_some() && about.course.is_none() && from.len() == agents.len();
        let is_led = from.get(agent)?.is_some();
        let fits = fits && is_led && agents.iter().zip(&from).all(ends);
        fits.then(|| Self::judged(about, plan, from, agent))?
    }

    fn grid(&self) -> &Grid {
        self.about.draft.grid()
    }

    /// The name of the agent that is led.
    pub fn name(&self) -> &str {
        let who = self.about.draft.agents().get(self.agent);
        who.map_or("", |who| who.name.as_str())
    }

    fn path(&self) -> &[Option<Cell>] {
        self.plan.path(self.name())
    }

    /// Where the agent has been led to.
    pub fn cell(&self) -> Cell {
        let last = self.path().last().copied().flatten();
        last.unwrap_or(Cell::new(0, 0))
    }

    /// The time up to which it has been led, in steps.
    pub fn time(&self) -> u32 {
        u32::try_from(self.path().len().saturating_sub(1)).unwrap_or(u32::MAX)
    }

    /// Whether there is a step to take back.
    pub fn can_go_back(&self) -> bool {
        let from = self.from.get(self.agent).copied().flatten();
        from.is_some_and(|from| self.time() > from)
    }

    /// Whether the agent charges in its next step; `None` where it cannot.
    pub fn charges(&self) -> Option<bool> {
        let who = self.about.draft.agents().get(self.agent)?;
        let can = who.battery.is_some() && self.grid().is_charger(self.cell());
        can.then(|| self.plan.charges(&who.name).contains(&self.time()))
    }
}

/// The time up to which an agent's path is kept where it is led from a time on;
/// `None` where it is gone by then.
fn end(scene: &Scene, plan: &Plan, agent: usize, time: u32) -> Option<usize> {
    let who = scene.agents.get(agent)?;
    let path = plan.path(&who.name);
    let (last, time) = (path.len().checked_sub(1)?, time as usize);
    if time <= last {
        // Within a slow move there is no turning: it is made.
        let rest = path.get(time..)?;
        return Some(time + rest.iter().position(Option::is_some)?);
    }
    if who.goal.is_some() && path.last() != Some(&who.goal) {
        // Not led further so far: it goes on from where it is.
        return Some(last);
    }
    (scene.rules.at_end_of(who) == AtGoal::Stay).then_some(time)
}
