//! How tight it is: what sets of robots alone need, the other robots gone.

use giveway_model::words::{and, name};
use giveway_model::{Cost, Question, tr};
use giveway_solve::explain::{ExplainAnswer, SubsetBound, Verdict};

use super::pieces::{Piece, pieces};
use crate::Asking;

/// At most so many robots are named in a sentence.
const MOST_NAMED: usize = 5;

/// Sets of robots, the one that needs most first.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Tight {
    /// What is counted, as the heading of its column: `need`, `lose`.
    pub counted: String,
    /// The sets.
    pub rows: Vec<TightRow>,
}

/// What a set of robots alone needs.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TightRow {
    /// The robots: each can be pressed.
    pub robots: Vec<Piece>,
    /// What they need, in the unit of the cost.
    pub need: u32,
    /// What it is beside the plan, in a few words.
    pub beside: String,
    /// Whether they need as much as all robots.
    pub is_all: bool,
}

/// The table: where a cost of all robots is asked about, or where there is no other reason.
pub(super) fn tight(asking: &Asking, told: &ExplainAnswer, has_core: bool) -> Option<Tight> {
    if has_core && !is_of_all(asking.question()) {
        return None;
    }
    let cost = told.alone.first()?.cost;
    let tells = |it: &&SubsetBound| cost != Cost::SumOfCosts || it.lost() > 0;
    let rows: Vec<TightRow> = told
        .alone
        .iter()
        .filter(tells)
        .map(|it| row(asking, told, it))
        .collect();
    (!rows.is_empty()).then(|| Tight {
        counted: match cost {
            Cost::Makespan => tr!("robots alone" => "need").to_owned(),
            Cost::SumOfCosts => tr!("robots alone" => "lose").to_owned(),
            Cost::Charges | Cost::Moves | Cost::Waits | Cost::Penalty => name(cost).to_owned(),
        },
        rows,
    })
}

fn row(asking: &Asking, told: &ExplainAnswer, bound: &SubsetBound) -> TightRow {
    let other = told.costs.filter(|_| told.verdict == Verdict::Costly);
    let of_all = other.or(asking.about.solved.costs);
    let of_all = of_all.map_or(bound.here, |costs| costs.get(bound.cost));
    let of_here = |n: u32| tr!("of {n} here", n);
    let (need, beside) = match bound.cost {
        Cost::Makespan => {
            let beside = match of_all.saturating_sub(bound.least) {
                0 if other.is_some() => tr!("as the other plan").to_owned(),
                0 => tr!("as the plan").to_owned(),
                n => tr!("{n} less", n),
            };
            (bound.least, beside)
        }
        Cost::SumOfCosts => (bound.lost(), of_here(bound.here.saturating_sub(bound.own))),
        Cost::Charges | Cost::Moves | Cost::Waits | Cost::Penalty => {
            (bound.least, of_here(bound.here))
        }
    };
    TightRow {
        robots: pieces(&and(&bound.agents), asking.about.agents()),
        need,
        beside,
        is_all: bound.cost == Cost::Makespan && bound.least == of_all,
    }
}

/// Whether a question is about a cost of all robots.
const fn is_of_all(question: &Question) -> bool {
    match question {
        Question::Makespan | Question::SumOfCosts | Question::Penalty => true,
        Question::Charges { agent } | Question::Moves { agent } | Question::Waits { agent } => {
            agent.is_none()
        }
        Question::Wait { .. }
        | Question::Yield { .. }
        | Question::Charge { .. }
        | Question::NoCharge { .. }
        | Question::Visit { .. }
        | Question::NoVisit { .. }
        | Question::Move { .. }
        | Question::NoMove { .. }
        | Question::Slow { .. }
        | Question::Order { .. }
        | Question::Arrival { .. }
        | Question::Length { .. }
        | Question::Rule { .. }
        | Question::Unsolvable
        | Question::Plan => false,
    }
}

/// Some of the robots that alone need as many steps as the plan has, where these are asked about.
pub(super) fn forcing<'a>(asking: &Asking, told: &'a ExplainAnswer) -> Option<&'a SubsetBound> {
    let makespan = asking.about.solved.costs?.makespan;
    let count = asking.about.agents().len();
    SubsetBound::forcing(
        &told.alone,
        asking.question(),
        told.verdict,
        makespan,
        count,
    )
}

/// `3 robots need 86`.
pub(super) fn forcing_title(bound: &SubsetBound) -> String {
    let n = bound.least;
    match bound.agents.as_slice() {
        [agent] => tr!("{agent} alone needs {n}", agent, n),
        agents => tr!("{count} robots need {n}", count = agents.len(), n),
    }
}

/// The same in a sentence, beside all other robots.
pub(super) fn forcing_sentence(asking: &Asking, bound: &SubsetBound) -> String {
    let others = asking
        .about
        .agents()
        .len()
        .saturating_sub(bound.agents.len()) as u32;
    let steps = tr!("{n} step" | "{n} steps" % bound.least);
    match bound.agents.as_slice() {
        [agent] => tr!(
            "{agent} alone needs {steps}, whatever the other robot does."
                | "{agent} alone needs {steps}, whatever the other {n} do." % others,
            agent,
            steps
        ),
        agents if agents.len() <= MOST_NAMED => tr!(
            "{robots} alone need {steps}, whatever the other robot does."
                | "{robots} alone need {steps}, whatever the other {n} do." % others,
            robots = and(agents),
            steps
        ),
        agents => tr!(
            "These {count} robots alone need {steps}, whatever the other robot does."
                | "These {count} robots alone need {steps}, whatever the other {n} do." % others,
            count = agents.len(),
            steps
        ),
    }
}
