//! A question about a plan around which the world has changed, as one about a snapshot
//! of the plan at the last change that counts.

use giveway_model::{
    Condition, Constraint, Fault, Instance, Plan, Question,
    change::{Changes, History},
    check::{Rule, check_history},
    constraint::TimedConstraint,
    question::{Misfit, names_exist},
    snapshot::Snapshot,
    tr,
};

use super::ExplainRequest;
use crate::Refusal;

/// The changes that count: those up to the time shown.
pub(crate) fn counting(changes: Option<&Changes>, shown: Option<u32>) -> Option<Changes> {
    let mut changes = changes?.clone();
    changes
        .changes
        .retain(|change| shown.is_none_or(|at| change.at <= at));
    (!changes.changes.is_empty()).then_some(changes)
}

/// A plan through changes of the world.
pub(crate) struct ChangedWorld {
    /// The plan as one that knows of no later changes.
    pub(crate) plan: Plan,
    /// The time of the last change.
    at: u32,
    /// The world without the changes of that time.
    before: History,
    /// The world with them.
    pub(crate) after: History,
}

impl ChangedWorld {
    /// # Errors
    /// Where there is no plan, a change contradicts it, or it breaks a rule before the
    /// last change.
    pub(crate) fn new(
        instance: &Instance,
        changes: &Changes,
        plan: Option<&Plan>,
    ) -> Result<Self, Refusal> {
        let Some(plan) = plan else {
            let fault = Fault::at("plan", "none", "the plan that ran while the world changed");
            return Err(Refusal::Request { fault });
        };
        let times = changes.by_time();
        let at = times.last().map_or(0, |&(at, _)| at);
        let mut plan = plan.clone();
        plan.knows = plan.knows.map(|knows| knows.min(at));
        for slept in plan.slept.values_mut() {
            slept.retain(|&[_, to]| to <= at);
        }
        plan.slept.retain(|_, slept| !slept.is_empty());
        let mut after = History::new(instance);
        let mut before = after.clone();
        for (time, list) in &times {
            before = after.clone();
            if let Err(faults) = after.apply(*time, list, &plan) {
                if *time == at {
                    past_is_right(&before, &plan, at)?;
                }
                return Err(Refusal::Changes { faults });
            }
        }
        past_is_right(&after, &plan, at)?;
        Ok(Self {
            plan,
            at,
            before,
            after,
        })
    }

    /// The plan at the last change. If it knows the changes of that time, they have a part
    /// in what it did up to then: an agent that they woke had slept.
    pub(crate) fn snapshot(&self, instance: &Instance) -> Snapshot<'_> {
        let is_known = self.plan.knows.is_some_and(|knows| knows >= self.at);
        let past = if is_known { &self.after } else { &self.before };
        Snapshot::new(self.at, instance, (past, &self.after), &self.plan)
    }
}

/// A plan must be right up to the last change, whatever is to come. It is judged
/// in the world with that change, since the plan may know of it already.
fn past_is_right(history: &History, plan: &Plan, at: u32) -> Result<(), Refusal> {
    let mut violations = check_history(history, plan).violations;
    // Later violations concern the world to come.
    violations.retain(|violation| {
        let of_its_time = !matches!(
            violation.rule,
            Rule::Shape | Rule::Goal | Rule::Waypoint | Rule::Charge
        );
        of_its_time && violation.time < at
    });
    if violations.is_empty() {
        return Ok(());
    }
    Err(Refusal::Plan { violations })
}

/// A refusal that is one plain sentence.
fn refused(is_so: String) -> Refusal {
    Refusal::Question {
        misfit: Misfit::NotSo { is_so, ask: None },
    }
}

/// The question and the horizon of a request in times of a snapshot. Waits that the
/// question is about and that have begun already are noted in the instance.
///
/// # Errors
/// Where the question is about the past.
pub(super) fn asked(
    request: &ExplainRequest,
    snapshot: &Snapshot<'_>,
    instance: &mut Instance,
) -> Result<(Question, Option<u32>), Refusal> {
    let (question, since) = (&request.question, snapshot.at);
    for name in question.agents() {
        let is_there = instance.agents().iter().any(|agent| agent.name == name);
        let mut timelines = snapshot.history.timelines().iter();
        if !is_there && timelines.any(|timeline| timeline.name() == name) {
            return Err(refused(tr!(
                "{name} is no longer there at time {since}.",
                name,
                since
            )));
        }
    }
    let last = question.clone().times_mut().pop().and_then(|time| *time);
    // A wait step ends at the last time of a wait.
    let is_wait = matches!(question, Question::Wait { .. });
    let time = last.map(|time| time.saturating_sub(u32::from(is_wait)));
    if let Some(time) = time.filter(|time| *time < since) {
        return Err(refused(tr!(
            "Time {time} is already past: the question is about the plan from time {since} \
             on, and the past cannot change.",
            time,
            since
        )));
    }
    begin_wait(question, snapshot, instance)?;
    let asked_rule = match question {
        Question::Rule { rule } => Some(begin_rule(question, rule, snapshot, instance)?),
        _ => None,
    };
    if let Some(within) = request.within.filter(|within| *within < since) {
        return Err(refused(tr!(
            "Nothing can be asked about plans that end by time {within}: the question is about \
             the plan from time {since} on.",
            within,
            since
        )));
    }
    for agent in instance.agents() {
        let mut cells = agent.waypoints.iter().chain(&agent.goal);
        if let Some(cell) = cells.find(|&&cell| !instance.grid().is_vertex(cell)) {
            return Err(refused(tr!(
                "There is no plan from time {changed} on, because {agent} has to go to {cell}, where \
                 there is an obstacle.",
                changed = since,
                agent = agent.name,
                cell
            )));
        }
    }
    if let Some(question) = asked_rule {
        return Ok((question, request.within.map(|within| within - since)));
    }
    // Of an interval that began before, what is left.
    let mut question = shifted(question, |time| time.saturating_sub(since));
    if let Question::Wait { from, to, .. } = &mut question
        && to.is_some()
    {
        from.get_or_insert(0);
    }
    Ok((question, request.within.map(|within| within - since)))
}

/// Notes how much of a long wait that is asked about lies in the past.
fn begin_wait(
    question: &Question,
    snapshot: &Snapshot<'_>,
    instance: &mut Instance,
) -> Result<(), Refusal> {
    let Question::Wait {
        agent,
        at,
        from,
        at_least: Some(steps),
        ..
    } = question
    else {
        return Ok(());
    };
    let agents = instance.agents().iter().zip(&snapshot.agents);
    let mut here = agents.filter(|(it, _)| it.name == *agent && at.is_none_or(|at| at == it.start));
    let waits = here.next().map_or(0, |(_, running)| running.waits);
    let since = snapshot.at;
    let begun = waits.min(since.saturating_sub(from.unwrap_or(0)));
    if *steps < 2 {
        return Ok(());
    }
    if begun >= *steps {
        return Err(refused(tr!(
            "{agent} was already waiting before the change. Ask about its wait from time \
             {since} on.",
            agent,
            since
        )));
    }
    instance.start_state_mut(agent).waits_begun = begun;
    Ok(())
}

/// The rest with the start states of a rule that is asked about, which is none of its own; and
/// that rule on the rest.
pub(super) fn with_question(
    snapshot: &Snapshot<'_>,
    rule: &Constraint,
    edit: impl FnOnce(&mut Vec<TimedConstraint>),
) -> (Instance, Option<Constraint>) {
    let mut instance = snapshot.with_rules(|rules| {
        edit(rules);
        rules.push(TimedConstraint {
            constraint: Constraint {
                off: false,
                ..rule.clone()
            },
            since: Some(snapshot.at),
            until: None,
        });
    });
    let rule = instance.pop_rule();
    (instance, rule)
}

/// A question about a rule as one about the rest: as if it were added at the time of the last
/// change. What was done before counts, as the start states of the instance then say.
///
/// # Errors
/// Where the rule does not fit the world, or the plan keeps it.
fn begin_rule(
    question: &Question,
    rule: &Constraint,
    snapshot: &Snapshot<'_>,
    instance: &mut Instance,
) -> Result<Question, Refusal> {
    names_exist(question, instance).map_err(|misfit| Refusal::Question { misfit })?;
    let (since, sentence) = (snapshot.at, rule.sentence());
    let is_alike = |own: &TimedConstraint| {
        own.is_there(since)
            && !own.constraint.off
            && (&own.constraint.kind, &own.constraint.agents) == (&rule.kind, &rule.agents)
    };
    if snapshot.history.constraints().iter().any(is_alike) {
        return Err(refused(tr!(
            "It is so: the scene has this rule, \"{sentence}\".",
            sentence
        )));
    }
    let (with, rest) = with_question(snapshot, rule, |_| {});
    let left = rest.filter(|rest| !rest.off);
    let is_kept = |rest: &Constraint| {
        let condition = Condition::Keeps(Box::new(rest.clone()));
        condition.holds(&with, &snapshot.rest()) == Some(true)
    };
    let Some(rest) = left.filter(|rest| !is_kept(rest)) else {
        return Err(refused(tr!(
            "It is so: this plan keeps the rule \"{sentence}\" from time {since} on.",
            sentence,
            since
        )));
    };
    *instance = with;
    let rule = Box::new(rest);
    Ok(Question::Rule { rule })
}

/// A question with other times.
pub(super) fn shifted(question: &Question, shift: impl Fn(u32) -> u32) -> Question {
    let mut question = question.clone();
    for time in question.times_mut() {
        *time = time.map(&shift);
    }
    question
}
