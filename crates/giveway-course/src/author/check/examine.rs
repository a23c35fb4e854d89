//! The check of one task: what must be asked of the solver, and what the answers mean.
//!
//! The check is run again from its start with all answers so far. It stops where an answer
//! is missing, with the request for it. So each kind of task reads from top to bottom, and
//! there is no state to keep beside the answers.

use giveway_model::{Objective, Plan};
use giveway_solve::{Request, Response};

use super::{Finding, Problem, Subject, paint};
use crate::judge::order::all_orders;
use crate::judge::proved::{Proved, solved};
use crate::judge::statement::{self, Held};
use crate::judge::{self, Did, Judging, Mark, Situation, Verdict, Why, ask};
use crate::lesson::Task;
use crate::lesson::read::MAX_ORDERED;
use crate::lesson::task::{Change, Choose, Lead, LeadAim, Order, OrderAim, Predict};

/// The result of a part of the check, or else the request that must be answered first.
pub(super) type Next<T = Finding> = Result<T, Box<Request>>;

/// Checks a task with all answers so far. `is_tried` says whether the author has solved
/// the task by hand.
pub(super) fn examine(subject: &Subject, is_tried: bool, answers: &[Response]) -> Next {
    let mut asked = Asked(answers);
    let start = subject.start();
    let found = match &subject.step.task {
        None => Finding::Passed,
        Some(Task::Paint(task)) => paint::search(task, start, is_tried, &mut asked)?,
        Some(Task::Lead(task)) => lead(task, start, &mut asked)?,
        Some(Task::Predict(task)) => predict(task, start, &mut asked)?,
        Some(Task::Spot(_)) => spot(start, &mut asked)?,
        Some(Task::Choose(task)) => choose(task, start, &mut asked)?,
        Some(Task::Order(task)) => order(task, start, &mut asked)?,
        Some(Task::Change(task)) => change(task, start, &mut asked)?,
    };
    Ok(match found {
        Finding::Failed(Problem::Unsolved) if is_tried => Finding::Passed,
        found => found,
    })
}

/// The answers of the solver, in the order in which the check asks.
pub(super) struct Asked<'a>(&'a [Response]);

impl<'a> Asked<'a> {
    /// The answers to some requests.
    pub(super) fn all(&mut self, requests: Vec<Request>) -> Next<&'a [Response]> {
        let count = requests.len();
        if let Some(missing) = requests.into_iter().nth(self.0.len()) {
            return Err(Box::new(missing));
        }
        let (now, later) = self.0.split_at_checked(count).unwrap_or_default();
        self.0 = later;
        Ok(now)
    }

    /// What the judge of the task says of something that was done.
    pub(super) fn judge(&mut self, now: Situation<'_>, did: &Did) -> Next<Verdict> {
        let verdict = match judge::begin(now, did) {
            Some(Judging::Verdict(verdict)) => Some(*verdict),
            Some(Judging::Ask(requests)) => judge::conclude(now, did, self.all(requests)?),
            None => None,
        };
        Ok(verdict.unwrap_or_else(|| Verdict::unknown(String::new())))
    }
}

/// The finding where the judge must say "solved".
fn must_solve(verdict: Verdict) -> Finding {
    if verdict.is_solved() {
        Finding::Passed
    } else {
        Finding::of(verdict.why)
    }
}

fn predict(task: &Predict, start: Situation<'_>, asked: &mut Asked<'_>) -> Next {
    let verdict = asked.judge(start, &Did::Revealed)?;
    Ok(match verdict.why {
        Why::Revealed(truth) => {
            let is_offered = task.answers.iter().any(|guess| guess.value == truth);
            if task.answers.is_empty() || is_offered {
                Finding::Passed
            } else {
                Problem::NotOffered(truth).into()
            }
        }
        why => Finding::of(why),
    })
}

fn choose(task: &Choose, start: Situation<'_>, asked: &mut Asked<'_>) -> Next {
    let right = task.answers.iter().filter(|answer| answer.right).count();
    if right != 1 {
        return Ok(Problem::Right(right).into());
    }
    let mut found = Finding::Passed;
    for (index, answer) in task.answers.iter().enumerate() {
        let Some(claim) = &answer.claim else {
            continue;
        };
        let outcome = match statement::requests(claim, start) {
            Ok(requests) => statement::decide(claim, start, asked.all(requests)?),
            Err(why) => return Ok(Finding::of(why)),
        };
        match (outcome.held, answer.right) {
            (Held::Yes, true) | (Held::No, false) => {}
            (Held::No, true) => return Ok(Problem::False(index).into()),
            (Held::Yes, false) => return Ok(Problem::True(index).into()),
            // A later answer may still be wrong for sure.
            (Held::Unknown, _) => found = Finding::of(outcome.why),
        }
    }
    Ok(found)
}

fn spot(start: Situation<'_>, asked: &mut Asked<'_>) -> Next {
    let conflicts = judge::conflicts(start);
    if conflicts.is_empty() {
        return Ok(Problem::NoConflicts.into());
    }
    if asked.judge(start, &Did::Marked(Vec::new()))?.is_solved() {
        return Ok(Problem::StartSolved.into());
    }
    let marks = conflicts.into_iter().map(|conflict| Mark {
        time: conflict.time,
        robots: conflict.agents,
        cells: conflict.cell.into_iter().collect(),
    });
    let all = asked.judge(start, &Did::Marked(marks.collect()))?;
    Ok(must_solve(all))
}

fn lead(task: &Lead, start: Situation<'_>, asked: &mut Asked<'_>) -> Next {
    let scene = start.scene;
    let given = start.step.plan.as_ref();
    let untouched = scene.agents.iter().map(|agent| {
        let path = match given {
            Some(plan) if !task.robots.contains(&agent.name) => plan.path(&agent.name).to_vec(),
            _ => vec![Some(agent.start)],
        };
        (agent.name.clone(), path)
    });
    let untouched = Plan {
        paths: untouched.collect(),
        ..Plan::default()
    };
    if asked.judge(start, &Did::Led(untouched))?.is_solved() {
        return Ok(Problem::StartSolved.into());
    }
    let objective = match &task.aim {
        LeadAim::Legal {} => None,
        LeadAim::Cost { cost, .. } => Objective::new(vec![*cost]).ok(),
        LeadAim::Best { objective } => objective.clone(),
    };
    let answer = asked.all(vec![ask::solve(scene, objective.as_ref())])?;
    let answer = answer.first();
    match (solved(answer), &task.aim) {
        (Ok(Proved::NoPlan), _) => return Ok(Problem::NoPlan.into()),
        (Ok(Proved::Best(costs, _)), LeadAim::Cost { cost, at_most }) => {
            let (cost, best) = (*cost, costs.get(*cost));
            if best > *at_most {
                return Ok(Problem::Dear { cost, best }.into());
            }
        }
        (Err(why @ Why::Refused(_)), _) => return Ok(Finding::of(why)),
        _ => {}
    }
    // A plan that is not proved best may be good enough.
    let plan = match answer {
        Some(Response::Solved(answer)) => answer.plan.clone(),
        _ => None,
    };
    let Some(plan) = plan else {
        return Ok(Problem::Unsolved.into());
    };
    // Where no plan is given, the robots that are not led stand still.
    let is_still = |name: &String| {
        let path = plan.path(name);
        path.iter().all(|at| Some(at) == path.first())
    };
    let mut others = scene.agents.iter().map(|agent| &agent.name);
    let as_led = given.is_some() || others.all(|name| task.robots.contains(name) || is_still(name));
    let verdict = asked.judge(start, &Did::Led(plan))?;
    Ok(if verdict.is_solved() && as_led {
        Finding::Passed
    } else {
        Problem::Unsolved.into()
    })
}

fn order(task: &Order, start: Situation<'_>, asked: &mut Asked<'_>) -> Next {
    let agents = &start.scene.agents;
    let orders = match task.find {
        OrderAim::None => {
            let verdict = asked.judge(start, &Did::NoOrder)?;
            return Ok(must_solve(verdict));
        }
        _ if agents.len() > MAX_ORDERED => {
            // There are too many to try them all.
            vec![agents.iter().map(|agent| agent.name.clone()).collect()]
        }
        OrderAim::Works | OrderAim::Best | OrderAim::Worse => all_orders(start.scene),
    };
    let is_all = agents.len() <= MAX_ORDERED;
    let mut found = Finding::from(if is_all {
        Problem::NoOrder
    } else {
        Problem::Unsolved
    });
    for order in orders {
        let verdict = asked.judge(start, &Did::Ordered(order))?;
        if verdict.is_solved() {
            return Ok(Finding::Passed);
        }
        if let Finding::Unknown(why) = Finding::of(verdict.why) {
            found = Finding::Unknown(why);
        }
    }
    Ok(found)
}

fn change(task: &Change, start: Situation<'_>, asked: &mut Asked<'_>) -> Next {
    let mut found = Finding::from(Problem::NoMethod);
    for method in &task.methods {
        let verdict = asked.judge(start, &Did::Went(*method))?;
        if verdict.is_solved() {
            return Ok(Finding::Passed);
        }
        if let Finding::Unknown(why) = Finding::of(verdict.why) {
            found = Finding::Unknown(why);
        }
    }
    Ok(found)
}
