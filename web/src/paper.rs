//! SVG as pixels, drawn by the browser without being shown.

use giveway_page::Shot;
use wasm_bindgen::{JsCast as _, JsValue};
use wasm_bindgen_futures::JsFuture;
use web_sys::{
    Blob, ContextAttributes2d, HtmlImageElement, ImageData, OffscreenCanvas,
    OffscreenCanvasRenderingContext2d,
};

/// What is drawn on.
pub(crate) struct Paper {
    canvas: OffscreenCanvas,
    context: OffscreenCanvasRenderingContext2d,
    size: (u32, u32),
}

impl Paper {
    /// A sheet of paper, so many pixels wide and high.
    ///
    /// # Errors
    /// What the browser says: it may be too large for it.
    pub(crate) fn new(size: (u32, u32)) -> Result<Self, JsValue> {
        let canvas = OffscreenCanvas::new(size.0, size.1)?;
        let often = ContextAttributes2d::new();
        // Without this the pixels of each frame would be fetched from the graphics card.
        often.set_will_read_frequently(true);
        let context = canvas.get_context_with_context_options("2d", &often)?;
        Ok(Self {
            context: context.ok_or("no canvas")?.dyn_into()?,
            canvas,
            size,
        })
    }

    /// Draws an SVG over what is there.
    ///
    /// # Errors
    /// What the browser says.
    pub(crate) async fn draw(&self, svg: &str) -> Result<(), JsValue> {
        self.put(&Self::image(svg.as_bytes(), Some("image/svg+xml")).await?)
    }

    /// A picture that the browser has read.
    ///
    /// # Errors
    /// What the browser says: it may be none.
    pub(crate) async fn image(
        bytes: &[u8],
        kind: Option<&str>,
    ) -> Result<HtmlImageElement, JsValue> {
        let blob = gloo::file::Blob::new_with_options(bytes, kind);
        let url = gloo::file::ObjectUrl::from(blob);
        let image = HtmlImageElement::new()?;
        image.set_src(&url);
        JsFuture::from(image.decode()).await?;
        Ok(image)
    }

    /// Draws a picture, as large as the paper.
    ///
    /// # Errors
    /// What the browser says.
    pub(crate) fn put(&self, image: &HtmlImageElement) -> Result<(), JsValue> {
        let (width, height) = (self.size.0.into(), self.size.1.into());
        self.context
            .draw_image_with_html_image_element_and_dw_and_dh(image, 0.0, 0.0, width, height)
    }

    /// Makes all of it white: a picture may let light through.
    pub(crate) fn fill(&self) {
        self.context.set_fill_style_str("#fff");
        let (width, height) = (self.size.0.into(), self.size.1.into());
        self.context.fill_rect(0.0, 0.0, width, height);
    }

    /// Writes pixels as they are.
    ///
    /// # Errors
    /// What the browser says.
    pub(crate) fn write(&self, pixels: &ImageData) -> Result<(), JsValue> {
        self.context.put_image_data(pixels, 0.0, 0.0)
    }

    /// Its size in pixels.
    pub(crate) const fn size(&self) -> (u32, u32) {
        self.size
    }

    /// It as a PNG.
    ///
    /// # Errors
    /// What the browser says: a picture may be too large for it.
    pub(crate) async fn blob(&self) -> Result<Blob, JsValue> {
        JsFuture::from(self.canvas.convert_to_blob()?)
            .await?
            .dyn_into()
    }

    /// Draws what another sheet has, as large as this one.
    pub(crate) fn copy(&self, other: &Self) -> Result<(), JsValue> {
        let (width, height) = (self.size.0.into(), self.size.1.into());
        self.context.draw_image_with_offscreen_canvas_and_dw_and_dh(
            &other.canvas,
            0.0,
            0.0,
            width,
            height,
        )
    }

    /// Red, green, blue, and how dense, row by row.
    pub(crate) fn pixels(&self) -> Result<Vec<u8>, JsValue> {
        let (width, height) = (self.size.0.into(), self.size.1.into());
        let pixels = self.context.get_image_data(0.0, 0.0, width, height)?;
        Ok(pixels.data().0)
    }
}

/// Paper for frames that have the same ground.
pub(crate) struct Frames {
    ground: Paper,
    frame: Paper,
}

impl Frames {
    /// Paper for the frames that begin with this one.
    ///
    /// # Errors
    /// What the browser says.
    pub(crate) async fn begin(size: (u32, u32), ground: &str) -> Result<Self, JsValue> {
        let frames = Self {
            ground: Paper::new(size)?,
            frame: Paper::new(size)?,
        };
        frames.ground.draw(ground).await?;
        Ok(frames)
    }

    /// The pixels of a frame.
    ///
    /// # Errors
    /// What the browser says.
    pub(crate) async fn pixels(&self, shot: &Shot) -> Result<Vec<u8>, JsValue> {
        self.frame.copy(&self.ground)?;
        self.frame.draw(&shot.over).await?;
        self.frame.pixels()
    }
}
