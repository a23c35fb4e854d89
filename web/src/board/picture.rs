//! The board as a picture that stands by itself: SVG, and PNG made of that.
//!
//! On the page its look comes from style sheets. The picture has none: what they
//! make of each shape is written onto a copy of it. What is for doing something
//! on the board is left out.

use giveway_model::Grid;
use giveway_page::board::Frame;
use wasm_bindgen::{JsCast as _, JsValue};
use web_sys::{Blob, CssStyleDeclaration, Element, Event, SvgsvgElement, XmlSerializer};
use yew::prelude::hook;

use crate::paper::Paper;
use crate::sheet::use_between;

/// What is done with, and not part of a picture.
const OVERLAYS: &str = "[role=row], .floor-plan, .hover, .cursor, .selcell, .selring";
/// What the look of a shape is made of, with what it is where nothing is said.
const LOOK: [(&str, &str); 12] = [
    ("fill", "rgb(0, 0, 0)"),
    ("fill-opacity", "1"),
    ("stroke", "none"),
    ("stroke-width", "1px"),
    ("stroke-opacity", "1"),
    ("stroke-dasharray", "none"),
    ("stroke-linecap", "butt"),
    ("stroke-linejoin", "miter"),
    ("vector-effect", "none"),
    ("paint-order", "normal"),
    OPACITY,
    TRANSFORM,
];
const OPACITY: (&str, &str) = ("opacity", "1");
const TRANSFORM: (&str, &str) = ("transform", "none");
/// The same of letters.
const LETTERS: [(&str, &str); 5] = [
    ("font-family", ""),
    ("font-size", ""),
    ("font-weight", "400"),
    ("letter-spacing", "normal"),
    ("text-anchor", "start"),
];
/// What stays of a shape's own attributes begins with none of these.
const DROPPED: [&str; 6] = ["class", "role", "tabindex", "style", "aria-", "data-"];

/// The space around the map, in units: room for the axis.
const MARGIN: f64 = 40.0;
/// The side of a cell, and the longest side of a picture, in pixels.
const CELL_PX: f64 = 64.0;
const LONGEST_PX: f64 = 2048.0;
/// How much finer a PNG is.
const FINER: u32 = 2;

/// What is in sight of the board, as it looks now.
pub(crate) struct Picture {
    /// The SVG.
    pub(crate) svg: String,
    /// Width and height, in pixels.
    size: (u32, u32),
}

/// The events between which the board has the detail of a picture, whatever its size on the
/// screen is.
const BEGIN: &str = "giveway-picture";
const END: &str = "giveway-picture-end";

/// Whether the board is being drawn for a picture.
#[hook]
pub(super) fn use_drawn() -> bool {
    use_between(BEGIN, END)
}

/// What is in sight, with cells as large as in a picture, and with room for the axis where
/// the map begins in sight.
pub(super) fn enlarged(frame: Frame) -> Frame {
    let cell_px = CELL_PX.min(LONGEST_PX / frame.width.max(frame.height) * 100.0);
    let room = |edge: f64| {
        if edge <= 0.0 {
            (edge + MARGIN).max(0.0)
        } else {
            0.0
        }
    };
    let (left, above) = (room(frame.x), room(frame.y));
    Frame {
        x: frame.x - left,
        y: frame.y - above,
        width: frame.width + left,
        height: frame.height + above,
        cell_px: cell_px.max(frame.cell_px),
    }
}

/// The picture of the board, which has this map; its title is for those who
/// do not see it.
///
/// # Errors
/// What the browser says; there is nothing that it should refuse.
pub(crate) fn picture(grid: &Grid, title: &str) -> Result<Picture, JsValue> {
    let window = gloo::utils::window();
    window.dispatch_event(&Event::new(BEGIN)?)?;
    let picture = copied(grid, title);
    window.dispatch_event(&Event::new(END)?)?;
    picture
}

/// The picture of the board as it is.
fn copied(grid: &Grid, title: &str) -> Result<Picture, JsValue> {
    let document = gloo::utils::document();
    // Its accessible name is in the language that is spoken.
    let board = document.query_selector("svg[data-board]")?;
    let board: SvgsvgElement = board.ok_or("no board")?.dyn_into()?;
    let copy: Element = board.clone_node_with_deep(true)?.dyn_into()?;
    let (shapes, copies) = (
        board.query_selector_all("*")?,
        copy.query_selector_all("*")?,
    );
    for n in 0..shapes.length() {
        let shape = shapes.get(n).and_then(|node| node.dyn_into().ok());
        let copy = copies.get(n).and_then(|node| node.dyn_into().ok());
        if let (Some(shape), Some(copy)) = (shape, copy) {
            dress(&shape, &copy)?;
        }
    }
    strip(&copy)?;
    copy.remove_attribute("id")?;

    let sight = board.view_box().base_val().ok_or("no sight")?;
    let part = |from: f32, length: f32, cells: u32| {
        let (from, length) = (f64::from(from), f64::from(length));
        let start = from.max(-MARGIN).floor();
        let end = (from + length).min(f64::from(100 * cells) + MARGIN).ceil();
        (start, (end - start).max(1.0))
    };
    let (x, width) = part(sight.x(), sight.width(), grid.width());
    let (y, height) = part(sight.y(), sight.height(), grid.height());
    let scale = (CELL_PX / 100.0).min(LONGEST_PX / width.max(height));
    let pixels = |units: f64| ((units * scale).ceil() as i32).unsigned_abs();
    let size = (pixels(width), pixels(height));
    let whole = |number: f64| (number as i32).to_string();
    copy.set_attribute("viewBox", &[x, y, width, height].map(whole).join(" "))?;
    copy.set_attribute("width", &size.0.to_string())?;
    copy.set_attribute("height", &size.1.to_string())?;
    copy.set_attribute("role", "img")?;

    let add = |name: &str| {
        let element = document.create_element_ns(copy.namespace_uri().as_deref(), name)?;
        copy.insert_before(&element, copy.first_child().as_ref())?;
        Ok::<_, JsValue>(element)
    };
    let ground = add("rect")?;
    // Whole pixels are a little more than what is in sight.
    for (name, value) in [
        ("x", x - 9.0),
        ("y", y - 9.0),
        ("width", width + 18.0),
        ("height", height + 18.0),
    ] {
        ground.set_attribute(name, &whole(value))?;
    }
    ground.set_attribute(
        "fill",
        &style(&gloo::utils::body())?.get_property_value("background-color")?,
    )?;
    add("title")?.set_text_content(Some(title));
    let svg = XmlSerializer::new()?.serialize_to_string(&copy)?;
    // A name may hold them, an XML file must not.
    let svg = svg.replace(
        |c: char| (c.is_control() && c != '\n') || matches!(c, '\u{fffe}' | '\u{ffff}'),
        "",
    );
    Ok(Picture { svg, size })
}

impl Picture {
    /// The same as a PNG, twice as fine.
    ///
    /// # Errors
    /// What the browser says: a picture may be too large for it.
    pub(crate) async fn png(&self) -> Result<Blob, JsValue> {
        let paper = Paper::new((self.size.0 * FINER, self.size.1 * FINER))?;
        paper.draw(&self.svg).await?;
        paper.blob().await
    }
}

fn style(element: &Element) -> Result<CssStyleDeclaration, JsValue> {
    let style = gloo::utils::window().get_computed_style(element)?;
    style.ok_or_else(|| "no style".into())
}

/// Gives the copy of a shape the look of the shape; what is not seen is left out.
fn dress(shape: &Element, copy: &Element) -> Result<(), JsValue> {
    let name = shape.tag_name();
    if matches!(name.as_str(), "defs" | "pattern") {
        return Ok(());
    }
    let style = style(shape)?;
    let value = |name: &str| style.get_property_value(name);
    let is_group = name == "g";
    let is_hidden = value("display")? == "none"
        || value("opacity")? == "0"
        || (!is_group && value("visibility")? == "hidden");
    if is_hidden || shape.closest(OVERLAYS)?.is_some() {
        copy.remove();
        return Ok(());
    }
    strip(copy)?;
    let write = |look: &[(&str, &str)]| {
        for &(name, usual) in look {
            let value = value(name)?;
            if value != usual {
                copy.set_attribute(name, &value)?;
            }
        }
        Ok::<_, JsValue>(())
    };
    if is_group {
        return write(&[OPACITY, TRANSFORM]);
    }
    write(&LOOK)?;
    if name == "text" {
        write(&LETTERS)?;
    }
    Ok(())
}

/// Takes away what means something on the page only.
fn strip(copy: &Element) -> Result<(), JsValue> {
    for name in copy.get_attribute_names() {
        if let Some(name) = name.as_string()
            && DROPPED.iter().any(|dropped| name.starts_with(dropped))
        {
            copy.remove_attribute(&name)?;
        }
    }
    Ok(())
}
