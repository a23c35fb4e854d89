//! What a question contrasts the plan with, as clauses.

use giveway_model::{Cell, Cost, Instance, Plan, Question, check::costs};

use super::costs::name;
use crate::explain::own_plan::own_costs;

/// A contrast as a clause, in the two moods that sentences need.
pub(crate) struct Contrast {
    /// After "if": `A2 did not wait at (3, 1)`.
    pub(crate) would: String,
    /// After "a plan in which": `A2 does not wait at (3, 1)`.
    pub(crate) does: String,
}

/// The contrast of a question about a plan; `None` where it has none.
pub(crate) fn contrast(question: &Question, instance: &Instance, plan: &Plan) -> Option<Contrast> {
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
                    let what = format!("wait {steps} steps on end{place}{time}");
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
        question => of_cost(question, instance, plan),
    }
}

/// The contrast of a question about a number.
fn of_cost(question: &Question, instance: &Instance, plan: &Plan) -> Option<Contrast> {
    let whole = |cost: Cost| {
        let below = costs(instance, plan)?.get(cost);
        let name = name(cost);
        Some(Contrast {
            would: format!("the {name} were below {below}"),
            does: format!("the {name} is below {below}"),
        })
    };
    let fewer = |agent: &str, below: u32, things: &str| {
        Some(Contrast {
            would: format!("{agent} made fewer than {below} {things}"),
            does: format!("{agent} makes fewer than {below} {things}"),
        })
    };
    let own = |agent: &str, cost: Cost| Some(own_costs(instance, agent, plan)?.get(cost));
    match question {
        Question::Arrival { agent } => {
            let time = own(agent, Cost::Makespan)?;
            Some(Contrast {
                would: format!("{agent} arrived before time {time}"),
                does: format!("{agent} arrives before time {time}"),
            })
        }
        Question::Length {
            agent,
            fewer_than: Some(most),
        } => fewer(agent, *most, "moves"),
        Question::Length { agent, .. } | Question::Moves { agent: Some(agent) } => {
            fewer(agent, own(agent, Cost::Moves)?, "moves")
        }
        Question::Charges { agent: Some(agent) } => {
            fewer(agent, own(agent, Cost::Charges)?, "charges")
        }
        Question::Waits { agent: Some(agent) } => fewer(agent, own(agent, Cost::Waits)?, "waits"),
        Question::Makespan => whole(Cost::Makespan),
        Question::SumOfCosts => whole(Cost::SumOfCosts),
        Question::Charges { agent: None } => whole(Cost::Charges),
        Question::Moves { agent: None } => whole(Cost::Moves),
        Question::Waits { agent: None } => whole(Cost::Waits),
        _ => None,
    }
}

fn place(at: Option<Cell>) -> String {
    at.map_or_else(String::new, |at| format!(" at {at}"))
}

fn moment(time: Option<u32>) -> String {
    time.map_or_else(String::new, |time| format!(" at time {time}"))
}
