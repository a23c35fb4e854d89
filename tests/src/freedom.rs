//! What is said of all best plans, compared with all of them.

use std::collections::{BTreeMap, BTreeSet};

use giveway_model::{Cell, Cost, Instance, Plan};
use giveway_solve::freedom::{
    Closed, CriticalCell, Farthest, FreedomAnswer, FreedomRequest, Hold, Known, Later, Need,
    PlanCount, Slack, Visit,
};
use giveway_solve::{Limits, Request, Response, SilentHost, Status, serve};

use crate::oracle::{Course, Every, Question, Verdict, Where, is_legal};
use crate::recount;

/// Labels and moments that the oracle may make.
const CAP: usize = 60_000;
/// Plans up to which is counted, and up to which the oracle looks at each.
const COUNT: u32 = 300;

/// What came of a comparison.
pub enum Compared {
    /// Both say the same.
    Agreed(Box<FreedomAnswer>),
    /// They contradict each other.
    Differ(Vec<String>),
    /// The oracle cannot say.
    TooLarge,
}

/// The service's answer.
pub fn ask(instance: &Instance, plan: Option<Plan>, within: Option<u32>) -> FreedomAnswer {
    let request = Request::Freedom(FreedomRequest {
        scene: instance.to_scene(),
        plan,
        within,
        count: Some(COUNT),
        limits: Limits {
            conflicts: Some(300_000),
            ..Limits::default()
        },
        ..FreedomRequest::default()
    });
    match serve(&request, &SilentHost) {
        Response::Freedom(answer) => *answer,
        other => panic!("expected an answer, got {other:?}"),
    }
}

/// Compares all parts of an answer. Where no cost of the objective counts time, plans
/// may be as long as the horizon allows, so there it is short.
pub fn compare(instance: &Instance, within: Option<u32>) -> Compared {
    let costs = instance.objective().costs();
    let timed = |cost: &Cost| matches!(cost, Cost::Makespan | Cost::SumOfCosts);
    let within = within.or((!costs.iter().any(timed)).then_some(7));
    let question = Question {
        instance,
        within,
        cap: CAP,
    };
    let best = match question.best() {
        Verdict::Capped => return Compared::TooLarge,
        Verdict::Impossible => None,
        Verdict::Best(point) => Some(point),
    };
    let Some(best) = best else {
        let answer = ask(instance, None, within);
        return match answer.status {
            Status::Impossible if answer.is_settled() => Compared::Agreed(Box::new(answer)),
            status => Compared::Differ(vec![format!("{status:?}, and there is no plan")]),
        };
    };
    let value = |cost| {
        let place = costs.iter().position(|&it| it == cost);
        place.map(|place| best.vector[place])
    };
    let latest = [value(Cost::Makespan), value(Cost::SumOfCosts), within];
    let Some(latest) = latest.into_iter().flatten().min() else {
        return Compared::TooLarge;
    };
    let Some(every) = Every::of(instance, &best.vector, latest, CAP) else {
        return Compared::TooLarge;
    };
    // Of every second instance the plan is the oracle's.
    let given = (best.vector.iter().sum::<u32>() % 2 == 0).then(|| best.plan.clone());
    let answer = ask(instance, given, within);
    let mut faults = Vec::new();
    let mut expect = |holds: bool, what: String| {
        if !holds {
            faults.push(what);
        }
    };
    expect(
        answer.status == Status::Optimal && answer.is_settled(),
        format!("{:?}, pending {:?}", answer.status, answer.pending),
    );
    let Some(plan) = &answer.plan else {
        return Compared::Differ(faults);
    };
    let vector = recount::costs(plan).vector(instance.objective());
    expect(
        vector == best.vector,
        format!("{vector:?}, not {:?}", best.vector),
    );
    let number = u64::from(COUNT);
    let counted = if every.count() > number {
        PlanCount::MoreThan(COUNT)
    } else {
        PlanCount::Exactly(every.count() as u32)
    };
    let said = answer.plans.as_ref().map(|plans| plans.number);
    expect(
        said == Some(counted),
        format!("{said:?} plans, not {}", every.count()),
    );
    faults.extend(backbone(instance, plan, &every, &answer));
    faults.extend(slack(instance, plan, &every, &answer));
    if every.count() <= number {
        faults.extend(ways(instance, &every.courses(), &answer));
        faults.extend(farthest(instance, plan, latest, &every.courses(), &answer));
    }
    match critical(instance, within, &best.vector, &answer) {
        Some(more) => faults.extend(more),
        None => return Compared::TooLarge,
    }
    if faults.is_empty() {
        Compared::Agreed(Box::new(answer))
    } else {
        faults.push(serde_json::to_string(&answer).unwrap());
        Compared::Differ(faults)
    }
}

/// Where a path has an agent at a time; `None` after its arrival.
fn at(path: &[Option<Cell>], time: usize) -> Option<Where> {
    let cell = |time: usize| path.get(time).copied().flatten();
    match path.get(time)? {
        Some(cell) => Some(Where::At(*cell)),
        None => Some(Where::Between(cell(time - 1)?, cell(time + 1)?)),
    }
}

fn known(said: Known, is_so: bool) -> bool {
    said == if is_so { Known::Yes } else { Known::No }
}

fn backbone(
    instance: &Instance,
    plan: &Plan,
    every: &Every,
    answer: &FreedomAnswer,
) -> Vec<String> {
    let mut faults = Vec::new();
    let none = BTreeMap::new();
    let backbone = answer.backbone.as_ref().unwrap_or(&none);
    for (i, agent) in instance.agents().iter().enumerate() {
        let empty: Vec<Visit> = Vec::new();
        let visits = backbone.get(&agent.name).unwrap_or(&empty);
        let path = plan.path(&agent.name);
        let cells: Vec<Option<Cell>> = visits.iter().map(|visit| visit.cell).collect();
        if cells != path {
            faults.push(format!("{} is at {cells:?}, not {path:?}", agent.name));
        }
        for visit in visits {
            let time = visit.time as usize;
            let here = at(path, time).unwrap_or(Where::Gone);
            let number = every.visits(i, time).get(&here).copied().unwrap_or(0);
            let mut right = known(visit.always, number == every.count());
            right &= known(visit.only, number == 1);
            let charges = plan.charges(&agent.name).contains(&visit.time);
            right &= visit.charge.is_some() == charges;
            if let Some(charge) = visit.charge {
                let number = every.charges(i, time);
                right &= known(charge.always, number == every.count());
                right &= known(charge.only, number == 1);
            }
            if !right {
                let all = every.count();
                faults.push(format!("{}: {visit:?} in {number} of {all}", agent.name));
            }
        }
    }
    faults
}

fn slack(instance: &Instance, plan: &Plan, every: &Every, answer: &FreedomAnswer) -> Vec<String> {
    let mut faults = Vec::new();
    let none = BTreeMap::new();
    let slacks = answer.slack.as_ref().unwrap_or(&none);
    for (i, agent) in instance.agents().iter().enumerate() {
        let now = plan.path(&agent.name).len() as u32 - 1;
        let later = every.latest_arrival(i) - now;
        let holds = holds(instance, plan, &agent.name);
        let expected = Slack {
            arrival: Later::Exactly(later),
            hold: holds,
        };
        let said = slacks.get(&agent.name);
        if said != Some(&expected) {
            faults.push(format!("{}: {said:?}, not {expected:?}", agent.name));
        }
    }
    faults
}

/// For how long an agent can stand still at each time, by trying.
fn holds(instance: &Instance, plan: &Plan, name: &str) -> Vec<Hold> {
    let first = instance.objective().costs()[0];
    let most = recount::costs(plan).get(first);
    let path = plan.path(name).to_vec();
    // By then everybody has arrived; and longer than any battery lasts.
    let long = plan.paths.values().map(Vec::len).max().unwrap_or(0) as u32 + 25;
    let mut holds = Vec::new();
    for time in 0..path.len() - 1 {
        let Some(here) = path[time] else {
            holds.push(Hold::InTransit);
            continue;
        };
        let passes = |steps: u32| {
            let mut later = plan.clone();
            let mut moved: Vec<Option<Cell>> = path[..time].to_vec();
            moved.extend((0..steps).map(|_| Some(here)));
            moved.extend(&path[time..]);
            later.paths.insert(name.to_owned(), moved);
            let charges = plan.charges(name);
            [0, steps].into_iter().any(|at_once| {
                let each = charges.iter().map(|&at| match at.cmp(&(time as u32)) {
                    std::cmp::Ordering::Less => at,
                    std::cmp::Ordering::Equal => at + at_once,
                    std::cmp::Ordering::Greater => at + steps,
                });
                let mut later = later.clone();
                later.charges.insert(name.to_owned(), each.collect());
                recount::costs(&later).get(first) <= most && is_legal(instance, &later)
            })
        };
        let steps = (1..=long).take_while(|&steps| passes(steps)).count() as u32;
        holds.push(if steps == long {
            Hold::Unlimited
        } else {
            Hold::Steps(steps)
        });
    }
    holds
}

fn ways(instance: &Instance, courses: &[Course], answer: &FreedomAnswer) -> Vec<String> {
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

fn farthest(
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
fn differs(instance: &Instance, plan: &Plan, latest: u32, course: &Course) -> u32 {
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

/// `None` where the oracle cannot say.
fn critical(
    instance: &Instance,
    within: Option<u32>,
    best: &[u32],
    answer: &FreedomAnswer,
) -> Option<Vec<String>> {
    let mut faults = Vec::new();
    let cells = answer.critical.as_ref()?;
    let grid = instance.grid();
    let free = grid.cells().filter(|(_, ground)| ground.is_vertex());
    let free: Vec<Cell> = free.map(|(cell, _)| cell).collect();
    if cells.iter().map(|it| it.cell).collect::<Vec<Cell>>() != free {
        faults.push(format!("not the free cells: {cells:?}"));
    }
    for CriticalCell { cell, closed } in cells {
        let mut scene = instance.to_scene();
        let row = &mut scene.map[cell.y as usize];
        row.replace_range(cell.x as usize..=cell.x as usize, "#");
        let expected = match Instance::new(scene) {
            Err(_) => Verdict::Impossible,
            Ok(instance) => Question {
                instance: &instance,
                within,
                cap: CAP,
            }
            .best(),
        };
        let mut agents = instance.agents().iter();
        let is_needed =
            agents.any(|a| a.start == *cell || a.goal == Some(*cell) || a.waypoints.contains(cell));
        let right = match (closed, expected) {
            (_, Verdict::Capped) => return None,
            (Closed::Impossible { needed, .. }, Verdict::Impossible) => {
                let by: Option<&Need> = needed.as_ref();
                by.is_some() == is_needed
            }
            (Closed::Optimal { costs, deltas, .. }, Verdict::Best(point)) => {
                let objective = instance.objective();
                let each = objective.costs().iter().zip(best).zip(&point.vector);
                let expected =
                    each.map(|((&cost, &before), &now)| (cost, i64::from(now) - i64::from(before)));
                costs.vector(objective) == point.vector
                    && *deltas == expected.collect::<BTreeMap<_, _>>()
            }
            _ => false,
        };
        if !right {
            faults.push(format!("without {cell}: {closed:?}"));
        }
    }
    Some(faults)
}
