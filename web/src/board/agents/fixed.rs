//! An agent drawn at once where it is at a time: on paper no frame moves it there.

use giveway_page::board::{Badge, CELL, Cast, Pose, of_badge};

use super::parts::{RING, shift};

/// The attributes that a frame sets, see [`Parts`](super::parts::Parts).
#[derive(Default)]
pub(super) struct Fixed {
    pub(super) place: Option<String>,
    pub(super) is_gone: bool,
    pub(super) turn: Option<String>,
    pub(super) aim: Option<String>,
    pub(super) level: Option<String>,
    pub(super) reserve: Option<&'static str>,
    pub(super) badge: Option<String>,
    pub(super) does: Option<Badge>,
}

impl Fixed {
    pub(super) fn of(pose: &Pose, cast: &Cast) -> Self {
        let (by, scale) = pose.aside.unzip();
        let x = super::super::units(pose.at.x) + by.unwrap_or(0.0) * CELL;
        let y = super::super::units(pose.at.y);
        let has_flag = || cast.has_goal_at(pose.at);
        Self {
            place: Some(shift(x, y, scale)),
            is_gone: pose.is_gone,
            turn: pose.heading.map(|heading| format!("rotate({heading:.0})")),
            aim: pose.turns_to.map(|to| format!("rotate({to:.0})")),
            level: pose
                .charge
                .map(|charge| format!("{:.1} {RING}", charge.share * RING)),
            reserve: pose.charge.map(giveway_picture::Charge::class),
            badge: pose.badge.map(|_| of_badge(has_flag())),
            does: pose.badge,
        }
    }
}
