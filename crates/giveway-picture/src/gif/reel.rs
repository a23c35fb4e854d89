//! The frames of a GIF, each as SVG: the ground once, and what changes over it.

use std::fmt;

use borsh::{BorshDeserialize, BorshSerialize};
use giveway_model::words::grouped;
use giveway_model::{Instance, Plan};

use super::palette::Palette;
use crate::Look;
use crate::draw::Stage;

/// How many frames a step may have: as many as there is room for. With eight a step
/// takes as long as on the page.
const FRAMES: [u32; 4] = [8, 4, 2, 1];
/// How long a step takes, the start is seen before, and the end after it, in hundredths
/// of a second.
const STEP: u16 = 48;
const LEAD: u16 = 60;
const REST: u16 = 180;

/// The most pixels of all frames together, the most of one, and the most frames: what
/// takes about half a minute to draw, and fits into the memory of a tab.
const MOST_PIXELS: u64 = 400_000_000;
const MOST_PIXELS_OF_ONE: u64 = 4_000_000;
const MOST_FRAMES: u64 = 3000;

/// The frames of a plan, in order.
pub struct Reel {
    stage: Stage,
    frames_a_step: u32,
}

/// What is to be drawn of a frame, each as SVG of the same size.
#[derive(Clone, Debug, PartialEq, Eq, BorshSerialize, BorshDeserialize)]
pub struct Shot {
    /// Width and height, in pixels.
    pub size: (u32, u32),
    /// What is the same in all frames, only with the first of them.
    pub ground: Option<String>,
    /// What is laid over it.
    pub over: String,
}

/// A GIF that would be too large: what it would be, and what to do.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TooLarge {
    size: (u32, u32),
    frames: u64,
}

impl fmt::Display for TooLarge {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let ((width, height), frames) = (self.size, grouped(self.frames));
        write!(
            f,
            "The GIF is too large: {frames} frames of {width} x {height} pixels. Make the cells \
             smaller, or take the moving picture as SVG."
        )
    }
}

impl Reel {
    /// The frames of a plan, as many a step as there is room for.
    ///
    /// # Errors
    /// Where there is no room for one frame a step.
    pub fn new(instance: &Instance, plan: &Plan, look: &Look) -> Result<Self, TooLarge> {
        let stage = Stage::new(instance, plan, look);
        let (width, height) = stage.sheet.size;
        let pixels = u64::from(width) * u64::from(height);
        let frames = |a_step: u32| u64::from(a_step) * u64::from(stage.steps) + 1;
        let fits = |a_step: &u32| {
            let frames = frames(*a_step);
            frames <= MOST_FRAMES && frames.saturating_mul(pixels) <= MOST_PIXELS
        };
        let is_small = pixels <= MOST_PIXELS_OF_ONE && width.max(height) <= u16::MAX.into();
        let frames_a_step = FRAMES.into_iter().find(fits).filter(|_| is_small);
        match frames_a_step {
            Some(frames_a_step) => Ok(Self {
                stage,
                frames_a_step,
            }),
            None => Err(TooLarge {
                size: (width, height),
                frames: frames(1),
            }),
        }
    }

    /// How many frames there are.
    pub const fn count(&self) -> usize {
        (self.frames_a_step * self.stage.steps) as usize + 1
    }

    /// Width and height of a frame, in pixels.
    pub const fn size(&self) -> (u32, u32) {
        self.stage.sheet.size
    }

    /// The time that a frame shows, in steps.
    pub fn time(&self, index: usize) -> f64 {
        index.min(self.count() - 1) as f64 / f64::from(self.frames_a_step)
    }

    /// A frame.
    pub fn shot(&self, index: usize) -> Shot {
        let stage = &self.stage;
        let ground = || {
            let shapes = stage.floor() + &stage.whole_ways();
            stage.svg(&stage.title(), "", "", &shapes)
        };
        Shot {
            size: self.size(),
            ground: (index == 0).then(ground),
            over: stage.overlay(&stage.at(self.time(index))),
        }
    }

    /// How long a frame is seen, in hundredths of a second.
    pub(super) fn delay(&self, index: usize) -> u16 {
        let usual = STEP / self.frames_a_step as u16;
        match index {
            _ if index + 1 == self.count() => REST,
            0 => LEAD,
            _ => usual,
        }
    }

    pub(super) fn palette(&self) -> Palette {
        Palette::new(&self.stage.look, self.stage.tracks.len())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_too_large_is_told_with_its_size() {
        let large = TooLarge {
            size: (2000, 1000),
            frames: 12_345,
        };
        assert_eq!(
            large.to_string(),
            "The GIF is too large: 12\u{202f}345 frames of 2000 x 1000 pixels. Make the cells \
             smaller, or take the moving picture as SVG."
        );
    }
}
