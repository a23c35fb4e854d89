//! What the column says of a step of PIBT: who has priority, and who pushes whom.

use std::rc::Rc;

use giveway_model::words::values;
use giveway_model::{Costs, Plan, tr};
use giveway_solve::plan::{Inherited, Went};

use super::at;
use crate::State;
use crate::inside::column::{Button, Column, Fact, Tint, Verdict};
use crate::inside::{InsideAction, index, steps};

/// The steps of PIBT.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct PibtRun {
    /// The inheritances of priority, each with the time at which its step begins.
    pub(crate) inherited: Vec<Inherited>,
    /// The robot of the highest priority in each step.
    pub(crate) leaders: Vec<String>,
    /// The plan; nothing where robots got stuck.
    pub(crate) plan: Option<Plan>,
    /// Its costs.
    pub(crate) costs: Option<Costs>,
    /// How it ended, in a sentence.
    pub(crate) ended: String,
}

impl PibtRun {
    /// Out of what a planner told.
    ///
    /// # Errors
    /// How it ended, as a sentence, where it told of no steps.
    pub(crate) fn new(
        went: Went,
        found: (Option<Plan>, Option<Costs>),
        ended: String,
    ) -> Result<Rc<Self>, String> {
        let Went::Pibt { inherited, leaders } = went else {
            return Err(ended);
        };
        let (plan, costs) = found;
        Ok(Rc::new(Self {
            inherited,
            leaders,
            plan,
            costs,
            ended,
        }))
    }

    /// How many steps can be looked at.
    pub(crate) fn steps(&self) -> usize {
        let makespan = self.costs.map(|costs| costs.makespan as usize);
        makespan.unwrap_or(self.leaders.len())
    }

    /// The inheritances of a step.
    pub(crate) fn step(&self, time: usize) -> impl Iterator<Item = &Inherited> {
        let is_now = move |one: &&Inherited| one.time.is_some_and(|at| at as usize == time);
        self.inherited.iter().filter(is_now)
    }
}

pub(in crate::inside) fn column(state: &State) -> Option<Column> {
    let run = super::pibt(state)?;
    let (time, last, _) = steps::place(state)?;
    let mut column = Column {
        over: tr!("PIBT: priority inheritance with backtracking").to_owned(),
        title: if time < last {
            tr!("The step from {time} to {next}", time, next = time + 1)
        } else {
            tr!("The end, at {time}", time)
        },
        verdict: Some(verdict(run, time, last)),
        ..Column::default()
    };
    let pushes: Vec<Fact> = run.step(time).map(|one| push(state, run, one)).collect();
    if !pushes.is_empty() {
        column
            .facts
            .push((tr!("Who pushed whom").to_owned(), pushes));
    } else if time < last {
        column.why = vec![if time < run.leaders.len() {
            tr!("Nobody stood in the way of a robot that chose before.").to_owned()
        } else {
            tr!("Steps as late as this one were not recorded.").to_owned()
        }];
    }
    if time == 0 {
        column.means = Some(
            tr!("In each step robots choose their next cell one after the other. First is the one that is longest on its way. Where another robot stands on the cell that it wants, that one inherits its priority and chooses at once. If it finds no cell, the first one takes its next best.")
                .to_owned(),
        );
    }
    column.remark = Some(run.ended.clone());
    if let Some(costs) = run.costs {
        let objective = state.document.draft.scene().objective.costs();
        column.note = None;
        column.remark = Some(tr!(
            "PIBT found a plan: {costs}. There may be better ones.",
            costs = values(objective, &costs)
        ));
        column.foot = vec![Button::new(
            "start",
            tr!("First step"),
            (time > 0).then_some(InsideAction::First),
            false,
        )];
    }
    Some(column)
}

/// Who has priority.
fn verdict(run: &PibtRun, time: usize, last: usize) -> Verdict {
    match run.leaders.get(time).filter(|_| time < last) {
        Some(leader) => Verdict {
            tint: Tint::Info,
            word: tr!("{robot} chooses first", robot = leader),
            beside: String::new(),
            text: tr!("No robot has been on its way for longer.").to_owned(),
        },
        None if run.plan.is_some() && time >= last => Verdict {
            tint: Tint::Fine,
            word: tr!("All have arrived").to_owned(),
            beside: String::new(),
            text: String::new(),
        },
        None if run.plan.is_some() => Verdict {
            tint: Tint::Told,
            word: tr!("Not recorded").to_owned(),
            beside: String::new(),
            text: String::new(),
        },
        None => Verdict {
            tint: Tint::Stuck,
            word: tr!("a robot is" => "stuck").to_owned(),
            beside: String::new(),
            text: run.ended.clone(),
        },
    }
}

/// That a robot inherits the priority of another one, and what came of it.
fn push(state: &State, run: &PibtRun, one: &Inherited) -> Fact {
    let cell = crate::words::at(one.cell);
    let time = one.time.unwrap_or(0);
    let plan = run.plan.as_ref();
    let goes = |name: &str| at(plan?, name, time + 1);
    let small = match (goes(&one.from), goes(&one.to)) {
        (Some(lender), _) if lender != one.cell => tr!(
            "{heir} found no way on, so {robot} took another cell.",
            heir = one.to,
            robot = one.from
        ),
        (Some(_), Some(to)) => tr!(
            "{heir} goes to {to}.",
            heir = one.to,
            to = crate::words::at(to)
        ),
        _ => String::new(),
    };
    Fact {
        agent: index(state, &one.from),
        text: tr!(
            "{robot} wants {cell}, where {heir} stands: {heir} chooses next.",
            robot = one.from,
            cell,
            heir = one.to
        ),
        small,
    }
}
