//! The ways of agents in all best plans, and the best plan that differs most.

use std::collections::BTreeSet;

use giveway_model::{Cell, Instance, Plan};
use giveway_solve::freedom::{Farthest, FreedomAnswer, PlanCount};

use super::at;
use crate::oracle::{Course, Where, is_legal};
use crate::recount;

pub(super) fn ways(instance: &Instance, courses: &[Course], answer: &FreedomAnswer) -> Vec<String> {
    let mut faults = Vec::new();
    let Some(plans) = &answer.plans else {
        return vec!["no ways".to_owned()];
    };
    for (i, agent) in instance.agents().iter().enumerate() {
        let way = |course: &Course| -> Vec<(Where, bool)> {
            let each = course.iter();
            each.map(|(places, charges)| (places[i], charges[i]))
                .collect()
        };
        let different: BTreeSet<_> = courses.iter().map(way).collect();
        let said = plans.ways.get(&agent.name);
        let number = said.map(|ways| ways.number);
        if number != Some(PlanCount::Exactly(different.len() as u32)) {
            faults.push(format!(
                "{}: {number:?}, not {}",
                agent.name,
                different.len()
            ));
        }
        let mut steps: BTreeSet<(u32, Cell, Cell)> = BTreeSet::new();
        for way in different {
            let places: Vec<Where> = way.iter().map(|&(place, _)| place).collect();
            let stays = instance.stays() || agent.goal.is_none();
            let end = agent.goal.map(Where::At).or(places.last().copied());
            // The arrival: all that follows is the same cell, or nowhere.
            let rests = |place: &&Where| Some(**place) == end && stays;
            let gone = |place: &&Where| **place == Where::Gone;
            let tail = places
                .iter()
                .rev()
                .take_while(|p| rests(p) || gone(p))
                .count();
            let arrival = places.len() - tail - usize::from(!stays);
            for time in 0..arrival {
                if let Where::At(from) = places[time] {
                    let to = match places[time + 1] {
                        Where::At(to) => Some(to),
                        _ => match places.get(time + 2) {
                            Some(Where::At(to)) => Some(*to),
                            _ => None,
                        },
                    };
                    steps.extend(to.map(|to| (time as u32, from, to)));
                }
            }
        }
        let told = said.map(|ways| {
            let steps = ways.steps.iter();
            steps
                .map(|it| (it.time, it.from, it.to))
                .collect::<BTreeSet<_>>()
        });
        if told.as_ref() != Some(&steps) {
            faults.push(format!("{}: steps {told:?}, not {steps:?}", agent.name));
        }
    }
    faults
}

pub(super) fn farthest(
    instance: &Instance,
    plan: &Plan,
    latest: u32,
    courses: &[Course],
    answer: &FreedomAnswer,
) -> Vec<String> {
    let most = courses
        .iter()
        .map(|course| differs(instance, plan, latest, course))
        .max();
    let most = most.unwrap_or(0);
    let right = match &answer.farthest {
        Some(Farthest::Only) => courses.len() == 1,
        Some(Farthest::Found {
            plan: other,
            differs: said,
            most: known,
        }) => {
            let vector = |plan| recount::costs(plan).vector(instance.objective());
            let no_goal = instance.agents().iter().any(|agent| agent.goal.is_none());
            // Where agents rest anywhere, no number is claimed to be the most.
            let is_most = if no_goal {
                !known.is_proved() && *said > 0
            } else {
                known.is_proved() && *said == most
            };
            is_most && most > 0 && is_legal(instance, other) && vector(other) == vector(plan)
        }
        _ => false,
    };
    if right {
        Vec::new()
    } else {
        vec![format!("farthest {most}: {:?}", answer.farthest)]
    }
}

/// In how many entries and charges a course differs from a plan.
pub(super) fn differs(instance: &Instance, plan: &Plan, latest: u32, course: &Course) -> u32 {
    let mut count = 0;
    for (i, agent) in instance.agents().iter().enumerate() {
        let path = plan.path(&agent.name);
        let until = course.iter().take(latest as usize + 1);
        for (time, (places, charges)) in until.enumerate() {
            let here = match at(path, time) {
                Some(here) => here,
                None if agent.goal.is_none() || instance.stays() => agent
                    .goal
                    .map(Where::At)
                    .or_else(|| at(path, path.len() - 1))
                    .unwrap(),
                None => Where::Gone,
            };
            count += u32::from(places[i] != here);
            let charged = plan.charges(&agent.name).contains(&(time as u32));
            count += u32::from(charges[i] != charged);
        }
    }
    count
}
