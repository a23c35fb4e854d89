//! What the judge of a task says, in words: first the verdict, then what was done.

mod made;
mod numbers;
mod spans;

use giveway_model::tr;
use giveway_model::words::{and, name, sentence, value};
use giveway_solve::words::reason;

use super::{Kind, Outside, Verdict, Why};
use crate::lesson::{Step, Task, Text, Value};
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
pub fn head(kind: Kind) -> &'static str {
    match kind {
        Kind::NotYet => tr!("a verdict" => "Not yet"),
        Kind::Solved => tr!("a verdict" => "Solved"),
        Kind::NotLikeThis => tr!("a verdict" => "Not like this"),
    }
}

/// A verdict on a task of a step.
pub fn said(verdict: &Verdict, step: &Step) -> Said {
    let text = match (reply(verdict, step), &verdict.why) {
        // The reply of the lesson need not say that the guess is wrong.
        (Some(reply), Why::Guessed { truth, .. }) if !verdict.is_solved() => {
            let wrong = tr!("Not this: it is {value}.", value = shown(truth));
            text(format!("{wrong} {reply}").trim_end())
        }
        (Some(reply), _) => reply,
        (None, _) => text(&why(verdict)),
    };
    Said {
        head: head(verdict.kind),
        text,
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
fn why(verdict: &Verdict) -> String {
    let solved = verdict.is_solved();
    match &verdict.why {
        Why::Untouched => tr!("nothing has changed.").to_owned(),
        Why::Unknown(None) => tr!("the solver ran out of time. There may be an answer.").to_owned(),
        Why::Unknown(Some(given)) => plain(&sentence(&reason(given))),
        Why::SolverFailed(said) | Why::Refused(said) => plain(&sentence(said)),
        Why::Outside(outside) => self::outside(outside),
        Why::TooManyEdits { made, allowed } => tr!(
            "{n} edit, and this asks for at most {allowed}. Take one back."
                | "{n} edits, and this asks for at most {allowed}. Take one back." % *made,
            allowed
        ),
        Why::AloneStuck(name) => {
            tr!("{robot} alone cannot arrive any more.", robot = robot(name))
        }
        Why::Plan(costs) if solved => tr!("there is a plan, makespan {n}.", n = costs.makespan),
        Why::Plan(costs) => tr!("there is still a plan, makespan {n}.", n = costs.makespan),
        Why::NoPlan if solved => {
            tr!("no plan exists, no matter how many steps you allow.").to_owned()
        }
        Why::NoPlan => tr!("no plan is left, no matter how many steps you allow.").to_owned(),
        Why::Cost {
            cost,
            value,
            compare,
            wanted,
        } => numbers::cost(*cost, *value, *compare, *wanted, solved),
        Why::Raised {
            cost,
            before,
            now,
            by,
        } => numbers::raised(*cost, *before, *now, *by, solved),
        Why::Price {
            rule,
            cost,
            with,
            without,
        } => numbers::price(*rule, *cost, *with, *without),
        Why::Answered { verdict, wanted } => numbers::answered(*verdict, *wanted, solved),
        Why::Points { count, costs } => {
            let [one, other] = costs.map(name);
            tr!(
                "one plan is best in both, {one} and {other}."
                    | "no plan is best in both, {one} and {other}: {n} plans are worth a choice."
                        % *count,
                one,
                other
            )
        }
        other => of_plan(other, solved),
    }
}

/// What is said of a plan; the rest is of answers.
fn of_plan(why: &Why, solved: bool) -> String {
    match why {
        Why::Broken(violation) => plain(&sentence(&violation.message)),
        Why::Legal => tr!("this plan breaks no rule.").to_owned(),
        Why::Keeps { rule } => tr!(
            "this plan keeps {rule}.",
            rule = Value::Rule { rule: *rule }
        ),
        Why::Best { cost, value: n } => {
            tr!("{cost}, and no plan is better.", cost = value(*cost, *n))
        }
        Why::NotBest {
            cost,
            value: n,
            best,
        } => tr!(
            "your plan is legal, with {cost}. The best has {best}.",
            cost = value(*cost, *n),
            best
        ),
        Why::NotHome(name) => tr!("{robot} is not at its flag.", robot = robot(name)),
        Why::NotVisited(name, Some(at)) => tr!(
            "{robot} has not been at {cell}.",
            robot = robot(name),
            cell = cell(*at)
        ),
        Why::NotVisited(name, None) => tr!("{robot} has missed a waypoint.", robot = robot(name)),
        Why::Costs {
            cost,
            value: n,
            at_most,
        } => tr!(
            "{cost}; at most {most} is asked for.",
            cost = value(*cost, *n),
            most = at_most
        ),
        Why::LedAnother(name) => tr!(
            "{robot} must go as planned. Take that back.",
            robot = robot(name)
        ),
        other => of_answer(other, solved),
    }
}

/// What is said of an answer that was given.
fn of_answer(why: &Why, solved: bool) -> String {
    match why {
        Why::Guessed { guess, truth, .. } => guessed(guess, truth, solved),
        Why::Revealed(truth) => tr!("{value} is proved.", value = shown(truth)),
        Why::Untold => tr!("this is not it. Look again.").to_owned(),
        Why::Differs => tr!("best plans differ in this.").to_owned(),
        Why::Unclear => tr!("this has no one answer here.").to_owned(),
        Why::Found { found, of } if solved => {
            tr!("{found} of {all} conflicts found.", found, all = of)
        }
        Why::Found { found, .. } => {
            tr!("{n} conflict found. There are more."
                | "{n} conflicts found. There are more." % *found)
        }
        Why::NoConflict(mark) if mark.robots.is_empty() => {
            tr!(
                "no rule is broken at time {time} by nobody.",
                time = mark.time
            )
        }
        Why::NoConflict(mark) => tr!(
            "no rule is broken at time {time} by {robots}.",
            time = mark.time,
            robots = all(&mark.robots)
        ),
        Why::Disputed => tr!("the solver does not agree with this lesson here.").to_owned(),
        Why::OrderStuck {
            robot: name,
            around,
        } if around.is_empty() => tr!("{robot} finds no way.", robot = robot(name)),
        Why::OrderStuck {
            robot: name,
            around,
        } => tr!(
            "{robot} finds no way around {others}.",
            robot = robot(name),
            others = all(around)
        ),
        Why::OrderWorks {
            cost,
            value: n,
            best,
        } => numbers::order_works(*cost, *n, *best),
        Why::NoOrderWorks { orders } => tr!(
            "none of the {orders} orders works, and yet there is a plan.",
            orders
        ),
        Why::SomeOrderWorks(order) => tr!("the order {robots} works.", robots = all(order)),
        Why::Went {
            method,
            cost,
            kept,
            wanted,
        } => numbers::went(*method, *cost, *kept, *wanted),
        Why::NoWayOn(method) => tr!(
            "{method} has no plan here.",
            method = numbers::method_name(*method)
        ),
        _ => String::new(),
    }
}

/// Robots by their names.
fn all(names: &[String]) -> String {
    plain(&and(names))
}

fn outside(outside: &Outside) -> String {
    let what = match outside {
        Outside::Cell(at) => cell(*at),
        Outside::Robot(name) => robot(name),
        Outside::Rules => {
            return tr!("map size, rules and costs must stay as they are.").to_owned();
        }
    };
    tr!("{what} must stay as it is. Take that back.", what)
}

fn guessed(guess: &Value, truth: &Value, solved: bool) -> String {
    if solved {
        tr!("{value} is proved.", value = shown(truth))
    } else {
        tr!(
            "you said {guess}; proved is {truth}.",
            guess = shown(guess),
            truth = shown(truth)
        )
    }
}
