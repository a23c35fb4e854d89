//! Who costs whom in the plan of a step, by the solver's ledger.

use giveway_solve::delays::{DelayCause, DelaysAnswer, Fraction};
use giveway_solve::{Request, Response};

use super::predict::Truth;
use super::proved;
use super::{Situation, Why, ask};
use crate::lesson::Value;
use crate::port::Evidence;

/// The request for the ledger of the step's plan.
///
/// # Errors
/// Where the step has none.
pub(super) fn ask(situation: Situation<'_>) -> Result<Vec<Request>, Why> {
    let plan = situation.step.plan.as_ref().ok_or(Why::Untouched)?;
    Ok(vec![ask::delays(situation.scene, plan)])
}

fn ledger(responses: &[Response]) -> Result<&DelaysAnswer, Why> {
    match responses.first() {
        Some(Response::Delays(answer)) if answer.costs.is_some() && answer.reason.is_none() => {
            Ok(answer)
        }
        Some(Response::Delays(answer)) => Err(Why::Unknown(answer.reason.clone())),
        other => Err(proved::unexpected(other)),
    }
}

/// How many steps a robot loses, in all or because of another one.
pub(super) fn delay(robot: &str, because: Option<&str>, responses: &[Response]) -> Truth {
    let mut rows = ledger(responses)?.agents.iter();
    let row = rows.find(|row| row.agent == robot).ok_or(Why::Unclear)?;
    let steps = match because {
        None => row.delay,
        Some(other) => {
            let is_it =
                |cause: &DelayCause| matches!(cause, DelayCause::Agent { agent } if agent == other);
            let mut shares = row.because.iter();
            match shares.find(|share| is_it(&share.cause)) {
                None => 0,
                Some(share) => whole(share.steps).ok_or(Why::Unclear)?,
            }
        }
    };
    Ok((Value::Number(steps), Evidence::default()))
}

/// The robot that loses most.
pub(super) fn loses_most(responses: &[Response]) -> Truth {
    let rows = ledger(responses)?.agents.iter();
    most(rows.map(|row| (row.agent.as_str(), Fraction::whole(row.delay))))
}

/// The robot that costs the others most.
pub(super) fn costs_most(responses: &[Response]) -> Truth {
    let ledger = ledger(responses)?;
    let mut robots = Vec::new();
    for total in &ledger.because {
        if let DelayCause::Agent { agent } = &total.cause {
            robots.push((agent.as_str(), total.steps.ok_or(Why::Unclear)?));
        }
    }
    most(robots)
}

/// The only robot with the most steps.
fn most<'a>(robots: impl IntoIterator<Item = (&'a str, Fraction)>) -> Truth {
    let mut robots: Vec<(&str, Fraction)> = robots.into_iter().collect();
    robots.sort_by_key(|(_, steps)| std::cmp::Reverse(*steps));
    let second = robots
        .get(1)
        .map_or(Fraction::whole(0), |(_, steps)| *steps);
    match robots.first() {
        Some((robot, steps)) if *steps > second => {
            Ok((Value::Robot((*robot).to_owned()), Evidence::default()))
        }
        _ => Err(Why::Unclear),
    }
}

/// A fraction that is a whole number of steps.
fn whole(steps: Fraction) -> Option<u32> {
    let is_whole = steps.denominator == 1;
    is_whole.then(|| u32::try_from(steps.numerator).ok())?
}
