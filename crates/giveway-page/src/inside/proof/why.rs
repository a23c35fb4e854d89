//! Why the robots of a step cannot all keep their limits, in sentences: where each has
//! to be, and where two of them collide whichever ways they take.

use giveway_model::words::and;
use giveway_model::{Cost, tr};
use giveway_solve::together::{MeetingKind, MustMeet, MustPass, TogetherAnswer};
use giveway_solve::trace::{AgentLimit, Core};

use super::closer::{keep, limits};

/// So many meetings are told.
const MEETINGS: usize = 2;

/// The sentences; none where nothing was found out.
pub(super) fn why(core: &Core, told: &TogetherAnswer) -> Vec<String> {
    let limits = limits(core);
    let mut why = Vec::new();
    let mut said: Vec<&MustPass> = Vec::new();
    for meeting in told.meetings.iter().take(MEETINGS) {
        for pass in told.passes.iter().filter(|pass| is_part(pass, meeting)) {
            if !said.contains(&pass) {
                said.push(pass);
                why.push(must_pass(core.cost, &limits, pass));
            }
        }
        why.push(meet(meeting));
    }
    if why.is_empty() && !told.regions.is_empty() {
        why.push(without_place(&limits, told).to_owned());
    }
    why
}

/// Whether a meeting follows from a place that a robot has to pass.
fn is_part(pass: &MustPass, meeting: &MustMeet) -> bool {
    let ends = match meeting.kind {
        MeetingKind::Vertex { cell } | MeetingKind::Target { cell } => [cell, cell],
        MeetingKind::Swap { edge } => edge,
    };
    let times = meeting.time..=meeting.time + 1;
    let is_then = times.contains(&pass.time) || (pass.rests && pass.time <= meeting.time);
    meeting.agents.contains(&pass.agent) && ends.contains(&pass.cell) && is_then
}

fn must_pass(cost: Cost, limits: &[AgentLimit], pass: &MustPass) -> String {
    let MustPass {
        agent, cell, time, ..
    } = pass;
    let own = limits.iter().find(|limit| limit.agent == *agent);
    let to = own.map_or_else(|| tr!("do so").to_owned(), |limit| keep(cost, limit));
    if pass.rests {
        tr!(
            "To {to}, {agent} must have arrived at {cell} by time {time}, and it stays there.",
            to,
            agent,
            cell,
            time
        )
    } else {
        tr!(
            "To {to}, {agent} must be at {cell} at time {time}.",
            to,
            agent,
            cell,
            time
        )
    }
}

fn meet(meeting: &MustMeet) -> String {
    let ([a, b], time) = (&meeting.agents, meeting.time);
    match meeting.kind {
        MeetingKind::Vertex { cell } => {
            tr!(
                "So {a} and {b} would both be at {cell} at time {time}.",
                a,
                b,
                cell,
                time
            )
        }
        MeetingKind::Swap { edge: [from, to] } => tr!(
            "So {a} and {b} would pass through each other between {from} and {to} in the step \
             from time {time}.",
            a,
            b,
            from,
            to,
            time
        ),
        MeetingKind::Target { cell } => {
            tr!(
                "So {b} would run into {a} at {cell} at time {time}.",
                b,
                a,
                cell,
                time
            )
        }
    }
}

/// Where no two of them have to meet.
fn without_place(limits: &[AgentLimit], told: &TogetherAnswer) -> &'static str {
    let refuted = told.alone.as_ref().and_then(|alone| alone.refuted);
    match (limits.len(), refuted) {
        (1, Some(false)) => {
            tr!("By itself it could. The other robots leave it no way that is as good.")
        }
        (_, Some(false)) => {
            tr!("By themselves these robots could. The other robots have a part in it, too.")
        }
        (1, _) => tr!("None of its ways goes together with the other robots."),
        _ => {
            tr!(
                "No single place shows it: each of these robots has several ways, but whichever they \
             take, two of them collide."
            )
        }
    }
}

/// The question that the proof of these robots alone answers.
pub(super) fn question(core: &Core) -> String {
    let limits = limits(core);
    let names: Vec<&str> = limits.iter().map(|limit| limit.agent.as_str()).collect();
    let asked: Vec<String> = limits.iter().map(|limit| keep(core.cost, limit)).collect();
    let is_same = asked.windows(2).all(|pair| pair[0] == pair[1]);
    let is_sum = !core.sums.is_empty();
    match asked.first() {
        Some(asked) if names.len() == 1 => {
            tr!("Why can {robot} not {asked}?", robot = names[0], asked)
        }
        Some(asked) if names.len() == 2 && is_same && !is_sum => {
            tr!(
                "Why can {robots} not both {asked}?",
                robots = and(&names),
                asked
            )
        }
        Some(asked) if is_same && !is_sum => tr!("Why can these not all {asked}?", asked),
        _ => tr!("Why is less not enough for these?").to_owned(),
    }
}
