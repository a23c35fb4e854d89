//! How far an answer has come: its layers in order, what is done now, and the places that are held
//! for what is still to come.

use giveway_model::{Question, tr, words::decimal};
use giveway_solve::explain::{ExplainAnswer, Layer, Part, Verdict};

use super::Card;
use crate::ask::signs::pending;
use crate::{Asking, State};

/// All parts of an answer.
const PARTS: [Part; 7] = [
    Part::Here,
    Part::Near,
    Part::Verdict,
    Part::Closest,
    Part::Witness,
    Part::Core,
    Part::Repairs,
];

/// So many robots have a place in the table before it is known who pays.
const ROWS: u32 = 5;

/// How far an answer has come.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Coming {
    /// The layers of the answer, the quickest first.
    pub layers: Vec<LayerStep>,
    /// Whether more is looked for.
    pub is_looking: bool,
    /// What is looked for now, or that the search ended.
    pub doing: String,
    /// The places held for what is to come.
    pub held: Held,
}

/// A layer and how far it has come.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LayerStep {
    /// Its name.
    pub name: &'static str,
    /// How far it has come.
    pub reached: Reached,
}

/// How far a layer has come.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reached {
    /// It stands.
    Done,
    /// It is looked for.
    Now,
    /// A part of it stands; the rest comes later, or does not come any more.
    Partly,
    /// It comes later, or does not come any more.
    Ahead,
}

/// Places for parts of an answer that are not there yet, so that nothing moves when they come.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[allow(
    clippy::struct_excessive_bools,
    reason = "each is of its own: a part of the card has its place or not"
)]
pub struct Held {
    /// The verdict.
    pub verdict: bool,
    /// So many ways to do without.
    pub ways: u32,
    /// So many rows of robots in the table of who pays.
    pub rows: u32,
    /// The buttons for the other plan.
    pub other: bool,
    /// The reasons.
    pub reasons: bool,
    /// What would help.
    pub help: bool,
}

/// The layers that answer a question. Where there is no plan, none is near; how good a plan is, is
/// told at once.
pub(crate) fn layers(question: &Question) -> Vec<Layer> {
    match question {
        Question::Plan => vec![Layer::Whole],
        Question::Unsolvable => vec![Layer::Whole, Layer::Reason, Layer::Help],
        Question::Wait { .. }
        | Question::Charge { .. }
        | Question::NoCharge { .. }
        | Question::Order { .. }
        | Question::Slow { .. }
        | Question::Visit { .. }
        | Question::NoVisit { .. }
        | Question::Move { .. }
        | Question::NoMove { .. }
        | Question::Yield { .. }
        | Question::Arrival { .. }
        | Question::Length { .. }
        | Question::Makespan
        | Question::SumOfCosts
        | Question::Penalty
        | Question::Charges { .. }
        | Question::Moves { .. }
        | Question::Waits { .. }
        | Question::Rule { .. } => Layer::ALL.to_vec(),
    }
}

/// So many ways to do without have a place before small changes were tried.
const fn ways(question: &Question) -> u32 {
    match question {
        Question::Wait { .. } | Question::Yield { .. } => 3,
        Question::Charge { .. }
        | Question::NoCharge { .. }
        | Question::Order { .. }
        | Question::Slow { .. }
        | Question::Visit { .. }
        | Question::NoVisit { .. }
        | Question::Move { .. }
        | Question::NoMove { .. }
        | Question::Arrival { .. }
        | Question::Length { .. } => 1,
        Question::Makespan
        | Question::SumOfCosts
        | Question::Penalty
        | Question::Charges { .. }
        | Question::Moves { .. }
        | Question::Waits { .. }
        | Question::Rule { .. }
        | Question::Unsolvable
        | Question::Plan => 0,
    }
}

const fn layer_of(part: Part) -> Layer {
    match part {
        Part::Here => Layer::Here,
        Part::Near => Layer::Near,
        Part::Verdict | Part::Closest => Layer::Whole,
        Part::Witness | Part::Core => Layer::Reason,
        Part::Repairs => Layer::Help,
    }
}

fn name(layer: Layer) -> &'static str {
    match layer {
        Layer::Here => tr!("a layer of an answer" => "Here"),
        Layer::Near => tr!("a layer of an answer" => "Near"),
        Layer::Whole => tr!("a layer of an answer" => "Whole"),
        Layer::Reason => tr!("a layer of an answer" => "Reason"),
        Layer::Help => tr!("a layer of an answer" => "Help"),
    }
}

/// How far it has come; nothing where all of it stands and is proved.
pub(super) fn coming(state: &State, asking: &Asking, card: &Card) -> Option<Coming> {
    let told = asking.told.as_deref();
    let is_looking = state.is_looking();
    let is_open = told.is_some_and(is_open);
    let next = told.map_or(Some(None), |told| told.pending.first().copied().map(Some));
    if !is_looking && !is_open && next.is_none() {
        return None;
    }
    let layers = layers(asking.question());
    let steps = layers.iter().map(|&layer| LayerStep {
        name: name(layer),
        reached: reached(told, &layers, layer, is_looking),
    });
    let doing = match next {
        _ if !is_looking && next.is_some() => {
            tr!("the search for an answer was" => "Stopped").to_owned()
        }
        _ if !is_looking => reached_limit(asking),
        Some(Some(part)) => pending(part).to_owned(),
        Some(None) | None => tr!("Looking at the plan").to_owned(),
    };
    Some(Coming {
        layers: steps.collect(),
        is_looking,
        doing,
        held: if is_looking {
            held(asking, told, card)
        } else {
            Held::default()
        },
    })
}

/// That the time limit was reached, with the seconds of the settings.
fn reached_limit(asking: &Asking) -> String {
    match asking.request.limits.seconds {
        Some(seconds) => tr!(
            "The time limit of {seconds} s was reached",
            seconds = decimal(seconds, 0)
        ),
        None => tr!("The time limit was reached").to_owned(),
    }
}

/// How far a layer has come: parts are pending in the order in which they are looked for. What a search that
/// is over did not find is not done.
fn reached(
    told: Option<&ExplainAnswer>,
    layers: &[Layer],
    layer: Layer,
    is_looking: bool,
) -> Reached {
    let now = match told {
        Some(told) => told.pending.first().map(|&part| layer_of(part)),
        None => layers.first().copied(),
    };
    let is_pending = |part: Part| told.is_none_or(|told| told.pending.contains(&part));
    let parts = PARTS.into_iter().filter(|&part| layer_of(part) == layer);
    let (pending, done): (Vec<Part>, Vec<Part>) = parts.partition(|&part| is_pending(part));
    match (pending.len(), layer) {
        (0, Layer::Whole) if told.is_some_and(is_open) => Reached::Partly,
        (0, Layer::Reason | Layer::Help) if told.is_some_and(is_open) => Reached::Ahead,
        (0, _) => Reached::Done,
        _ if is_looking && now == Some(layer) => Reached::Now,
        _ if !done.is_empty() => Reached::Partly,
        _ => Reached::Ahead,
    }
}

/// Whether a better answer may come of a longer search.
fn is_open(told: &ExplainAnswer) -> bool {
    told.verdict == Verdict::Unknown && told.valid != Some(false)
}

fn held(asking: &Asking, told: Option<&ExplainAnswer>, card: &Card) -> Held {
    let waits_for = |part: Part| told.is_none_or(|told| told.pending.contains(&part));
    let has = |layer: Layer| layers(asking.question()).contains(&layer);
    let rows = card
        .pays
        .as_ref()
        .map_or(0, |pays| pays.robots.len() as u32);
    Held {
        verdict: card.verdict.is_none(),
        ways: if has(Layer::Near) && waits_for(Part::Near) {
            ways(asking.question()).saturating_sub(card.could.len() as u32)
        } else {
            0
        },
        // What stands does not move until all of it is there.
        rows: if has(Layer::Near) && (waits_for(Part::Verdict) || card.pays.is_some()) {
            ROWS.saturating_sub(rows)
        } else {
            0
        },
        other: has(Layer::Near) && waits_for(Part::Verdict) && card.other.is_none(),
        reasons: has(Layer::Reason) && waits_for(Part::Core) && card.cores.is_empty(),
        help: has(Layer::Help) && waits_for(Part::Repairs) && card.repairs.is_empty(),
    }
}
