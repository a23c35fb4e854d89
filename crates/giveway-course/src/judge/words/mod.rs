//! What the judge of a task says, in words: first the verdict, then what was done.

mod made;
mod numbers;
mod spans;

use giveway_model::words::{and, count, name, sentence, value};

use super::{Kind, Outside, Verdict, Why};
use crate::lesson::{Span, Step, Task, Text, Value};
use spans::{cell, plain, robot, shown, text};

pub use made::made;

/// A verdict in words.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Said {
    /// The words that it begins with, to be made bold: `Not yet`.
    pub head: &'static str,
    /// What follows, a sentence or two; robots and cells in it are links.
    pub text: Text,
}

/// The first words of a verdict.
pub const fn head(kind: Kind) -> &'static str {
    match kind {
        Kind::NotYet => "Not yet",
        Kind::Solved => "Solved",
        Kind::NotLikeThis => "Not like this",
    }
}

/// A verdict on a task of a step.
pub fn said(verdict: &Verdict, step: &Step) -> Said {
    Said {
        head: head(verdict.kind),
        text: reply(verdict, step).unwrap_or_else(|| Text::of(why(verdict))),
    }
}

/// The lesson's own words to an answer that was picked.
fn reply(verdict: &Verdict, step: &Step) -> Option<Text> {
    match (&verdict.why, step.task.as_ref()?) {
        (Why::Reply(answer), Task::Choose(task)) => {
            task.answers.get(*answer).map(|choice| choice.reply.clone())
        }
        (
            Why::Guessed {
                answer: Some(answer),
                ..
            },
            Task::Predict(task),
        ) => task.answers.get(*answer).map(|guess| guess.reply.clone()),
        _ => None,
    }
}

/// What is said of a scene; the rest is of plans and answers.
fn why(verdict: &Verdict) -> Vec<Span> {
    let solved = verdict.is_solved();
    match &verdict.why {
        Why::Untouched => plain("nothing has changed."),
        Why::Unknown(None) => plain("the solver ran out of time. There may be an answer."),
        Why::Unknown(Some(reason)) | Why::Refused(reason) => plain(sentence(reason)),
        Why::Outside(outside) => self::outside(outside),
        Why::TooManyEdits { made, allowed } => {
            let edits = count(*made, "edit");
            plain(format!(
                "{edits}, and this asks for at most {allowed}. Take one back."
            ))
        }
        Why::AloneStuck(robot_name) => {
            vec![robot(robot_name), text(" alone cannot arrive any more.")]
        }
        Why::Plan(costs) if solved => {
            plain(format!("there is a plan, makespan {}.", costs.makespan))
        }
        Why::Plan(costs) => plain(format!(
            "there is still a plan, makespan {}.",
            costs.makespan
        )),
        Why::NoPlan if solved => plain("no plan exists, no matter how many steps you allow."),
        Why::NoPlan => plain("no plan is left, no matter how many steps you allow."),
        Why::Cost {
            cost,
            value,
            compare,
            wanted,
        } => plain(numbers::cost(*cost, *value, *compare, *wanted, solved)),
        Why::Raised {
            cost,
            before,
            now,
            by,
        } => plain(numbers::raised(*cost, *before, *now, *by, solved)),
        Why::Answered { verdict, wanted } => plain(numbers::answered(*verdict, *wanted, solved)),
        Why::Points { count: 1, costs } => {
            let [one, other] = costs.map(name);
            plain(format!("one plan is best in both, {one} and {other}."))
        }
        Why::Points { count, costs } => {
            let [one, other] = costs.map(name);
            plain(format!(
                "no plan is best in both, {one} and {other}: {count} plans are worth a choice."
            ))
        }
        other => of_plan(other, solved),
    }
}

/// What is said of a plan; the rest is of answers.
fn of_plan(why: &Why, solved: bool) -> Vec<Span> {
    match why {
        Why::Broken(violation) => plain(sentence(&violation.message)),
        Why::Legal => plain("this plan breaks no rule."),
        Why::Best { cost, value: n } => {
            plain(format!("{}, and no plan is better.", value(*cost, *n)))
        }
        Why::NotBest {
            cost,
            value: n,
            best,
        } => plain(format!(
            "your plan is legal, with {}. The best has {best}.",
            value(*cost, *n)
        )),
        Why::NotHome(name) => vec![robot(name), text(" is not at its flag.")],
        Why::NotVisited(name, Some(at)) => {
            vec![robot(name), text(" has not been at "), cell(*at), text(".")]
        }
        Why::NotVisited(name, None) => vec![robot(name), text(" has missed a waypoint.")],
        Why::Costs {
            cost,
            value: n,
            at_most,
        } => plain(format!(
            "{}; at most {at_most} is asked for.",
            value(*cost, *n)
        )),
        Why::LedAnother(name) => {
            vec![robot(name), text(" must go as planned. Take that back.")]
        }
        other => of_answer(other, solved),
    }
}

/// What is said of an answer that was given.
fn of_answer(why: &Why, solved: bool) -> Vec<Span> {
    match why {
        Why::Guessed { guess, truth, .. } => guessed(guess, truth, solved),
        Why::Revealed(truth) => vec![shown(truth), text(" is proved.")],
        Why::Untold => plain("this is not it. Look again."),
        Why::Differs => plain("best plans differ in this."),
        Why::Found { found, of } if solved => plain(format!("{found} of {of} conflicts found.")),
        Why::Found { found, .. } => plain(format!(
            "{} found. There are more.",
            count(*found as u32, "conflict")
        )),
        Why::NoConflict(mark) => {
            let who = and(&mark.robots);
            let who = if who.is_empty() { "nobody" } else { &who };
            plain(format!("no rule is broken at time {} by {who}.", mark.time))
        }
        Why::Disputed => plain("the solver does not agree with this lesson here."),
        Why::OrderStuck {
            robot: name,
            around,
        } => {
            let mut spans = vec![robot(name), text(" finds no way")];
            if !around.is_empty() {
                spans.push(text(&format!(" around {}", and(around))));
            }
            spans.push(text("."));
            spans
        }
        Why::OrderWorks {
            cost,
            value: n,
            best,
        } => plain(numbers::order_works(*cost, *n, *best)),
        Why::NoOrderWorks { orders } => plain(format!(
            "none of the {orders} orders works, and yet there is a plan."
        )),
        Why::SomeOrderWorks(order) => plain(format!("the order {} works.", and(order))),
        Why::Went {
            method,
            cost,
            kept,
            wanted,
        } => plain(numbers::went(*method, *cost, *kept, *wanted)),
        Why::NoWayOn(method) => plain(format!(
            "{} has no plan here.",
            numbers::method_name(*method)
        )),
        _ => Vec::new(),
    }
}

fn outside(outside: &Outside) -> Vec<Span> {
    match outside {
        Outside::Cell(at) => vec![cell(*at), text(" must stay as it is. Take that back.")],
        Outside::Robot(name) => vec![robot(name), text(" must stay as it is. Take that back.")],
        Outside::Rules => plain("map size, rules and costs must stay as they are."),
    }
}

fn guessed(guess: &Value, truth: &Value, solved: bool) -> Vec<Span> {
    if solved {
        vec![shown(truth), text(" is proved.")]
    } else {
        vec![
            text("you said "),
            shown(guess),
            text("; proved is "),
            shown(truth),
            text("."),
        ]
    }
}
