//! What the order alone does not keep, and by what one can tell.

use borsh::{BorshDeserialize, BorshSerialize};
use giveway_model::Assumption;
use giveway_model::change::History;
use giveway_model::check::levels_over_time;
use giveway_model::condition::Times;
use giveway_model::constraint::{ConstraintKind, TimedConstraint};
use serde::{Deserialize, Serialize};

use crate::OrderGraph;
use crate::rules::is_whole;

/// Something of the problem that robots may break though they keep to the order.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
#[serde(tag = "loss", rename_all = "kebab-case")]
pub enum Loss {
    /// A rule of the scene's own that is about times.
    Rule {
        /// Its number in the scene, from 0; rules that changes added come after those.
        index: u32,
        /// The kind of the constraint, as in files.
        kind: String,
        /// The rule in words.
        text: String,
    },
    /// A battery: it bears so many steps of lateness for sure.
    Battery {
        /// The agent's name.
        agent: String,
        /// The least level above the floor in the plan, in steps.
        spare: u32,
    },
    /// What changes does so at its own time, however late the robots are.
    Changes {
        /// The time of the last change, in steps.
        last: u32,
    },
    /// Obstacles that move do so at their own times.
    MovingObstacles,
}

/// What the order of a plan does not keep by itself. Rules first, then batteries, changes and
/// obstacles that move.
pub fn losses(graph: &OrderGraph<'_>) -> Vec<Loss> {
    let history = graph.history;
    let rules = history.constraints().iter().enumerate();
    let same_world = history.times().next().is_none();
    let rules = rules.filter(|(_, rule)| !is_kept(rule, same_world));
    let mut losses: Vec<Loss> = rules
        .map(|(index, rule)| Loss::Rule {
            index: index as u32,
            kind: rule.constraint.kind_name().to_owned(),
            text: rule.constraint.sentence(),
        })
        .collect();
    losses.extend(batteries(graph, history));
    let last = graph.changes.changes.iter().map(|change| change.at).max();
    losses.extend(last.map(|last| Loss::Changes { last }));
    let moves = |one: &Assumption| matches!(one, Assumption::MovingObstacle { .. });
    if history.assumptions().iter().any(moves) {
        losses.push(Loss::MovingObstacles);
    }
    losses
}

/// Whether a rule is off, or kept however late the robots are; `same_world` where nothing
/// changes.
fn is_kept(rule: &TimedConstraint, same_world: bool) -> bool {
    if rule.constraint.off {
        return true;
    }
    let always = |times: &Times| times.from.is_none() && times.to.is_none();
    match &rule.constraint.kind {
        // Of the ways alone, which stay the same; that no robot goes earlier than in the plan;
        // and what forbids nothing, though its penalty may grow.
        ConstraintKind::OneWay { .. }
        | ConstraintKind::Sequence { .. }
        | ConstraintKind::Depart { .. }
        | ConstraintKind::Late { .. }
        | ConstraintKind::Avoid { .. } => true,
        ConstraintKind::Closed { times, .. } => always(times) && is_whole(rule),
        // In the graph. How long a move takes may change, and with it a gap.
        ConstraintKind::Gap { .. } => is_whole(rule) && same_world,
        ConstraintKind::Turns { .. } => is_whole(rule),
        ConstraintKind::Arrive { times } => times.to.is_none(),
        ConstraintKind::Visit { stay, times, .. } => times.to.is_none() && *stay == 0,
        ConstraintKind::Capacity { .. }
        | ConstraintKind::Apart { .. }
        | ConstraintKind::Before { .. }
        | ConstraintKind::NoWaiting { .. } => false,
    }
}

/// What each battery bears.
fn batteries<'a>(
    graph: &'a OrderGraph<'_>,
    history: &'a History,
) -> impl Iterator<Item = Loss> + 'a {
    let floor = i64::from(history.rules().battery_floor);
    graph.ways.iter().filter_map(move |way| {
        let levels = levels_over_time(history, &way.trajectory);
        let least = levels.into_iter().min()?;
        Some(Loss::Battery {
            agent: way.name().to_owned(),
            spare: u32::try_from(least - floor).unwrap_or(0),
        })
    })
}
