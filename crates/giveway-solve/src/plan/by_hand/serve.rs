//! A tree by hand, from the splits to the answer.

use giveway_model::{Fault, Version};
use giveway_planners::{
    cbs::{
        Cardinality, Party,
        by_hand::{Branch, Choice, Hand, HandError, MOST_SPLITS},
    },
    planner::{Halt, Outcome, Report, by_hand, so_far},
    problem::Problem,
};

use super::{ByHand, ConflictChoice, HandSplit, NodeChoices, SplitMade, ToldBranch, UnmadeSplit};
use crate::Refusal;
use crate::plan::serve::{PlanTask, end};
use crate::plan::teller::Teller;
use crate::plan::{PlanAnswer, PlanTrace, Went};

/// Of a node so many conflicts are told, with what each split would give.
const MOST_TOLD: usize = 20;

impl PlanTask<'_> {
    /// The tree of these splits, with what can be split at a node.
    ///
    /// # Errors
    /// When a split is none of that tree.
    pub(in crate::plan) fn by_hand(
        &self,
        problem: &Problem,
        asked: &ByHand,
    ) -> Result<PlanAnswer, Refusal> {
        let teller = self.teller(problem);
        let mut hand = match by_hand(&self.asked(problem), &self.budget) {
            Ok(hand) => hand,
            Err(outcome) => return Ok(self.answer(end(&outcome, &teller))),
        };
        let told = Told {
            task: self,
            teller: &teller,
        };
        let mut splits = Vec::new();
        for (number, split) in asked.splits.iter().enumerate() {
            match told.make(&mut hand, number, split)? {
                Ok(made) => splits.push(made),
                Err(outcome) => return Ok(self.answer(end(&outcome, &teller))),
            }
        }
        let choices = match told.choices(&hand, asked.node) {
            Ok(choices) => choices,
            Err(outcome) => return Ok(self.answer(end(&outcome, &teller))),
        };
        let report = Report {
            outcome: so_far(&hand),
            steps: hand.splits().len() as u64,
            trace: None,
        };
        let mut answer = self.answer(end(&report.outcome, &teller));
        answer.stats.steps = report.steps;
        answer.trace = Some(PlanTrace {
            giveway: Version,
            went: Went::CbsByHand {
                nodes: teller.nodes(&hand.tree()),
                splits,
                choices,
            },
        });
        self.add_plan(&mut answer, problem, &report);
        Ok(answer)
    }
}

/// What is told of a tree by hand.
struct Told<'a> {
    task: &'a PlanTask<'a>,
    teller: &'a Teller<'a>,
}

/// Something, unless the budget is spent.
type Unless<T> = Result<T, Outcome>;

impl Told<'_> {
    /// Makes a split.
    fn make(
        &self,
        hand: &mut Hand,
        number: usize,
        split: &HandSplit,
    ) -> Result<Unless<SplitMade>, Refusal> {
        let choice = self.choice(hand, number, split)?;
        let rule = match self.rule(hand, choice) {
            Ok(rule) => rule,
            Err(why) => return refused(why, number),
        };
        let is_rule = hand.rule(choice.node) == Some(choice);
        match hand.split(choice, &self.task.budget) {
            Ok(branches) => Ok(Ok(SplitMade {
                node: split.node,
                agent: split.agent.clone(),
                branches: branches.map(|branch| branch as u64),
                rule,
                is_rule,
            })),
            Err(why) => refused(why, number),
        }
    }

    /// A split by numbers.
    fn choice(&self, hand: &Hand, number: usize, split: &HandSplit) -> Result<Choice, Refusal> {
        let node = usize::try_from(split.node).unwrap_or(usize::MAX);
        let conflict = split.conflict as usize;
        let conflicts = hand.conflicts(node);
        let Some(met) = conflicts.get(conflict) else {
            return Err(match conflicts.len() {
                0 => not_open(number, node),
                of => no_conflict(number, conflict, of),
            });
        };
        let [first, second] = [met.first, met.second].map(|agent| self.teller.name(agent));
        let party = if split.agent == first {
            Party::First
        } else if split.agent == second {
            Party::Second
        } else {
            let found = format!("\"{}\"", split.agent);
            let expected = format!("\"{first}\" or \"{second}\"");
            return Err(fault(number, "agent", found, expected));
        };
        Ok(Choice {
            node,
            conflict,
            party,
        })
    }

    /// What the rule of the planner would split there.
    fn rule(&self, hand: &Hand, choice: Choice) -> Result<UnmadeSplit, HandError> {
        let rule = hand.rule(choice.node).ok_or(HandError::NotOpen)?;
        let met = hand.conflicts(rule.node).get(rule.conflict);
        let met = met.ok_or(HandError::NotOpen)?;
        let cardinality = cardinality(hand, rule);
        Ok(UnmadeSplit {
            conflict: self.teller.conflict(met, cardinality),
            agent: self.teller.name(met.agent(rule.party)),
            branches: self.branches(hand, rule)?,
        })
    }

    fn branches(&self, hand: &Hand, choice: Choice) -> Result<[ToldBranch; 2], HandError> {
        let branches = hand.preview(choice, &self.task.budget)?;
        Ok(branches.map(|branch: Branch| ToldBranch {
            constraint: self.teller.constraint(branch.constraint),
            cost: branch.cost,
            conflicts: branch.conflicts as u64,
        }))
    }

    /// What can be split at a node, where it is open.
    fn choices(&self, hand: &Hand, node: u64) -> Unless<Option<NodeChoices>> {
        let own = usize::try_from(node).unwrap_or(usize::MAX);
        if !hand.open().any(|open| open == own) {
            return Ok(None);
        }
        let mut told = Vec::new();
        let all = hand.conflicts(own);
        for (conflict, met) in all.iter().enumerate().take(MOST_TOLD) {
            let choice = |party| Choice {
                node: own,
                conflict,
                party,
            };
            let branches = |party| match self.branches(hand, choice(party)) {
                Ok(branches) => Ok(branches),
                Err(HandError::Stopped(stop)) => Err(Halt::Budget(stop)),
                Err(HandError::NotOpen | HandError::NoConflict { .. } | HandError::Full) => {
                    Err(Halt::Effort)
                }
            };
            let both = branches(Party::First)
                .and_then(|first| Ok([first, branches(Party::Second)?]))
                .map_err(stopped)?;
            let cardinality = cardinality(hand, choice(Party::First));
            told.push(ConflictChoice {
                conflict: self.teller.conflict(met, cardinality),
                branches: both,
            });
        }
        Ok(Some(NodeChoices {
            node,
            left_out: all.len().saturating_sub(told.len()) as u64,
            conflicts: told,
        }))
    }
}

fn cardinality(hand: &Hand, choice: Choice) -> Cardinality {
    let rated = hand.cardinality(choice.node, choice.conflict);
    rated.unwrap_or(Cardinality::NonCardinal)
}

const fn stopped(halt: Halt) -> Outcome {
    Outcome::Stopped {
        halt,
        walks: None,
        bound: None,
    }
}

/// Why a split was not made: the request is wrong, or the budget is spent.
fn refused<T>(why: HandError, number: usize) -> Result<Unless<T>, Refusal> {
    match why {
        HandError::Stopped(stop) => Ok(Err(stopped(Halt::Budget(stop)))),
        HandError::NotOpen => {
            let found = "a node that is not open".to_owned();
            Err(fault(number, "node", found, "an open node".to_owned()))
        }
        HandError::NoConflict { of } => Err(no_conflict(number, of, of)),
        HandError::Full => {
            let found = format!("more than {MOST_SPLITS} splits");
            let expected = format!("at most {MOST_SPLITS}");
            let fault = Fault::at("by_hand.splits", found, expected);
            Err(Refusal::Request { fault })
        }
    }
}

fn not_open(number: usize, node: usize) -> Refusal {
    let expected = "an open node with a conflict".to_owned();
    fault(number, "node", node.to_string(), expected)
}

fn no_conflict(number: usize, conflict: usize, of: usize) -> Refusal {
    let expected = format!("less than {of}, the number of its conflicts");
    fault(number, "conflict", conflict.to_string(), expected)
}

fn fault(number: usize, field: &str, found: String, expected: String) -> Refusal {
    let place = format!("by_hand.splits[{number}].{field}");
    Refusal::Request {
        fault: Fault::at(place, found, expected),
    }
}
