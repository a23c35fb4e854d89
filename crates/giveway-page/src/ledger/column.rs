//! The ledger as the inspector shows it.

use giveway_model::tr;
use giveway_solve::delays::{AgentDelay, CauseTotal, DelayCause, DelaysAnswer, LossPlace, words};

use super::verdict::verdict;
use super::{LedgerLit, asked_of, largest};
use crate::State;
use crate::ask::{Offer, VerdictPart};

/// The title of the ledger, and the question that opens it.
pub const TITLE: giveway_model::words::Later = giveway_model::tr_later!("Who costs whom?");

/// All that is told of the delays of a plan.
#[derive(Clone, Debug, PartialEq)]
pub struct Column {
    /// What the numbers are.
    pub lead: &'static str,
    /// What is lost in all, and what is proved of it; nothing before it is known.
    pub verdict: Option<VerdictPart>,
    /// What is still looked for, as a quiet line.
    pub pending: Option<&'static str>,
    /// Whether the table tells who costs others.
    pub is_turned: bool,
    /// The robots that lose steps, who loses most first.
    pub losses: Vec<LossRow>,
    /// The robots and rules that cost others steps, who costs most first.
    pub causes: Vec<CauseRow>,
    /// The steps that nobody is in the way of, in words.
    pub nobody: String,
    /// The steps lost by all.
    pub all: u32,
    /// How many robots cost nobody a step, in words.
    pub harmless: Option<String>,
    /// How many robots lose nothing, in words.
    pub unharmed: Option<String>,
    /// Where most is lost, the worst first.
    pub places: Vec<PlaceRow>,
    /// The question about the loss that is lit up, else about the largest.
    pub ask: Option<Offer>,
}

/// A robot that loses steps.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LossRow {
    /// Its index.
    pub agent: Option<usize>,
    /// Its name.
    pub name: String,
    /// The steps.
    pub steps: u32,
    /// Whom it lets pass.
    pub because: Vec<Because>,
    /// What each of them costs it, in words, where they are several.
    pub each: Option<String>,
    /// Whether it is lit up.
    pub is_lit: bool,
    /// The row as a sentence.
    pub aloud: String,
}

/// A robot or a rule that a robot lets pass.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Because {
    /// The index of the robot.
    pub agent: Option<usize>,
    /// Its name, or the rule in words.
    pub text: String,
}

/// A robot or a rule that costs others steps.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CauseRow {
    /// Which.
    pub cause: Because,
    /// The steps in all, in words; nothing where the fraction has too large numbers.
    pub steps: String,
    /// Who loses them.
    pub losers: Vec<Because>,
}

/// A place where steps are lost.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PlaceRow {
    /// Its number on the map, from 1.
    pub number: usize,
    /// Where, in words.
    pub text: String,
    /// The steps.
    pub steps: u32,
    /// Who loses them, in words.
    pub who: String,
    /// Whether it is lit up.
    pub is_lit: bool,
}

/// The ledger, where it is open.
pub fn column(state: &State) -> Option<Column> {
    let ledger = state.ledger()?;
    let told = ledger.told.as_deref();
    let mut column = Column {
        lead: tr!("Steps that each robot loses against its own best way alone."),
        verdict: told.map(verdict),
        pending: state.is_adding_up().then(|| match told {
            None => tr!("Adding up who costs whom"),
            Some(_) => tr!("Looking for a proof"),
        }),
        is_turned: state.view.ledger.is_turned,
        losses: Vec::new(),
        causes: Vec::new(),
        nobody: "0".to_owned(),
        all: 0,
        harmless: None,
        unharmed: None,
        places: Vec::new(),
        ask: None,
    };
    if let Some(told) = told {
        fill(&mut column, state, told);
    }
    Some(column)
}

/// The robots for which nobody loses a step, as a sentence; nothing where there are none.
fn harmless(told: &DelaysAnswer) -> Option<String> {
    let causes = told.because.iter();
    let causes = causes
        .filter(|total| matches!(total.cause, DelayCause::Agent { .. }))
        .count();
    let n = told.agents.len().saturating_sub(causes) as u32;
    (n > 0 && told.delay > 0)
        .then(|| tr!("{n} robot costs nobody a step." | "{n} robots cost nobody a step." % n))
}

fn fill(column: &mut Column, state: &State, told: &DelaysAnswer) {
    let lit = state.view.ledger.lit;
    column.all = told.delay;
    column.unharmed = words::unharmed(told);
    column.harmless = harmless(told);
    let losers = told.agents.iter().filter(|row| row.delay > 0);
    column.losses = losers.map(|row| loss(state, row, lit)).collect();
    for total in &told.because {
        match total.cause {
            DelayCause::Nobody => column.nobody = steps(total),
            DelayCause::Agent { .. } | DelayCause::Rule { .. } => column.causes.push(CauseRow {
                cause: because(state, &total.cause),
                steps: steps(total),
                losers: losers_to(state, told, &total.cause),
            }),
        }
    }
    let places = told.places.iter().enumerate();
    column.places = places
        .map(|(rank, place)| place_row(rank, place, lit))
        .collect();
    let lit = column.losses.iter().find(|row| row.is_lit);
    let question = lit.map_or_else(|| largest(told), |row| Some(asked_of(row.name.clone())));
    column.ask = question.map(|question| Offer::new("question", question));
}

fn loss(state: &State, row: &AgentDelay, lit: Option<LedgerLit>) -> LossRow {
    let agent = index(state, &row.agent);
    let each = match row.because.as_slice() {
        [first, _, ..] => Some(tr!("{steps} each", steps = first.steps)),
        [_] | [] => None,
    };
    LossRow {
        agent,
        name: row.agent.clone(),
        steps: row.delay,
        because: row
            .because
            .iter()
            .map(|share| because(state, &share.cause))
            .collect(),
        each,
        is_lit: agent.is_some() && agent.map(LedgerLit::Robot) == lit,
        aloud: words::row(row),
    }
}

/// The robots that lose steps because of something, who loses most first.
fn losers_to(state: &State, told: &DelaysAnswer, cause: &DelayCause) -> Vec<Because> {
    let rows = told.agents.iter();
    let rows = rows.filter(|row| row.because.iter().any(|share| share.cause == *cause));
    rows.map(|row| Because {
        agent: index(state, &row.agent),
        text: row.agent.clone(),
    })
    .collect()
}

fn because(state: &State, cause: &DelayCause) -> Because {
    Because {
        agent: match cause {
            DelayCause::Agent { agent } => index(state, agent),
            DelayCause::Rule { .. } | DelayCause::Nobody => None,
        },
        text: words::cause(cause),
    }
}

fn steps(total: &CauseTotal) -> String {
    total
        .steps
        .map_or_else(String::new, |steps| steps.to_string())
}

fn place_row(rank: usize, place: &LossPlace, lit: Option<LedgerLit>) -> PlaceRow {
    let who = place.agents.iter();
    let who: Vec<String> = who
        .map(|loss| format!("{} {}", loss.agent, loss.steps))
        .collect();
    PlaceRow {
        number: rank + 1,
        text: giveway_model::words::capital(&words::cells(place)),
        steps: place.steps,
        who: who.join(", "),
        is_lit: lit == Some(LedgerLit::Place(rank)),
    }
}

/// The index of a robot of the plan.
fn index(state: &State, name: &str) -> Option<usize> {
    let answer = state.document.fresh_answer()?;
    let mut agents = answer.agents().iter();
    agents.position(|agent| agent.name == name)
}
