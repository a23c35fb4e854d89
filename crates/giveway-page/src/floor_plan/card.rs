//! What the page shows of a floor plan: under the grid, in the column, and beside the scene.

use giveway_model::{Cell, tr};

use super::cells::BARS;
use super::{FloorPlan, Picture};
use crate::State;
use crate::edit::Paint;
use crate::number::decimal_text;

/// The column of a floor plan that is turned into cells.
#[derive(Clone, Debug, PartialEq)]
pub struct Card {
    /// Its file and size: `hall.png, 2480 × 1494`.
    pub about: String,
    /// How long it is there, in a sentence.
    pub stays: &'static str,
    /// Its left and upper edge and its width, in cells.
    pub place: (f64, f64, f64),
    /// The button that makes the map larger, where the picture is larger.
    pub grow: Option<String>,
    /// Metres between the two points, where known.
    pub apart: Option<f64>,
    /// Metres a cell.
    pub cell: f64,
    /// How large the map is.
    pub size: Option<String>,
    /// The units that the scene gets with the cells.
    pub units: Option<String>,
    /// How much of a cell is dark at least, in per cent.
    pub threshold: u32,
    /// What cells become.
    pub becomes: Paint,
    /// How many cells are so dark, from light to dark, as parts of the longest bar.
    pub bars: [f64; BARS],
    /// What the cells become, in a sentence.
    pub told: String,
    /// What is to be looked at.
    pub close: Vec<String>,
    /// The button that draws them; `None` where there are none.
    pub draw: Option<String>,
}

/// The column of the floor plan that is turned into cells.
pub fn card(state: &State) -> Option<Card> {
    let plan = state.open_plan()?;
    let draft = &state.document.draft;
    let made = plan.made(draft);
    let (width, height) = (draft.grid().width(), draft.grid().height());
    let is_known = plan.metres.is_some();
    let metres = |cells: u32| decimal_text(f64::from(cells) * plan.cell);
    let n = made.cells.len();
    let (told, draw) = match plan.becomes {
        Paint::Slow => (
            tr!("{n} cell becomes part of the slow zone"
                | "{n} cells become part of the slow zone" % n),
            tr!("Draw {n} slow cell" | "Draw {n} slow cells" % n),
        ),
        Paint::Obstacle | Paint::Charger => (
            tr!("{n} cell becomes an obstacle" | "{n} cells become obstacles" % n),
            tr!("Draw {n} obstacle" | "Draw {n} obstacles" % n),
        ),
    };
    let mut close = Vec::new();
    if !made.close.is_empty() {
        close.push(tr!(
            "{n} cell is close to the line: dotted. Press it to turn it over."
                | "{n} cells are close to the line: dotted. Press one to turn it over."
                    % made.close.len()
        ));
    }
    if made.needed > 0 {
        close.push(tr!(
            "{n} dark cell stays free: a robot starts there, goes there or has a waypoint there."
                | "{n} dark cells stay free: robots start there, go there or have waypoints there."
                    % made.needed
        ));
    }
    let logs = made.bars.map(|count| f64::from(count).ln_1p());
    let longest = logs.iter().copied().fold(1.0, f64::max);
    Some(Card {
        about: about(&plan.picture),
        stays: stays(&plan.picture),
        place: (plan.corner.0, plan.corner.1, plan.wide),
        grow: plan
            .grown(draft.grid())
            .map(|(width, height)| tr!("Make the map {width} × {height}", width, height)),
        apart: plan.apart,
        cell: plan.cell,
        size: is_known.then(|| {
            tr!(
                "{width} × {height} cells are {across} × {down} m.",
                width,
                height,
                across = metres(width),
                down = metres(height)
            )
        }),
        units: plan.units(draft.scene()).filter(|_| n > 0).map(|units| {
            tr!(
                "Drawing sets the units of the scene: a cell is {cell} m wide, a step takes {step} s. Edit scene changes them.",
                cell = units.cell,
                step = units.step
            )
        }),
        threshold: plan.threshold,
        becomes: plan.becomes,
        bars: logs.map(|log| log / longest),
        told,
        close,
        draw: (n > 0).then_some(draw),
    })
}

fn about(picture: &Picture) -> String {
    format!(
        "{}, {} \u{d7} {}",
        picture.name, picture.width, picture.height
    )
}

/// How long a picture is there.
fn stays(picture: &Picture) -> &'static str {
    if picture.is_kept {
        tr!(
            "It stays under the grid in this tab, also when the page is loaded again; it is no part of the file."
        )
    } else {
        tr!(
            "It stays under the grid until the page is closed or loaded again: the browser has no room to keep it. It is no part of the file."
        )
    }
}

/// A floor plan as it lies under the grid. Lengths are in cells.
#[derive(Clone, Debug, PartialEq)]
pub struct Laid {
    /// Where the browser has the picture.
    pub address: String,
    /// How it is put into its place: an SVG transformation of the picture in pixels, to units
    /// of the map.
    pub transform: String,
    /// Width and height of the picture in pixels, as it was brought.
    pub pixels: (u32, u32),
    /// Its upper left and its lower right corner; `None` where nothing of it is done.
    pub corners: Option<[(f64, f64); 2]>,
    /// The two points.
    pub points: [(f64, f64); 2],
    /// Their distance in words.
    pub apart: String,
    /// Cells that become what the column says, and cells near the threshold.
    pub cells: [Vec<Cell>; 2],
}

/// The floor plan under the grid, where it is seen.
pub fn laid(state: &State) -> Option<Laid> {
    let plan = state.view.floor_plan.as_deref()?;
    if !plan.is_shown || !state.can_place_fleet() {
        return None;
    }
    let made = state
        .open_plan()
        .map(|plan| plan.made(&state.document.draft));
    let made = made.unwrap_or_default();
    let at = |(right, down): (f64, f64)| {
        (
            plan.corner.0 + right * plan.wide,
            plan.corner.1 + down * plan.wide,
        )
    };
    let far = (plan.corner.0 + plan.wide, plan.corner.1 + plan.high());
    Some(Laid {
        address: plan.picture.address.clone(),
        transform: transform(plan),
        pixels: (plan.picture.width, plan.picture.height),
        corners: plan.is_open.then_some([plan.corner, far]),
        points: plan.points.map(at),
        apart: match plan.apart {
            Some(apart) => tr!(
                "these two points are {apart} m apart",
                apart = decimal_text(apart)
            ),
            None => tr!("how far apart are these two points?").to_owned(),
        },
        cells: [made.cells, made.close],
    })
}

fn transform(plan: &FloorPlan) -> String {
    let (x, y) = (100.0 * plan.corner.0, 100.0 * plan.corner.1);
    let (width, height) = plan.pixels();
    let scale = 100.0 * plan.wide / width.max(1.0);
    let turn = match plan.turns {
        1 => format!(" translate({width} 0) rotate(90)"),
        2 => format!(" translate({width} {height}) rotate(180)"),
        3 => format!(" translate(0 {height}) rotate(270)"),
        _ => String::new(),
    };
    format!("translate({x:.2} {y:.2}) scale({scale:.5}){turn}")
}

/// What stands beside the scene of a picture that is under the grid: its file, and whether it
/// is seen.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Row {
    /// Its file and size.
    pub about: String,
    /// Whether it is seen.
    pub is_shown: bool,
    /// How long it is there, in a sentence.
    pub stays: &'static str,
}

/// The floor plan under the grid, hidden or not.
pub fn row(state: &State) -> Option<Row> {
    let plan = state.view.floor_plan.as_deref()?;
    Some(Row {
        about: about(&plan.picture),
        is_shown: plan.is_shown,
        stays: stays(&plan.picture),
    })
}
