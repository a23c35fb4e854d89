//! What an agent does, on a small disc beside it: it charges, waits, turns, is broken down.

use super::agents::{hidden, opacity};
use super::course::each_step;
use super::ground::push;
use super::motion::When;
use super::stage::Stage;
use crate::{Badge, Pose, Track, corner};

const BOLT: &str = "M2.5-10-7 2.5h6l-2 9L8-3.5H1.5Z";
const PAUSE: &str = "M-4-6V6M4-6V6";
const CROSS: &str = "M-6-6 6 6M6-6-6 6";

impl Stage {
    pub(super) fn badge(
        &self,
        badge: Badge,
        track: &Track,
        pose: &Pose,
        when: &mut When<'_>,
        svg: &mut String,
    ) {
        let shown = |pose: &Pose| pose.badge == Some(badge);
        let blinks = when.at_once(
            || each_step(track, self.steps, 0.0, shown),
            |shown| opacity(*shown),
        );
        let is_shown = shown(pose);
        if !is_shown && blinks.is_empty() {
            return;
        }
        let inks = &self.inks;
        let (circle, sign) = match badge {
            Badge::Charges => (inks.charge, format!("d=\"{BOLT}\" fill=\"{}\"", inks.bolt)),
            Badge::Waits => (
                inks.wait,
                format!(
                    "d=\"{PAUSE}\" fill=\"none\" stroke=\"{}\" stroke-width=\"4.5\" stroke-linecap=\"round\"",
                    inks.floor
                ),
            ),
            Badge::Turns(side) => (
                inks.wait,
                format!(
                    "d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"4\" stroke-linecap=\"round\" stroke-linejoin=\"round\"",
                    side.arrow(),
                    inks.floor
                ),
            ),
            Badge::Broken => (
                inks.danger,
                format!(
                    "d=\"{CROSS}\" fill=\"none\" stroke=\"{}\" stroke-width=\"4.5\" stroke-linecap=\"round\"",
                    inks.floor
                ),
            ),
        };
        let floor = inks.floor;
        push(
            svg,
            format_args!(
                "<g{blinks}{} transform=\"{}\"><circle r=\"17\" fill=\"{circle}\" stroke=\"{floor}\" stroke-width=\"4\"/><path {sign}/></g>",
                hidden(is_shown),
                // In a moving picture it may come to a flag.
                corner::of_badge(true)
            ),
        );
    }
}
