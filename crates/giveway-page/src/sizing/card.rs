//! What the inspector says of it: the sentence, how far it has come, and what follows.

use giveway_model::{Battery, Cell, tr};
use giveway_solve::sizing::{Finding, findings, words};

use super::{Beside, Said};
use crate::words::at;
use crate::{Draft, State};

/// The sentence with its slots, and what is known.
#[derive(Clone, Debug, PartialEq)]
pub struct Card {
    /// The first number of robots.
    pub from: u32,
    /// The last one.
    pub to: u32,
    /// How many more each time.
    pub by: u32,
    /// Whether half of them go the other way.
    pub back: bool,
    /// How many waypoints each has.
    pub waypoints: u32,
    /// Their battery.
    pub battery: Option<Battery>,
    /// The time limit of each solve, in seconds.
    pub seconds: u32,
    /// The number of the draw.
    pub draw: u32,
    /// Where they start and go, as a sentence.
    pub rows: String,
    /// What stands beside it: `nothing`, `one charger more at (0, 7)`.
    pub beside: String,
    /// What can stand beside it: its words, and whether it is chosen.
    pub choices: Vec<(Option<Beside>, String, bool)>,
    /// Whether the next press on the board is the cell of a charger.
    pub is_picking: bool,
    /// What can be done, or why less can than was asked for.
    pub told: String,
    /// The button that solves all; `None` while that is done, and where nothing can be solved.
    pub solve: Option<String>,
    /// How far it has come, while it is solved.
    pub progress: Option<Progress>,
    /// What follows from the figures.
    pub says: Vec<FindingRow>,
    /// The button that takes the robots that are looked at.
    pub take: Option<String>,
}

/// How far the solves have come.
#[derive(Clone, Debug, PartialEq)]
pub struct Progress {
    /// In words: `20 of 22 plans, solving 40 robots`.
    pub text: String,
    /// From 0 to 1.
    pub share: f64,
}

/// What follows from the figures.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FindingRow {
    /// Its icon.
    pub icon: &'static str,
    /// The fact.
    pub text: String,
    /// What is said of it in small print.
    pub small: String,
    /// The plan that it is seen in, by its place.
    pub place: Option<usize>,
}

/// What is said and known; `None` where it is not open.
pub fn card(state: &State) -> Option<Card> {
    let said = state
        .view
        .sizing
        .said
        .as_ref()
        .filter(|_| state.shows_sizing())?;
    let draft = &state.own_document().draft;
    let run = state.sizing();
    let counts = said.counts(draft);
    let looked = state.view.sizing.looked.as_ref();
    let take = looked.and_then(|looked| {
        let robots = run?.answer.points.get(looked.place)?.robots;
        Some(tr!("Take this {n} robot" | "Take these {n} robots" % robots))
    });
    let floors = if said.beside.is_some() { 2 } else { 1 };
    let solve = (!state.is_sizing() && !counts.is_empty() && looked.is_none())
        .then(|| tr!("Solve {n} plan" | "Solve {n} plans" % counts.len() * floors));
    Some(Card {
        from: said.from,
        to: said.to,
        by: said.by,
        back: said.fleet.back,
        waypoints: said.fleet.waypoints,
        battery: said.fleet.battery,
        seconds: said.seconds,
        draw: said.fleet.draw,
        rows: rows(said),
        beside: beside_words(draft, said.beside)
            .unwrap_or_else(|| tr!("beside it stands" => "nothing").to_owned()),
        choices: choices(draft, said.beside),
        is_picking: state.view.sizing.is_picking,
        told: told(state, said, draft),
        solve,
        progress: state.is_sizing().then(|| progress(state)).flatten(),
        says: says(state),
        take,
    })
}

/// Where robots start and go.
fn rows(said: &Said) -> String {
    let row = |(from, to): (Cell, Cell)| tr!("{from} to {to}", from = at(from), to = at(to));
    let goals = said.fleet.goals.map(row).unwrap_or_default();
    tr!(
        "Starts along {starts}, goals along {goals}.",
        starts = row(said.fleet.starts),
        goals
    )
}

/// What differs on the floor that is compared, in a few words.
pub(super) fn beside_words(draft: &Draft, beside: Option<Beside>) -> Option<String> {
    Some(match beside? {
        Beside::Charger(cell) => {
            let is_there = draft
                .grid()
                .ground(cell)
                .is_some_and(giveway_model::Ground::is_charger);
            if is_there {
                tr!("one charger less at {cell}", cell = at(cell))
            } else {
                tr!("one charger more at {cell}", cell = at(cell))
            }
        }
        Beside::Rule(rule) => {
            let constraint = draft.scene().constraints.get(rule)?;
            let words = constraint.sentence();
            if constraint.off {
                tr!("with the rule: {rule}", rule = words)
            } else {
                tr!("without the rule: {rule}", rule = words)
            }
        }
    })
}

/// What can stand beside it: nothing, a charger, each rule that names no robot.
fn choices(draft: &Draft, chosen: Option<Beside>) -> Vec<(Option<Beside>, String, bool)> {
    let nothing = (
        None,
        tr!("beside it stands" => "nothing").to_owned(),
        chosen.is_none(),
    );
    let charger = chosen.filter(|it| matches!(it, Beside::Charger(_)));
    let rules = draft.scene().constraints.iter().enumerate();
    let rules = rules.filter(|(_, rule)| rule.named_agents().next().is_none());
    let others = charger
        .into_iter()
        .chain(rules.map(|(index, _)| Beside::Rule(index)));
    let others = others.filter_map(|beside| {
        let words = beside_words(draft, Some(beside))?;
        Some((Some(beside), words, chosen == Some(beside)))
    });
    std::iter::once(nothing).chain(others).collect()
}

fn told(state: &State, said: &Said, draft: &Draft) -> String {
    let most = said.most(draft);
    if state.view.sizing.is_picking {
        tr!("Now press the cell of a charger more, or less.").to_owned()
    } else if most < said.to {
        tr!("There is room for {most} robots in both rows.", most)
    } else if draft
        .scene()
        .constraints
        .iter()
        .any(|rule| rule.named_agents().next().is_some())
    {
        tr!("Rules that name a robot of yours do not count here.").to_owned()
    } else {
        tr!("Your own robots stay as they are. For other rows draw them with the tool Robot: starts, then goals.").to_owned()
    }
}

fn progress(state: &State) -> Option<Progress> {
    let run = state.sizing()?;
    let (known, all) = (run.known(), run.all());
    let floors = if run.request.beside.is_some() { 2 } else { 1 };
    let robots = run.request.counts.get(known / floors)?;
    Some(Progress {
        text: tr!(
            "{known} of {all} plans, solving {robots} robots",
            known,
            all,
            robots
        ),
        share: known as f64 / all.max(1) as f64,
    })
}

/// What the status says of a plan of more robots that is only looked at.
pub(crate) fn looked(state: &State) -> Option<String> {
    let looked = state.view.sizing.looked.as_ref()?;
    let run = state.sizing()?;
    let point = run.answer.points.get(looked.place)?;
    let plan = words::point(&run.answer, point);
    Some(tr!("Only looked at: {plan}", plan))
}

/// What the status says while it is solved.
pub(crate) fn doing(state: &State) -> String {
    progress(state).map_or_else(
        || tr!("Solving more and more robots.").to_owned(),
        |progress| giveway_model::words::sentence(&progress.text),
    )
}

fn says(state: &State) -> Vec<FindingRow> {
    let Some(run) = state.sizing() else {
        return Vec::new();
    };
    let other = beside_words(&run.draft, run.said.beside).unwrap_or_default();
    let place = |robots: u32| run.answer.points.iter().position(|it| it.robots == robots);
    let row = |finding: &Finding| {
        let (text, small) = words::finding_parts(finding, &other);
        let (icon, robots) = match finding {
            Finding::Later { from, .. } => ("end", *from),
            Finding::Delay { robots, .. } => ("clock", *robots),
            Finding::Saves { robots, .. } | Finding::Sooner { robots, .. } => ("charger", *robots),
            Finding::NoPlan { robots, .. } | Finding::NotSolved { robots } => ("warning", *robots),
        };
        FindingRow {
            icon,
            text,
            small,
            place: place(robots).filter(|&place| run.answer.points[place].plan.is_some()),
        }
    };
    findings(&run.answer).iter().map(row).collect()
}
