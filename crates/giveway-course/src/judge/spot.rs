//! Judges conflicts that were marked in a faulty plan: the judge of plans knows them.

use giveway_model::Instance;
use giveway_model::check::{Rule, Violation, check};

use super::{Mark, Situation, Verdict, Why};
use crate::port::Evidence;

pub(super) fn judge(situation: Situation<'_>, marks: &[Mark]) -> Verdict {
    let mut conflicts = conflicts(situation);
    if let Some(mark) = marks.iter().find(|mark| !is_of_any(mark, &conflicts)) {
        return Verdict::not_like_this(Why::NoConflict(mark.clone()));
    }
    let of = conflicts.len();
    let is_found = |conflict: &Violation| marks.iter().any(|mark| is_of(mark, conflict));
    conflicts.retain(is_found);
    let found = conflicts.len();
    let evidence = Evidence {
        time: conflicts.last().map(|conflict| conflict.time),
        violations: conflicts,
        ..Evidence::default()
    };
    let why = if marks.is_empty() {
        Why::Untouched
    } else {
        Why::Found { found, of }
    };
    Verdict::if_holds(of > 0 && found == of, why).with(evidence)
}

/// Whether two marks are of one conflict of the plan: a swap may be marked before or after
/// its step, and by either robot first.
pub(crate) fn is_same_conflict(situation: Situation<'_>, one: &Mark, other: &Mark) -> bool {
    let conflicts = conflicts(situation);
    let mut conflicts = conflicts.iter();
    conflicts.any(|conflict| is_of(one, conflict) && is_of(other, conflict))
}

/// The conflicts of two robots in the plan of the step.
pub(crate) fn conflicts(situation: Situation<'_>) -> Vec<Violation> {
    let instance = Instance::new(situation.scene.clone());
    let (Ok(instance), Some(plan)) = (instance, &situation.step.plan) else {
        return Vec::new();
    };
    let mut conflicts = check(&instance, plan).violations;
    conflicts.retain(is_conflict);
    conflicts
}

/// Whether a broken rule is a conflict of two robots.
const fn is_conflict(violation: &Violation) -> bool {
    matches!(violation.rule, Rule::Vertex | Rule::Swap | Rule::SlowSwap)
}

fn is_of_any(mark: &Mark, conflicts: &[Violation]) -> bool {
    conflicts.iter().any(|conflict| is_of(mark, conflict))
}

/// Whether a mark is of a conflict. One on the way between two cells may be marked
/// before or after the step.
fn is_of(mark: &Mark, conflict: &Violation) -> bool {
    let begin = conflict.time;
    let time = match conflict.rule {
        Rule::Vertex => mark.time == begin,
        _ => (begin..=begin.saturating_add(1)).contains(&mark.time),
    };
    let mut clicked = mark.cells.iter();
    let place = clicked.all(|cell| {
        conflict.cell == Some(*cell) || conflict.edge.is_some_and(|edge| edge.contains(cell))
    });
    let who = conflict
        .agents
        .iter()
        .all(|name| mark.robots.contains(name))
        && mark
            .robots
            .iter()
            .all(|name| conflict.agents.contains(name));
    time && place && who
}
