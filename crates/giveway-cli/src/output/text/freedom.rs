//! The answer of `freedom` as text.

use std::fmt::Write as _;

use giveway_model::Instance;
use giveway_model::words::count;
use giveway_solve::freedom::{CriticalCell, Farthest, FreedomAnswer, same_steps, words};
use giveway_solve::words::reach;

use super::{bold, drawings, solve::work, status_word, title};
use crate::output::{plain, table};

/// So many cells are told one by one; the rest is counted.
const TOLD: usize = 20;

/// What is known of the plan, the plan, and each part that was asked for.
pub(crate) fn freedom(instance: &Instance, answer: &FreedomAnswer, columns: usize) -> String {
    let mut parts = vec![title(instance), known(answer)];
    parts.push(drawings(instance, answer.plan.as_ref(), columns));
    parts.push(steps(instance, answer));
    parts.push(ways(instance, answer));
    parts.push(slack(instance, answer));
    parts.push(cells(answer));
    parts.push(farthest(instance, answer, columns));
    if let Some(reason) = answer.reason.as_ref().filter(|_| !answer.is_settled()) {
        let reason = plain::text(&giveway_solve::words::reason(reason));
        parts.push(format!("{reason} What is not said above is open.\n"));
    }
    parts.push(work(&answer.stats));
    parts.retain(|part| !part.is_empty());
    parts.join("\n")
}

fn known(answer: &FreedomAnswer) -> String {
    let head = words::headline(answer);
    let word = status_word(answer.status, &plain::text(&head.word));
    let mut text = format!("{word}{}\n", plain::text(&head.rest));
    if let Some(about) = words::about(answer) {
        let _ = writeln!(text, "{about}");
    }
    if answer.plan.is_some()
        && let Some(reach) = reach(answer.reach)
    {
        let _ = writeln!(text, "{reach}");
    }
    text
}

/// How many steps of each robot are the same in every best plan.
fn steps(instance: &Instance, answer: &FreedomAnswer) -> String {
    let (Some(backbone), Some(sentence)) = (&answer.backbone, words::backbone(answer)) else {
        return String::new();
    };
    let mut text = format!("{}: {sentence}\n", bold("Backbone"));
    for agent in instance.agents() {
        let Some(visits) = backbone.get(&agent.name) else {
            continue;
        };
        let (same, all) = same_steps(visits);
        let name = plain::pad_right(&plain::text(&agent.name), 8);
        let free = visits.windows(2).filter(|pair| {
            let mut both = pair.iter();
            !both.all(|visit| visit.always.is_proved())
        });
        let free: Vec<String> = free
            .filter_map(|pair| pair.first().map(|visit| visit.time.to_string()))
            .collect();
        let _ = write!(text, "  {name}{same} of {}", count(all as u32, "step"));
        if free.is_empty() {
            text.push('\n');
        } else {
            let _ = writeln!(text, "; free in the steps from time {}", free.join(", "));
        }
    }
    text
}

fn ways(instance: &Instance, answer: &FreedomAnswer) -> String {
    let Some(plans) = &answer.plans else {
        return String::new();
    };
    let sentence = words::plans_found(plans.number);
    let mut text = format!("{}: {sentence}\n", bold("Best plans"));
    for agent in instance.agents() {
        if let Some(ways) = plans.ways.get(&agent.name) {
            let name = plain::pad_right(&plain::text(&agent.name), 8);
            let _ = writeln!(text, "  {name}{}", words::ways(ways.number));
        }
    }
    if let Some(product) = words::product(answer) {
        let _ = writeln!(text, "  {product}");
    }
    text
}

fn slack(instance: &Instance, answer: &FreedomAnswer) -> String {
    let Some(slacks) = &answer.slack else {
        return String::new();
    };
    let mut text = format!("{}:\n", bold("Slack"));
    for agent in instance.agents() {
        if let Some(slack) = slacks.get(&agent.name) {
            let name = plain::text(&agent.name);
            let late = words::late(&name, slack);
            let _ = writeln!(text, "  {late}; it {}", words::later(slack));
        }
    }
    text
}

/// The cells that cost something to close, the dearest first as the answer has them.
fn cells(answer: &FreedomAnswer) -> String {
    let Some(cells) = &answer.critical else {
        return String::new();
    };
    let objective = &answer.objective;
    let marked = |it: &&CriticalCell| words::mark(it, objective).is_some();
    let critical: Vec<&CriticalCell> = cells.iter().filter(marked).collect();
    let open = cells.iter().filter(|it| it.closed.is_open()).count();
    let mut text = format!("{}: ", bold("Critical cells"));
    let _ = match critical.len() {
        0 if open == 0 => writeln!(
            text,
            "Any one cell that is no start, goal or waypoint can be closed without loss."
        ),
        0 => writeln!(text, "{} open.", count(open as u32, "cell")),
        n => writeln!(
            text,
            "{} cannot be closed without loss.",
            count(n as u32, "cell")
        ),
    };
    for it in critical.iter().take(TOLD) {
        let _ = writeln!(text, "  {}", words::closed(it, objective));
    }
    if critical.len() > TOLD {
        let more = critical.len() - TOLD;
        let _ = writeln!(text, "  and {more} more; --format json shows them all");
    }
    text
}

fn farthest(instance: &Instance, answer: &FreedomAnswer, columns: usize) -> String {
    let Some(farthest) = &answer.farthest else {
        return String::new();
    };
    let sentence = words::farthest(farthest);
    let mut text = format!("{}: {sentence}\n", bold("The most different best plan"));
    if let (Farthest::Found { plan: other, .. }, Some(plan)) = (farthest, &answer.plan) {
        text += &table::beside(instance, plan, other, columns);
    }
    text
}
