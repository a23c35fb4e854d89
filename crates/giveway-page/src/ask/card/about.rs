//! What a question is about, in the plan that is shown: who waits, where, and when.

use giveway_model::{Question, tr};

use crate::timeline::Lane;
use crate::{Asking, words};

/// `A1 waits at (2, 6) from time 37 to 46.`; nothing where the question is about no wait.
pub(super) fn about(asking: &Asking) -> Option<String> {
    let about = &asking.about;
    let of = |name: &str| {
        let agent = about.agents().iter().position(|agent| agent.name == name)?;
        Lane::of(about, agent)
    };
    let (lane, at_most) = match asking.question() {
        Question::Wait { agent, to, .. } => (of(agent)?, *to),
        Question::Yield { agent, at, .. } => {
            let lane = of(agent)?;
            let comes = lane.steps.iter().find(|step| step.to == *at)?.ends;
            (lane, Some(comes))
        }
        Question::Charge { .. }
        | Question::NoCharge { .. }
        | Question::Order { .. }
        | Question::Slow { .. }
        | Question::Visit { .. }
        | Question::NoVisit { .. }
        | Question::Move { .. }
        | Question::NoMove { .. }
        | Question::Arrival { .. }
        | Question::Length { .. }
        | Question::Makespan
        | Question::SumOfCosts
        | Question::Penalty
        | Question::Charges { .. }
        | Question::Moves { .. }
        | Question::Waits { .. }
        | Question::Rule { .. }
        | Question::Unsolvable
        | Question::Plan => return None,
    };
    // The last wait up to then.
    let mut waits = lane.steps.iter().filter(|step| step.way.stays());
    let last = waits.rfind(|step| at_most.is_none_or(|end| step.ends <= end))?;
    let from = lane
        .steps
        .iter()
        .rev()
        .skip_while(|step| step.begins > last.begins);
    let from = from
        .take_while(|step| step.way.stays() && step.from == last.from)
        .last()?
        .begins;
    Some(tr!(
        "{name} waits at {cell} from time {from} to {to}.",
        name = lane.name,
        cell = words::at(last.from),
        from,
        to = last.ends
    ))
}
