//! How another plan of the same costs does without what was asked about, in one sentence.

use giveway_model::{Question, tr};

use crate::explain::{AgentDifference, ExplainAnswer, How};

/// The sentence of the first of the ways in which the other plan does without it; nothing where
/// the answer tells none. It names whoever arrives later.
///
/// ```
/// use giveway_solve::explain::{AgentDifference, how_sentence, How};
/// use giveway_model::Question;
/// let question = Question::Arrival { agent: "A3".into() };
/// let pays = [AgentDifference {
///     agent: "A4".into(), arrival: 10, other: 15, more_waits: 5, other_way: false,
/// }];
/// assert_eq!(
///     how_sentence(&question, &[How::Others], &pays).unwrap(),
///     "A4 could wait instead; then A4 arrives 5 later."
/// );
/// ```
pub fn how_sentence(question: &Question, how: &[How], pays: &[AgentDifference]) -> Option<String> {
    let asked = question.agent();
    let is_wait = matches!(question, Question::Wait { .. } | Question::Yield { .. });
    Some(match (how.first()?, asked) {
        (How::Others, _) => {
            let mut others = pays.iter().filter(|it| Some(it.agent.as_str()) != asked);
            let pays =
                |it: &&AgentDifference| it.other > it.arrival || it.more_waits > 0 || it.other_way;
            others_instead(others.find(pays)?)
        }
        (How::OtherWay | How::Elsewhere | How::Free, Some(agent))
            if let Some(sentence) = so(question, agent) =>
        {
            sentence
        }
        (How::OtherWay, Some(agent)) if is_wait && how.contains(&How::Elsewhere) => {
            tr!("{agent} could go another way and wait there.", agent)
        }
        (How::OtherWay, Some(agent)) => tr!("{agent} could drive around instead.", agent),
        (How::Elsewhere, Some(agent)) if is_wait => tr!("{agent} could wait elsewhere.", agent),
        (How::Elsewhere, Some(agent)) => tr!("{agent} could wait instead.", agent),
        (How::Free, Some(agent)) if is_wait => tr!("{agent} need not wait here at all.", agent),
        (How::OtherWay | How::Elsewhere | How::Free, _) => tr!("It was for nothing.").to_owned(),
    })
}

/// What an agent could do or be as a question asks, where that says more than that something could
/// go.
fn so(question: &Question, agent: &str) -> Option<String> {
    match question {
        Question::NoCharge { .. } | Question::NoVisit { .. } | Question::NoMove { .. } => {
            Some(tr!("{agent} could do so.", agent))
        }
        Question::Arrival { .. } => Some(tr!("{agent} could arrive sooner.", agent)),
        Question::Length { .. } => Some(tr!("The path of {agent} could be shorter.", agent)),
        Question::Moves { .. } => Some(tr!("{agent} could make fewer moves.", agent)),
        Question::Charges { .. } => Some(tr!("{agent} could charge fewer times.", agent)),
        Question::Waits { .. } => Some(tr!("{agent} could wait less.", agent)),
        Question::Wait { .. }
        | Question::Yield { .. }
        | Question::Charge { .. }
        | Question::Visit { .. }
        | Question::Move { .. }
        | Question::Slow { .. }
        | Question::Order { .. }
        | Question::Makespan
        | Question::SumOfCosts
        | Question::Penalty
        | Question::Rule { .. }
        | Question::Unsolvable
        | Question::Plan => None,
    }
}

/// The same of an answer.
pub fn how_of(answer: &ExplainAnswer) -> Option<String> {
    how_sentence(&answer.question, &answer.how, &answer.pays)
}

/// What another robot does instead.
fn others_instead(other: &AgentDifference) -> String {
    let name = &other.agent;
    let does = if other.more_waits > 0 {
        tr!("{name} could wait instead", name)
    } else if other.other_way {
        tr!("{name} could go another way instead", name)
    } else {
        tr!("{name} could arrive later instead", name)
    };
    match other.other.saturating_sub(other.arrival) {
        0 => tr!("{does}.", does),
        later => tr!(
            "{does}; then {name} arrives {later} later.",
            does,
            name,
            later
        ),
    }
}
