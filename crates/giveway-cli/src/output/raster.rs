//! SVG as pixels. The pictures that are drawn have no text, so that no font is needed.

use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg::{Options, Tree};

/// A picture as pixels.
pub(crate) struct Raster(Pixmap);

impl Raster {
    /// The pixels of an SVG, in its own size.
    ///
    /// # Errors
    /// Why it cannot be drawn, as a sentence.
    pub(crate) fn of(svg: &str) -> Result<Self, String> {
        let tree = read(svg)?;
        let size = tree.size().to_int_size();
        let pixels = Pixmap::new(size.width(), size.height());
        let mut pixels = pixels.ok_or("There is no memory for a picture of this size.")?;
        resvg::render(&tree, Transform::identity(), &mut pixels.as_mut());
        Ok(Self(pixels))
    }

    /// This one with another one of its size laid over it.
    ///
    /// # Errors
    /// As [`Raster::of`].
    pub(crate) fn under(&self, svg: &str) -> Result<Self, String> {
        let tree = read(svg)?;
        let mut pixels = self.0.clone();
        resvg::render(&tree, Transform::identity(), &mut pixels.as_mut());
        Ok(Self(pixels))
    }

    /// As a PNG.
    ///
    /// # Errors
    /// As [`Raster::of`].
    pub(crate) fn png(&self) -> Result<Vec<u8>, String> {
        let png = self.0.encode_png();
        png.map_err(|error| format!("The picture could not be written: {error}"))
    }

    /// Red, green, blue, and how dense, row by row.
    pub(crate) fn pixels(self) -> Vec<u8> {
        self.0.take()
    }
}

fn read(svg: &str) -> Result<Tree, String> {
    Tree::from_str(svg, &Options::default())
        .map_err(|error| format!("The picture could not be drawn: {error}"))
}
