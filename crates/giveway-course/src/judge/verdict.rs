//! What the judge of a task says, as data.

use giveway_model::check::Violation;
use giveway_model::{Cell, Cost, Costs};
use giveway_solve::change::Method;
use giveway_solve::{Reason, explain};

use super::{Mark, Outside};
use crate::lesson::{Comparison, Value};
use crate::port::Evidence;

/// What the judge of a task says.
#[derive(Clone, Debug, PartialEq)]
pub struct Verdict {
    /// Which of the three it is.
    pub kind: Kind,
    /// Why.
    pub why: Why,
    /// What shows it.
    pub evidence: Evidence,
    /// The cells that a seal is put on.
    pub seal: Vec<Cell>,
}

/// The three verdicts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// There is something left to do.
    NotYet,
    /// It is done.
    Solved,
    /// It is outside of the task, or breaks a rule.
    NotLikeThis,
}

/// Why a verdict is as it is.
#[derive(Clone, Debug, PartialEq)]
pub enum Why {
    /// Nothing was done yet.
    Untouched,
    /// The solver does not know; why, where it says so.
    Unknown(Option<Reason>),
    /// The solver broke down; why, as a sentence.
    SolverFailed(String),
    /// The solver refuses what is on the board, for a reason as a sentence.
    Refused(String),

    /// Something was changed that may not be.
    Outside(Outside),
    /// There are more edits than are allowed.
    TooManyEdits {
        /// How many were made.
        made: u32,
        /// How many may be.
        allowed: u32,
    },
    /// A robot cannot arrive even alone.
    AloneStuck(String),
    /// There is a plan.
    Plan(Costs),
    /// There is no plan.
    NoPlan,
    /// The cost of the best plan.
    Cost {
        /// The cost.
        cost: Cost,
        /// What it is.
        value: u32,
        /// How it should compare.
        compare: Comparison,
        /// With what.
        wanted: u32,
    },
    /// The cost of the best plan beside that of the start.
    Raised {
        /// The cost.
        cost: Cost,
        /// At the start.
        before: u32,
        /// Now.
        now: u32,
        /// By how much it should be more.
        by: u32,
    },
    /// What a rule of the scene's own costs: the first cost of the best plan with it, and
    /// of the best one without it.
    Price {
        /// The rule, by its number in the scene, from 0.
        rule: u32,
        /// The cost.
        cost: Cost,
        /// How much of it with the rule.
        with: u32,
        /// How much of it without the rule.
        without: u32,
    },
    /// The answer to a question.
    Answered {
        /// What it is.
        verdict: explain::Verdict,
        /// What it should be.
        wanted: explain::Verdict,
    },
    /// How many plans the Pareto front of two costs has.
    Points {
        /// How many.
        count: usize,
        /// The costs.
        costs: [Cost; 2],
    },

    /// The plan breaks a rule.
    Broken(Violation),
    /// The plan breaks no rule.
    Legal,
    /// The plan does not break this rule of the scene's own, by its number from 0.
    Keeps {
        /// The rule.
        rule: u32,
    },
    /// The plan costs the least.
    Best {
        /// Its first cost.
        cost: Cost,
        /// How much of it.
        value: u32,
    },
    /// A better plan is known.
    NotBest {
        /// The first cost in which it is better.
        cost: Cost,
        /// How much the plan has.
        value: u32,
        /// How much the better plan has.
        best: u32,
    },
    /// A robot is not at its flag yet.
    NotHome(String),
    /// A robot has not been at a waypoint yet.
    NotVisited(String, Option<Cell>),
    /// What a plan costs, against what it may cost.
    Costs {
        /// The cost.
        cost: Cost,
        /// How much the plan has.
        value: u32,
        /// The most.
        at_most: u32,
    },
    /// A robot goes another way that was not to be led.
    LedAnother(String),

    /// A value was said, and the solver has proved one.
    Guessed {
        /// What was said.
        guess: Value,
        /// What is so.
        truth: Value,
        /// The answer that was picked, by its index, where there were some.
        answer: Option<usize>,
    },
    /// Nothing was said; this is so, as the solver has proved.
    Revealed(Value),
    /// Best plans differ in what was asked for.
    Differs,
    /// What was asked for has not one answer: several robots or rules are alike in it, or
    /// it is no whole number.
    Unclear,

    /// So many conflicts are found.
    Found {
        /// How many.
        found: usize,
        /// Of how many.
        of: usize,
    },
    /// There is no conflict of these robots then.
    NoConflict(Mark),

    /// What was said is not so, and what is so is not told.
    Untold,

    /// An answer was picked that has its own reply.
    Reply(usize),
    /// The solver does not agree with what the lesson says of an answer.
    Disputed,

    /// An order does not work.
    OrderStuck {
        /// Who finds no way.
        robot: String,
        /// Around whom.
        around: Vec<String>,
    },
    /// An order works.
    OrderWorks {
        /// The cost.
        cost: Cost,
        /// How much its plan has.
        value: u32,
        /// How much the best plan has, where that was asked.
        best: Option<u32>,
    },
    /// No order works, though there is a plan.
    NoOrderWorks {
        /// How many orders there are.
        orders: usize,
    },
    /// An order was found that works, though none should.
    SomeOrderWorks(Vec<String>),

    /// What a method goes on with.
    Went {
        /// The method.
        method: Method,
        /// What the new plan costs against what it may cost.
        cost: Option<(Cost, u32, u32)>,
        /// How many robots keep their path.
        kept: u32,
        /// How many must.
        wanted: Option<u32>,
    },
    /// A method has no plan to go on with.
    NoWayOn(Method),
}

impl Verdict {
    fn new(kind: Kind, why: Why) -> Self {
        Self {
            kind,
            why,
            evidence: Evidence::default(),
            seal: Vec::new(),
        }
    }

    pub(super) fn not_yet(why: Why) -> Self {
        Self::new(Kind::NotYet, why)
    }

    /// What is said where the solver broke down.
    pub(crate) fn unknown(sentence: String) -> Self {
        Self::not_yet(Why::SolverFailed(sentence))
    }

    pub(super) fn solved(why: Why) -> Self {
        Self::new(Kind::Solved, why)
    }

    pub(crate) fn not_like_this(why: Why) -> Self {
        Self::new(Kind::NotLikeThis, why)
    }

    /// Solved where something holds, else not yet.
    pub(super) fn if_holds(holds: bool, why: Why) -> Self {
        let kind = if holds { Kind::Solved } else { Kind::NotYet };
        Self::new(kind, why)
    }

    pub(super) fn with(mut self, evidence: Evidence) -> Self {
        self.evidence = evidence;
        self
    }

    /// Tells an answer that is not right nothing but that: where answers are hidden.
    pub(crate) fn keep_quiet(&mut self) {
        let is_answer = matches!(self.why, Why::Guessed { .. } | Why::Reply(_));
        if is_answer && !self.is_solved() {
            *self = Self::not_yet(Why::Untold);
        }
    }

    /// The value that was asked for, once it is on the table.
    pub const fn truth(&self) -> Option<&Value> {
        match &self.why {
            Why::Guessed { truth, .. } | Why::Revealed(truth) => Some(truth),
            _ => None,
        }
    }

    /// Whether the task is done.
    pub fn is_solved(&self) -> bool {
        self.kind == Kind::Solved
    }
}
