//! The pixels of a floor plan: how much of a rectangle is dark.

use std::rc::Rc;

use super::whole;

/// A picture of a floor, which the browser shows by its address.
#[derive(Clone, Debug)]
pub struct Picture {
    /// The name of its file.
    pub name: String,
    /// Where the browser has it.
    pub address: String,
    /// Columns of pixels.
    pub width: u32,
    /// Rows of pixels.
    pub height: u32,
    /// Whether the browser keeps it for when the page is loaded again.
    pub is_kept: bool,
    /// How many pixels are dark above and left of each corner of a pixel, row by row.
    sums: Rc<[u32]>,
}

impl PartialEq for Picture {
    fn eq(&self, other: &Self) -> bool {
        Rc::ptr_eq(&self.sums, &other.sums) && self.address == other.address
    }
}

impl Picture {
    /// A picture of grey pixels, 0 black, row by row; those below a grey are dark. Pixels
    /// that are missing are light.
    pub fn new(
        (name, address): (String, String),
        (width, height): (u32, u32),
        grey: &[u8],
        below: u8,
    ) -> Self {
        let columns = width as usize + 1;
        let mut sums = vec![0; columns * (height as usize + 1)];
        for row in 0..height as usize {
            let mut dark = 0;
            for column in 0..width as usize {
                let is_dark = grey
                    .get(row * width as usize + column)
                    .is_some_and(|&g| g < below);
                dark += u32::from(is_dark);
                let above = sums[row * columns + column + 1];
                sums[(row + 1) * columns + column + 1] = above + dark;
            }
        }
        Self {
            name,
            address,
            width,
            height,
            is_kept: false,
            sums: sums.into(),
        }
    }

    /// How much of a rectangle of pixels is dark, from 0 to 1; what is beside the picture is
    /// light.
    pub(super) fn darkness(&self, (left, right): (f64, f64), (top, bottom): (f64, f64)) -> f64 {
        let area = (right - left) * (bottom - top);
        if area <= 0.0 {
            return 0.0;
        }
        let near = |at: f64, most: u32| whole(at.round().min(f64::from(most)));
        let (left, right) = (near(left, self.width), near(right, self.width));
        let (top, bottom) = (near(top, self.height), near(bottom, self.height));
        let sum = |row: usize, column: usize| {
            let at = row * (self.width as usize + 1) + column;
            self.sums.get(at).copied().unwrap_or(0)
        };
        let dark = sum(bottom, right) + sum(top, left) - sum(bottom, left) - sum(top, right);
        (f64::from(dark) / area).min(1.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn darkness_is_that_of_the_pixels_counted() {
        // A checked picture, in which each second pixel is dark.
        let grey: Vec<u8> = (0..35)
            .map(|pixel| if pixel % 2 == 0 { 10 } else { 200 })
            .collect();
        let picture = Picture::new((String::new(), String::new()), (7, 5), &grey, 128);
        for (left, right, top, bottom) in [(0, 7, 0, 5), (2, 3, 1, 2), (1, 6, 2, 4), (3, 4, 0, 5)] {
            let cells = (top..bottom).flat_map(|y| (left..right).map(move |x| y * 7 + x));
            let dark = cells.filter(|&pixel| grey[pixel] < 128).count();
            let area = (right - left) * (bottom - top);
            let found = picture.darkness((left as f64, right as f64), (top as f64, bottom as f64));
            assert!((found - dark as f64 / area as f64).abs() < 1e-9);
        }
        assert!(
            picture.darkness((-9.0, 0.0), (0.0, 5.0)) < 1e-9,
            "beside it is light"
        );
        assert!(
            picture.darkness((3.0, 3.0), (0.0, 5.0)) < 1e-9,
            "nothing is light"
        );
    }
}
