//! What all best plans share, when agents arrive in them, and the plan farthest from one.

use std::collections::BTreeMap;

use giveway_model::check::check;
use giveway_model::{Instance, Objective, Plan};
use giveway_solve::freedom::{Farthest, FreedomAnswer, Known, Later};

use super::courses::{arrival, place};
use crate::freedom::{at, plans::differs};
use crate::oracle::Course;

pub(super) fn backbone(
    instance: &Instance,
    plan: &Plan,
    courses: &[Course],
    answer: &FreedomAnswer,
) -> Vec<String> {
    let mut faults = Vec::new();
    let none = BTreeMap::new();
    let backbone = answer.backbone.as_ref().unwrap_or(&none);
    let known = |number: usize| {
        let of = |is| if is { Known::Yes } else { Known::No };
        (of(number == courses.len()), of(number == 1))
    };
    for (i, agent) in instance.agents().iter().enumerate() {
        let path = plan.path(&agent.name);
        let visits = backbone.get(&agent.name).map_or(&[][..], Vec::as_slice);
        if visits.len() != path.len() {
            faults.push(format!("{}: {visits:?}", agent.name));
        }
        for visit in visits {
            let time = visit.time as usize;
            let here = at(path, time).unwrap();
            let number = courses.iter().filter(|it| place(it, i, time) == here);
            let number = number.count();
            let mut right = known(number) == (visit.always, visit.only);
            if let Some(charge) = visit.charge {
                let charges = courses.iter();
                let charges = charges.filter(|it| it.get(time).is_some_and(|it| it.1[i]));
                right &= known(charges.count()) == (charge.always, charge.only);
            }
            if !right {
                let all = courses.len();
                faults.push(format!("{}: {visit:?} in {number} of {all}", agent.name));
            }
        }
    }
    faults
}

pub(super) fn arrivals(
    instance: &Instance,
    plan: &Plan,
    courses: &[Course],
    answer: &FreedomAnswer,
) -> Vec<String> {
    let mut faults = Vec::new();
    for (i, agent) in instance.agents().iter().enumerate() {
        let now = plan.path(&agent.name).len() - 1;
        let latest = courses.iter().map(|it| arrival(instance, it, i)).max();
        let expected = Later::Exactly((latest.unwrap() - now) as u32);
        let slack = answer.slack.as_ref().and_then(|all| all.get(&agent.name));
        let said = slack.map(|slack| slack.arrival);
        if said != Some(expected) {
            faults.push(format!("{}: {said:?}, not {expected:?}", agent.name));
        }
    }
    faults
}

pub(super) fn farthest(
    instance: &Instance,
    plan: &Plan,
    (latest, courses, objective): (u32, &[Course], &Objective),
    answer: &FreedomAnswer,
) -> Vec<String> {
    let all = courses.iter();
    let most = all.map(|course| differs(instance, plan, latest, course));
    let most = most.max().unwrap_or(0);
    let right = match &answer.farthest {
        Some(Farthest::Only) => courses.len() == 1,
        Some(Farthest::Found {
            plan: other,
            differs,
            most: known,
        }) => {
            let judged = |plan| check(instance, plan).costs.map(|it| it.vector(objective));
            let legal = check(instance, other).is_valid();
            let as_good = judged(other) == judged(plan);
            known.is_proved() && *differs == most && most > 0 && legal && as_good
        }
        _ => false,
    };
    if right {
        Vec::new()
    } else {
        vec![format!("farthest {most}: {:?}", answer.farthest)]
    }
}
