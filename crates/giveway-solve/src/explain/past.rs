//! What is past when a question is asked of a plan around which the world has
//! changed, and how an answer about the rest is told as one about the whole.
//!
//! The rest of such a plan is a plan of an instance of its own: agents begin
//! where they are, times run from 0 ([`super::rest`] makes it). All searches
//! look at that instance. [`Past`] translates: times are those of the whole,
//! costs have what was spent before, other plans stand behind the past. In one
//! world nothing is past, and nothing is translated.

use std::collections::BTreeMap;
use std::rc::Rc;

use giveway_model::tr;
use giveway_model::{
    Costs, Instance, Plan, Question,
    change::History,
    check::{self, Rule, Violation, arrivals, check, check_history},
    question::{Misfit, fits},
    sorting,
};

use crate::problem::Problem;

/// What is past; by default nothing.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Past {
    course: Option<Rc<Course>>,
}

/// A course up to the time from which a question is answered.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Course {
    /// The time from which the question is answered.
    pub(super) since: u32,
    /// The question as it was asked.
    pub(super) question: Question,
    /// The world over time, all changes up to then in it.
    pub(super) history: History,
    /// The whole plan that is asked about.
    pub(super) plan: Plan,
    /// The agents that go on.
    pub(super) shares: BTreeMap<String, Share>,
    /// What those that are there no more add to all costs.
    pub(super) gone: Costs,
}

/// What one agent has behind it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Share {
    /// Its arrival where it stays where it is from now on.
    pub(super) base: u32,
    /// The steps at its goal, since the last change, that become waits if it
    /// leaves.
    pub(super) idle: u32,
    /// Its charges, moves and waits so far, idle steps apart.
    pub(super) spent: Costs,
}

impl Past {
    pub(super) fn new(course: Course) -> Self {
        Self {
            course: Some(Rc::new(course)),
        }
    }

    pub(super) fn course(&self) -> Option<&Course> {
        self.course.as_deref()
    }

    /// The time from which the question is answered; `None` in one world.
    pub(crate) fn since(&self) -> Option<u32> {
        self.course().map(|course| course.since)
    }

    /// A time of the rest as one of the whole.
    pub(crate) fn time(&self, time: u32) -> u32 {
        time.saturating_add(self.since().unwrap_or(0))
    }

    /// How long an agent has been at its goal, with nothing left to do: what it
    /// adds to the sum of costs that it leaves again.
    fn slept(&self, name: &str) -> u32 {
        let course = self.course();
        let share = course.and_then(|course| Some((course, course.shares.get(name)?)));
        share.map_or(0, |(course, share)| course.since - share.base)
    }

    /// The costs of a plan of the rest, as searches count them.
    pub(crate) fn costs(&self, instance: &Instance, plan: &Plan) -> Option<Costs> {
        let mut costs = check::costs(instance, plan)?;
        for (agent, arrival) in instance.agents().iter().zip(arrivals(instance, plan)) {
            if arrival.is_some_and(|arrival| arrival > 0) {
                costs.sum_of_costs += self.slept(&agent.name);
            }
        }
        Some(costs)
    }

    /// Tells a problem what it costs to wake agents.
    pub(crate) fn wake(&self, instance: &Instance, problem: &mut Problem) {
        for (agent, task) in instance.agents().iter().zip(&mut problem.tasks) {
            task.woken = self.slept(&agent.name);
        }
    }

    /// The rules that a plan of the rest breaks, in times of the whole. Of the
    /// moves of an agent during its breakdown only the first is listed: the others
    /// follow from it.
    pub(crate) fn check(&self, instance: &Instance, plan: &Plan) -> Vec<Violation> {
        let Some(course) = self.course() else {
            return check(instance, plan).violations;
        };
        let since = course.since;
        let mut plan = plan.clone();
        for charges in plan.charges.values_mut() {
            for time in charges {
                *time += since;
            }
        }
        if since > 0 {
            let agents = instance.agents().iter();
            plan.from = sorting::map(agents.map(|agent| (agent.name.clone(), since)));
        }
        let mut violations = check_history(&History::beginning(instance, since), &plan).violations;
        let mut moved = Vec::new();
        violations.retain(|violation| {
            let agent = violation.agents.first();
            let held = agent.map_or(0, |agent| instance.held(agent));
            let is_held = violation.rule == Rule::Move && violation.time < since + held;
            let first = !is_held || !moved.contains(&agent.cloned());
            moved.extend(is_held.then(|| agent.cloned()));
            first
        });
        violations
    }

    /// The costs of the whole, where those of the rest are these.
    pub(crate) fn whole_costs(&self, costs: Costs, plan: &Plan) -> Costs {
        let Some(course) = self.course() else {
            return costs;
        };
        let mut whole = Costs {
            makespan: course.gone.makespan,
            sum_of_costs: costs.sum_of_costs + course.gone.sum_of_costs,
            charges: costs.charges + course.gone.charges,
            moves: costs.moves + course.gone.moves,
            waits: costs.waits + course.gone.waits,
        };
        for (name, share) in &course.shares {
            let Some(path) = plan.paths.get(name) else {
                continue; // it is left out
            };
            whole.makespan = whole.makespan.max(share.base);
            whole.sum_of_costs += share.base;
            whole.charges += share.spent.charges;
            whole.moves += share.spent.moves;
            whole.waits += share.spent.waits;
            let first = path.first();
            if path.iter().any(|entry| Some(entry) != first) {
                whole.waits += share.idle;
            }
        }
        if costs.makespan > 0 {
            whole.makespan = whole.makespan.max(course.since + costs.makespan);
        }
        whole
    }

    /// The costs of the whole with a plan of the rest.
    pub(crate) fn told_costs(&self, instance: &Instance, plan: &Plan) -> Option<Costs> {
        let costs = self.costs(instance, plan)?;
        Some(self.whole_costs(costs, plan))
    }

    /// A question about the rest in times of the whole.
    pub(crate) fn told_question(&self, question: &Question) -> Question {
        shifted(question, |time| self.time(time))
    }

    /// A plan of the rest with nothing listed before it: its times are those of
    /// the whole, for sentences about it.
    pub(crate) fn padded(&self, plan: &Plan) -> Plan {
        let since = self.since().unwrap_or(0);
        let mut plan = plan.clone();
        for path in plan.paths.values_mut() {
            path.splice(0..0, (0..since).map(|_| None));
        }
        for charges in plan.charges.values_mut() {
            for time in charges {
                *time += since;
            }
        }
        plan
    }

    /// Why a question does not fit, in times of the whole.
    pub(crate) fn misfit(
        &self,
        question: &Question,
        instance: &Instance,
        plan: &Plan,
        misfit: Misfit,
    ) -> Misfit {
        let Some(since) = self.since() else {
            return misfit;
        };
        let about = |what: &str| Misfit::NotSo {
            is_so: tr!(
                "{what} already at its goal at time {since}, and the past cannot change.",
                what,
                since
            ),
            ask: None,
        };
        let told = match (question, misfit) {
            (Question::Arrival { agent }, Misfit::NotSo { ask: None, .. }) => {
                return about(&tr!("{agent} was", agent));
            }
            (Question::Makespan | Question::SumOfCosts, Misfit::NotSo { ask: None, .. }) => {
                return about(tr!("Every robot was"));
            }
            (_, misfit @ Misfit::Fault { .. }) => misfit,
            (_, misfit) => {
                let asked = self.told_question(question);
                let told = fits(&asked, instance, &self.padded(plan));
                told.err().unwrap_or(misfit)
            }
        };
        match told {
            Misfit::NotSo { is_so, ask } => Misfit::NotSo {
                is_so: tr!("From time {since} on: {is_so}", since, is_so),
                ask,
            },
            fault @ Misfit::Fault { .. } => fault,
        }
    }
}

/// A question with other times.
pub(super) fn shifted(question: &Question, shift: impl Fn(u32) -> u32) -> Question {
    let mut question = question.clone();
    match &mut question {
        Question::Wait { from, to, .. } => {
            *from = from.map(&shift);
            *to = to.map(&shift);
        }
        Question::Charge { time, .. }
        | Question::Visit { time, .. }
        | Question::Move { time, .. }
        | Question::NoMove { time, .. } => *time = time.map(&shift),
        _ => {}
    }
    question
}
