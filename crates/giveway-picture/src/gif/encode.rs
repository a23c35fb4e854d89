//! Frames as a GIF: of each only the part that changed.

use std::fmt;

use gif::{DisposalMethod, Frame, Repeat};

use super::palette::{Palette, UNCHANGED};
use super::reel::Reel;

/// Bytes of a pixel: red, green, blue, and how dense.
const PIXEL: usize = 4;

/// Makes a GIF of frames, one after the other.
pub struct Encoder {
    file: Result<gif::Encoder<Vec<u8>>, Broken>,
    palette: Palette,
    size: (u32, u32),
    /// How long each frame is seen.
    delays: Vec<u16>,
    pushed: usize,
    /// The pixels of the frame before, and the number of the colour of each.
    pixels: Vec<u8>,
    numbers: Vec<u8>,
    /// The frame before, which is written once it is known how long it is seen.
    waiting: Option<Frame<'static>>,
}

/// A GIF that cannot be made: a frame of the wrong size, or one too many or too few.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Broken(String);

impl fmt::Display for Broken {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for Broken {}

/// What the library says of it; nothing that it should refuse is asked of it.
fn refused(error: &gif::EncodingError) -> Broken {
    Broken(format!("The GIF could not be written: {error}"))
}

impl Encoder {
    /// An encoder for these frames, in their order.
    pub fn new(reel: &Reel) -> Self {
        let palette = reel.palette();
        let size = reel.size();
        let (width, height) = (size.0 as u16, size.1 as u16);
        let file = gif::Encoder::new(Vec::new(), width, height, &palette.table());
        let file = file.and_then(|mut file| {
            file.set_repeat(Repeat::Infinite)?;
            Ok(file)
        });
        Self {
            file: file.map_err(|error| refused(&error)),
            palette,
            size,
            delays: (0..reel.count()).map(|index| reel.delay(index)).collect(),
            pushed: 0,
            pixels: Vec::new(),
            numbers: Vec::new(),
            waiting: None,
        }
    }

    /// The next frame: its pixels, row by row.
    ///
    /// # Errors
    /// Where it has another size than its picture, or is one too many.
    pub fn push(&mut self, pixels: &[u8]) -> Result<(), Broken> {
        let count = self.size.0 as usize * self.size.1 as usize;
        if pixels.len() != count * PIXEL {
            let (width, height) = self.size;
            return Err(Broken(format!(
                "found a frame of {} bytes, expected {width} x {height} pixels",
                pixels.len()
            )));
        }
        let Some(&delay) = self.delays.get(self.pushed) else {
            return Err(Broken("found one frame too many".to_owned()));
        };
        self.pushed += 1;
        let changed = self.see(pixels);
        match (changed, &mut self.waiting) {
            // Nothing new to see: the frame before is seen longer.
            (None, Some(before)) => before.delay = before.delay.saturating_add(delay),
            (None, None) => {}
            (Some((part, numbers)), waiting) => {
                let before = waiting.replace(part.frame(numbers, delay));
                if let Some(before) = before {
                    self.write(&before)?;
                }
            }
        }
        Ok(())
    }

    /// The file.
    ///
    /// # Errors
    /// Where frames are missing.
    pub fn finish(mut self) -> Result<Vec<u8>, Broken> {
        if self.pushed != self.delays.len() {
            let (pushed, all) = (self.pushed, self.delays.len());
            return Err(Broken(format!("found {pushed} of {all} frames")));
        }
        if let Some(last) = self.waiting.take() {
            self.write(&last)?;
        }
        let bytes = self.file?.into_inner();
        bytes.map_err(|error| Broken(format!("The GIF could not be written: {error}")))
    }

    /// Takes in the pixels of a frame: the part that differs from the one before, with
    /// the numbers of what changed in it.
    fn see(&mut self, pixels: &[u8]) -> Option<(Part, Vec<u8>)> {
        let is_first = self.pixels.is_empty();
        if is_first {
            self.pixels = vec![0; pixels.len()];
            self.numbers = vec![UNCHANGED; pixels.len() / PIXEL];
        }
        let mut changes = Vec::new();
        let mut last = ([0; 3], self.palette.nearest([0; 3]));
        let both = self
            .pixels
            .chunks_exact(PIXEL)
            .zip(pixels.chunks_exact(PIXEL));
        for (index, (before, now)) in both.enumerate() {
            let &[red, green, blue, _] = now else {
                continue;
            };
            if before == now && !is_first {
                continue;
            }
            let pixel = [red, green, blue];
            if last.0 != pixel {
                last = (pixel, self.palette.nearest(pixel));
            }
            if let Some(number) = self.numbers.get_mut(index)
                && *number != last.1
            {
                *number = last.1;
                changes.push((index, last.1));
            }
        }
        self.pixels.copy_from_slice(pixels);
        let width = self.size.0 as usize;
        let at = |index: usize| (index % width, index / width);
        let places = changes.iter().map(|(index, _)| at(*index));
        let part = places.map(Part::pixel).reduce(Part::and)?;
        let mut numbers = vec![UNCHANGED; part.width() * part.height()];
        for (index, number) in changes {
            let (x, y) = at(index);
            let place = (y - part.top) * part.width() + (x - part.left);
            if let Some(place) = numbers.get_mut(place) {
                *place = number;
            }
        }
        Some((part, numbers))
    }

    fn write(&mut self, frame: &Frame<'_>) -> Result<(), Broken> {
        match &mut self.file {
            Ok(file) => file.write_frame(frame).map_err(|error| refused(&error)),
            Err(broken) => Err(broken.clone()),
        }
    }
}

/// A part of a frame, in pixels; its right and lower end are beyond it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Part {
    left: usize,
    top: usize,
    right: usize,
    bottom: usize,
}

impl Part {
    const fn pixel((x, y): (usize, usize)) -> Self {
        Self {
            left: x,
            top: y,
            right: x + 1,
            bottom: y + 1,
        }
    }

    /// The smallest part that holds both.
    fn and(self, other: Self) -> Self {
        Self {
            left: self.left.min(other.left),
            top: self.top.min(other.top),
            right: self.right.max(other.right),
            bottom: self.bottom.max(other.bottom),
        }
    }

    const fn width(self) -> usize {
        self.right - self.left
    }

    const fn height(self) -> usize {
        self.bottom - self.top
    }

    /// The frame that changes this part to these numbers.
    fn frame(self, numbers: Vec<u8>, delay: u16) -> Frame<'static> {
        Frame {
            left: self.left as u16,
            top: self.top as u16,
            width: self.width() as u16,
            height: self.height() as u16,
            delay,
            dispose: DisposalMethod::Keep,
            transparent: Some(UNCHANGED),
            buffer: numbers.into(),
            ..Frame::default()
        }
    }
}
