//! What the inspector tells of all best plans: ways to choose from, who may be late,
//! cells that matter, and the plan that differs most.

mod cells;
mod slack;
mod ways;

use giveway_model::tr;
use giveway_solve::freedom::{Farthest, Known, PlanCount, same_steps};
use giveway_solve::words::reach;
use giveway_solve::words::reason;

use super::{Freedom, doing, is_done};
use crate::State;

pub use cells::{CellRow, Cells};
pub use slack::Late;
pub(super) use slack::{detail, sentence};
pub use ways::Ways;

/// The most robots that are listed.
const MOST: usize = 40;

/// What is told.
#[derive(Clone, Debug, PartialEq)]
pub struct Column {
    /// How much of this plan is in all of them.
    pub lead: String,
    /// What is being looked for.
    pub doing: Option<String>,
    /// That something is open, and why; it can be looked for again.
    pub stopped: Option<String>,
    /// Ways to choose from; `None` where there is no choice.
    pub ways: Option<Section<Ways>>,
    /// Who may be late.
    pub late: Section<Late>,
    /// Cells that matter.
    pub cells: Section<Cells>,
    /// The plan that differs most; `None` where no other is as good.
    pub other: Option<Section<Other>>,
    /// How far all that reaches.
    pub reach: Option<String>,
}

/// What is known of something.
#[derive(Clone, Debug, PartialEq)]
pub enum Section<T> {
    /// This much.
    Known(T),
    /// It is being looked for.
    Coming,
    /// It was not found out.
    Open,
}

/// A robot in a list.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// Its index in the scene.
    pub agent: usize,
    /// What is told of it.
    pub title: String,
    /// What else there is to know; may be empty.
    pub detail: String,
    /// A number at the end of the line; may be empty.
    pub value: String,
    /// Whether there is no choice.
    pub is_fixed: bool,
}

/// The best plan that differs most from this one.
#[derive(Clone, Debug, PartialEq)]
pub struct Other {
    /// By how much, and whether none differs in more.
    pub sentence: String,
    /// Whether it is shown.
    pub is_shown: bool,
}

/// The column; `None` where nothing is laid over the plan.
pub fn column(state: &State) -> Option<Column> {
    let freedom = state.freedom()?;
    let is_counting = state.is_counting();
    let told = freedom.told.as_deref();
    let missing = || {
        is_counting
            .then_some(())
            .map_or(Left::Open, |()| Left::Coming)
    };
    let is_only = freedom.count() == Some(PlanCount::Exactly(1));
    let ways = told.and_then(|told| ways::ways(freedom, told));
    let late = told.and_then(|told| slack::late(freedom, told));
    let cells = told.and_then(|told| cells::cells(told, is_counting));
    let other = told.and_then(|told| other(told.farthest.as_ref()?, state));
    let is_alone = is_only || told.is_some_and(|told| told.farthest == Some(Farthest::Only));
    Some(Column {
        lead: lead(freedom, is_only),
        doing: doing(state),
        stopped: stopped(freedom, is_counting),
        ways: (!is_only).then(|| missing().or(ways)),
        late: missing().or(late),
        cells: missing().or(cells),
        other: (!is_alone).then(|| missing().or(other)),
        reach: told
            .filter(|told| told.backbone.is_some())
            .and_then(|told| reach(told.reach)),
    })
}

/// What stands where nothing is known.
enum Left {
    Coming,
    Open,
}

impl Left {
    fn or<T>(self, known: Option<T>) -> Section<T> {
        match (known, self) {
            (Some(known), _) => Section::Known(known),
            (None, Self::Coming) => Section::Coming,
            (None, Self::Open) => Section::Open,
        }
    }
}

fn lead(freedom: &Freedom, is_only: bool) -> String {
    if is_only {
        return tr!("This plan is the only best one: every step of it must be so.").to_owned();
    }
    let backbone = freedom
        .told
        .as_deref()
        .and_then(|told| told.backbone.as_ref());
    let Some(backbone) = backbone else {
        return tr!("Over all best plans: what each of them has, and where there is a choice.")
            .to_owned();
    };
    let (mut same, mut all, mut open) = (0, 0, false);
    for visits in backbone.values() {
        let (own, steps) = same_steps(visits);
        same += own;
        all += steps;
        open |= visits.iter().any(|visit| visit.always == Known::Open);
    }
    if same == all && freedom.count().is_some() {
        return tr!(
            "All {all} steps are the same in every best plan, but not when robots charge.",
            all
        );
    }

    if open {
        tr!(
            "At least {n} of {all} steps is the same in every best plan; others are open."
                | "At least {n} of {all} steps are the same in every best plan; others are open."
                    % same,
            all
        )
    } else {
        tr!(
            "{n} of {all} steps is the same in every best plan."
                | "{n} of {all} steps are the same in every best plan." % same,
            all
        )
    }
}

/// That something is open, and why.
fn stopped(freedom: &Freedom, is_counting: bool) -> Option<String> {
    let told = freedom.told.as_deref();
    let is_done = told.is_some_and(is_done);
    if is_counting || is_done {
        return None;
    }
    let given = told.and_then(|told| told.reason.as_ref());
    let reason = given.map_or_else(|| tr!("You stopped it").to_owned(), reason);
    let reason = reason.trim_end_matches('.');
    Some(tr!("{reason}. Results may be incomplete.", reason))
}

fn other(farthest: &Farthest, state: &State) -> Option<Other> {
    let Farthest::Found { differs, most, .. } = farthest else {
        return None;
    };

    let most = match most {
        Known::Yes => tr!("No best plan differs in more."),
        Known::No | Known::Open => tr!("Another one may differ in more."),
    };
    Some(Other {
        sentence: tr!(
            "In it robots are elsewhere {n} time. {most}"
                | "In it robots are elsewhere {n} times. {most}" % *differs,
            most
        ),
        is_shown: state.farthest().is_some(),
    })
}
