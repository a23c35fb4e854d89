//! A robot comes late: who is pushed, by how much, and what that breaks.

use borsh::{BorshDeserialize, BorshSerialize};
use giveway_model::change::{Changes, MAX_DELAY};
use giveway_model::check::{Violation, check_changes};
use giveway_model::{Cell, Fault, Instance, Plan, tr};
use serde::{Deserialize, Serialize};

use crate::OrderGraph;
use crate::events::Time;
use crate::graph::step;
use crate::late_plan::late_plan;

/// The longest lateness, in steps.
pub const MAX_LATENESS: u32 = MAX_DELAY;

/// An agent that comes late to a cell: it begins its move into the cell so many steps later
/// than in the order without lateness. At its first cell it is ready that many steps later.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
#[serde(deny_unknown_fields)]
pub struct Lateness {
    /// Its name.
    pub agent: String,
    /// The cell.
    pub cell: Cell,
    /// Which of its visits of the cell is meant, from 1.
    #[serde(default = "first", skip_serializing_if = "is_first")]
    pub visit: u32,
    /// How late it comes, in steps.
    pub steps: u32,
}

const fn first() -> u32 {
    1
}

#[expect(
    clippy::trivially_copy_pass_by_ref,
    reason = "serde hands in a reference"
)]
const fn is_first(visit: &u32) -> bool {
    *visit == 1
}

/// Why a lateness is none.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum LatenessError {
    /// No agent of the plan has the name.
    NoAgent(String),
    /// The agent is not there so often.
    NoVisit(Lateness),
    /// It is too long.
    TooLong(u32),
}

impl LatenessError {
    /// The fault of a list of latenesses, at the place of the one in question.
    pub fn fault(&self, index: usize) -> Fault {
        let place = |key: &str| format!("late[{index}].{key}");
        match self {
            Self::NoAgent(name) => Fault::at(
                place("agent"),
                format!("\"{name}\""),
                tr!("a robot of the plan"),
            ),
            Self::NoVisit(late) => {
                let (agent, cell, visit) = (&late.agent, late.cell, late.visit);
                match visit {
                    1 => Fault::at(
                        place("cell"),
                        tr!("{agent} at {cell}", agent, cell),
                        tr!("a cell that the robot visits in the plan"),
                    ),
                    _ => Fault::at(
                        place("visit"),
                        tr!("visit {visit} of {agent} at {cell}", visit, agent, cell),
                        tr!("one that the plan has"),
                    ),
                }
            }
            Self::TooLong(steps) => Fault::at(
                place("steps"),
                steps.to_string(),
                tr!("at most {most}", most = MAX_LATENESS),
            ),
        }
    }
}

/// An agent's arrival without and with the lateness.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
pub struct Arrival {
    /// Its name.
    pub agent: String,
    /// When it comes to its last cell without lateness.
    pub planned: u32,
    /// When it comes there now; `null` where it is removed before.
    pub now: Option<u32>,
    /// By how much it is late at most, at any of its cells.
    pub most: u32,
}

/// A visit at another time than without lateness.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
pub struct LateVisit {
    /// The agent's name.
    pub agent: String,
    /// The number of the visit, from 0.
    pub visit: u32,
    /// The cell.
    pub cell: Cell,
    /// When it arrives without lateness.
    pub planned: u32,
    /// When it arrives now.
    pub now: u32,
}

/// What follows if some agents come late and all keep to the order.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
pub struct Outcome {
    /// Who comes late.
    pub late: Vec<Lateness>,
    /// All agents of the plan, in the order in which they came.
    pub arrivals: Vec<Arrival>,
    /// The visits that are later than without lateness, by agent.
    pub visits: Vec<LateVisit>,
    /// The plan as it is carried out.
    pub plan: Plan,
    /// What that plan breaks: a battery that does not bear the lateness, a rule of the scene's
    /// own, an obstacle that moves or that a change brings. No two agents collide in it.
    pub violations: Vec<Violation>,
    /// Changes that contradict the world as that plan has it.
    pub refused: Vec<String>,
}

impl Outcome {
    /// The agents that are pushed though they do not come late themselves, with how many
    /// steps at most.
    pub fn pushed(&self) -> impl Iterator<Item = &Arrival> {
        let own = |name: &str| self.late.iter().any(|late| late.agent == name);
        let arrivals = self.arrivals.iter();
        arrivals.filter(move |it| it.most > 0 && !own(&it.agent))
    }
}

impl OrderGraph<'_> {
    /// What follows from some latenesses. `instance` is that of which the history was made.
    ///
    /// # Errors
    /// The first lateness that does not fit the plan, with its number in the list.
    pub fn late(
        &self,
        instance: &Instance,
        late: &[Lateness],
    ) -> Result<Outcome, (usize, LatenessError)> {
        let begins = self.late_begins(late)?;
        let plan = late_plan(self, &begins);
        let (violations, refused) = match check_changes(instance, &self.put_off(&begins), &plan) {
            Ok(report) => (report.violations, Vec::new()),
            Err(faults) => (Vec::new(), faults.iter().map(ToString::to_string).collect()),
        };
        let (arrivals, visits) = self.moved(&begins);
        Ok(Outcome {
            late: late.to_vec(),
            arrivals,
            visits,
            plan,
            violations,
            refused,
        })
    }

    /// The begin of each event under some latenesses.
    fn late_begins(&self, late: &[Lateness]) -> Result<Vec<Time>, (usize, LatenessError)> {
        let mut release = self.begins.clone();
        for (index, one) in late.iter().enumerate() {
            let event = self.late_event(one).map_err(|error| (index, error))?;
            if let Some(time) = release.get_mut(event) {
                *time = (*time).max(self.begin(event) + Time::from(one.steps));
            }
        }
        let release = |event: usize| release.get(event).copied().unwrap_or(0);
        Ok(self.timing().begins(&release))
    }

    fn late_event(&self, late: &Lateness) -> Result<usize, LatenessError> {
        if late.steps > MAX_LATENESS {
            return Err(LatenessError::TooLong(late.steps));
        }
        let way = self.ways.iter().find(|way| way.name() == late.agent);
        let way = way.ok_or_else(|| LatenessError::NoAgent(late.agent.clone()))?;
        let visits = (way.first..).zip(&way.stays);
        let mut visits = visits.filter(|(_, stay)| stay.cell == late.cell);
        let nth = (late.visit as usize).checked_sub(1);
        let visit = nth.and_then(|nth| visits.nth(nth));
        let found = visit.map(|(event, _)| event);
        found.ok_or_else(|| LatenessError::NoVisit(late.clone()))
    }

    /// The changes, where an agent appears later since its cell is not left yet.
    fn put_off(&self, begins: &[Time]) -> Changes {
        let mut changes = self.changes.clone();
        for change in &mut changes.changes {
            if let giveway_model::change::What::AddAgent { agent } = &change.what
                && let Some(way) = self.ways.iter().find(|way| way.name() == agent.name)
                && let Some(&begin) = begins.get(way.first)
            {
                change.at = step(begin + 1);
            }
        }
        changes
    }

    /// Arrivals and visits, compared with those without lateness.
    fn moved(&self, begins: &[Time]) -> (Vec<Arrival>, Vec<LateVisit>) {
        let (mut arrivals, mut visits) = (Vec::new(), Vec::new());
        let timing = self.timing();
        for way in &self.ways {
            let mut arrival = Arrival {
                agent: way.name().to_owned(),
                planned: 0,
                now: None,
                most: 0,
            };
            for ((event, stay), number) in (way.first..).zip(&way.stays).zip(0..) {
                let planned = step(timing.arrives(event, self.begin(event)));
                let begin = begins.get(event).copied().unwrap_or(0);
                let now = step(timing.arrives(event, begin));
                arrival.planned = planned;
                arrival.now = way.until().is_none_or(|until| now < until).then_some(now);
                if arrival.now.is_none() {
                    continue;
                }
                arrival.most = arrival.most.max(now.saturating_sub(planned));
                if planned < now {
                    visits.push(LateVisit {
                        agent: way.name().to_owned(),
                        visit: number,
                        cell: stay.cell,
                        planned,
                        now,
                    });
                }
            }
            arrivals.push(arrival);
        }
        (arrivals, visits)
    }
}
