//! All best plans as the oracle has them: where agents are, when they arrive, and as plans.

use giveway_model::{Instance, Plan};

use crate::oracle::{Course, Where};

/// Where an agent is in a course at a time.
pub(super) fn place(course: &Course, agent: usize, time: usize) -> Where {
    course[time.min(course.len() - 1)].0[agent]
}

/// When an agent arrives in a course.
pub(super) fn arrival(instance: &Instance, course: &Course, agent: usize) -> usize {
    let goal = instance.agents()[agent].goal.map(Where::At);
    let rest = if instance.stays() {
        goal
    } else {
        Some(Where::Gone)
    };
    let mut time = course.len();
    while time > 0 && Some(place(course, agent, time - 1)) == rest {
        time -= 1;
    }
    // Where agents stay, the first time at the goal; else the last one before it is gone.
    if instance.stays() { time } else { time - 1 }
}

pub(super) fn plan_of(instance: &Instance, course: &Course) -> Plan {
    let mut plan = Plan::default();
    for (i, agent) in instance.agents().iter().enumerate() {
        let end = arrival(instance, course, i);
        let cell = |time| match place(course, i, time) {
            Where::At(cell) => Some(cell),
            Where::Between(..) | Where::Gone => None,
        };
        let path = (0..=end).map(cell).collect();
        plan.paths.insert(agent.name.clone(), path);
        let charges = (0..end).filter(|&time| course[time].1[i]);
        let charges: Vec<u32> = charges.map(|time| time as u32).collect();
        if !charges.is_empty() {
            plan.charges.insert(agent.name.clone(), charges);
        }
    }
    plan
}
