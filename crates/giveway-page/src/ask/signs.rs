//! The parts of a card in words and signs.

use giveway_model::Question;
use giveway_solve::explain::{Edit, ExplainAnswer, Fact, FactKind, Part, Verdict};

use super::card::{Badge, numbers_facts};
use crate::{Asking, State};

/// The verdict in words. Where there is no plan, all that follows from it stands below
/// in lists: only the reason is said.
pub(super) fn verdict_words<'a>(
    state: &'a State,
    asking: &'a Asking,
    told: &'a ExplainAnswer,
) -> &'a str {
    if !numbers_facts(asking) || told.verdict != Verdict::Necessary {
        return &told.words;
    }
    // Where the world changed it is what the method found that keeps to the least.
    let tried = state.document.mode.comparing().into_iter();
    let mut tried = tried.flat_map(|comparing| comparing.tried.iter().rev());
    let found = tried.find_map(|tried| tried.told.result.reason.as_deref());
    let reason = found.or(asking.about.solved.reason.as_deref());
    reason.unwrap_or(&told.words)
}

pub(super) fn badge(asking: &Asking, verdict: Verdict) -> Badge {
    let (word, icon, class) = match (asking.question(), verdict) {
        (Question::Unsolvable, Verdict::Necessary) => ("Impossible", "cancel", "necessary"),
        (Question::Plan, Verdict::Needless) => ("Optimal", "proved", "needless"),
        (_, Verdict::Needless) => ("Needless", "compare", "needless"),
        (_, Verdict::Improvable) => ("Improvable", "compare", "needless"),
        (_, Verdict::Costly) => ("Costly", "warning", "costly"),
        (_, Verdict::Necessary) => ("Necessary", "proved", "necessary"),
        (_, Verdict::Unknown) => ("Not known", "clock", "unknown"),
    };
    Badge { word, icon, class }
}

pub(super) fn would(asking: &Asking) -> String {
    match asking.question() {
        Question::Wait { agent, .. } => format!("If {agent} did not wait"),
        Question::Unsolvable => "At the least, this would go wrong".to_owned(),
        Question::Plan => "What is against the rules".to_owned(),
        _ => "What would go wrong if only this changed".to_owned(),
    }
}

pub(super) fn pending(part: Part) -> &'static str {
    match part {
        Part::Verdict => "Looking for the verdict",
        Part::Closest => "Looking for a plan closer to this one",
        Part::Witness => "Looking for what would happen",
        Part::Core => "Looking for the reasons",
        Part::Repairs => "Looking for what would help",
    }
}

pub(super) fn fact_icon(fact: &Fact) -> &'static str {
    match fact.kind {
        FactKind::Task => "agent",
        FactKind::Waypoint => "waypoint",
        FactKind::Battery => "charger",
        FactKind::Obstacle => "obstacle",
        FactKind::Slow => "slow",
        FactKind::Collision => "collision",
        FactKind::Stay => "goal",
        FactKind::Deadline => "clock",
    }
}

pub(super) fn edit_icon(edit: &Edit) -> &'static str {
    match edit {
        Edit::RemoveObstacle { .. } => "erase",
        Edit::AddCharger { .. } | Edit::Battery { .. } => "charger",
        Edit::Deadline { .. } => "clock",
        Edit::MakeNormal { .. } => "slow",
        Edit::DropWaypoint { .. } => "waypoint",
        Edit::Vanish => "goal",
        Edit::LeaveOut { .. } => "agent",
    }
}
