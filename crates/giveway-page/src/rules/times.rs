//! The timeline's row of rules: when each rule with times is in force, and where the plan that
//! is shown breaks one.

use giveway_model::check::Violation;
use giveway_model::constraint::meant;
use giveway_model::{Constraint, tr};

use super::counts::times_in;
use super::{Lit, icon, ranges, zone_of};
use crate::State;

/// So many lines are shown until the row is opened.
const LINES: usize = 3;
/// At most so many rules have a stretch.
const MOST: usize = 60;

/// The row of rules.
#[derive(Clone, Debug, PartialEq)]
pub struct TimesRow {
    /// The lines that are shown; stretches on one line do not meet.
    pub lines: Vec<Vec<Stretch>>,
    /// How many lines more there are.
    pub hidden: usize,
    /// Whether it shows more lines than it does at first.
    pub is_open: bool,
}

/// A rule, and when it is in force.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Stretch {
    /// The rule, by its index in the scene.
    pub rule: usize,
    /// The icon of its kind.
    pub icon: &'static str,
    /// What it is called: its name, that of its zone, or its sentence.
    pub text: String,
    /// Its sentence, with what breaks it.
    pub label: String,
    /// The first time of it on the axis.
    pub from: u32,
    /// The last time of it on the axis.
    pub to: u32,
    /// Whether it is in force at the time shown.
    pub is_now: bool,
    /// Whether it is lit.
    pub is_lit: bool,
    /// The times at which it is broken.
    pub broken: Vec<u32>,
}

/// The row, on an axis that ends at a time; nothing where no rule in force has times and none is
/// broken.
pub fn times_row(state: &State, last: u32) -> Option<TimesRow> {
    let scene = state.world().scene();
    let rules = scene.constraints.iter().enumerate();
    let in_force = rules.filter(|(_, rule)| !rule.off);
    let stretches = in_force.filter_map(|(index, rule)| stretch(state, index, rule, last));
    let mut stretches: Vec<Stretch> = stretches.take(MOST).collect();
    stretches.sort_by_key(|stretch| (stretch.from, stretch.rule));
    let mut lines: Vec<Vec<Stretch>> = Vec::new();
    for stretch in stretches {
        let is_free =
            |line: &&mut Vec<Stretch>| line.last().is_none_or(|before| before.to < stretch.from);
        match lines.iter_mut().find(is_free) {
            Some(line) => line.push(stretch),
            None => lines.push(vec![stretch]),
        }
    }
    if lines.is_empty() {
        return None;
    }
    let is_open = state.view.rules.shows_all_times && lines.len() > LINES;
    let hidden = if is_open {
        0
    } else {
        lines.len().saturating_sub(LINES)
    };
    lines.truncate(lines.len() - hidden);
    Some(TimesRow {
        lines,
        hidden,
        is_open,
    })
}

fn stretch(state: &State, index: usize, rule: &Constraint, last: u32) -> Option<Stretch> {
    let mut kind = rule.kind.clone();
    let times = super::parts(&mut kind).times.map(|times| meant(*times));
    let times = times.filter(|times| !super::pieces::is_always(*times));
    let broken: Vec<u32> = broken(state)
        .filter(|violation| {
            violation
                .broken
                .as_ref()
                .is_some_and(|of| of.index as usize == index)
        })
        .map(|violation| violation.time.min(last))
        .collect();
    if times.is_none() && broken.is_empty() {
        return None;
    }
    let times = times.unwrap_or_default();
    if times.first() > last {
        return None;
    }
    let sentence = rule.sentence();
    let zone = zone_of(&rule.kind).map(str::to_owned);
    let sentence_of = match &rule.name {
        Some(name) => format!("{name}: {sentence}"),
        None => sentence.clone(),
    };
    let label = if broken.is_empty() {
        sentence_of
    } else {
        let when = ranges(&broken, 3);
        tr!("{rule}, broken {when}", rule = sentence_of, when)
    };
    Some(Stretch {
        rule: index,
        icon: icon(rule),
        text: rule.name.clone().or(zone).unwrap_or(sentence),
        label,
        from: times.first(),
        to: times.last().min(last),
        is_now: times.contains(state.view.playback.time),
        is_lit: state.is_lit(index, rule),
        broken,
    })
}

/// The rules of the scene's own that the plan on the board breaks: one that is led by hand, one of
/// elsewhere, or one that is older than a rule.
pub(crate) fn broken(state: &State) -> impl Iterator<Item = &Violation> {
    let led = state.document.mode.steering();
    let led = led.map(|own| own.violations.as_slice());
    let audited = state
        .audited()
        .map(|audit| audit.plan.violations.as_slice());
    let outdated = super::outdated::of(state).map(|it| it.violations.as_slice());
    let all = led.or(audited).or(outdated).unwrap_or_default().iter();
    all.filter(|violation| violation.broken.is_some())
}

/// The times at which a robot is in the zone that is lit, from first to last; of a rule only
/// where it binds the robot.
pub fn in_lit_zone(state: &State, name: &str) -> Vec<(u32, u32)> {
    let rules = &state.world().scene().constraints;
    let zone = match state.lit_rule() {
        Some(Lit::Zone(zone)) => Some(zone.as_str()),
        Some(Lit::Rule(index)) => {
            let rule = rules.get(*index);
            let binds = |rule: &&Constraint| {
                let names = rule.agents.as_ref();
                names.is_none_or(|names| names.iter().any(|of| of == name))
            };
            rule.filter(binds).and_then(|rule| zone_of(&rule.kind))
        }
        None => None,
    };
    let (Some(zone), Some(plan)) = (zone, state.plan()) else {
        return Vec::new();
    };
    let mut stretches: Vec<(u32, u32)> = Vec::new();
    for time in times_in(state, plan, zone, name, state.last_time()) {
        match stretches.last_mut() {
            Some((_, last)) if *last + 1 == time => *last = time,
            Some(_) | None => stretches.push((time, time)),
        }
    }
    stretches
}
