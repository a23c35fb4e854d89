//! What a question contrasts a plan with, as clauses.

use super::Question;
use crate::Cell;

/// A contrast as a clause, in the two moods that sentences need.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Contrast {
    /// After "if": `A2 did not wait at (3, 1)`.
    pub would: String,
    /// After "a plan in which": `A2 does not wait at (3, 1)`.
    pub does: String,
}

/// The contrast of a question about what an agent does or does not do; `None`
/// where it is about a number, the instance or the plan as a whole.
///
/// ```
/// use giveway_model::{Cell, Question, question::contrast};
/// let why = Question::NoCharge { agent: "A1".into(), at: Cell::new(3, 1) };
/// let contrast = contrast(&why).unwrap();
/// assert_eq!(contrast.would, "A1 charged at (3, 1)");
/// assert_eq!(contrast.does, "A1 charges at (3, 1)");
/// ```
pub fn contrast(question: &Question) -> Option<Contrast> {
    let both = |would: String, does: String| Some(Contrast { would, does });
    // Not doing: "did not" and "does not".
    let not = |agent: &str, what: String| {
        both(
            format!("{agent} did not {what}"),
            format!("{agent} does not {what}"),
        )
    };
    let doing = |agent: &str, did: String, does: String| {
        both(format!("{agent} {did}"), format!("{agent} {does}"))
    };
    match question {
        Question::Wait {
            agent,
            at,
            from,
            to,
            at_least,
        } => {
            let place = place(*at);
            let time = match (from, to) {
                (None | Some(0), None) => String::new(),
                (Some(from), None) => format!(" after time {from}"),
                (from, Some(to)) => format!(" between time {} and {to}", from.unwrap_or(0)),
            };
            match at_least {
                Some(steps) if *steps > 1 => {
                    let what = format!("wait {steps} steps in a row{place}{time}");
                    not(agent, what)
                }
                _ => not(agent, format!("wait{place}{time}")),
            }
        }
        Question::Charge { agent, at, time } => {
            not(agent, format!("charge{}{}", place(*at), moment(*time)))
        }
        Question::NoCharge { agent, at } => doing(
            agent,
            format!("charged at {at}"),
            format!("charges at {at}"),
        ),
        Question::Visit { agent, at, time } => match time {
            Some(time) => doing(
                agent,
                format!("were not at {at} at time {time}"),
                format!("is not at {at} at time {time}"),
            ),
            None => not(agent, format!("pass {at}")),
        },
        Question::NoVisit { agent, at } => {
            let who = agent.as_deref().unwrap_or("somebody");
            doing(who, format!("passed {at}"), format!("passes {at}"))
        }
        Question::Move {
            agent,
            from_cell,
            to_cell,
            time,
        } => not(
            agent,
            format!("go from {from_cell} to {to_cell}{}", moment(*time)),
        ),
        Question::NoMove {
            agent,
            from_cell,
            to_cell,
            time,
        } => {
            let what = format!("from {from_cell} to {to_cell}{}", moment(*time));
            doing(agent, format!("went {what}"), format!("goes {what}"))
        }
        Question::Slow {
            agent,
            from_cell,
            to_cell,
        } => {
            let edge = from_cell.zip(*to_cell);
            let edge = edge.map_or_else(String::new, |(u, v)| format!(" between {u} and {v}"));
            not(agent, format!("take the slow way{edge}"))
        }
        Question::Order {
            agent,
            first,
            second,
        } => doing(
            agent,
            format!("visited {second} before {first}"),
            format!("visits {second} before {first}"),
        ),
        Question::Yield { agent, to, at } => doing(
            agent,
            format!("were at {at} before {to}"),
            format!("is at {at} before {to}"),
        ),
        _ => None,
    }
}

fn place(at: Option<Cell>) -> String {
    at.map_or_else(String::new, |at| format!(" at {at}"))
}

fn moment(time: Option<u32>) -> String {
    time.map_or_else(String::new, |time| format!(" at time {time}"))
}
