//! What the signs on the board mean: only those that are there.

use giveway_model::{Ground, tr};

use super::{Cast, MarkKind, SpotSign, Track};
use crate::rules::{in_clash_robots, in_lit_zone};
use crate::{State, freedom};

/// A sign of the board.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Something is wrong on a cell.
    Problem,
    /// Something is against the rules at the time shown.
    Burst,
    /// Something is against the rules at another time.
    Later,
    /// Robots would meet there, if only what is asked about changed.
    WouldMeet,
    /// The robot could wait there instead.
    Instead,
    /// A group of facts of which one would help if it went.
    Helps,
    /// A group of facts that is part of a reason.
    InReason,
    /// A fact that, with others, rules every plan out.
    Reason,
    /// The best try at a plan ends there.
    Try,
    /// Two plans are shown, and an agent is elsewhere in the other one.
    Differs,
    /// The plan is of another scene.
    Stale,
    /// A charger.
    Charger,
    /// The slow zone.
    Slow,
    /// A goal.
    Goal,
    /// A waypoint.
    Waypoint,
    /// The way ahead.
    Ahead,
    /// The shortest way of a robot that has no plan.
    Shortest,
    /// A wait.
    Wait,
    /// A turn in a step of its own.
    Turn,
    /// A breakdown.
    Broken,
    /// A cell that is used much.
    Used,
    /// A way that every best plan has.
    Must,
    /// A way that this one alone of all best plans has.
    Only,
    /// A way that some best plans have.
    May,
    /// A way of which it is open whether every best plan has it.
    Unsure,
    /// What closing a cell costs.
    Price,
    /// How late a robot may be.
    Late,
    /// A zone.
    Zone,
    /// At most so many robots in a zone.
    AtMost,
    /// A zone that is closed at the time shown.
    Closed,
    /// A one-way lane.
    OneWay,
    /// Over a lane of the timeline: the robot is in the zone that is lit.
    InZone,
}

impl Kind {
    /// What it means.
    pub fn words(self) -> &'static str {
        match self {
            Self::Problem => tr!("Problem: press to see it"),
            Self::Burst => tr!("Against a rule at this time"),
            Self::Later => tr!("Against a rule at another time"),
            Self::WouldMeet => tr!("Would meet, with the time"),
            Self::Instead => tr!("Could wait here as well"),
            Self::Helps => tr!("a sign on the board" => "Would help"),
            Self::InReason => tr!("A group of the reason"),
            Self::Reason => tr!("Part of the reason"),
            Self::Try => tr!("The best try ends here"),
            Self::Differs => tr!("Elsewhere in the other plan"),
            Self::Stale => tr!("Stale plan, faded"),
            Self::Charger => tr!("Charger"),
            Self::Slow => tr!("Slow zone: a move takes 2 steps"),
            Self::Goal => tr!("Goal"),
            Self::Waypoint => tr!("Waypoint, filled once visited"),
            Self::Ahead => tr!("Way ahead"),
            Self::Shortest => tr!("Shortest way, without rules and other robots"),
            Self::Wait => tr!("Waits"),
            Self::Turn => tr!("a sign on the board" => "Turns here"),
            Self::Broken => tr!("Broken down"),
            Self::Used => tr!("Darker: used more often"),
            Self::Must => tr!("In every best plan"),
            Self::Only => tr!("In this plan alone"),
            Self::May => tr!("Free to choose"),
            Self::Unsure => tr!("Not known"),
            Self::Price => tr!("Closing this cell costs so much"),
            Self::Late => tr!("May be late"),
            Self::Zone => tr!("a sign on the board" => "Zone"),
            Self::AtMost => tr!("At most this many"),
            Self::Closed => tr!("Closed now"),
            Self::OneWay => tr!("One way"),
            Self::InZone => tr!("In that zone, in the timeline"),
        }
    }

    /// What it means on paper, where nothing is pressed.
    pub fn on_paper(self) -> &'static str {
        match self {
            Self::Problem => tr!("Problem"),
            other => other.words(),
        }
    }

    /// The class of its picture.
    pub const fn class(self) -> &'static str {
        match self {
            Self::Problem => "k-problem",
            Self::Later | Self::WouldMeet => "k-later",
            Self::Instead => "k-instead",
            Self::Helps => "k-helps",
            Self::InReason => "k-needed",
            Self::Reason => "k-core",
            Self::Burst | Self::Try => "k-burst",
            Self::Differs => "k-diff",
            Self::Stale => "k-stale",
            Self::Charger => "k-chg",
            Self::Slow => "k-slow",
            Self::Goal => "k-goal",
            Self::Waypoint => "k-wp",
            Self::Ahead | Self::Shortest => "k-ahead",
            Self::Wait => "k-wait",
            Self::Turn => "k-turn",
            Self::Broken => "k-broken",
            Self::Used => "k-used",
            Self::Must => "k-must",
            Self::Only => "k-only",
            Self::May => "k-may",
            Self::Unsure => "k-unsure",
            Self::Price => "k-price",
            Self::Late => "k-late",
            Self::Zone => "k-zone",
            Self::AtMost => "k-most",
            Self::Closed => "k-shut",
            Self::OneWay => "k-way",
            Self::InZone => "k-in-zone",
        }
    }
}

/// The signs on the board of a state, with its cast.
pub fn legend(state: &State, cast: &Cast) -> Vec<Kind> {
    if state.is_laid_over() {
        return freedom::signs(state);
    }
    let grid = state.world().grid();
    let rows = || (0..grid.height()).map(|y| grid.row(y));
    let has_ground = |is: fn(Ground) -> bool| rows().any(|row| row.iter().any(|&g| is(g)));
    let has_mark = |kind| cast.marks.iter().any(|mark| mark.kind == kind);
    let is_stale = state.shows_stale() && cast.has_plan();
    let moves = cast.tracks.iter().any(|track| track.arrival() > 0);
    let problems = state.document.draft.problems();
    let reasons = super::reasons(state);
    let has_sign = |sign| reasons.spots.iter().any(|spot| spot.sign == sign);
    let is_asked = state.document.mode.asking().is_some();
    let [zone, most, closed, lane] = super::rules::signs(state);
    let mut names = state.world().agents().iter().map(|agent| &agent.name);
    let is_lit =
        state.lit_rule().is_some() && names.any(|name| !in_lit_zone(state, name).is_empty());
    let signs = [
        (
            Kind::Problem,
            problems.iter().any(|problem| problem.cell.is_some()),
        ),
        (Kind::Burst, !reasons.bursts.is_empty()),
        (Kind::Later, !reasons.later.is_empty() && !is_asked),
        (Kind::WouldMeet, !reasons.later.is_empty() && is_asked),
        (Kind::Instead, !reasons.instead.is_empty()),
        (Kind::Helps, has_sign(SpotSign::Helps)),
        (Kind::InReason, has_sign(SpotSign::Reason)),
        (Kind::Reason, !reasons.places.is_empty()),
        (Kind::Try, !reasons.tries.is_empty()),
        (Kind::Differs, state.beside().is_some()),
        (Kind::Stale, is_stale),
        (Kind::Broken, cast.tracks.iter().any(Track::has_breakdowns)),
        (Kind::Charger, has_ground(Ground::is_charger)),
        (Kind::Slow, has_ground(Ground::is_slow)),
        (Kind::Zone, zone),
        (Kind::AtMost, most),
        (Kind::Closed, closed),
        (Kind::OneWay, lane),
        (Kind::InZone, is_lit),
        (Kind::Goal, has_mark(MarkKind::Goal)),
        (Kind::Waypoint, has_mark(MarkKind::Waypoint)),
        (Kind::Ahead, state.view.layers.trails && moves),
        (Kind::Shortest, !in_clash_robots(state).is_empty()),
        (Kind::Wait, cast.tracks.iter().any(Track::has_waits)),
        (Kind::Turn, cast.tracks.iter().any(Track::has_turns)),
        (Kind::Used, state.view.layers.heat && moves),
    ];
    signs
        .into_iter()
        .filter(|sign| sign.1)
        .map(|sign| sign.0)
        .collect()
}
