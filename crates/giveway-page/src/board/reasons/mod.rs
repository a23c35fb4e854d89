//! Where the reasons of an answer are on the map.

mod audit;
mod beside;
mod groups;
mod numbers;

use giveway_model::Cell;
use giveway_model::check::Violation;
use giveway_solve::explain::{Core, FactKind};

use super::{CELL, ConflictPlace};
use crate::ask::{instead, numbers_facts, numbers_groups};
use crate::beside::differing_now;
use crate::steering::Steering;
use crate::{Asking, Lit, State};

pub use beside::reasons_beside;

use audit::in_audit;
use groups::in_groups;
use numbers::fact_place;

/// A number on the map: the same as in the list beside it.
#[derive(Clone, Debug, PartialEq)]
pub struct Spot {
    /// The number, from 1.
    pub number: usize,
    /// The middle of it, in units.
    pub at: (f64, f64),
    /// Whether it is lit up.
    pub is_lit: bool,
    /// What it numbers.
    pub sign: SpotSign,
}

/// What a number on the map stands beside.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SpotSign {
    /// What would go wrong, or a fact that rules a plan out.
    Broken,
    /// Facts that are part of a reason, needed or not: a ring.
    Reason,
    /// Facts of which one would help if it went: full.
    Helps,
}

/// A cell where the robot could wait instead.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Instead {
    /// The cell.
    pub cell: Cell,
    /// Whether it is the one that is told of.
    pub is_first: bool,
}

/// A cell of a minimal set.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Place {
    /// The cell.
    pub cell: Cell,
    /// Whether it is lit up.
    pub is_lit: bool,
}

/// Where a try at a plan goes wrong.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Try {
    /// The middle of it, in units.
    pub at: (f64, f64),
    /// When, in steps.
    pub time: u32,
}

/// What is drawn of an answer.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Reasons {
    /// What would go wrong, where it would; where there is no plan, the facts that
    /// rule it out.
    pub spots: Vec<Spot>,
    /// Where the best tries end, where there is no plan.
    pub tries: Vec<Try>,
    /// The cells of the minimal sets.
    pub places: Vec<Place>,
    /// The agents of the row or the fact that is lit up, by their indices.
    pub agents: Vec<usize>,
    /// What is against the rules of the plan at the time shown.
    pub bursts: Vec<ConflictPlace>,
    /// The cells where that is so in a plan of elsewhere.
    pub frames: Vec<Cell>,
    /// What is against the rules of it at other times; of an answer what would be, if only this
    /// changed.
    pub later: Vec<Later>,
    /// The cells where the robot could wait instead.
    pub instead: Vec<Instead>,
}

/// A place where something is against the rules at another time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Later {
    /// The middle of it, in units.
    pub at: (f64, f64),
    /// Whether it is a cell, not an edge.
    pub is_cell: bool,
    /// When, in steps.
    pub time: u32,
}

/// The numbers that are drawn: more would cover the map.
const SPOTS: usize = 12;

/// What would go wrong that is drawn beside the numbers of groups.
const WOULD_BE: usize = 3;

/// From the middle of a cell to a number in its corner, across and down, in units.
const CORNER: f64 = 34.0;

/// What to draw; nothing where nothing was asked, where answers are hidden from a room, or
/// while the other plan is shown in the place of this one: in it nothing goes wrong.
pub fn reasons(state: &State) -> Reasons {
    let mut reasons = Reasons::default();
    if state.hides_answers() {
        return reasons;
    }
    let Some(asking) = state.document.mode.asking() else {
        reasons.bursts = bursts(state);
        if let Some(audit) = state.audited() {
            in_audit(&mut reasons, audit, state.view.playback.time);
        }
        return reasons;
    };
    let Some(told) = asking.told.as_deref().filter(|_| is_this(asking, state)) else {
        return reasons;
    };
    reasons.agents = marked(state, asking);
    if let Some(Lit::Cell(cell)) = asking.lit {
        reasons.places.push(Place { cell, is_lit: true });
    }
    let instead = instead(asking).into_iter();
    reasons.instead = instead
        .map(|(cell, is_first)| Instead { cell, is_first })
        .collect();
    if numbers_groups(asking) {
        let violations = asking.violations().map(|(_, violation)| violation);
        would_be(&mut reasons, violations);
        in_groups(&mut reasons, asking, told, state, state.shown());
        return reasons;
    }
    if told.witness.is_empty() {
        would_be(
            &mut reasons,
            told.here.iter().flat_map(|here| &here.violations),
        );
    }
    let is_numbered = numbers_facts(asking);
    for (index, (_, violation)) in asking.violations().enumerate().take(SPOTS) {
        match place(violation) {
            None => {}
            // What is in an obstacle is part of a fact, which has its mark there.
            Some(_) if is_numbered && violation.agents.len() < 2 => {}
            Some(at) if is_numbered => reasons.tries.push(Try {
                at,
                time: violation.time,
            }),
            Some(at) => reasons.spots.push(Spot {
                number: index + 1,
                at: apart(&reasons.spots, in_corner(violation, at)),
                is_lit: asking.lit == Some(Lit::Witness(index)),
                sign: SpotSign::Broken,
            }),
        }
    }
    let sets = told.core.iter().flat_map(Core::sets);
    let facts = sets.flat_map(|core| &core.facts);
    for (index, fact) in facts.enumerate() {
        let is_lit = asking.lit == Some(Lit::Fact(index));
        if let Some(cell) = fact.cell {
            reasons.places.push(Place { cell, is_lit });
        }
        if let Some(at) = fact_place(fact, state, &reasons.tries).filter(|_| is_numbered) {
            reasons.spots.push(Spot {
                number: index + 1,
                at: apart(&reasons.spots, at),
                is_lit,
                sign: SpotSign::Broken,
            });
        }
        if is_lit && fact.kind != FactKind::Obstacle {
            let named = state.document.draft.agents().iter().enumerate();
            let named = named.filter(|(_, agent)| match fact.kind {
                FactKind::Floor => agent.battery.is_some(),
                _ => fact.agents.contains(&agent.name),
            });
            reasons.agents = named.map(|(index, _)| index).collect();
        }
    }
    reasons
}

/// The first things that would go wrong if only this changed, with their times.
fn would_be<'a>(reasons: &mut Reasons, violations: impl Iterator<Item = &'a Violation>) {
    for violation in violations.take(WOULD_BE) {
        if let Some(at) = place(violation) {
            reasons.later.push(Later {
                at,
                is_cell: violation.cell.is_some(),
                time: violation.time,
            });
        }
    }
}

/// The robot that is lit up; while nothing is, those that differ beside the other plan.
fn marked(state: &State, asking: &Asking) -> Vec<usize> {
    match asking.lit {
        Some(Lit::Robot(agent)) => vec![agent],
        Some(Lit::Witness(_) | Lit::Fact(_) | Lit::Group(_) | Lit::Cell(_)) => Vec::new(),
        None => differing_now(state),
    }
}

/// The robots that the row or the fact that is lit up is about, by their indices, or those that
/// are selected in their table; all others are faded. `None` where nothing is lit up.
pub fn lit(state: &State) -> Option<Vec<usize>> {
    let Some(asking) = state.document.mode.asking() else {
        let selected = state.rows_selected();
        return (!selected.is_empty()).then_some(selected);
    };
    asking.lit?;
    let agents = reasons(state).agents;
    (!agents.is_empty()).then_some(agents)
}

/// A number beside what stands in the middle of a cell: in the upper left corner,
/// which flags, stars and badges leave free.
const fn corner((x, y): (f64, f64)) -> (f64, f64) {
    (x - CORNER, y - CORNER)
}

/// The number of what happens on a cell leaves the name of who stands there free;
/// between two cells there is no name.
fn in_corner(violation: &Violation, at: (f64, f64)) -> (f64, f64) {
    if violation.cell.is_some() {
        corner(at)
    } else {
        at
    }
}

/// Where a violation is, in units.
fn place(violation: &Violation) -> Option<(f64, f64)> {
    ConflictPlace::of(violation).map(ConflictPlace::middle)
}

/// What is against the rules at the time shown, each place once.
fn bursts(state: &State) -> Vec<ConflictPlace> {
    let mut bursts = Vec::new();
    let own = state.document.mode.steering();
    let led = own.into_iter().flat_map(|own| &own.violations);
    // A plan that is older than a rule breaks it on the spot, too; one of elsewhere has frames.
    let is_older = own.is_none() && state.audited().is_none();
    let older = crate::rules::broken(state).filter(|_| is_older);
    for violation in led.chain(older) {
        if let Some(at) = ConflictPlace::of(violation)
            && Steering::is_now(violation, state.view.playback.time)
            && !bursts.contains(&at)
        {
            bursts.push(at);
        }
    }
    bursts
}

/// Whether the plan asked about is the one that is shown.
fn is_this(asking: &Asking, state: &State) -> bool {
    !asking.shows_other || state.view.is_wide
}

/// A place beside those before it that are at the same one.
fn apart(before: &[Spot], (x, y): (f64, f64)) -> (f64, f64) {
    const STEP: f64 = 30.0;
    let near = |spot: &&Spot| (spot.at.1 - y).abs() < 1.0 && (spot.at.0 - x).abs() < CELL / 2.0;
    let count = before.iter().filter(near).count();
    (x + STEP * count as f64, y)
}
