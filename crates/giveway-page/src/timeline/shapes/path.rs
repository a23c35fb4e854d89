//! The path data of single shapes in a lane, in pixels.

use std::fmt::Write as _;

use giveway_picture::whole;

use crate::timeline::Turn;

/// A rectangle with round corners.
pub(crate) fn rounded(path: &mut String, left: f64, top: f64, width: f64, tall: f64, radius: f64) {
    let radius = radius.min(width / 2.0);
    let (across, down) = (px(width - 2.0 * radius), px(tall - 2.0 * radius));
    let (left, top, r) = (px(left + radius), px(top), px(radius));
    let _ = write!(
        path,
        "M{left} {top}h{across}a{r} {r} 0 0 1 {r} {r}v{down}a{r} {r} 0 0 1-{r} {r}h-{across}a{r} {r} 0 0 1-{r}-{r}v-{down}a{r} {r} 0 0 1 {r}-{r}Z"
    );
}

/// Slanted stripes that stay within a rectangle.
pub(crate) fn stripes(path: &mut String, left: f64, top: f64, width: f64, tall: f64) {
    const EVERY: f64 = 8.0;
    let slant = tall * 0.45;
    let count = ((width - slant - 3.0) / EVERY).floor().max(0.0);
    let used = count * EVERY + slant;
    let first = left + (width - used) / 2.0;
    for n in 0..=whole(count) {
        let x = first + f64::from(n) * EVERY;
        let (top, bottom) = (px(top + 1.0), px(top + tall - 1.0));
        let _ = write!(path, "M{} {bottom}L{} {top}", px(x), px(x + slant));
    }
}

/// A hundredth of a pixel is enough.
pub(super) fn px(x: f64) -> f64 {
    (x * 100.0).round() / 100.0
}

/// Adds a clock around a point, as large as a bar of this size has room for.
pub(super) fn clock(d: &mut String, x: f64, y: f64, size: f64) {
    let radius = (size / 2.0 - 2.5).clamp(1.5, 4.5);
    let (r, hand) = (px(radius), px(radius * 0.6));
    let (x, top) = (px(x), px(y - radius));
    let _ = write!(
        d,
        "M{x} {top}a{r} {r} 0 1 1-.01 0M{x} {}v{hand}h{hand}",
        px(y - radius * 0.6)
    );
}

/// Adds the arrow of a turn around a point, as large as a bar of this width has room for.
pub(super) fn arrow(d: &mut String, turn: Turn, x: f64, y: f64, width: f64) {
    let size = (width / 14.0).clamp(0.35, 1.0);
    let by = |n: f64| px(n * size);
    let side = match turn {
        Turn::Left => -1.0,
        Turn::Right => 1.0,
        Turn::Back => {
            let _ = write!(
                d,
                "M{} {}v{}a{r} {r} 0 0 1 {} 0v{}m{} {}l{} {} {} {}",
                px(x - 3.0 * size),
                px(y + 4.0 * size),
                by(-4.5),
                by(5.0),
                by(3.5),
                by(-2.0),
                by(-2.0),
                by(2.0),
                by(2.0),
                by(2.0),
                by(-2.0),
                r = by(2.5),
            );
            return;
        }
    };
    let _ = write!(
        d,
        "M{} {}v{}a{r} {r} 0 0 {} {} {}h{}m{} {}l{} {} {} {}",
        px(x - 4.0 * side * size),
        px(y + 4.0 * size),
        by(-2.5),
        u8::from(turn == Turn::Right),
        by(3.0 * side),
        by(-3.0),
        by(5.0 * side),
        by(-2.5 * side),
        by(-2.5),
        by(2.5 * side),
        by(2.5),
        by(-2.5 * side),
        by(2.5),
        r = by(3.0),
    );
}
