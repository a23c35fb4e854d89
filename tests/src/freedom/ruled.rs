//! What is said of all best plans of a scene with rules of its own, compared with all of them.

use std::collections::BTreeMap;

use giveway_model::check::check;
use giveway_model::format::native;
use giveway_model::{Cell, Cost, Instance, Objective, Plan, constraint::ConstraintKind};
use giveway_solve::freedom::{Closed, Farthest, FreedomAnswer, Hold, Known, Later, PlanCount};
use giveway_solve::{Reason, Status, Stop};
use serde_json::Value;

use super::plans::{differs, ways};
use super::{COUNT, Compared, ask, at};
use crate::oracle::{Course, Where};
use crate::rules_oracle::{Answer, RuleScene, all_best, best};

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
            let answer = ask(&instance, None, within);
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
    let given = given.filter(|_| vector.iter().sum::<i64>() % 2 == 0);
    let given = given.map(|course| plan_of(&instance, course));
    let answer = ask(&instance, given, within);
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

/// Where an agent is in a course at a time.
fn place(course: &Course, agent: usize, time: usize) -> Where {
    course[time.min(course.len() - 1)].0[agent]
}

/// When an agent arrives in a course.
fn arrival(instance: &Instance, course: &Course, agent: usize) -> usize {
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

fn plan_of(instance: &Instance, course: &Course) -> Plan {
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

fn backbone(
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

fn arrivals(
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

/// For how long agents can stand still at each time, by trying with the judge.
fn holds(
    instance: &Instance,
    plan: &Plan,
    (objective, answer): (&Objective, &FreedomAnswer),
) -> Vec<String> {
    let first = objective.costs()[0];
    let most = check(instance, plan).costs.unwrap().get(first);
    let longest = plan.paths.values().map(Vec::len).max().unwrap_or(0);
    let long = longest as u32 + 40;
    let mut faults = Vec::new();
    for agent in instance.agents() {
        let name = &agent.name;
        let path = plan.path(name).to_vec();
        let mut expected = Vec::new();
        for time in 0..path.len() - 1 {
            let Some(here) = path[time] else {
                expected.push(Hold::InTransit);
                continue;
            };
            let passes = |steps: u32| {
                let mut moved: Vec<Option<Cell>> = path[..time].to_vec();
                moved.extend((0..steps).map(|_| Some(here)));
                moved.extend(&path[time..]);
                [0, steps].into_iter().any(|at_once| {
                    let mut later = plan.clone();
                    later.paths.insert(name.clone(), moved.clone());
                    let charges = plan.charges(name).iter();
                    let charges = charges.map(|&at| match at.cmp(&(time as u32)) {
                        std::cmp::Ordering::Less => at,
                        std::cmp::Ordering::Equal => at + at_once,
                        std::cmp::Ordering::Greater => at + steps,
                    });
                    let charges: Vec<u32> = charges.collect();
                    if !charges.is_empty() {
                        later.charges.insert(name.clone(), charges);
                    }
                    let report = check(instance, &later);
                    let cost = report.costs.map(|costs| costs.get(first));
                    report.violations.is_empty() && cost.is_some_and(|cost| cost <= most)
                })
            };
            let steps = (1..=long).take_while(|&steps| passes(steps)).count() as u32;
            expected.push(if steps == long {
                Hold::Unlimited
            } else {
                Hold::Steps(steps)
            });
        }
        let slack = answer.slack.as_ref().and_then(|all| all.get(name));
        let said = slack.map(|slack| &slack.hold);
        if said != Some(&expected) {
            faults.push(format!("{name} holds {said:?}, not {expected:?}"));
        }
    }
    faults
}

fn farthest(
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

/// What closing each free cell costs, where the oracle can say.
fn critical(
    json: &Value,
    instance: &Instance,
    (within, objective, before): (Option<u32>, &Objective, &[u32]),
    answer: &FreedomAnswer,
) -> Vec<String> {
    let mut faults = Vec::new();
    for it in answer.critical.iter().flatten() {
        let cell = it.cell;
        let mut agents = instance.agents().iter();
        let of_agent =
            agents.any(|a| a.start == cell || a.goal == Some(cell) || a.waypoints.contains(&cell));
        let mut rules = instance.constraints_in_force();
        let of_rule = rules.any(|rule| match &rule.constraint.kind {
            ConstraintKind::Sequence { cells, .. } => cells.contains(&cell),
            ConstraintKind::Visit { cell: at, .. } => *at == cell,
            _ => false,
        });
        let mut json = json.clone();
        let mut row = json["map"][cell.y as usize].as_str().unwrap().to_owned();
        row.replace_range(cell.x as usize..=cell.x as usize, "#");
        json["map"][cell.y as usize] = row.into();
        let expected = if of_agent {
            Answer::Impossible
        } else {
            let scene = RuleScene::read(&json.to_string(), &[]);
            best(&scene, within.map(i64::from), MOST_STATES)
        };
        let right = match (&it.closed, expected) {
            (_, Answer::Capped) => true,
            (Closed::Impossible { needed, .. }, Answer::Impossible) => {
                needed.is_some() == (of_agent || of_rule)
            }
            (Closed::Optimal { costs, deltas, .. }, Answer::Best(vector)) => {
                let vector: Vec<u32> = vector.into_iter().map(number).collect();
                let each = objective.costs().iter().zip(before).zip(&vector);
                let by =
                    each.map(|((&cost, &one), &other)| (cost, i64::from(other) - i64::from(one)));
                costs.vector(objective) == vector && *deltas == by.collect()
            }
            _ => false,
        };
        if !right {
            faults.push(format!("without {cell}: {:?}", it.closed));
        }
    }
    faults
}
