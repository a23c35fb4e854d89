//! The parts of a card in words and signs.

use std::borrow::Cow;

use giveway_model::{Question, tr};
use giveway_solve::explain::{Edit, ExplainAnswer, Fact, FactKind, Part, Verdict, verdict_word};
use giveway_solve::words::reason;

use super::card::{Badge, numbers_facts};
use crate::{Asking, State};

/// The verdict in words. Where there is no plan, all that follows from it stands below
/// in lists: only the reason is said.
pub(super) fn verdict_words<'a>(
    state: &'a State,
    asking: &'a Asking,
    told: &'a ExplainAnswer,
) -> Cow<'a, str> {
    if !numbers_facts(asking) || told.verdict != Verdict::Necessary {
        return Cow::Borrowed(&told.words);
    }
    // Where the world changed it is what the method found that keeps to the least.
    let tried = state.document.mode.comparing().into_iter();
    let mut tried = tried.flat_map(|comparing| comparing.tried.iter().rev());
    let found = tried.find_map(|tried| tried.told.result.reason.as_ref());
    let given = found.or(asking.about.solved.reason.as_ref());
    given.map_or(Cow::Borrowed(&told.words), |given| {
        // A reason names one cause alone.
        Cow::Owned(reason(given) + &other_causes(asking).unwrap_or_default())
    })
}

/// ` There is another cause, too.`, where there is no plan for several reasons.
pub(crate) fn other_causes(asking: &Asking) -> Option<String> {
    let core = asking.told.as_deref()?.core.as_ref()?;
    let further = core.further.len();
    (further > 0 && numbers_facts(asking)).then(|| {
        tr!("behind a sentence" => " There is another cause, too."
            | " There are {n} other causes, too." % further)
    })
}

pub(super) fn badge(told: &ExplainAnswer) -> Badge {
    let (icon, class) = match (&told.question, told.verdict) {
        _ if told.valid == Some(false) => ("collision", "broken"),
        (Question::Unsolvable, Verdict::Necessary) => ("cancel", "broken"),
        (Question::Plan, Verdict::Needless) => ("proved", "needless"),
        (_, Verdict::Needless | Verdict::Improvable) => ("compare", "needless"),
        (_, Verdict::Costly) => ("warning", "costly"),
        (_, Verdict::Necessary) => ("proved", "necessary"),
        (_, Verdict::Unknown) => ("clock", "unknown"),
    };
    Badge {
        word: verdict_word(told),
        icon,
        class,
    }
}

pub(super) fn pending(part: Part) -> &'static str {
    match part {
        Part::Here => tr!("Looking at the plan"),
        Part::Near => tr!("Trying small changes"),
        Part::Verdict => tr!("Looking for the verdict"),
        Part::Closest => tr!("Looking for a plan closer to this one"),
        Part::Witness => tr!("Looking for what would happen"),
        Part::Core => tr!("Looking for the reasons"),
        Part::Repairs => tr!("Looking for what would help"),
    }
}

pub(super) fn fact_icon(fact: &Fact) -> &'static str {
    match fact.kind {
        FactKind::Task | FactKind::Presence => "agent",
        FactKind::Waypoint => "waypoint",
        FactKind::Battery | FactKind::Floor => "charger",
        FactKind::Obstacle => "obstacle",
        FactKind::Slow => "slow",
        FactKind::Collision => "collision",
        FactKind::Stay | FactKind::Rest => "goal",
        FactKind::Deadline => "clock",
        FactKind::Breakdown => "pause",
        FactKind::Constraint => "lock",
    }
}

pub(super) fn edit_icon(edit: &Edit) -> &'static str {
    match edit {
        Edit::RemoveObstacle { .. } => "erase",
        Edit::AddCharger { .. } | Edit::Battery { .. } | Edit::BatteryFloor { .. } => "charger",
        Edit::Deadline { .. } => "clock",
        Edit::MakeNormal { .. } => "slow",
        Edit::DropWaypoint { .. } => "waypoint",
        Edit::Vanish => "goal",
        Edit::LeaveOut { .. } => "agent",
        Edit::AllowMore { .. } | Edit::GiveUntil { .. } => "loosen",
        Edit::SwitchOff { .. } => "lock",
    }
}

/// Whether an edit gives something up that was wanted, instead of asking for less of it.
pub(super) const fn gives_up(edit: &Edit) -> bool {
    match edit {
        Edit::SwitchOff { .. } | Edit::LeaveOut { .. } | Edit::DropWaypoint { .. } => true,
        Edit::RemoveObstacle { .. }
        | Edit::AddCharger { .. }
        | Edit::Battery { .. }
        | Edit::BatteryFloor { .. }
        | Edit::Deadline { .. }
        | Edit::MakeNormal { .. }
        | Edit::Vanish
        | Edit::AllowMore { .. }
        | Edit::GiveUntil { .. } => false,
    }
}
