//! Delays in sentences.

use giveway_model::words::and;
use giveway_model::{Cell, Cost, tr};

use super::{AgentDelay, CauseTotal, DelayCause, DelayProof, DelaysAnswer, LossPlace, Share};

/// At most so many agents and rules are named in a sentence.
const MOST_NAMED: usize = 6;

/// Whom an agent lets pass, in a few words.
pub fn cause(cause: &DelayCause) -> String {
    match cause {
        DelayCause::Agent { agent } => agent.clone(),
        DelayCause::Rule { text, .. } => text.clone(),
        DelayCause::Nobody => tr!("a robot lets pass" => "nobody").to_owned(),
    }
}

/// The row of an agent as a sentence.
pub fn row(row: &AgentDelay) -> String {
    let AgentDelay {
        agent,
        arrival,
        delay,
        ..
    } = row;
    match row.because.as_slice() {
        [] => tr!(
            "{agent} arrives at {arrival}, as early as alone.",
            agent,
            arrival
        ),
        [
            Share {
                cause: DelayCause::Nobody,
                ..
            },
        ] => tr!(
            "{agent} arrives at {arrival} and loses {delay}, though nobody is in its way: this could be saved.",
            agent,
            arrival,
            delay
        ),
        [one] => tr!(
            "{agent} arrives at {arrival} and loses {delay}: in the way that it would take alone there is {cause}.",
            agent,
            arrival,
            delay,
            cause = cause(&one.cause)
        ),
        [first, ..] => tr!(
            "{agent} arrives at {arrival} and loses {delay}: in the way that it would take alone there are {causes}, for {steps} each.",
            agent,
            arrival,
            delay,
            causes = causes(&row.because),
            steps = first.steps
        ),
    }
}

/// Whom an agent lets pass, as far as a cell of a table has room; nothing where it loses nothing.
pub fn passes(row: &AgentDelay) -> String {
    if row.because.is_empty() {
        return String::new();
    }
    causes(&row.because)
}

/// The names of all causes of a row, as far as a sentence has room.
pub fn causes(shares: &[Share]) -> String {
    let mut named: Vec<String> = shares.iter().map(|share| cause(&share.cause)).collect();
    let more = named.len().saturating_sub(MOST_NAMED);
    if more > 1 {
        named.truncate(MOST_NAMED);
        named.push(tr!("robots" => "{n} other" | "{n} others" % more as u32));
    }
    and(&named)
}

/// The sum of all delays as a sentence.
pub fn total(answer: &DelaysAnswer) -> String {
    let sum = answer.costs.map_or(0, |costs| costs.sum_of_costs);
    if answer.delay == 0 {
        return tr!("No robot loses a step against its best way alone.").to_owned();
    }
    tr!(
        "{n} step is lost: alone the robots need {alone} in all, here {sum}."
            | "{n} steps are lost: alone the robots need {alone} in all, here {sum}."
                % answer.delay,
        alone = answer.alone,
        sum
    )
}

/// What is proved of the sum of all delays, as sentences; nothing where nothing was lost.
pub fn proof(answer: &DelaysAnswer) -> Option<String> {
    if answer.delay == 0 {
        return None;
    }
    let open = || tr!("Whether any of this can be saved is open.").to_owned();
    let Some(proof) = &answer.proof else {
        return (!answer.pending).then(open);
    };
    let plans = plans(proof);
    let saved = answer.delay.saturating_sub(proof.at_most);
    if saved > 0 {
        return Some(tr!(
            "Another plan{plans} loses {saved} fewer.",
            plans,
            saved
        ));
    }
    if proof.at_least >= answer.delay {
        return Some(tr!("No plan{plans} loses less.", plans));
    }
    if proof.at_least == 0 {
        return Some(open());
    }
    Some(tr!(
        "Every plan{plans} loses at least {least}; whether the other {rest} can be saved is open.",
        plans,
        least = proof.at_least,
        rest = answer.delay - proof.at_least
    ))
}

/// The plans that a proof is about, behind the word "plan".
fn plans(proof: &DelayProof) -> String {
    let given = proof.given.iter().map(|(cost, &n)| match cost {
        Cost::Makespan => tr!("behind: plan" => "that is done at {n}", n),
        Cost::SumOfCosts => tr!("behind: plan" => "with a sum of costs of {n}", n),
        Cost::Charges => tr!("behind: plan" => "with {n} charge" | "with {n} charges" % n),
        Cost::Moves => tr!("behind: plan" => "with {n} move" | "with {n} moves" % n),
        Cost::Waits => tr!("behind: plan" => "with {n} wait" | "with {n} waits" % n),
        Cost::Penalty => tr!("behind: plan" => "with a penalty of {n}", n),
    });
    let mut given: Vec<String> = given.collect();
    let is_timed = proof.given.contains_key(&Cost::Makespan);
    if let Some(n) = proof.reach.within().filter(|_| !is_timed) {
        given.push(tr!("behind: plan" => "of makespan at most {n}", n));
    }
    if given.is_empty() {
        return String::new();
    }
    format!(" {}", and(&given))
}

/// What a robot or a rule costs all others, in a few words: `A14 61⅙`.
pub fn cost(total: &CauseTotal) -> String {
    let cause = cause(&total.cause);
    match total.steps {
        Some(steps) => format!("{cause} {steps}"),
        None => cause,
    }
}

/// Where a place is: `(3, 1)`, `from (6, 5) to (15, 5)`.
pub fn cells(place: &LossPlace) -> String {
    let ends: Option<(&Cell, &Cell)> = place.cells.first().zip(place.cells.last());
    match ends {
        None => String::new(),
        Some((first, last)) if first == last => tr!("steps are lost" => "at {first}", first),
        Some((first, last)) => tr!(
            "steps are lost" => "from {first} to {last}",
            first,
            last
        ),
    }
}

/// A place as a sentence; `is_worst` where most is lost there.
pub fn place(place: &LossPlace, is_worst: bool) -> String {
    let agents = place.agents.iter();
    let mut agents: Vec<String> = agents
        .map(|loss| format!("{} {}", loss.agent, loss.steps))
        .collect();
    let more = agents.len().saturating_sub(MOST_NAMED);
    if more > 1 {
        agents.truncate(MOST_NAMED);
        agents.push(tr!("robots" => "{n} other" | "{n} others" % more as u32));
    }
    let (cells, agents) = (cells(place), and(&agents));
    if is_worst {
        tr!(
            "Most is lost {cells}: {n} step ({agents})."
                | "Most is lost {cells}: {n} steps ({agents})." % place.steps,
            cells,
            agents
        )
    } else {
        tr!(
            "Then {cells}: {n} step ({agents})."
                | "Then {cells}: {n} steps ({agents})." % place.steps,
            cells,
            agents
        )
    }
}

/// The robots that lose nothing, as a sentence; nothing where there are none.
pub fn unharmed(answer: &DelaysAnswer) -> Option<String> {
    let rows = answer.agents.iter();
    let n = rows.filter(|row| row.delay == 0).count() as u32;
    (n > 0 && answer.delay > 0)
        .then(|| tr!("{n} robot loses nothing." | "{n} robots lose nothing." % n))
}

/// All of it.
pub(super) fn all(answer: &DelaysAnswer) -> String {
    if answer.costs.is_none() {
        return tr!("The search ended before there was a plan to ask about.").to_owned();
    }
    if let Some(reason) = &answer.reason {
        let reason = crate::words::reason(reason);
        return tr!("There is no ledger of this plan. {reason}", reason);
    }
    let mut sentences = vec![total(answer)];
    if let Some(since) = answer.since {
        sentences.insert(
            0,
            tr!("This is about the plan from time {since} on.", since),
        );
    }
    sentences.extend(proof(answer));
    let losers = answer.agents.iter().filter(|it| it.delay > 0);
    sentences.extend(losers.map(row));
    sentences.extend(unharmed(answer));
    let places = answer.places.iter().zip(0..);
    sentences.extend(places.map(|(it, number)| place(it, number == 0)));
    sentences.join(" ")
}
