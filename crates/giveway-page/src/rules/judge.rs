//! What the plan on the board is under a rule that is being written, by the checker alone.

use std::collections::BTreeSet;

use giveway_model::check::{Rule, Violation, check};
use giveway_model::constraint::ConstraintKind;
use giveway_model::words::{and, capital, sentence};
use giveway_model::{Constraint, Instance, Scene, sorting::set, tr};

use super::never::never;
use super::outdated::judged_by;
use super::{Writing, zone_of};
use crate::changing::{Changing, inside};
use crate::{Answer, State};

/// At most so many stretches of time are told.
const STRETCHES: usize = 3;

/// What becomes of the plan under a rule.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ruling {
    /// It is in force already.
    InForce,
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

/// Judges the plan on the board; names a rule in force that differs in its numbers alone.
pub(super) fn judge(state: &State, writing: &Writing) -> Judged {
    let mut judged = ruling(state, writing);
    let is_open = !matches!(judged.ruling, Ruling::InForce | Ruling::Fault);
    if let Some(kin) = kin(state, writing).filter(|_| is_open) {
        let told = tr!(
            "“{rule}” stays in force beside it: open that one to change it.",
            rule = kin.sentence()
        );
        judged.details.push(crate::words::unnested(&told));
    }
    judged
}

/// That the times of a rule end before they begin.
fn ends_early(rule: &Constraint) -> Option<String> {
    let mut kind = rule.kind.clone();
    let times = super::parts(&mut kind).times?;
    let (from, to) = times.from.zip(times.to)?;
    (from > to).then(|| {
        tr!(
            "It would end at time {to}, before it begins at time {from}.",
            to,
            from
        )
    })
}

/// A rule in force of the same kind, about the same place and robots, while a new one is written.
fn kin<'s>(state: &'s State, writing: &Writing) -> Option<&'s Constraint> {
    let rule = &writing.rule;
    let is_kin = |other: &&Constraint| {
        let (one, two) = (zone_of(&rule.kind), zone_of(&other.kind));
        one.is_some()
            && one == two
            && !other.off
            && other.kind_name() == rule.kind_name()
            && other.agents == rule.agents
    };
    let mut rules = state.document.draft.scene().constraints.iter();
    rules
        .find(is_kin)
        .filter(|_| writing.index.is_none() && !writing.asks)
}

fn ruling(state: &State, writing: &Writing) -> Judged {
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
            let own: Vec<String> = match ends_early(&writing.rule) {
                Some(told) => vec![told],
                None => own.collect(),
            };
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
    if super::twin(state, &writing.rule, writing.index).is_some() {
        let said = tr!("Every plan of this scene keeps it.").to_owned();
        return say(Ruling::InForce, tr!("It is in force already"), vec![said]);
    }
    if let Some(changing) = state.document.mode.changing() {
        let title = tr!("It holds from time {at} on", at = changing.at);
        let inside = uncounted(state, changing, &writing.rule);
        return say(Ruling::Open, &title, inside.into_iter().collect());
    }
    if let Some(never) = never(state.document.draft.scene(), &writing.rule) {
        return say(Ruling::Never, tr!("No plan can keep it"), vec![never.why]);
    }
    let Some(plan) = judged_by(state).and_then(Answer::plan) else {
        let title = if state.document.is_stale() {
            tr!("The plan on the board is of the scene before: solve it again, then it is judged.")
        } else {
            tr!("There is no plan to judge yet.")
        };
        return say(Ruling::Open, title, Vec::new());
    };
    let report = check(&instance, plan);
    let broken: Vec<&Violation> = report
        .violations
        .iter()
        .filter(|violation| violation.rule == Rule::Constraint)
        .collect();
    if broken.is_empty() {
        return kept(state, writing);
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

fn kept(state: &State, writing: &Writing) -> Judged {
    let answer = state.document.fresh_answer();
    let is_best = answer.is_some_and(|answer| {
        answer.solved.status == giveway_solve::Status::Optimal && answer.course.is_none()
    });
    let detail = if writing.rule.is_penalty() {
        tr!("It costs a penalty, which the next search counts.")
    } else if writing.index.is_some() {
        // The rule as it was may be what keeps a better plan away.
        tr!("The next search tells whether there is a better one.")
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

/// The robots that are in the zone of a rule already when it is added: they are not counted until
/// they have left it.
fn uncounted(state: &State, changing: &Changing, rule: &Constraint) -> Option<String> {
    let (ConstraintKind::Capacity { .. } | ConstraintKind::Closed { .. }) = rule.kind else {
        return None;
    };
    let name = zone_of(&rule.kind)?;
    let zones = &state.document.draft.scene().zones;
    let zone = zones.iter().find(|zone| zone.name == name)?;
    let robots = inside(changing, &zone.cell_set());
    (!robots.is_empty()).then(|| {
        tr!(
            "{robots} is in {zone} then, and not counted until it has left."
                | "{robots} are in {zone} then, and not counted until they have left."
                    % robots.len(),
            robots = and(&robots),
            zone = name
        )
    })
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
