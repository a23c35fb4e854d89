//! Pictures of a floor, read by the browser: their pixels, and an address that shows them.

use std::rc::Rc;

use giveway_formats::pgm::{is_pgm, read_pgm};
use giveway_model::tr_data;
use giveway_page::floor_plan::{Brought, FloorPlanAction, Picture, kept};
use giveway_page::{Action, FileAction, Notice};
use gloo::file::futures::read_as_data_url;
use wasm_bindgen::{Clamped, JsCast as _, JsValue};
use wasm_bindgen_futures::JsFuture;
use web_sys::{HtmlImageElement, ImageData, Url};
use yew::platform::spawn_local;
use yew::prelude::*;

use crate::held::use_held;
use crate::paper::Paper;
use crate::{Shown, keep};

/// Where this tab keeps a picture, and how it lies.
const PICTURE: &str = "floor-plan";
const PLACE: &str = "floor-plan-place";
/// The longest text of a picture that is kept, in bytes: a browser has some 5 MB for a tab.
const MOST: usize = 4_000_000;

/// The longest side of the picture that is kept, in pixels.
const LONGEST: f64 = 1600.0;
/// A pixel of a picture is dark below this grey.
const DARK: u8 = 128;

/// Lays a picture under the grid, or tells why that cannot be.
pub(crate) async fn lay(brought: Brought<'_>, send: &Callback<Action>) {
    let action = match read(&brought).await {
        Ok((picture, metres)) => Action::FloorPlan(FloorPlanAction::Lay(Rc::new(picture), metres)),
        Err(why) => {
            let notice = Notice::refusal(tr_data!(
                "{name} is no picture that can be shown; the scene stays as it is.",
                name = &brought.picture.name
            ));
            Action::File(FileAction::Tell(notice.with([why])))
        }
    };
    send.emit(action);
}

/// The picture, and metres a pixel where its file tells them.
async fn read(brought: &Brought<'_>) -> Result<(Picture, Option<f64>), String> {
    let bytes = &brought.picture.bytes;
    let (paper, smaller) = if is_pgm(bytes) {
        let map = read_pgm(bytes).map_err(|why| why.to_string())?;
        let grey = map.grey.iter();
        let pixels: Vec<u8> = grey.flat_map(|&grey| [grey, grey, grey, 255]).collect();
        let whole = written(&pixels, map.width).map_err(told)?;
        shrunk(&whole, (map.width, map.height)).map_err(told)?
    } else {
        drawn(bytes, &brought.picture.name).await.map_err(told)?
    };
    let sheet = brought.sheet;
    let read = Read {
        name: brought.picture.name.clone(),
        is_negative: sheet.is_some_and(|sheet| sheet.is_negative),
        below: sheet.map_or(DARK, |sheet| sheet.dark_below()),
    };
    let picture = read.picture(&paper, true).await.map_err(told)?;
    Ok((picture, sheet.map(|sheet| sheet.resolution * smaller)))
}

/// How the pixels of a picture are read, and its file.
struct Read {
    name: String,
    is_negative: bool,
    below: u8,
}

impl Read {
    /// The picture on a paper; `is_new` asks the browser to keep it for this tab.
    async fn picture(&self, paper: &Paper, is_new: bool) -> Result<Picture, JsValue> {
        let blob = paper.blob().await?;
        let address = Url::create_object_url_with_blob(&blob)?;
        let pixels = paper.pixels()?;
        let grey: Vec<u8> = pixels
            .chunks_exact(4)
            .map(|pixel| {
                let sum: u32 = pixel.iter().take(3).map(|&part| u32::from(part)).sum();
                let grey = (sum / 3).to_le_bytes()[0];
                if self.is_negative { 255 - grey } else { grey }
            })
            .collect();
        let name = (self.name.clone(), address);
        let mut picture = Picture::new(name, paper.size(), &grey, self.below);
        picture.is_kept = !is_new || self.keep(blob).await;
        Ok(picture)
    }

    /// Keeps the pixels for this tab, as far as the browser has room; whether it does.
    async fn keep(&self, blob: web_sys::Blob) -> bool {
        keep::forget_here(PICTURE);
        let Ok(data) = read_as_data_url(&blob.into()).await else {
            return false;
        };
        let (negative, below) = (u8::from(self.is_negative), self.below);
        let text = format!("{negative} {below} {data} {}", self.name);
        text.len() < MOST && keep::remember(PICTURE, &text)
    }

    /// What was kept for this tab, with its pixels as a data URL.
    fn kept() -> Option<(Self, String)> {
        let text = keep::remembered(PICTURE)?;
        let mut parts = text.splitn(4, ' ');
        let is_negative = parts.next()? == "1";
        let below = parts.next()?.parse().ok()?;
        let data = parts.next()?.to_owned();
        let name = parts.next()?.to_owned();
        let read = Self {
            name,
            is_negative,
            below,
        };
        Some((read, data))
    }
}

/// Keeps how a floor plan lies, and brings one that was kept back when the page is loaded again.
#[hook]
pub(crate) fn use_kept_floor_plan(state: &Shown, send: &Callback<Action>) {
    let is_settled = use_held(|| false);
    {
        let (is_settled, send) = (Rc::clone(&is_settled), send.clone());
        use_effect_with((), move |()| {
            spawn_local(async move {
                if let Some((picture, place)) = restored().await {
                    let restore = FloorPlanAction::Restore(Rc::new(picture), place);
                    send.emit(Action::FloorPlan(restore));
                }
                is_settled.set(true);
            });
        });
    }
    // A lesson has the board for a while.
    let place = state.lesson().is_none().then(|| kept(state));
    use_effect_with(place, move |place| {
        let Some(place) = place.as_ref().filter(|_| is_settled.get()) else {
            return;
        };
        if let Some(place) = place {
            keep::remember(PLACE, place);
        } else {
            keep::forget_here(PLACE);
            keep::forget_here(PICTURE);
        }
    });
}

async fn restored() -> Option<(Picture, String)> {
    let place = keep::remembered(PLACE)?;
    let (read, data) = Read::kept()?;
    let image = HtmlImageElement::new().ok()?;
    image.set_src(&data);
    JsFuture::from(image.decode()).await.ok()?;
    let paper = Paper::new((image.natural_width(), image.natural_height())).ok()?;
    paper.put(&image).ok()?;
    Some((read.picture(&paper, false).await.ok()?, place))
}

/// A picture that the browser can show, on paper, and how many of its pixels one of the paper is.
async fn drawn(bytes: &[u8], name: &str) -> Result<(Paper, f64), JsValue> {
    let is_svg = name.to_ascii_lowercase().ends_with(".svg");
    let image = Paper::image(bytes, is_svg.then_some("image/svg+xml")).await?;
    // A drawing may have no size of its own.
    let side = |natural: u32| if natural == 0 { 1000 } else { natural };
    let size = (side(image.natural_width()), side(image.natural_height()));
    let (to, smaller) = fitting(size);
    let paper = Paper::new(to)?;
    paper.fill();
    paper.put(&image)?;
    Ok((paper, smaller))
}

/// Pixels on paper as they are.
fn written(pixels: &[u8], width: u32) -> Result<Paper, JsValue> {
    let data = ImageData::new_with_u8_clamped_array(Clamped(pixels), width)?;
    let paper = Paper::new((width, data.height()))?;
    paper.write(&data)?;
    Ok(paper)
}

fn shrunk(whole: &Paper, size: (u32, u32)) -> Result<(Paper, f64), JsValue> {
    let (to, smaller) = fitting(size);
    let paper = Paper::new(to)?;
    paper.copy(whole)?;
    Ok((paper, smaller))
}

/// The size of a picture that is kept, and how many pixels one of it is.
fn fitting((width, height): (u32, u32)) -> ((u32, u32), f64) {
    let smaller = (f64::from(width.max(height)) / LONGEST).max(1.0);
    let side = |pixels: u32| {
        ((f64::from(pixels) / smaller).round() as i32)
            .unsigned_abs()
            .max(1)
    };
    ((side(width), side(height)), smaller)
}

fn told(error: JsValue) -> String {
    let error = error.dyn_into::<js_sys::Error>();
    error.map_or_else(|_| String::new(), |error| String::from(error.message()))
}
