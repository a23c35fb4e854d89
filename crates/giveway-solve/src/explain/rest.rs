//! The rest of a plan around which the world has changed, as an instance and a
//! plan of their own: agents begin where they are, on the map of that time.
//!
//! It begins at the last change that counts. An instance has no agent half way
//! along a slow move; where there is one, the rest begins at the first later time
//! without. An agent that has broken down is held in the rest, too
//! ([`Breakdown`]). What an arrived agent adds to the costs when it is woken, no
//! instance can say: [`Past`] does.

use giveway_model::tr;
use giveway_model::{
    Breakdown, Costs, Instance, Objective, Plan, Question, Scene, Version,
    change::{History, MAX_TIME, Trajectory, Whereabouts},
    check::{costs_over_time, costs_until},
    question::Misfit,
    sorting,
};

use super::{
    ExplainRequest,
    going_on::{Member, Resting},
    past::{Course, Past, shifted},
    world::World,
};
use crate::Refusal;

/// What is asked, about an instance and its plan.
pub(crate) struct Asked {
    pub(crate) instance: Instance,
    /// The plan that is asked about; `None` where none was given, or the
    /// question is why there is none.
    pub(crate) plan: Option<Plan>,
    pub(crate) question: Question,
    /// The horizon, where a person set one.
    pub(crate) within: Option<u32>,
    pub(crate) past: Past,
}

/// The rest of a course, with what is asked about it.
///
/// # Errors
/// Where the question cannot be answered of the rest, with the reason.
pub(crate) fn rest_of(
    instance: &Instance,
    world: World,
    plan: &Plan,
    request: &ExplainRequest,
) -> Result<Asked, Refusal> {
    let World { changed, history } = world;
    let question = &request.question;
    let solvable = !matches!(question, Question::Unsolvable);
    let since = first_standing(&history, changed, plan, solvable)?;
    let resting = Resting {
        history: &history,
        changed,
        since,
        plan,
    };
    let members = resting.members()?;
    let question_now = resting.question(question, &members)?;
    if let Some(within) = request.within.filter(|within| *within < since) {
        return Err(refused(tr!(
            "Nothing can be asked about plans that end by time {within}: the question is about \
             the plan from time {since} on.",
            within,
            since
        )));
    }
    let objective = instance.objective();
    let rest = resting.instance(instance, objective, &members)?;
    let rest_plan = resting.plan(&members);
    let shares = members.iter().map(|m| (m.agent.name.clone(), m.share));
    let past = Past::new(Course {
        since,
        question: question.clone(),
        shares: sorting::map(shares),
        gone: resting.gone(&members),
        plan: plan.clone(),
        history: history.clone(),
    });
    if solvable {
        let told = past.told_costs(&rest, &rest_plan);
        if told != costs_over_time(&history, plan) || !past.check(&rest, &rest_plan).is_empty() {
            return Err(refused(tr!(
                "The plan from time {since} on cannot be separated from what happened before.",
                since
            )));
        }
        let idle = members.iter().any(|member| member.share.idle > 0);
        let counts = objective.costs().contains(&giveway_model::Cost::Waits)
            || matches!(question, Question::Waits { .. });
        if idle && counts {
            return Err(refused(tr!(
                "Waits cannot be compared from time {since} on: a robot has been at its goal \
                 since time {changed}, and whether that is waiting depends on what it does later.",
                since,
                changed
            )));
        }
    }
    Ok(Asked {
        instance: rest,
        plan: solvable.then_some(rest_plan),
        question: question_now,
        within: request.within.map(|within| within - since),
        past,
    })
}

/// A refusal that is one plain sentence.
pub(super) fn refused(is_so: String) -> Refusal {
    Refusal::Question {
        misfit: Misfit::NotSo { is_so, ask: None },
    }
}

/// The first time from the last change on at which no agent is in the middle of
/// a slow move. Where there is no plan from the change on, only its own time will
/// do.
fn first_standing(
    history: &History,
    changed: u32,
    plan: &Plan,
    solvable: bool,
) -> Result<u32, Refusal> {
    let mut time = changed;
    loop {
        let trajectories = history.trajectories(plan, time);
        let moving = trajectories
            .iter()
            .find(|trajectory| !matches!(trajectory.place(time), Whereabouts::At(_)));
        let Some(moving) = moving else {
            return Ok(time);
        };
        if !solvable || time > moving.end().min(MAX_TIME) {
            return Err(refused(tr!(
                "At time {time} {name} is in the middle of a slow move. Questions about the time \
                 after that cannot be answered.",
                time,
                name = moving.timeline.name()
            )));
        }
        time += 1;
    }
}

impl Resting<'_> {
    fn instance(
        &self,
        whole: &Instance,
        objective: &Objective,
        members: &[Member<'_>],
    ) -> Result<Instance, Refusal> {
        let grid = self.history.grid(self.since);
        for Member { agent, .. } in members {
            let mut cells = agent.waypoints.iter().chain([&agent.goal]);
            if let Some(cell) = cells.find(|&&cell| !grid.is_vertex(cell)) {
                return Err(refused(tr!(
                    "There is no plan from time {changed} on, because {agent} has to go to {cell}, where \
                     there is an obstacle.",
                    changed = self.changed,
                    agent = agent.name,
                    cell
                )));
            }
        }
        let scene = Scene {
            giveway: Version,
            name: whole.name().to_owned(),
            map: grid.rows(),
            rules: self.history.rules(),
            objective: objective.clone(),
            agents: members.iter().map(|member| member.agent.clone()).collect(),
        };
        let instance = Instance::new(scene).map_err(|faults| Refusal::Changes { faults })?;
        Ok(instance.with_breakdowns(self.breakdowns(members)))
    }

    /// The breakdowns that go on; of those of one agent that began at one time,
    /// the longest.
    fn breakdowns(&self, members: &[Member<'_>]) -> Vec<Breakdown> {
        let mut breakdowns = Vec::new();
        for member in members {
            let agent = &member.agent.name;
            let mut timelines = self.history.timelines().iter();
            let timeline = timelines.find(|timeline| timeline.name() == agent);
            let held = timeline.map_or(&[][..], |timeline| &timeline.held);
            let ends = held.iter().filter(|&&(_, to)| to > self.since);
            let longest = sorting::map(ends.map(|&(from, _)| {
                let same = held.iter().filter(|&&(begun, _)| begun == from);
                (from, same.map(|&(_, to)| to).max().unwrap_or(0))
            }));
            breakdowns.extend(longest.into_iter().map(|(from, to)| Breakdown {
                agent: agent.clone(),
                from,
                to,
                held: to - self.since,
            }));
        }
        breakdowns
    }

    fn plan(&self, members: &[Member<'_>]) -> Plan {
        let mut plan = Plan::default();
        for member in members {
            let Some(trajectory) = &member.trajectory else {
                continue;
            };
            let name = member.agent.name.clone();
            let times = self.since..=trajectory.end().max(self.since);
            plan.paths.insert(
                name.clone(),
                times.map(|time| trajectory.at(time)).collect(),
            );
            let later = trajectory
                .charges
                .iter()
                .filter(|&&time| time >= self.since);
            let charges: Vec<u32> = later.map(|time| time - self.since).collect();
            if !charges.is_empty() {
                plan.charges.insert(name, charges);
            }
        }
        plan
    }

    /// What those that have vanished add to all costs.
    fn gone(&self, members: &[Member<'_>]) -> Costs {
        let mut gone = Costs::default();
        for timeline in self.history.timelines() {
            let goes_on = members.iter().any(|m| m.agent.name == timeline.name());
            let trajectory = Trajectory::of(self.history, timeline, self.plan);
            let Some(trajectory) = trajectory.filter(|_| !goes_on && timeline.until.is_none())
            else {
                continue;
            };
            let spent = costs_until(self.history, &trajectory, trajectory.end());
            gone.makespan = gone.makespan.max(trajectory.end());
            gone.sum_of_costs += trajectory.end();
            gone.charges += spent.charges;
            gone.moves += spent.moves;
            gone.waits += spent.waits;
        }
        gone
    }

    /// The question in times of the rest.
    fn question(&self, question: &Question, members: &[Member<'_>]) -> Result<Question, Refusal> {
        let since = self.since;
        for name in question.agents() {
            let is_there = members.iter().any(|member| member.agent.name == name);
            let mut timelines = self.history.timelines().iter();
            if !is_there && timelines.any(|timeline| timeline.name() == name) {
                return Err(refused(tr!(
                    "{name} is no longer there at time {since}.",
                    name,
                    since
                )));
            }
        }
        let time = match question {
            Question::Wait { to, .. } => to.map(|to| to.saturating_sub(1)),
            Question::Charge { time, .. }
            | Question::Visit { time, .. }
            | Question::Move { time, .. }
            | Question::NoMove { time, .. } => *time,
            _ => None,
        };
        if let Some(time) = time.filter(|time| *time < since) {
            return Err(refused(tr!(
                "Time {time} is already past: the question is about the plan from time {since} \
                 on, and the past cannot change.",
                time,
                since
            )));
        }
        if let Question::Wait {
            agent,
            from,
            at_least: Some(steps),
            ..
        } = question
            && from.unwrap_or(0) < since
            && *steps > 1
            && let Some(member) = members.iter().find(|member| member.agent.name == *agent)
            && let (Some(trajectory), Some(before)) = (&member.trajectory, since.checked_sub(1))
            && trajectory.at(before) == trajectory.at(since)
        {
            return Err(refused(tr!(
                "{agent} was already waiting before the change. Ask about its wait from time \
                 {since} on.",
                agent,
                since
            )));
        }
        // Of an interval that began before, what is left.
        let mut question = shifted(question, |time| time.saturating_sub(since));
        if let Question::Wait { from, to, .. } = &mut question
            && to.is_some()
        {
            from.get_or_insert(0);
        }
        Ok(question)
    }
}
