//! What all best plans share of the robot or the cell that is selected: could it be later, must
//! it pass here?

use giveway_model::{Cell, tr};
use giveway_solve::freedom::{FreedomAnswer, Known, PlanCount};

use super::column::{detail, sentence};
use super::words::{how_many, outcome, reach};
use super::{Chip, Freedom, chip};
use crate::timeline::Lane;
use crate::words::at;
use crate::{Selection, State};

/// What is told of it, or could be asked.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Part {
    /// What is known, a sentence each.
    pub facts: Vec<String>,
    /// What could be asked.
    pub asks: Vec<String>,
    /// What closing the cell would come to: it can be closed for a look.
    pub closing: Option<(Cell, String)>,
}

/// The most robots that are told of.
const AGENTS: usize = 4;

/// What all best plans share of what is selected; `None` where nothing is, or nothing is known
/// or could be asked.
pub fn part(state: &State) -> Option<Part> {
    let part = match (chip(state), state.freedom()) {
        (Chip::On, Some(freedom)) => {
            let told = freedom.told.as_deref();
            let (part, is_known, open) = match state.view.selection {
                Selection::Agent(agent) => (
                    told.map(|told| of_agent(freedom, told, agent)),
                    told.is_some_and(|told| told.slack.is_some()),
                    tr!("Whether it could be later was not found out."),
                ),
                Selection::Cell(cell) => (
                    told.map(|told| of_cell(freedom, told, cell)),
                    told.is_some_and(|told| told.backbone.is_some()),
                    tr!("Who must be here was not found out."),
                ),
                Selection::Nothing => return None,
            };
            let mut part = part.unwrap_or_default();
            if !is_known && !state.is_counting() {
                part.facts.push(open.to_owned());
            }
            part
        }
        (Chip::Ready, _) => Part {
            asks: asks(state),
            ..Part::default()
        },
        _ => return None,
    };
    (part != Part::default()).then_some(part)
}

/// What could be asked of what is selected.
fn asks(state: &State) -> Vec<String> {
    let Some(answer) = state.document.fresh_answer() else {
        return Vec::new();
    };
    let agents = answer.draft.agents();
    match state.view.selection {
        Selection::Agent(agent) => {
            let name = agents.get(agent).map(|agent| &agent.name);
            let ask = |name| tr!("Could {name} be later?", name);
            name.map(ask).into_iter().collect()
        }
        Selection::Cell(cell) => {
            let passes = |(index, agent): (usize, &giveway_model::Agent)| {
                let must = agent.start == cell || agent.goal == Some(cell);
                let lane = Lane::of(answer, index)?;
                let passes = lane.steps.iter().any(|step| step.to == cell);
                let ask = || tr!("Must {agent} pass here?", agent = agent.name);
                (passes && !must && !agent.waypoints.contains(&cell)).then(ask)
            };
            let asks = agents.iter().enumerate().filter_map(passes);
            asks.take(AGENTS).collect()
        }
        Selection::Nothing => Vec::new(),
    }
}

fn of_agent(freedom: &Freedom, told: &FreedomAnswer, agent: usize) -> Part {
    let mut part = Part::default();
    let Some((_, name)) = freedom.names().find(|&(index, _)| index == agent) else {
        return part;
    };
    if let Some(slack) = told.slack.as_ref().and_then(|slack| slack.get(name)) {
        let late = slack.late();
        let late = late.map(|hold| sentence(told, freedom, (agent, name), hold));
        let detail = detail(told, freedom, agent, slack);
        let detail = (!detail.is_empty()).then(|| giveway_model::words::capital(&detail));
        part.facts
            .extend(late.into_iter().chain(detail).map(|fact| fact + "."));
    }
    let ways = told.plans.as_ref().and_then(|plans| plans.ways.get(name));
    part.facts.extend(ways.map(|ways| match ways.number {
        PlanCount::Exactly(1) => tr!("Every step of it is fixed.").to_owned(),
        number => tr!(
            "It has {many} ways to choose from.",
            many = how_many(number)
        ),
    }));
    part
}

fn of_cell(freedom: &Freedom, told: &FreedomAnswer, cell: Cell) -> Part {
    let mut part = Part::default();
    for (_, name) in freedom.names() {
        let visits = told.backbone.as_ref().and_then(|all| all.get(name));
        let mut here = visits.into_iter().flatten();
        let here = here.find(|visit| visit.cell == Some(cell));
        let ways = told.plans.as_ref().and_then(|plans| plans.ways.get(name));
        let mut steps = ways.into_iter().flat_map(|ways| &ways.steps);
        let fact = match here {
            Some(visit) => match visit.always {
                Known::Yes => tr!(
                    "{name} must be here at time {time}.",
                    name,
                    time = visit.time
                ),
                Known::No if visit.only.is_proved() => {
                    tr!(
                        "{name} is here at time {time} in this plan alone.",
                        name,
                        time = visit.time
                    )
                }
                Known::No => tr!(
                    "{name} need not be here at time {time}.",
                    name,
                    time = visit.time
                ),
                Known::Open => tr!(
                    "Whether {name} must be here at time {time} is open.",
                    name,
                    time = visit.time
                ),
            },
            None if steps.any(|step| step.to == cell) => {
                tr!("{name} may pass here: in another best plan it does.", name)
            }
            None => continue,
        };
        if part.facts.len() < AGENTS {
            part.facts.push(fact);
        }
    }
    if let Some(closed) = freedom.closed(cell) {
        let outcome = outcome(told, closed);
        part.closing = outcome.map(|outcome| {
            (
                cell,
                tr!("Close {cell}: {outcome}", cell = at(cell), outcome),
            )
        });
        part.facts.extend(reach(closed));
    } else if told
        .critical
        .iter()
        .flatten()
        .any(|it| it.cell == cell && it.closed.is_harmless())
    {
        part.facts
            .push(tr!("Closing it would cost nothing.").to_owned());
    }
    part
}
