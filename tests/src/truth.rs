//! Whether what a certificate says is so, by the oracle.

use giveway_model::{Cell, Condition, Cost, Instance, Plan, Question};
use giveway_proof::{Checked, CheckedLemma, Claim, Conclusion, Lemma, Report};

use crate::oracle::{self, AtMost, Contrast, Verdict, some_plan_keeps};
use crate::recount;

/// Labels that the oracle may make.
const CAP: usize = 400_000;
/// Times and numbers of steps beyond this are taken as this: it is far beyond
/// what matters on maps as small as the oracle's.
const LATE: u32 = 100;

/// What of a report is not so, as sentences; `None` where that is too much for
/// the oracle. What is said not to be certified is no part of it.
pub fn lies(instance: &Instance, plan: Option<&Plan>, report: &Report) -> Option<Vec<String>> {
    let mut lies = Vec::new();
    for checked in &report.claims {
        match checked {
            Checked::Proof { text, claim, .. }
            | Checked::Lemmas { text, claim, .. }
            | Checked::Search { text, claim, .. } => {
                if !holds(instance, claim)? {
                    lies.push(text.clone());
                }
            }
            Checked::None { .. } => {}
        }
        if let Checked::Lemmas { lemmas, .. } = checked {
            for CheckedLemma { text, lemma, .. } in lemmas {
                if !is_so(instance, lemma)? {
                    lies.push(text.clone());
                }
            }
        }
    }
    let so = match &report.concluded {
        Some(Conclusion::NoPlan { claim }) => holds(instance, claim)?,
        Some(Conclusion::Best {
            objective,
            condition,
            within,
        }) => {
            let instance = instance.clone().with_objective(objective.clone());
            match plan.map(|plan| recount::costs(plan).vector(objective)) {
                Some(own) => is_best(&instance, condition.as_ref(), *within, &own)?,
                None => false,
            }
        }
        Some(Conclusion::Believed | Conclusion::Bounds) | None => true,
    };
    if !so {
        lies.push(format!("{:?}", report.concluded));
    }
    Some(lies)
}

/// Whether agents by themselves have no plan such as a lemma says; `None` where the oracle cannot tell.
fn is_so(instance: &Instance, lemma: &Lemma) -> Option<bool> {
    let mut scene = instance.to_scene();
    scene
        .agents
        .retain(|agent| lemma.by.contains_key(&agent.name));
    let of_agents = Instance::new(scene).ok()?;
    let arrivals = lemma.by.iter().map(|(agent, &by)| AtMost {
        cost: Cost::SumOfCosts,
        agents: Some(vec![agent.clone()]),
        most: by,
    });
    let sums = lemma.most.iter().map(|(&cost, &most)| AtMost {
        cost,
        agents: None,
        most,
    });
    let limits: Vec<AtMost> = arrivals.chain(sums).collect();
    some_plan_keeps(&of_agents, &limits, CAP).map(|keeps| !keeps)
}

/// Whether there is no plan such as a claim says; `None` where the oracle cannot
/// tell.
pub fn holds(instance: &Instance, claim: &Claim) -> Option<bool> {
    // As a horizon, a limit of the makespan ends the search, too.
    let makespan = claim.most.get(&Cost::Makespan).copied();
    let within = [claim.within, makespan].into_iter().flatten().min();
    let asked = question(instance, within);
    let mut exists_any = Some(false);
    for case in cases(instance, claim.condition.as_ref()) {
        match asked.exists(&claim.most, case.as_ref().map(Case::contrast)) {
            Some(true) => return Some(false),
            Some(false) => {}
            None => exists_any = None,
        }
    }
    exists_any.map(|exists| !exists)
}

/// Whether no plan of a kind costs less than this, and one costs it; `None` where
/// the oracle cannot tell.
fn is_best(
    instance: &Instance,
    condition: Option<&Condition>,
    within: Option<u32>,
    vector: &[u32],
) -> Option<bool> {
    let asked = question(instance, within);
    let mut least: Option<Vec<u32>> = None;
    for case in cases(instance, condition) {
        let verdict = match &case {
            None => asked.best(),
            Some(case) => asked.best_with(case.contrast()),
        };
        match verdict {
            Verdict::Capped => return None,
            Verdict::Impossible => {}
            Verdict::Best(point) => {
                let others = least.into_iter().chain([point.vector]);
                least = others.min();
            }
        }
    }
    Some(least.as_deref() == Some(vector))
}

fn question(instance: &Instance, within: Option<u32>) -> oracle::Question<'_> {
    oracle::Question {
        instance,
        within,
        cap: CAP,
    }
}

/// A question about a plan that was made to be asked about.
struct Case {
    question: Question,
    plan: Plan,
}

impl Case {
    fn contrast(&self) -> Contrast<'_> {
        Contrast {
            question: &self.question,
            plan: &self.plan,
        }
    }
}

/// The questions of which one must have its contrast for a condition to hold;
/// none of them where there is no condition.
fn cases(instance: &Instance, condition: Option<&Condition>) -> Vec<Option<Case>> {
    let Some(condition) = condition else {
        return vec![None];
    };
    let names = instance.agents().iter().map(|agent| &agent.name);
    let rest = Cell::new(0, 0);
    let mut plan = Plan {
        paths: names
            .clone()
            .map(|name| (name.clone(), vec![Some(rest)]))
            .collect(),
        ..Plan::default()
    };
    let mut steps = |agent: &str, steps: u32| {
        let path = vec![Some(rest); steps.min(LATE) as usize + 1];
        plan.paths.insert(agent.to_owned(), path);
    };
    let questions = match condition.clone() {
        Condition::Visit { agent: None, cell } => names
            .map(|name| Question::NoVisit {
                agent: Some(name.clone()),
                at: cell,
            })
            .collect(),
        Condition::Below {
            agent: Some(agent),
            cost,
            limit,
        } => {
            let fewer_than = limit.min(LATE);
            let name = Some(agent.clone());
            vec![match cost {
                Cost::Makespan | Cost::SumOfCosts => {
                    steps(&agent, limit);
                    Question::Arrival { agent }
                }
                Cost::Charges => {
                    plan.charges.insert(agent, (0..fewer_than).collect());
                    Question::Charges { agent: name }
                }
                Cost::Waits => {
                    steps(&agent, fewer_than);
                    Question::Waits { agent: name }
                }
                // No instance here has one.
                Cost::Penalty => return Vec::new(),
                Cost::Moves => Question::Length {
                    agent,
                    fewer_than: Some(fewer_than),
                },
            }]
        }
        condition @ (Condition::Never { .. }
        | Condition::Visit { agent: Some(_), .. }
        | Condition::Move { .. }
        | Condition::Charge { .. }
        | Condition::Before { .. }
        | Condition::Keeps(_)
        | Condition::Below { agent: None, .. }) => {
            vec![early(Question::with_contrast(condition).unwrap())]
        }
    };
    let case = |question| {
        Some(Case {
            question,
            plan: plan.clone(),
        })
    };
    questions.into_iter().map(case).collect()
}

/// The same question, with times that the oracle can count up to.
fn early(mut question: Question) -> Question {
    let soon = |time: &mut Option<u32>| *time = time.map(|time| time.min(LATE));
    match &mut question {
        Question::Wait { from, to, .. } => {
            soon(from);
            soon(to);
        }
        Question::Charge { time, .. }
        | Question::Visit { time, .. }
        | Question::Move { time, .. }
        | Question::NoMove { time, .. } => soon(time),
        Question::NoCharge { .. }
        | Question::NoVisit { .. }
        | Question::Slow { .. }
        | Question::Order { .. }
        | Question::Arrival { .. }
        | Question::Length { .. }
        | Question::Makespan
        | Question::SumOfCosts
        | Question::Penalty
        | Question::Charges { .. }
        | Question::Moves { .. }
        | Question::Waits { .. }
        | Question::Yield { .. }
        // The oracle of rules knows it, and no certificate here is about one.
        | Question::Rule { .. }
        | Question::Unsolvable
        | Question::Plan => {}
    }
    question
}
