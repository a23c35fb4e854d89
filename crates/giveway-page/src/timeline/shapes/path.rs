//! The path data of single shapes in a lane, in pixels.

use std::fmt::Write as _;

use crate::timeline::whole;

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
