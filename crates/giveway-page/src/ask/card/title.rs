//! The title of an answer: what could be instead, and what it would cost.

use giveway_model::{Cost, Question, tr};
use giveway_solve::explain::{AgentDifference, ExplainAnswer, How, Part, Verdict, other_charges};

use super::tight::{forcing, forcing_title};
use super::verdict::is_of_a_whole;
use crate::{Asking, words};

/// The verdict in words; nothing where its one word is all that is known.
pub(super) fn title(asking: &Asking, told: &ExplainAnswer) -> Option<String> {
    if is_of_a_whole(told) {
        return None;
    }
    match told.verdict {
        Verdict::Needless => charges_instead(asking).or_else(|| needless(told)),
        Verdict::Costly if told.at_most => at_most(asking, told),
        Verdict::Costly => {
            let (cost, n) = first_difference(asking, told, |delta| delta > 0)?;
            Some(match cost {
                Cost::Charges => tr!("It would cost {n} charge" | "It would cost {n} charges" % n),
                Cost::Moves => tr!("It would cost {n} move" | "It would cost {n} moves" % n),
                Cost::Penalty => tr!("It would cost a penalty of {n}", n),
                Cost::Waits => tr!("It would cost {n} wait" | "It would cost {n} waits" % n),
                Cost::Makespan => {
                    tr!("{n} step more until all are done"
                        | "{n} steps more until all are done" % n)
                }
                Cost::SumOfCosts => tr!("{n} step more in all" | "{n} steps more in all" % n),
            })
        }
        Verdict::Improvable => {
            let (cost, n) = first_difference(asking, told, |delta| delta < 0)?;
            Some(match cost {
                Cost::Charges => tr!("It would save {n} charge" | "It would save {n} charges" % n),
                Cost::Moves => tr!("It would save {n} move" | "It would save {n} moves" % n),
                Cost::Penalty => tr!("It would save a penalty of {n}", n),
                Cost::Waits => tr!("It would save {n} wait" | "It would save {n} waits" % n),
                Cost::Makespan => {
                    tr!("All can be done {n} step sooner" | "All can be done {n} steps sooner" % n)
                }
                Cost::SumOfCosts => tr!("{n} step less in all" | "{n} steps less in all" % n),
            })
        }
        Verdict::Necessary if matches!(told.question, Question::Rule { .. }) => {
            Some(tr!("It cannot be so").to_owned())
        }
        Verdict::Necessary => forcing(asking, told).map(forcing_title),
        // The other plan is the best one that was found: another may cost less.
        Verdict::Unknown => at_most(asking, told),
    }
}

/// What the best other plan that was found costs, with the name of the cost.
fn at_most(asking: &Asking, told: &ExplainAnswer) -> Option<String> {
    asking.other.as_ref()?;
    if told.deltas.values().all(|&delta| delta == 0) {
        return Some(tr!("It costs no more").to_owned());
    }
    if let Some((cost, n)) = first_difference(asking, told, |delta| delta < 0) {
        let cost = words::name(cost);
        return Some(tr!("A better plan: {cost} {n} less", cost, n));
    }
    let (cost, n) = first_difference(asking, told, |delta| delta > 0)?;
    Some(match cost {
        Cost::Charges => tr!("At most {n} charge more" | "At most {n} charges more" % n),
        Cost::Moves => tr!("At most {n} move more" | "At most {n} moves more" % n),
        Cost::Penalty => tr!("At most a penalty of {n} more", n),
        Cost::Waits => tr!("At most {n} wait more" | "At most {n} waits more" % n),
        Cost::Makespan => {
            tr!("At most {n} step more until all are done"
                | "At most {n} steps more until all are done" % n)
        }
        Cost::SumOfCosts => {
            tr!("At most {n} step more in all" | "At most {n} steps more in all" % n)
        }
    })
}

/// Where a robot charges instead in the other plan, where it was asked why it charges.
fn charges_instead(asking: &Asking) -> Option<String> {
    let Question::Charge { agent, .. } = asking.question() else {
        return None;
    };
    let other = asking.other.as_ref()?.plan()?;
    let charges = other_charges(agent, asking.about.plan()?, other)?;
    Some(tr!("It could charge {charges} instead", charges))
}

/// How the other plan of the same costs does without it; not before the closest one is known, which
/// may do it in another way.
fn needless(told: &ExplainAnswer) -> Option<String> {
    if told.pending.contains(&Part::Closest) {
        return None;
    }
    let asked = told.question.agent();
    let is_wait = matches!(
        told.question,
        Question::Wait { .. } | Question::Yield { .. }
    );
    Some(match told.how.first()? {
        How::Others => {
            let others = told.pays.iter();
            let mut others = others.filter(|it| Some(it.agent.as_str()) != asked);
            let pays =
                |it: &&AgentDifference| it.other > it.arrival || it.more_waits > 0 || it.other_way;
            let other = others.find(pays)?;
            let name = &other.agent;
            if other.more_waits > 0 {
                tr!("{name} could wait instead", name)
            } else if other.other_way {
                tr!("{name} could go another way instead", name)
            } else {
                tr!("{name} could arrive later instead", name)
            }
        }
        How::OtherWay | How::Elsewhere | How::Free
            if asked.is_some()
                && let Some(title) = so(&told.question) =>
        {
            title.to_owned()
        }
        How::OtherWay if is_wait && told.how.contains(&How::Elsewhere) => {
            tr!("It could go another way and wait there").to_owned()
        }
        How::OtherWay => tr!("It could drive around instead").to_owned(),
        How::Elsewhere if is_wait => tr!("It could wait elsewhere").to_owned(),
        How::Elsewhere => tr!("It could wait instead").to_owned(),
        How::Free if is_wait => tr!("It need not wait at all").to_owned(),
        How::Free => tr!("It was for nothing").to_owned(),
    })
}

/// What a robot could do or be as a question asks, where that says more than that something could
/// go: `It could arrive sooner`.
fn so(question: &Question) -> Option<&'static str> {
    match question {
        Question::NoCharge { .. } | Question::NoVisit { .. } | Question::NoMove { .. } => {
            Some(tr!("It could do so"))
        }
        Question::Arrival { .. } => Some(tr!("It could arrive sooner")),
        Question::Length { .. } => Some(tr!("Its path could be shorter")),
        Question::Moves { agent: Some(_) } => Some(tr!("It could make fewer moves")),
        Question::Charges { agent: Some(_) } => Some(tr!("It could charge fewer times")),
        Question::Waits { agent: Some(_) } => Some(tr!("It could wait less")),
        Question::Wait { .. }
        | Question::Yield { .. }
        | Question::Charge { .. }
        | Question::Visit { .. }
        | Question::Move { .. }
        | Question::Slow { .. }
        | Question::Order { .. }
        | Question::Moves { agent: None }
        | Question::Charges { agent: None }
        | Question::Waits { agent: None }
        | Question::Makespan
        | Question::SumOfCosts
        | Question::Penalty
        | Question::Rule { .. }
        | Question::Unsolvable
        | Question::Plan => None,
    }
}

/// The first cost of the objective that differs so, and by how much.
pub(super) fn first_difference(
    asking: &Asking,
    told: &ExplainAnswer,
    is_so: impl Fn(i64) -> bool,
) -> Option<(Cost, u32)> {
    let costs = asking.objective().costs().iter();
    let mut deltas = costs.filter_map(|cost| Some((*cost, *told.deltas.get(cost)?)));
    let (cost, delta) = deltas.find(|(_, delta)| *delta != 0)?;
    let n = u32::try_from(delta.unsigned_abs()).ok()?;
    is_so(delta).then_some((cost, n))
}
