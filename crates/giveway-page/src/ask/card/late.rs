//! Who arrives later in the other plan, in one short sentence.

use giveway_model::words::and;
use giveway_model::{Question, condition::Clause, tr};
use giveway_solve::explain::{AgentDifference, ExplainAnswer};

/// The most words of the sentence, where it is made here.
const MOST_WORDS: usize = 30;

/// Who would arrive later, the first by name. Nothing where the plans are the same.
pub(super) fn who_is_late(told: &ExplainAnswer, clause: Option<&Clause>) -> Option<String> {
    if told.pays.is_empty() {
        return None;
    }
    let late: Vec<&AgentDifference> = late(told).collect();
    let Some(first) = late.first() else {
        return Some(match clause {
            Some(Clause { would, .. }) => {
                let short = tr!("If {would}, nobody would arrive later.", would);
                if is_short(&short) {
                    short
                } else {
                    tr!("Nobody would arrive later.").to_owned()
                }
            }
            None => tr!("Nobody would arrive later.").to_owned(),
        });
    };
    let AgentDifference {
        agent: name,
        arrival,
        other,
        ..
    } = first;
    let plain = tr!(
        "{name} would arrive at {other} instead of {arrival}.",
        name,
        other,
        arrival
    );
    let main = clause.map(|Clause { would, .. }| {
        tr!(
            "If {would}, {name} would arrive at {other} instead of {arrival}.",
            would,
            name,
            other,
            arrival
        )
    });
    let main = main.filter(|main| is_short(main)).unwrap_or(plain);
    let more = late.len() as u32 - 1;
    let whole = if let Some(passing) = passing(told, &late) {
        format!("{main} {passing}")
    } else if more == 0 {
        main.clone()
    } else {
        let more = tr!(
            "{n} other would arrive later, too." | "{n} others would arrive later, too." % more
        );
        format!("{main} {more}")
    };
    Some(if is_short(&whole) { whole } else { main })
}

/// How those fare that the plan lets pass, where another robot would be late by most; nothing where
/// nobody is let pass.
fn passing(told: &ExplainAnswer, late: &[&AgentDifference]) -> Option<String> {
    let passing = let_pass(told);
    let is_first = late.first().is_some_and(|it| passing.contains(&&it.agent));
    if is_first || passing.is_empty() {
        return None;
    }
    let is_late = |name: &&String| late.iter().any(|it| it.agent == **name);
    let (later, others): (Vec<&String>, Vec<&String>) = passing.into_iter().partition(is_late);
    Some(if later.is_empty() {
        tr!("No later than now: {robots}.", robots = and(&others))
    } else {
        tr!("Later, too: {robots}.", robots = and(&later))
    })
}

/// The robots that the sentence about this plan names as let pass.
pub(super) fn let_pass(told: &ExplainAnswer) -> Vec<&String> {
    match &told.question {
        Question::Yield { to, .. } => vec![to],
        Question::Wait { .. }
        | Question::Charge { .. }
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
        | Question::Plan => told
            .here
            .iter()
            .flat_map(giveway_solve::explain::Here::let_pass)
            .collect(),
    }
}

/// The robots that arrive later in the other plan, those that lose most first.
pub(super) fn late(told: &ExplainAnswer) -> impl Iterator<Item = &AgentDifference> {
    told.pays.iter().filter(|it| it.other > it.arrival)
}

pub(super) fn is_short(sentence: &str) -> bool {
    sentence.split_whitespace().count() <= MOST_WORDS
}
