//! What the plan on the board is under a rule that is being written, by the checker alone.

use std::collections::BTreeSet;

use giveway_model::check::{Rule, Violation, check};
use giveway_model::constraint::ConstraintKind;
use giveway_model::words::{and, capital, sentence};
use giveway_model::{Constraint, Instance, Plan, Scene, sorting::set, tr};

use super::never::never;
use super::{Writing, zone_of};
use crate::{Answer, State};

/// At most so many stretches of time are told.
const STRETCHES: usize = 3;

/// What becomes of the plan under a rule.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ruling {
    /// The plan keeps it.
    Keeps,
    /// The plan breaks it.
    Breaks,
    /// The rule cannot be: something of it is wrong.
    Fault,
    /// No plan can keep it.
    Never,
    /// There is no plan to judge.
    Open,
}

/// What the plan on the board is under the rule that is being written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Judged {
    /// The ruling.
    pub ruling: Ruling,
    /// In a few words: `This plan breaks it from 13 to 15`.
    pub title: String,
    /// More of it, as sentences.
    pub details: Vec<String>,
    /// The times at which it is broken.
    pub(crate) times: Vec<u32>,
}

/// How many robots are in the zone at some times on end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Count {
    /// For how many times.
    pub times: u32,
    /// The number of robots.
    pub robots: u32,
    /// Whether the rule holds then.
    pub is_in: bool,
    /// Whether the rule is broken then.
    pub is_over: bool,
}

/// Judges the plan on the board.
pub(super) fn judge(state: &State, writing: &Writing) -> Judged {
    let scene = Scene {
        constraints: vec![Constraint {
            off: false,
            ..writing.rule.clone()
        }],
        ..state.document.draft.scene().clone()
    };
    let say = |ruling, title: &str, details| Judged {
        ruling,
        title: title.to_owned(),
        details,
        times: Vec::new(),
    };
    let instance = match Instance::new(scene) {
        Ok(instance) => instance,
        Err(faults) => {
            let own = faults.iter().filter_map(|fault| {
                let part = fault.place.strip_prefix("constraints[0]")?;
                let place = part.trim_start_matches('.').to_owned();
                let fault = giveway_model::Fault {
                    place,
                    ..fault.clone()
                };
                Some(sentence(&capital(&fault.to_string())))
            });
            let own: Vec<String> = own.collect();
            return if own.is_empty() {
                say(
                    Ruling::Open,
                    tr!("The scene has a problem: nothing is judged."),
                    own,
                )
            } else {
                say(Ruling::Fault, tr!("This rule cannot be"), own)
            };
        }
    };
    if let Some(changing) = state.document.mode.changing() {
        let title = tr!("It holds from time {at} on", at = changing.at);
        return say(Ruling::Open, &title, Vec::new());
    }
    if let Some(why) = never(state.document.draft.scene(), &writing.rule) {
        return say(Ruling::Never, tr!("No plan can keep it"), vec![why]);
    }
    let Some(plan) = state.document.plan() else {
        return say(
            Ruling::Open,
            tr!("There is no plan to judge yet."),
            Vec::new(),
        );
    };
    let report = check(&instance, plan);
    let broken: Vec<&Violation> = report
        .violations
        .iter()
        .filter(|violation| violation.rule == Rule::Constraint)
        .collect();
    if broken.is_empty() {
        return kept(state, &writing.rule);
    }
    let times: BTreeSet<u32> = set(broken.iter().map(|violation| violation.time));
    let times: Vec<u32> = times.into_iter().collect();
    let when = ranges(&times, STRETCHES);
    Judged {
        ruling: Ruling::Breaks,
        title: tr!("This plan breaks it {when}", when),
        details: vec![detail(&broken, &writing.rule)],
        times,
    }
}

fn kept(state: &State, rule: &Constraint) -> Judged {
    let answer = state.document.fresh_answer();
    let is_best = answer.is_some_and(|answer| {
        answer.solved.status == giveway_solve::Status::Optimal && answer.course.is_none()
    });
    let detail = if rule.is_penalty() {
        tr!("It costs a penalty, which the next search counts.")
    } else if is_best {
        tr!("Added, it stays the best plan.")
    } else {
        tr!("Added, it stays a plan.")
    };
    Judged {
        ruling: Ruling::Keeps,
        title: tr!("This plan keeps it").to_owned(),
        details: vec![detail.to_owned()],
        times: Vec::new(),
    }
}

/// Who breaks a rule, as a sentence.
fn detail(broken: &[&Violation], rule: &Constraint) -> String {
    let mut names: Vec<String> = Vec::new();
    for name in broken.iter().flat_map(|violation| &violation.agents) {
        if !names.contains(name) {
            names.push(name.clone());
        }
    }
    match (&rule.kind, zone_of(&rule.kind)) {
        (ConstraintKind::Capacity { .. } | ConstraintKind::Closed { .. }, Some(zone)) => {
            tr!(
                "{robots} is in {zone} then." | "{robots} are in {zone} then." % names.len(),
                robots = and(&names),
                zone
            )
        }
        (_, _) => broken
            .first()
            .map_or_else(String::new, |first| sentence(&first.message)),
    }
}

/// Times in words: `at 4`, `from 13 to 15`, at most so many stretches of them.
///
/// ```
/// use giveway_page::rules::ranges;
/// assert_eq!(ranges(&[4, 5, 9], 3), "from 4 to 5 and at 9");
/// assert_eq!(ranges(&[1, 3, 5], 2), "at 1, at 3 and more often");
/// ```
pub fn ranges(times: &[u32], most: usize) -> String {
    let mut stretches: Vec<(u32, u32)> = Vec::new();
    for &time in times {
        match stretches.last_mut() {
            Some((_, last)) if *last + 1 == time => *last = time,
            _ => stretches.push((time, time)),
        }
    }
    let say = |&(from, to): &(u32, u32)| {
        if from == to {
            tr!("times" => "at {time}", time = from)
        } else {
            tr!("times" => "from {from} to {to}", from, to)
        }
    };
    let mut said: Vec<String> = stretches.iter().take(most).map(say).collect();
    if stretches.len() > most {
        said.push(tr!("times" => "more often").to_owned());
    }
    and(&said)
}

/// How many robots are in a zone at each time of the plan on the board, equal ones as one.
pub(super) fn counts(state: &State, rule: &Constraint, broken: &[u32]) -> Vec<Count> {
    let Some((plan, zone)) = state.document.plan().zip(zone_of(&rule.kind)) else {
        return Vec::new();
    };
    let last = state
        .document
        .fresh_answer()
        .map_or(0, |answer| answer.makespan());
    let bound = rule.agents.as_deref();
    let agents = state.document.agents().iter();
    let agents = agents.filter(|agent| bound.is_none_or(|names| names.contains(&agent.name)));
    let inside: Vec<Vec<u32>> = agents
        .map(|agent| times_in(state, plan, zone, &agent.name, last))
        .collect();
    let mut kind = rule.kind.clone();
    let times = super::parts(&mut kind).times.map(|times| *times);
    let count = |time: u32| Count {
        times: 1,
        robots: inside.iter().filter(|times| times.contains(&time)).count() as u32,
        is_in: times.is_none_or(|times| times.contains(time)),
        is_over: broken.contains(&time),
    };
    let mut counts: Vec<Count> = Vec::new();
    for count in (0..=last).map(count) {
        match counts.last_mut() {
            Some(run) if (Count { times: 1, ..*run }) == count => run.times += 1,
            Some(_) | None => counts.push(count),
        }
    }
    counts
}

/// The times at which a robot is in a zone: at a cell of it, or in transit over an edge with
/// an end in it.
pub(super) fn times_in(state: &State, plan: &Plan, zone: &str, name: &str, last: u32) -> Vec<u32> {
    let scene = state.document.draft.scene();
    let Some(zone) = scene.zones.iter().find(|of| of.name == zone) else {
        return Vec::new();
    };
    let cells = zone.cell_set();
    let path = plan.path(name);
    let stays = scene.rules.at_goal == giveway_model::AtGoal::Stay;
    let at = |time: usize| match path.get(time) {
        Some(cell) => *cell,
        None if stays => path.last().copied().flatten(),
        None => None,
    };
    let is_in = |&time: &u32| {
        let time = time as usize;
        let Some(cell) = at(time) else {
            // Between two cells, or gone.
            let is_passing = time < path.len();
            let ends = [time.checked_sub(1).and_then(at), at(time + 1)];
            return is_passing && ends.into_iter().flatten().any(|end| cells.contains(&end));
        };
        cells.contains(&cell)
    };
    (0..=last).filter(is_in).collect()
}

/// Whether the plan of an answer is a plan of another scene, which has the same robots on the
/// same map, and whether all that was proved of it holds there: each rule that is in force
/// here is in force there, too, and the plan keeps those that came.
pub(crate) fn keeps(answer: &Answer, scene: &Scene) -> bool {
    let before = answer.draft.scene();
    let rest = Scene {
        zones: before.zones.clone(),
        constraints: before.constraints.clone(),
        ..scene.clone()
    };
    let (Some(plan), true) = (answer.plan(), rest == *before) else {
        return false;
    };
    if answer.course.is_some() || answer.by.is_some() {
        return false;
    }
    let cells = |scene: &Scene, name: &str| {
        let zone = scene.zones.iter().find(|zone| zone.name == name)?;
        Some(zone.cell_set())
    };
    let mut came: Vec<&Constraint> = scene.constraints.iter().filter(|rule| !rule.off).collect();
    for rule in before.constraints.iter().filter(|rule| !rule.off) {
        let is_it = |other: &&Constraint| other.kind == rule.kind && other.agents == rule.agents;
        let Some(place) = came.iter().position(is_it) else {
            return false;
        };
        let zone = zone_of(&rule.kind);
        if zone.is_some_and(|zone| cells(before, zone) != cells(scene, zone)) {
            return false;
        }
        came.swap_remove(place);
    }
    let has_penalty = came.iter().any(|rule| rule.is_penalty());
    let is_valid = |instance: &Instance| check(instance, plan).is_valid();
    !has_penalty && Instance::new(scene.clone()).is_ok_and(|instance| is_valid(&instance))
}
