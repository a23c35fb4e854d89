//! The parts of a question, and the question that they make.

use super::{Question, WordsError};
use crate::{Cell, Constraint, tr};

/// The word that stands for whichever agent, in `no-visit any`.
const ANY: &str = "any";

/// All kinds, in the order in which help lists them.
pub(super) const KINDS: [&str; 21] = [
    "wait",
    "charge",
    "no-charge",
    "visit",
    "no-visit",
    "move",
    "no-move",
    "slow",
    "order",
    "arrival",
    "length",
    "makespan",
    "sum-of-costs",
    "penalty",
    "charges",
    "moves",
    "waits",
    "yield",
    "rule",
    "unsolvable",
    "plan",
];

/// The parts of a question as they are typed: its kind, agents and options.
///
/// ```
/// use giveway_model::{Cell, Question, question::Asked};
/// let asked = Asked {
///     kind: "visit".into(),
///     agents: vec!["A1".into()],
///     at: Some(Cell::new(3, 1)),
///     ..Asked::default()
/// };
/// let question = Question::Visit { agent: "A1".into(), at: Cell::new(3, 1), time: None };
/// assert_eq!(asked.question(), Ok(question));
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Asked {
    /// The kind, such as `wait`.
    pub kind: String,
    /// The agents, in the order of the question.
    pub agents: Vec<String>,
    /// `--at X,Y`
    pub at: Option<Cell>,
    /// `--from T`
    pub from: Option<u32>,
    /// `--to T`
    pub to: Option<u32>,
    /// `--time T`
    pub time: Option<u32>,
    /// `--at-least N`
    pub at_least: Option<u32>,
    /// `--fewer-than N`
    pub fewer_than: Option<u32>,
    /// `--from-cell X,Y`
    pub from_cell: Option<Cell>,
    /// `--to-cell X,Y`
    pub to_cell: Option<Cell>,
    /// `--first X,Y`
    pub first: Option<Cell>,
    /// `--second X,Y`
    pub second: Option<Cell>,
}

impl Asked {
    /// The question that the parts make.
    ///
    /// # Errors
    /// A sentence, where an agent or an option is missing or too many.
    pub fn question(&self) -> Result<Question, WordsError> {
        let agent = || self.agent(0);
        let maybe_agent = || self.agents.first().cloned();
        let question = match self.kind.as_str() {
            "wait" => Question::Wait {
                agent: agent()?,
                at: self.at,
                from: self.from,
                to: self.to,
                at_least: self.at_least,
            },
            "charge" => Question::Charge {
                agent: agent()?,
                at: self.at,
                time: self.time,
            },
            "no-charge" => Question::NoCharge {
                agent: agent()?,
                at: self.need("at", self.at)?,
            },
            "visit" => Question::Visit {
                agent: agent()?,
                at: self.need("at", self.at)?,
                time: self.time,
            },
            "no-visit" => Question::NoVisit {
                agent: Some(agent()?).filter(|name| name != ANY),
                at: self.need("at", self.at)?,
            },
            "move" => Question::Move {
                agent: agent()?,
                from_cell: self.need("from-cell", self.from_cell)?,
                to_cell: self.need("to-cell", self.to_cell)?,
                time: self.time,
            },
            "no-move" => Question::NoMove {
                agent: agent()?,
                from_cell: self.need("from-cell", self.from_cell)?,
                to_cell: self.need("to-cell", self.to_cell)?,
                time: self.time,
            },
            "slow" => Question::Slow {
                agent: agent()?,
                from_cell: match self.to_cell {
                    Some(_) => Some(self.need("from-cell", self.from_cell)?),
                    None => None,
                },
                to_cell: match self.from_cell {
                    Some(_) => Some(self.need("to-cell", self.to_cell)?),
                    None => None,
                },
            },
            "order" => Question::Order {
                agent: agent()?,
                first: self.need("first", self.first)?,
                second: self.need("second", self.second)?,
            },
            "arrival" => Question::Arrival { agent: agent()? },
            "length" => Question::Length {
                agent: agent()?,
                fewer_than: self.fewer_than,
            },
            "makespan" => Question::Makespan,
            "sum-of-costs" => Question::SumOfCosts,
            "penalty" => Question::Penalty,
            "charges" => Question::Charges {
                agent: maybe_agent(),
            },
            "moves" => Question::Moves {
                agent: maybe_agent(),
            },
            "waits" => Question::Waits {
                agent: maybe_agent(),
            },
            "yield" => Question::Yield {
                agent: agent()?,
                to: self.agent(1)?,
                at: self.need("at", self.at)?,
            },
            "rule" => Question::Rule { rule: self.rule()? },
            "unsolvable" => Question::Unsolvable,
            "plan" => Question::Plan,
            kind => return Err(WordsError::Kind(kind.to_owned())),
        };
        self.nothing_more(&question)?;
        Ok(question)
    }

    fn agent(&self, index: usize) -> Result<String, WordsError> {
        let found = self.agents.get(index).cloned();
        let kind = &self.kind;
        found.ok_or_else(|| {
            WordsError::Sentence(if index == 0 {
                tr!("\"{kind}\" needs a robot.", kind)
            } else {
                tr!("\"{kind}\" needs two robots.", kind)
            })
        })
    }

    /// The rule that is said in place of agents, in one part or word by word.
    fn rule(&self) -> Result<Box<Constraint>, WordsError> {
        let words = self.agents.join(" ");
        let rule = Constraint::from_words(words.trim().trim_matches('"'));
        rule.map(Box::new).map_err(|fault| {
            WordsError::Sentence(tr!(
                "In the rule: found {found}, expected {expected}.",
                found = fault.found,
                expected = fault.expected
            ))
        })
    }

    fn need<T>(&self, option: &str, value: Option<T>) -> Result<T, WordsError> {
        value.ok_or_else(|| {
            WordsError::Sentence(tr!(
                "\"{kind}\" needs --{option}.",
                kind = self.kind,
                option
            ))
        })
    }

    /// Refuses what the question does not use, rather than to answer another.
    fn nothing_more(&self, question: &Question) -> Result<(), WordsError> {
        let mut used = Self::of(question);
        if let Question::Rule { .. } = question {
            // It may be said in other words.
            used.agents.clone_from(&self.agents);
        }
        if let Some(agent) = self.agents.get(used.agents.len()) {
            let kind = &self.kind;
            return Err(WordsError::Sentence(tr!(
                "\"{kind}\" does not use \"{agent}\".",
                kind,
                agent
            )));
        }
        let options = used.options();
        for (option, _) in self.options() {
            if options.iter().all(|(other, _)| *other != option) {
                let kind = &self.kind;
                return Err(WordsError::Sentence(tr!(
                    "\"{kind}\" does not use --{option}.",
                    kind,
                    option
                )));
            }
        }
        Ok(())
    }

    /// The parts of a question.
    pub fn of(question: &Question) -> Self {
        let mut asked = Self {
            kind: question.kind().to_owned(),
            agents: question.agent().into_iter().map(str::to_owned).collect(),
            ..Self::default()
        };
        match question {
            Question::Wait {
                at,
                from,
                to,
                at_least,
                ..
            } => {
                (asked.at, asked.from) = (*at, *from);
                (asked.to, asked.at_least) = (*to, *at_least);
            }
            Question::Charge { at, time, .. } => (asked.at, asked.time) = (*at, *time),
            Question::NoCharge { at, .. } => asked.at = Some(*at),
            Question::Visit { at, time, .. } => (asked.at, asked.time) = (Some(*at), *time),
            Question::NoVisit { agent, at } => {
                if agent.is_none() {
                    asked.agents.push(ANY.to_owned());
                }
                asked.at = Some(*at);
            }
            Question::Move {
                from_cell,
                to_cell,
                time,
                ..
            }
            | Question::NoMove {
                from_cell,
                to_cell,
                time,
                ..
            } => {
                (asked.from_cell, asked.to_cell) = (Some(*from_cell), Some(*to_cell));
                asked.time = *time;
            }
            Question::Slow {
                from_cell, to_cell, ..
            } => (asked.from_cell, asked.to_cell) = (*from_cell, *to_cell),
            Question::Order { first, second, .. } => {
                (asked.first, asked.second) = (Some(*first), Some(*second));
            }
            Question::Length { fewer_than, .. } => asked.fewer_than = *fewer_than,
            Question::Yield { to, at, .. } => {
                asked.agents.push(to.clone());
                asked.at = Some(*at);
            }
            Question::Rule { rule } => asked.agents = vec![format!("\"{}\"", rule.sentence())],
            Question::Arrival { .. }
            | Question::Makespan
            | Question::SumOfCosts
            | Question::Penalty
            | Question::Charges { .. }
            | Question::Moves { .. }
            | Question::Waits { .. }
            | Question::Unsolvable
            | Question::Plan => {}
        }
        asked
    }
}
