//! A plan as a GIF: the frames to be drawn, their colours, and the file.
//!
//! Whoever draws the frames (a browser, or a library natively) gets each as SVG and gives
//! back its pixels; all else is here.

mod encode;
mod palette;
mod reel;

use std::ops::ControlFlow;

use giveway_model::{Instance, Plan};

pub use encode::{Broken, Encoder};
pub use reel::{Reel, Shot, TooLarge};

use crate::Look;

/// Why there is no GIF.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Failure<E> {
    /// It would be too large.
    TooLarge(TooLarge),
    /// A frame could not be drawn.
    Draw(E),
    /// A frame has another size than its picture.
    Broken(Broken),
    /// Somebody said stop.
    Stopped,
}

/// Makes a GIF: `draw` gives the pixels of each shot (red, green, blue, and how dense,
/// row by row), `tell` hears how many frames of how many are done and can say stop.
///
/// # Errors
/// Where it would be too large, and where drawing fails or is stopped.
pub fn gif<E>(
    instance: &Instance,
    plan: &Plan,
    look: &Look,
    mut draw: impl FnMut(&Shot) -> Result<Vec<u8>, E>,
    mut tell: impl FnMut(usize, usize) -> ControlFlow<()>,
) -> Result<Vec<u8>, Failure<E>> {
    let reel = Reel::new(instance, plan, look).map_err(Failure::TooLarge)?;
    let mut encoder = Encoder::new(&reel);
    for index in 0..reel.count() {
        if tell(index, reel.count()).is_break() {
            return Err(Failure::Stopped);
        }
        let pixels = draw(&reel.shot(index)).map_err(Failure::Draw)?;
        encoder.push(&pixels).map_err(Failure::Broken)?;
    }
    encoder.finish().map_err(Failure::Broken)
}
