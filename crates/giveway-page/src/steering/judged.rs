//! What the judge says of a plan of one's own.

use std::rc::Rc;

use giveway_model::check::{Report, Rule, Violation, check};
use giveway_model::words::Sentence;
use giveway_model::{Agent, Instance, Plan};
use giveway_solve::{SolveAnswer, Stats, Status};

use super::Steering;
use crate::Answer;

impl Steering {
    /// The plan with what the judge says of it.
    pub(super) fn judged(
        about: &Rc<Answer>,
        plan: Plan,
        from: Vec<Option<u32>>,
        agent: usize,
    ) -> Option<Self> {
        let instance = about.draft.instance().ok()?;
        let made = without_pending(&plan, about.draft.agents(), &from);
        let report = check(instance, &made);
        let answer = answer(about, instance, made, &report);
        let all = report.violations.len();
        let (to_do, violations) = sorted(report);
        let follows = all.saturating_sub(to_do.len() + violations.len());
        Some(Self {
            about: Rc::clone(about),
            agent,
            answer: Rc::new(open_ended(answer, &to_do)),
            violations,
            to_do,
            follows,
            told: Sentence::default(),
            plan,
            from,
        })
    }

    /// Another plan for the agent that is led, with what is against the rules
    /// only now.
    pub(super) fn after(&self, plan: Plan) -> Self {
        let after = Self::judged(&self.about, plan, self.from.clone(), self.agent);
        let mut after = after.unwrap_or_else(|| self.clone());
        let news = after.violations.iter();
        let news = news.filter(|violation| !self.violations.contains(violation));
        let news: Vec<String> = news
            .take(2)
            .map(|violation| violation.message.clone())
            .collect();
        after.told = news.join(" ").into();
        after
    }

    /// Whether every agent does its task, and none breaks a rule.
    pub const fn is_whole(&self) -> bool {
        self.problems() == 0
    }

    /// How many problems the judge finds in the plan as it stands.
    pub(crate) const fn problems(&self) -> usize {
        self.violations.len() + self.to_do.len() + self.follows
    }

    /// Whether a violation is to be seen at a time: a step lasts.
    pub(crate) fn is_now(violation: &Violation, time: u32) -> bool {
        let lasts = match violation.rule {
            Rule::Swap | Rule::Move => 1,
            Rule::SlowSwap => 2,
            _ => 0,
        };
        let past = time.checked_sub(violation.time);
        past.is_some_and(|past| past <= lasts)
    }
}

/// The plan as the page shows plans, with what is proved of all plans.
fn answer(about: &Answer, instance: &Instance, mut plan: Plan, report: &Report) -> Answer {
    plan.cut_trailing_goals(instance);
    let solved = SolveAnswer {
        status: Status::Feasible,
        costs: report.costs,
        plan: Some(plan),
        ended: None,
        reason: None,
        stats: Stats::default(),
        ..about.solved.clone()
    };
    Answer::new(Rc::clone(&about.draft), Rc::clone(&about.request), solved)
}

/// The plan without charges that are chosen for a step that is not made yet.
fn without_pending(plan: &Plan, agents: &[Agent], from: &[Option<u32>]) -> Plan {
    let mut made = plan.clone();
    for (agent, _) in agents.iter().zip(from).filter(|(_, from)| from.is_some()) {
        let end = plan.path(&agent.name).len().saturating_sub(1);
        if let Some(charges) = made.charges.get_mut(&agent.name) {
            charges.retain(|&charge| (charge as usize) < end);
        }
    }
    made
}

/// Whose task is not done has not arrived.
fn open_ended(mut answer: Answer, to_do: &[Violation]) -> Answer {
    let agents = answer.draft.agents().iter();
    for (agent, arrival) in agents.zip(&mut answer.arrivals) {
        if to_do.iter().any(|open| open.agents.contains(&agent.name)) {
            *arrival = None;
        }
    }
    answer
}

/// What is not done yet, and what is against the rules.
fn sorted(report: Report) -> (Vec<Violation>, Vec<Violation>) {
    let is_open = |violation: &Violation| matches!(violation.rule, Rule::Goal | Rule::Waypoint);
    let (to_do, violations): (Vec<_>, Vec<_>) = report.violations.into_iter().partition(is_open);
    // The judge has an agent stay where its path ends; it may yet be led away.
    let is_after = |violation: &Violation| {
        let ends = to_do.iter().filter(|open| open.time < violation.time);
        matches!(violation.rule, Rule::Vertex | Rule::Constraint)
            && ends
                .flat_map(|open| &open.agents)
                .any(|agent| violation.agents.contains(agent))
    };
    let violations = violations.into_iter().filter(|v| !is_after(v)).collect();
    (to_do, violations)
}
