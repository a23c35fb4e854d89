//! What a question contrasts a plan with, as clauses.

use super::Question;
use crate::{Cell, tr};

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
#[expect(
    clippy::too_many_lines,
    reason = "two clauses for each kind of question"
)]
pub fn contrast(question: &Question) -> Option<Contrast> {
    let both = |would: String, does: String| Some(Contrast { would, does });
    // Not doing: "did not" and "does not".
    let not = |agent: &str, what: String| {
        let what = what.trim_start();
        both(
            tr!("If ..." => "{agent} did not {what}", agent, what),
            tr!("a plan in which ..." => "{agent} does not {what}", agent, what),
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
                (Some(from), None) => tr!("something done" => " after time {from}", from),
                (from, Some(to)) => tr!(
                    "something done" => " between time {from} and {to}",
                    from = from.unwrap_or(0),
                    to
                ),
            };
            match at_least {
                Some(steps) if *steps > 1 => {
                    let what = tr!(
                        "a robot does not" => "wait {steps} steps in a row{place}{time}",
                        steps,
                        place,
                        time
                    );
                    not(agent, what)
                }
                _ => not(
                    agent,
                    tr!("a robot does not" => "wait{place}{time}", place, time),
                ),
            }
        }
        Question::Charge { agent, at, time } => not(
            agent,
            tr!(
                "a robot does not" => "charge{place}{moment}",
                place = place(*at),
                moment = moment(*time)
            ),
        ),
        Question::NoCharge { agent, at } => doing(
            agent,
            tr!("If a robot ..." => "charged at {at}", at),
            tr!("a plan in which a robot ..." => "charges at {at}", at),
        ),
        Question::Visit { agent, at, time } => match time {
            Some(time) => doing(
                agent,
                tr!("If a robot ..." => "were not at {at} at time {time}", at, time),
                tr!("a plan in which a robot ..." => "is not at {at} at time {time}", at, time),
            ),
            None => not(agent, tr!("a robot does not" => "pass {at}", at)),
        },
        Question::NoVisit { agent, at } => {
            let who = agent.as_deref().unwrap_or(tr!("somebody"));
            doing(
                who,
                tr!("If a robot ..." => "passed {at}", at),
                tr!("a plan in which a robot ..." => "passes {at}", at),
            )
        }
        Question::Move {
            agent,
            from_cell,
            to_cell,
            time,
        } => not(
            agent,
            tr!(
                "a robot does not" => "go from {from_cell} to {to_cell}{moment}",
                from_cell,
                to_cell,
                moment = moment(*time)
            ),
        ),
        Question::NoMove {
            agent,
            from_cell,
            to_cell,
            time,
        } => {
            let what = tr!(
                "something done" => "from {from_cell} to {to_cell}{moment}",
                from_cell,
                to_cell,
                moment = moment(*time)
            );
            doing(
                agent,
                tr!("If a robot ..." => "went {what}", what),
                tr!("a plan in which a robot ..." => "goes {what}", what),
            )
        }
        Question::Slow {
            agent,
            from_cell,
            to_cell,
        } => {
            let edge = from_cell.zip(*to_cell);
            let edge = edge.map_or_else(
                String::new,
                |(u, v)| tr!("something done" => " between {u} and {v}", u, v),
            );
            not(
                agent,
                tr!("a robot does not" => "take the slow way{edge}", edge),
            )
        }
        Question::Order {
            agent,
            first,
            second,
        } => doing(
            agent,
            tr!("If a robot ..." => "visited {second} before {first}", second, first),
            tr!("a plan in which a robot ..." => "visits {second} before {first}", second, first),
        ),
        Question::Yield { agent, to, at } => doing(
            agent,
            tr!("If a robot ..." => "were at {at} before {to}", at, to),
            tr!("a plan in which a robot ..." => "is at {at} before {to}", at, to),
        ),
        _ => None,
    }
}

fn place(at: Option<Cell>) -> String {
    at.map_or_else(String::new, |at| tr!("something done" => " at {at}", at))
}

fn moment(time: Option<u32>) -> String {
    time.map_or_else(
        String::new,
        |time| tr!("something done" => " at time {time}", time),
    )
}
