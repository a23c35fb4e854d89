//! Answers about the rest of a plan as answers about the whole plan.
//!
//! After a change the search looks at a [`Snapshot`], whose times begin at 0. People
//! read times and costs of the whole plan, and other plans with the past before them.

use giveway_model::{
    Cost, Costs, Instance, Plan, Question,
    check::{self, Rule, Violation, check},
    constraint::TimedConstraint,
    question::{Misfit, fits},
    snapshot::Snapshot,
    tr,
};

use super::{
    Edit, ExplainAnswer, Repair, Verdict,
    changed::{shifted, with_question},
    words,
};
use crate::Reach;

/// The plan of which an instance is the rest, with the question as it was asked; without
/// a change of the world there is none.
#[derive(Clone, Copy, Default)]
pub(crate) struct WholePlan<'a> {
    pub(super) running: Option<(&'a Snapshot<'a>, &'a Question)>,
}

impl WholePlan<'_> {
    fn since(self) -> u32 {
        self.running.map_or(0, |(snapshot, _)| snapshot.at)
    }

    /// A time of the rest as one of the whole.
    pub(crate) fn time(self, time: u32) -> u32 {
        time.saturating_add(self.since())
    }

    /// The costs of the whole, where those of the rest are these.
    pub(crate) fn costs(self, costs: Costs, plan: &Plan) -> Costs {
        let whole = |(snapshot, _): (&Snapshot<'_>, _)| snapshot.whole_costs(costs, plan);
        self.running.map_or(costs, whole)
    }

    /// The costs of the whole with a plan of the rest.
    pub(crate) fn costs_of(self, instance: &Instance, plan: &Plan) -> Option<Costs> {
        Some(self.costs(check::costs(instance, plan)?, plan))
    }

    /// The sums that some agents had paid before the rest began, whose plan is this one.
    pub(crate) fn paid(self, agents: &[String], plan: &Plan) -> Costs {
        let mut own = plan.clone();
        own.paths.retain(|name, _| agents.contains(name));
        let [own, nobody] = [own, Plan::default()].map(|plan| self.costs(Costs::default(), &plan));
        Costs {
            makespan: 0,
            sum_of_costs: own.sum_of_costs.saturating_sub(nobody.sum_of_costs),
            charges: own.charges.saturating_sub(nobody.charges),
            moves: own.moves.saturating_sub(nobody.moves),
            waits: own.waits.saturating_sub(nobody.waits),
            penalty: own.penalty.saturating_sub(nobody.penalty),
        }
    }

    /// A plan of the rest as one of the whole.
    pub(crate) fn plan(self, rest: &Plan) -> Plan {
        let whole = |(snapshot, _): (&Snapshot<'_>, _)| snapshot.whole(rest);
        self.running.map_or_else(|| rest.clone(), whole)
    }

    /// The rules that a plan of the rest breaks, in times of the whole. Of the
    /// moves of an agent during its breakdown only the first is listed: the others
    /// follow from it.
    pub(crate) fn check(self, instance: &Instance, plan: &Plan) -> Vec<Violation> {
        let Some((snapshot, _)) = self.running else {
            return check(instance, plan).violations;
        };
        let mut violations = snapshot.check(plan).violations;
        let mut moved = Vec::new();
        violations.retain(|violation| {
            let agent = violation.agents.first();
            let held = agent.map_or(0, |agent| instance.start_state(agent).not_before());
            let is_held = violation.rule == Rule::Move && violation.time < self.time(held);
            let first = !is_held || !moved.contains(&agent.cloned());
            moved.extend(is_held.then(|| agent.cloned()));
            first
        });
        violations
    }

    /// A question about the rest in times of the whole.
    pub(crate) fn question(self, question: &Question) -> Question {
        if matches!(question, Question::Rule { .. }) {
            return self.asked(question).clone();
        }
        shifted(question, |time| self.time(time))
    }

    /// A question whose names are looked up: a rule as it was written, since of one on the
    /// rest no time may be left.
    pub(crate) fn asked<'q>(&'q self, question: &'q Question) -> &'q Question {
        match (question, self.running) {
            (Question::Rule { .. }, Some((_, asked))) => asked,
            _ => question,
        }
    }

    /// The rest as it is after some rules have other last times, in times of the whole plan;
    /// `None` where there was no change. What was done before counts in the new times.
    pub(crate) fn with_last_times(
        self,
        instance: &Instance,
        last_times: &[(usize, u32)],
    ) -> Option<Instance> {
        let (snapshot, asked) = self.running?;
        let edit = |rules: &mut Vec<TimedConstraint>| {
            for &(rule, to) in last_times {
                let weaker = rules.get_mut(rule).and_then(|rule| {
                    let kind = rule.constraint.kind.with_last_time(to)?;
                    Some((rule, kind))
                });
                if let Some((rule, kind)) = weaker {
                    rule.constraint.kind = kind;
                }
            }
        };
        let rest = match asked {
            Question::Rule { rule } => with_question(snapshot, rule, edit).0,
            _ => snapshot.with_rules(edit),
        };
        let mut rest = rest.with_objective(instance.objective().clone());
        for agent in instance.agents() {
            let waits = instance.start_state(&agent.name).waits_begun;
            rest.start_state_mut(&agent.name).waits_begun = waits;
        }
        Some(rest)
    }

    /// Checks that a question fits the plan.
    ///
    /// # Errors
    /// Why it does not, in times of the whole.
    pub(crate) fn fits(
        self,
        question: &Question,
        instance: &Instance,
        plan: &Plan,
    ) -> Result<(), Misfit> {
        // Of a rule on the rest that was seen when it was rewritten.
        if self.running.is_some() && matches!(question, Question::Rule { .. }) {
            return Ok(());
        }
        fits(question, instance, plan)
            .map_err(|misfit| self.misfit(question, instance, plan, misfit))
    }

    /// Why a question does not fit, in times of the whole.
    fn misfit(
        self,
        question: &Question,
        instance: &Instance,
        plan: &Plan,
        misfit: Misfit,
    ) -> Misfit {
        if self.running.is_none() {
            return misfit;
        }
        let since = self.since();
        let about = |what: &str| Misfit::NotSo {
            is_so: tr!(
                "{what} already at its goal at time {since}, and the past cannot change.",
                what,
                since
            ),
            ask: None,
        };
        let misfit = match (question, misfit) {
            (Question::Arrival { agent }, Misfit::NotSo { ask: None, .. }) => {
                return about(&tr!("{agent} was", agent));
            }
            (Question::Makespan | Question::SumOfCosts, Misfit::NotSo { ask: None, .. }) => {
                return about(tr!("Every robot was"));
            }
            (_, misfit @ Misfit::Fault { .. }) => misfit,
            (_, misfit) => {
                // The same plan with nothing listed in the past.
                let mut plan = plan.clone();
                for path in plan.paths.values_mut() {
                    path.splice(0..0, (0..since).map(|_| None));
                }
                for time in plan.charges.values_mut().flatten() {
                    *time += since;
                }
                let fits = fits(&self.question(question), instance, &plan);
                fits.err().unwrap_or(misfit)
            }
        };
        match misfit {
            Misfit::NotSo { is_so, ask } => Misfit::NotSo {
                is_so: tr!("From time {since} on: {is_so}", since, is_so),
                ask,
            },
            fault @ Misfit::Fault { .. } => fault,
        }
    }

    /// The answer in times, costs and plans of the whole; `asked` are the costs of the
    /// plan that is asked about.
    pub(crate) fn answer(self, mut answer: ExplainAnswer, asked: Option<Costs>) -> ExplainAnswer {
        let Some((snapshot, question)) = self.running else {
            return answer;
        };
        answer.since = Some(snapshot.at);
        answer.question = question.clone();
        answer.reach = answer.reach.later(self.since());
        if let Some(core) = &mut answer.core {
            core.reach = core.reach.later(self.since());
            for further in &mut core.further {
                further.reach = further.reach.later(self.since());
            }
        }
        answer.repairs = self.repairs(&answer.repairs, &answer.question);
        if let Some(rest) = answer.alternative.take() {
            let costs = answer.costs.map(|costs| self.costs(costs, &rest));
            let report = snapshot.check(&rest);
            if !report.is_valid() || report.costs != costs {
                return without_other(answer);
            }
            (answer.alternative, answer.costs) = (Some(snapshot.whole(&rest)), costs);
        } else if let Some(costs) = answer.costs {
            // The costs of the plan asked about.
            answer.costs = asked.or(Some(costs));
        }
        if let (Some(costs), Some(asked)) = (answer.costs, asked)
            && let Some(delta) = answer.deltas.get_mut(&Cost::Makespan)
        {
            *delta = i64::from(costs.makespan) - i64::from(asked.makespan);
        }
        if !answer.words.is_empty() {
            answer.words = tr!(
                "This is about the plan from time {since} on. {answer}",
                since = snapshot.at,
                answer = answer.words
            );
        }
        answer
    }

    /// Repairs as those of the whole.
    pub(crate) fn repairs(self, repairs: &[Repair], question: &Question) -> Vec<Repair> {
        let Some((snapshot, _)) = self.running else {
            return repairs.to_vec();
        };
        let whole = |repair: &Repair| {
            let mut edits = repair.edits.clone();
            for edit in &mut edits {
                if let Edit::Deadline { within } = edit {
                    *within = self.time(*within);
                }
            }
            let costs = self.costs(repair.costs, &repair.plan);
            let mut repair = Repair {
                edits,
                least: repair.least,
                costs,
                arrival: repair.arrival,
                proved: repair.proved,
                plan: snapshot.whole(&repair.plan),
                text: String::new(),
            };
            repair.text = words::repair(&repair, question.arriving());
            repair
        };
        repairs.iter().map(whole).collect()
    }
}

/// The answer where the other plan is none behind the past: never trust the
/// search.
fn without_other(mut answer: ExplainAnswer) -> ExplainAnswer {
    answer.verdict = Verdict::Unknown;
    (answer.costs, answer.reach) = (None, Reach::default());
    answer.deltas.clear();
    answer.witness.clear();
    answer.how.clear();
    answer.pays.clear();
    answer.core = None;
    answer.alone.clear();
    answer.near = None;
    answer.repairs.clear();
    answer.further_repairs = 0;
    answer.exhaustive = false;
    tr!("The plan that was found does not fit what happened before, so nothing is claimed.")
        .clone_into(&mut answer.words);
    answer
}
