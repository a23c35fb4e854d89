//! What the column says of a step of `LaCAM`: which configuration it made, at which depth, and
//! which come again.

use std::collections::BTreeMap;
use std::rc::Rc;

use giveway_model::words::values;
use giveway_model::{Agent, Cell, Costs, Plan, tr};
use giveway_solve::plan::{LacamEvent, Went};

use crate::State;
use crate::inside::column::{Column, Fact, Tint, Verdict};
use crate::inside::{index, steps};

/// The search of `LaCAM`.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct LacamRun {
    /// Its steps, the first of them.
    pub(crate) events: Vec<LacamEvent>,
    /// The configurations by number: the one that it was made from first, and how deep it is.
    made: BTreeMap<u32, (u32, usize)>,
    /// Where robots are in them, in the order of the scene.
    cells: BTreeMap<u32, Vec<Cell>>,
    /// The costs of the best plan.
    pub(crate) costs: Option<Costs>,
    /// How it ended, in a sentence.
    pub(crate) ended: String,
}

impl LacamRun {
    /// Out of what a planner told.
    ///
    /// # Errors
    /// How it ended, as a sentence, where it told of no steps.
    pub(crate) fn new(
        went: Went,
        agents: &[Agent],
        costs: Option<Costs>,
        ended: String,
    ) -> Result<Rc<Self>, String> {
        let Went::Lacam { events } = went else {
            return Err(ended);
        };
        let mut made = BTreeMap::from([(0, (0, 0))]);
        let starts = agents.iter().map(|agent| agent.start).collect();
        let mut cells = BTreeMap::from([(0, starts)]);
        for event in &events {
            if let Some(id) = event.made.filter(|_| !event.known) {
                let depth = made.get(&event.from).map_or(0, |(_, depth)| depth + 1);
                made.entry(id).or_insert((event.from, depth));
                if !event.cells.is_empty() {
                    cells.entry(id).or_insert_with(|| event.cells.clone());
                }
            }
        }
        Ok(Rc::new(Self {
            events,
            made,
            cells,
            costs,
            ended,
        }))
    }

    /// Where robots are in a configuration, in the order of the scene; nothing where that was
    /// not told.
    pub(crate) fn cells(&self, id: u32) -> &[Cell] {
        self.cells.get(&id).map_or(&[], Vec::as_slice)
    }

    /// How deep a configuration is: how many steps lead to it.
    pub(crate) fn depth(&self, id: u32) -> usize {
        self.made.get(&id).map_or(0, |(_, depth)| *depth)
    }

    /// The configuration after so many steps of the search: the one that was made, else the one
    /// that it was tried from.
    pub(crate) fn configuration(&self, step: usize) -> u32 {
        let event = step.checked_sub(1).and_then(|place| self.events.get(place));
        event.map_or(0, |event| event.made.unwrap_or(event.from))
    }

    /// The steps that lead to a configuration, as a plan; `None` where its cells were not told.
    pub(crate) fn plan(&self, id: u32, agents: &[Agent]) -> Option<Plan> {
        let mut line = vec![id];
        let mut at = id;
        while at != 0 && line.len() <= self.made.len() {
            at = self.made.get(&at)?.0;
            line.push(at);
        }
        let mut plan = Plan::default();
        for (place, agent) in agents.iter().enumerate() {
            let cell = |id: &u32| self.cells.get(id)?.get(place).copied();
            let path: Option<Vec<Cell>> = line.iter().rev().map(cell).collect();
            let path = path?.into_iter().map(Some).collect();
            plan.paths.insert(agent.name.clone(), path);
        }
        Some(plan)
    }
}

pub(in crate::inside) fn column(state: &State) -> Option<Column> {
    let run = super::lacam(state)?;
    let (at, last, _) = steps::place(state)?;
    let event = at.checked_sub(1).and_then(|place| run.events.get(place));
    let id = run.configuration(at);
    let mut column = Column {
        over: tr!("LaCAM: a search over configurations").to_owned(),
        title: match event {
            None => tr!("The start").to_owned(),
            Some(_) => tr!(
                "Configuration {id}, after {n} step"
                    | "Configuration {id}, after {n} steps" % run.depth(id),
                id
            ),
        },
        verdict: Some(verdict(run, event)),
        ..Column::default()
    };
    if let Some(event) = event {
        let names = event.constrained.iter().zip(&event.constraints);
        let asked: Vec<Fact> = names
            .map(|(name, cell)| Fact {
                agent: index(state, name),
                text: tr!(
                    "{robot} has to go to {cell}",
                    robot = name,
                    cell = crate::words::at(*cell)
                ),
                small: String::new(),
            })
            .collect();
        if !asked.is_empty() {
            column
                .facts
                .push((tr!("What it was asked").to_owned(), asked));
        }
        let pushes = event.inherited.iter().map(|one| Fact {
            agent: index(state, &one.from),
            text: tr!(
                "{robot} wants {cell}, where {heir} stands: {heir} chooses next.",
                robot = one.from,
                cell = crate::words::at(one.cell),
                heir = one.to
            ),
            small: String::new(),
        });
        let pushes: Vec<Fact> = pushes.collect();
        if !pushes.is_empty() {
            column
                .facts
                .push((tr!("Who pushed whom").to_owned(), pushes));
        }
    } else {
        column.means = Some(
            tr!("A configuration is where all robots are at one time. From the one that was made last, PIBT makes the next one. Where that is known already, the search looks at it again: it goes on from there, and each time one robot more is told where to go. So in time every configuration is made.")
                .to_owned(),
        );
    }
    column
        .facts
        .push((tr!("The search so far").to_owned(), so_far(run, at)));
    if at == last {
        let objective = state.document.draft.scene().objective.costs();
        column.remark = Some(run.costs.map_or_else(
            || run.ended.clone(),
            |costs| {
                tr!(
                    "LaCAM found a plan: {costs}. There may be better ones.",
                    costs = values(objective, &costs)
                )
            },
        ));
    }
    Some(column)
}

/// What became of a step.
fn verdict(run: &LacamRun, event: Option<&LacamEvent>) -> Verdict {
    let say = |tint, word: &str, text: String| Verdict {
        tint,
        word: word.to_owned(),
        beside: String::new(),
        text,
    };
    let Some(event) = event else {
        return say(
            Tint::Told,
            tr!("All robots are at their starts"),
            tr!("It is configuration 0.").to_owned(),
        );
    };
    let from = event.from;
    match (event.made, event.known) {
        (Some(_), false) => say(
            Tint::Info,
            tr!("a configuration is" => "New"),
            tr!("It was made from configuration {from}.", from),
        ),
        (Some(id), true) => say(
            Tint::Told,
            tr!("a configuration is" => "Known already"),
            if run.depth(id) > run.depth(from) + 1 {
                tr!(
                    "From configuration {from} it is reached sooner. The search goes on from it again.",
                    from
                )
            } else {
                tr!(
                    "It was made from configuration {from}, too. The search goes on from it again.",
                    from
                )
            },
        ),
        (None, _) => say(
            Tint::Stuck,
            tr!("No configuration"),
            tr!(
                "With what was asked, some robot finds no cell. Configuration {from} is tried again, asked otherwise.",
                from
            ),
        ),
    }
}

/// How much the search has made after so many steps.
fn so_far(run: &LacamRun, at: usize) -> Vec<Fact> {
    let events = || run.events.iter().take(at);
    let new = events().filter(|event| event.made.is_some() && !event.known);
    let deepest = new
        .clone()
        .filter_map(|event| event.made)
        .map(|id| run.depth(id))
        .max();
    let (new, again, none) = (
        new.count() + 1,
        events().filter(|event| event.known).count(),
        events().filter(|event| event.made.is_none()).count(),
    );
    let fact = |text: String| Fact {
        agent: None,
        text,
        small: String::new(),
    };
    let mut facts = vec![fact(tr!(
        "{n} configuration, depth at most {deepest}"
            | "{n} configurations, depth at most {deepest}" % new,
        deepest = deepest.unwrap_or(0)
    ))];
    if again > 0 {
        facts.push(fact(tr!(
            "{n} time a known one came again" | "{n} times a known one came again" % again
        )));
    }
    if none > 0 {
        facts.push(fact(tr!(
            "{n} time there was none" | "{n} times there was none" % none
        )));
    }
    facts
}
