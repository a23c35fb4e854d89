//! A robot is late: the sentence with its slots, who is pushed, what that breaks.

use giveway_model::{Cell, tr};
use giveway_order::{Arrival, Lateness, Order, Outcome, words};

use super::crossing::{index, visits_at};
use super::known::LateOutcome;
use crate::State;
use crate::words::at;

/// The longest lateness that is said, in steps.
pub const MOST_LATE: u32 = 999;
/// The lateness that is asked about first.
const FIRST: u32 = 3;
/// At most so many broken rules are told.
const MOST_TOLD: usize = 6;

/// The lateness that is asked about.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct LateView {
    /// The robot.
    pub(crate) agent: String,
    /// The visit that it comes late to, by its number from 0.
    pub(crate) visit: usize,
    /// How late, in steps.
    pub(crate) steps: u32,
}

impl LateView {
    /// The same as the solver takes it; `None` where there is no such visit.
    pub(crate) fn lateness(&self, order: &Order) -> Option<Lateness> {
        let agent = order.agent(&self.agent)?;
        let cell = agent.visits.get(self.visit)?.cell;
        let before = visits_at(agent, cell).take_while(|&number| number < self.visit);
        Some(Lateness {
            agent: self.agent.clone(),
            cell,
            visit: before.count() as u32 + 1,
            steps: self.steps,
        })
    }
}

/// What is asked about first: the robot in the cell or the next one to come there, at the
/// time shown.
pub(crate) fn first(state: &State) -> Option<LateView> {
    let order = state.order()?;
    let time = state.view.playback.time;
    let passes = super::crossing::passes(state, state.order_cell()?);
    let next = passes.iter().find(|pass| pass.arrives >= time);
    let (agent, visit) = match next.or(passes.first()) {
        Some(pass) => (pass.name.clone(), pass.visit),
        None => (order.agents.first()?.agent.clone(), 0),
    };
    Some(LateView {
        agent,
        visit,
        steps: FIRST,
    })
}

/// What follows from the lateness that is asked about, where that is known.
pub(super) fn outcome(state: &State) -> Option<&LateOutcome> {
    let asked = state.view.order.late.as_ref()?.lateness(state.order()?)?;
    let late = state.order_known()?.late.as_deref()?;
    (late.outcome.late == [asked]).then_some(late)
}

/// The sentence with its slots, and what follows.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LateCard {
    /// The robots, and whether each is the late one.
    pub robots: Vec<(String, bool)>,
    /// How late it comes, in steps.
    pub steps: u32,
    /// The cells of its way: the number of the visit, its words, whether it is the one.
    pub cells: Vec<(usize, String, bool)>,
    /// How many are pushed; `None` before that is known.
    pub title: Option<String>,
    /// Who is pushed and when the last one arrives.
    pub sentence: String,
    /// What the late plan breaks, a sentence each.
    pub broken: Vec<String>,
    /// The button that looks for new plans from the lateness on; nothing before what follows is
    /// known, and where what is at that time is settled.
    pub replan: Option<String>,
    /// When each arrives; the last row is that of the last arrival.
    pub arrivals: Vec<ArrivalRow>,
}

/// When a robot arrives.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ArrivalRow {
    /// Its index; `None` for the last arrival of all.
    pub agent: Option<usize>,
    /// Its name.
    pub name: String,
    /// When it arrives without lateness.
    pub planned: u32,
    /// When it arrives now, in words.
    pub now: String,
    /// How much later that is, in words.
    pub by: String,
    /// Whether it is later.
    pub is_late: bool,
}

/// The sentence and what follows; `None` where it is not asked.
pub(super) fn card(state: &State) -> Option<LateCard> {
    let (order, said) = (state.order()?, state.view.order.late.as_ref()?);
    let agent = order.agent(&said.agent)?;
    let robots = order.agents.iter();
    let cells = agent.visits.iter().enumerate();
    let mut card = LateCard {
        robots: robots
            .map(|it| (it.agent.clone(), it.agent == said.agent))
            .collect(),
        steps: said.steps,
        cells: cells
            .map(|(number, visit)| {
                let times = visits_at(agent, visit.cell).position(|it| it == number);
                let is_said = number == said.visit;
                (number, cell_words(visit.cell, times.unwrap_or(0)), is_said)
            })
            .collect(),
        title: None,
        sentence: String::new(),
        broken: Vec::new(),
        replan: None,
        arrivals: Vec::new(),
    };
    if let Some(late) = outcome(state) {
        fill(&mut card, state, &late.outcome);
        card.replan = begins(state).map(|time| tr!("Find new plans from {time}", time));
    }
    Some(card)
}

/// When the lateness begins in the plan: the robot would begin its move to the cell then. `None`
/// where what is at that time is settled.
pub(crate) fn begins(state: &State) -> Option<u32> {
    let (order, said) = (state.order()?, state.view.order.late.as_ref()?);
    let visit = order.agent(&said.agent)?.visits.get(said.visit)?;
    let comes = visit.comes.unwrap_or(visit.arrives);
    // The order may begin a move later than the plan.
    let mut later = order.later.iter();
    let later = later.find(|shift| {
        shift.agent == said.agent && shift.cell == visit.cell && shift.begins == comes
    });
    let time = later.map_or(comes, |shift| shift.planned);
    let settled = state.document.changed_last();
    settled.is_none_or(|last| time > last).then_some(time)
}

/// `(4, 1)`, and for a later visit of it which one.
fn cell_words(cell: Cell, times: usize) -> String {
    let cell = at(cell);
    match times as u32 {
        0 => cell,
        before => tr!("{cell}, visit {visit}", cell, visit = before + 1),
    }
}

fn fill(card: &mut LateCard, state: &State, outcome: &Outcome) {
    let count = outcome.pushed().count() as u32;
    card.title = Some(if count == 0 {
        tr!("No other robot is pushed").to_owned()
    } else {
        tr!("{n} robot is pushed" | "{n} robots are pushed" % count)
    });
    let pushed = words::pushed(outcome);
    let last = words::last_arrival(outcome);
    card.sentence = std::iter::once(pushed)
        .chain(last)
        .collect::<Vec<_>>()
        .join(" ");
    card.broken = broken(outcome);
    card.arrivals = outcome.arrivals.iter().map(|it| row(state, it)).collect();
    let planned = outcome.arrivals.iter().map(|it| it.planned).max();
    let now = outcome.arrivals.iter().filter_map(|it| it.now).max();
    if let (Some(planned), Some(now)) = (planned, now) {
        card.arrivals.push(ArrivalRow {
            agent: None,
            name: tr!("Last arrival").to_owned(),
            planned,
            now: now.to_string(),
            by: by(planned, now),
            is_late: now > planned,
        });
    }
}

/// What the late plan breaks: batteries, rules, changes of the world.
fn broken(outcome: &Outcome) -> Vec<String> {
    let broken = outcome.violations.iter().map(|it| it.message.clone());
    let broken = broken.chain(outcome.refused.iter().cloned());
    broken.take(MOST_TOLD).collect()
}

fn row(state: &State, arrival: &Arrival) -> ArrivalRow {
    let planned = arrival.planned;
    ArrivalRow {
        agent: index(state, &arrival.agent),
        name: arrival.agent.clone(),
        planned,
        now: arrival
            .now
            .map_or_else(|| "\u{2013}".to_owned(), |now| now.to_string()),
        by: arrival.now.map_or_else(String::new, |now| by(planned, now)),
        is_late: arrival.now.is_some_and(|now| now > planned),
    }
}

fn by(planned: u32, now: u32) -> String {
    match now.saturating_sub(planned) {
        0 => tr!("a time" => "same").to_owned(),
        later => format!("+{later}"),
    }
}

/// What the status says while the late plan is on the board.
pub(crate) fn status(state: &State) -> Option<String> {
    let outcome = &outcome(state)?.outcome;
    let late: Vec<String> = outcome.late.iter().map(words::lateness).collect();
    let late = giveway_model::words::sentence(&giveway_model::words::and(&late));
    let last = words::last_arrival(outcome);
    Some(
        [Some(late), last]
            .into_iter()
            .flatten()
            .collect::<Vec<_>>()
            .join(" "),
    )
}
