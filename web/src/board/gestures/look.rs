//! The wheel and two fingers: how near the map is seen.

use web_sys::WheelEvent;

use super::place::{Px, distance};
use super::{Hand, Surface};
use crate::board::viewport::Look;

/// How much a pixel of a wheel enlarges, and one of a pinch on a touchpad.
const WHEEL: f64 = 0.0015;
const PINCH: f64 = 0.01;
/// A line of a wheel that counts in lines, in pixels.
const LINE_PX: f64 = 33.0;

impl Surface {
    pub(super) fn wheel(&self, event: &WheelEvent) {
        let unit = match event.delta_mode() {
            WheelEvent::DOM_DELTA_PIXEL => 1.0,
            _ => LINE_PX,
        };
        let (across, down) = (event.delta_x() * unit, event.delta_y() * unit);
        if event.shift_key() || across.abs() > down.abs() {
            if !self.is_fit {
                event.prevent_default();
                let by = if across == 0.0 {
                    (-down, 0.0)
                } else {
                    (-across, -down)
                };
                self.look.emit(Look::Pan(by));
            }
            return;
        }
        // Where there is nothing to make smaller the page may scroll.
        if down > 0.0 && self.is_fit && !event.ctrl_key() {
            return;
        }
        event.prevent_default();
        let rate = if event.ctrl_key() { PINCH } else { WHEEL };
        let at = self.px(event);
        self.look.emit(Look::Zoom((-down * rate).exp(), Some(at)));
    }

    pub(super) fn pinch(&self, hand: &Hand, finger: usize, before: Px, at: Px) {
        let other = hand.fingers.iter().enumerate().find(|&(i, _)| i != finger);
        let Some((_, &(_, other))) = other else {
            return;
        };
        let half = |a: Px, b: Px| (f64::midpoint(a.0, b.0), f64::midpoint(a.1, b.1));
        let (from, to) = (half(before, other), half(at, other));
        let factor = distance(at, other) / distance(before, other).max(1.0);
        let by = (to.0 - from.0, to.1 - from.1);
        self.look.emit(Look::Pinch(factor, from, by));
    }
}
