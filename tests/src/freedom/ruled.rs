//! What is said of all best plans of a scene with rules of its own, compared with all of them.

mod courses;
mod critical;
mod holds;
mod visits;

use giveway_model::Cost;
use giveway_model::check::check;
use giveway_model::format::native;
use giveway_solve::freedom::PlanCount;
use giveway_solve::{Reason, Status, Stop};
use serde_json::Value;

use super::latest::{Latest, left};
use super::plans::ways;
use super::{Asked, COUNT, Compared, ask};
use crate::rules_oracle::{Answer, RuleScene, all_best, best};
use courses::{arrival, plan_of};
use critical::critical;
use holds::holds;
use visits::{arrivals, backbone, farthest};

/// Joint states that the oracle looks at.
const MOST_STATES: usize = 12_000;

/// Compares all parts of an answer about a scene, given as JSON.
///
/// # Panics
/// When the text is no scene.
pub fn compare_ruled(json: &Value, within: Option<u32>) -> Compared {
    let text = json.to_string();
    let instance = native::read_instance(&text).unwrap();
    let scene = RuleScene::read(&text, &[]);
    let costs = instance.in_force(instance.objective().clone());
    let timed = |cost: &Cost| matches!(cost, Cost::Makespan | Cost::SumOfCosts);
    let within = within.or((!costs.costs().iter().any(timed)).then_some(7));
    let vector = match best(&scene, within.map(i64::from), MOST_STATES) {
        Answer::Capped => return Compared::TooLarge,
        Answer::Impossible => {
            let answer = ask(&instance, Asked::Own, within);
            return match answer.status {
                Status::Impossible if answer.is_settled() => Compared::Agreed(Box::new(answer)),
                status => Compared::Differ(vec![format!("{status:?}, and there is no plan")]),
            };
        }
        Answer::Best(vector) => vector,
    };
    let of = |cost| costs.costs().iter().position(|&it| it == cost);
    let value = |cost| Some(number(vector[of(cost)?]));
    let latest = [value(Cost::Makespan), value(Cost::SumOfCosts), within];
    let Some(latest) = latest.into_iter().flatten().min() else {
        return Compared::TooLarge;
    };
    let Some(all) = all_best(&scene, &vector, i64::from(latest), 4 * MOST_STATES) else {
        return Compared::TooLarge;
    };
    let courses = all.courses(COUNT as usize);
    let given = courses.as_ref().and_then(|courses| courses.last());
    let given = given.map(|course| plan_of(&instance, course));
    let asked = match (vector.iter().sum::<i64>() % 3, &given) {
        (0, Some(plan)) => Asked::Given(plan),
        (1, _) => Asked::Proved,
        _ => Asked::Own,
    };
    let answer = ask(&instance, asked, within);
    if answer.reason == Some(Reason::Stopped(Stop::Conflicts)) {
        return Compared::TooLarge;
    }
    let mut faults = Vec::new();
    if answer.status != Status::Optimal || !answer.is_settled() {
        let (status, pending) = (answer.status, &answer.pending);
        faults.push(format!(
            "{status:?}, pending {pending:?}, {:?}",
            answer.reason
        ));
    }
    let Some(plan) = &answer.plan else {
        return Compared::Differ(faults);
    };
    let report = check(&instance, plan);
    let told = report.costs.map(|own| own.vector(&costs));
    let expected: Vec<u32> = vector.iter().copied().map(number).collect();
    if !report.violations.is_empty() || told.as_ref() != Some(&expected) {
        faults.push(format!(
            "{told:?}, not {expected:?}: {:?}",
            report.violations
        ));
    }
    if let Some(courses) = &courses {
        let latest = |agent| {
            let all = courses.iter().map(|it| arrival(&instance, it, agent));
            all.max().unwrap_or(0) as u32
        };
        if let Latest::Differ(fault) = left(&instance, within, latest) {
            faults.push(fault);
        }
    }
    let counted = match &courses {
        Some(courses) => PlanCount::Exactly(courses.len() as u32),
        None => PlanCount::MoreThan(COUNT),
    };
    let said = answer.plans.as_ref().map(|plans| plans.number);
    if said != Some(counted) {
        faults.push(format!("{said:?} plans, not {counted:?}"));
    }
    faults.extend(holds(&instance, plan, (&costs, &answer)));
    if let Some(courses) = &courses {
        faults.extend(backbone(&instance, plan, courses, &answer));
        faults.extend(arrivals(&instance, plan, courses, &answer));
        faults.extend(ways(&instance, courses, &answer));
        faults.extend(farthest(
            &instance,
            plan,
            (latest, courses, &costs),
            &answer,
        ));
    }
    faults.extend(critical(
        json,
        &instance,
        (within, &costs, &expected),
        &answer,
    ));
    if faults.is_empty() {
        Compared::Agreed(Box::new(answer))
    } else {
        faults.push(serde_json::to_string(&answer).unwrap());
        Compared::Differ(faults)
    }
}

fn number(cost: i64) -> u32 {
    u32::try_from(cost).unwrap()
}
