//! The broken rules of a plan of elsewhere, gone through one after the other: all of
//! them, or those in which the robot that is selected takes part.

use giveway_model::check::Violation;
use giveway_model::{Cell, tr};

use super::rows::violation as row;
use super::{Audit, Dropped};
use crate::State;

/// The conflicts to go through.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Conflicts {
    /// Whether there is one to go to.
    pub has_next: bool,
    /// How many there are, or the one that was gone to last, in a sentence.
    pub sentence: String,
}

/// The conflicts of the robot that is selected, else of all; `None` unless a plan that
/// breaks a rule is on the board.
pub fn conflicts(state: &State) -> Option<Conflicts> {
    let audit = state.audited().filter(|audit| !audit.plan.is_legal())?;
    let who = who(state, audit);
    let all = of(&audit.plan, who);
    let gone_to = gone_to(state, audit);
    let place = gone_to.and_then(|gone_to| all.iter().position(|&index| index == gone_to));
    let told = place.and_then(|place| Some((place, audit.plan.violations.get(*all.get(place)?)?)));
    let sentence = match (told, who) {
        (Some((place, violation)), _) => {
            let row = row(&audit.plan, violation, place, true);
            tr!(
                "Conflict {place} of {all}, at time {time}: {row}",
                place = place + 1,
                all = all.len(),
                time = row.time,
                row = row.text
            )
        }
        (None, Some(name)) if all.is_empty() => tr!("No conflict of {name}.", name),
        (None, Some(name)) => tr!(
            "{name} takes part in {n} conflict."
                | "{name} takes part in {n} conflicts." % all.len(),
            name
        ),
        (None, None) => tr!("{n} conflict." | "{n} conflicts." % all.len()),
    };
    Some(Conflicts {
        has_next: !all.is_empty(),
        sentence,
    })
}

/// The robot that is selected, by its name in the plan.
fn who<'a>(state: &State, audit: &'a Audit) -> Option<&'a str> {
    let agents = audit.plan.answer.draft.agents();
    agents
        .get(state.selected_agent()?)
        .map(|agent| agent.name.as_str())
}

/// Which violations there are, of a robot or of all.
fn of(plan: &Dropped, who: Option<&str>) -> Vec<usize> {
    let violations = plan.violations.iter().enumerate();
    let takes_part = |violation: &Violation| {
        who.is_none_or(|who| violation.agents.iter().any(|agent| agent == who))
    };
    let own = violations.filter(|(_, violation)| takes_part(violation));
    own.map(|(index, _)| index).collect()
}

/// The one that was gone to last, while its time is shown.
fn gone_to(state: &State, audit: &Audit) -> Option<usize> {
    let index = state.view.conflict?;
    let violation = audit.plan.violations.get(index)?;
    (violation.time == state.view.playback.time).then_some(index)
}

/// The next one after the one that was gone to last, or from the time shown on; after
/// the last comes the first. In its place, why there is none.
pub(crate) fn next(state: &State) -> Result<usize, String> {
    let audit = state
        .audited()
        .ok_or(tr!("This plan is not checked yet."))?;
    let who = who(state, audit);
    let all = of(&audit.plan, who);
    let gone_to = gone_to(state, audit);
    let is_next = |&&index: &&usize| {
        if let Some(gone_to) = gone_to {
            return index > gone_to;
        }
        let violation = audit.plan.violations.get(index);
        violation.is_some_and(|violation| violation.time >= state.view.playback.time)
    };
    let next = all.iter().find(is_next).or(all.first()).copied();
    next.ok_or_else(|| match who {
        Some(name) => tr!("No conflict of {name}.", name),
        None => tr!("This plan has no conflict.").to_owned(),
    })
}

/// Where to look for a violation.
pub(crate) fn place(violation: &Violation) -> Option<Cell> {
    let from = violation.edge.map(|[from, _]| from);
    violation.cell.or(from)
}
