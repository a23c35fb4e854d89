//! Which part of a long plan is seen: only that is drawn.

mod watch;

use std::ops::Range;

use giveway_page::timeline::{Axis, MIN_COLUMN};
use giveway_picture::whole;
use web_sys::Element;
use yew::NodeRef;

pub(super) use watch::use_seen;

/// The height of a row of the plan table, in pixels: as in the style sheet.
const TABLE_ROW: f64 = 22.0;
/// Free room after the last column, in pixels: the thumb and a flag reach into it.
const END: f64 = 9.0;
/// Rows drawn beyond those that are seen, on each side.
const MORE: usize = 3;

/// How large the whole plan is.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Extent {
    /// Its last time.
    pub last: u32,
    /// The number of lanes.
    pub lanes: usize,
    /// The height of a lane, in pixels.
    pub lane: f64,
    /// The number of rows of the table.
    pub rows: usize,
    /// The least width of a column of the table, in pixels.
    pub least: f64,
    /// Whether labels tell what becomes of robots, and are wider for that.
    pub tells: bool,
}

/// What is seen of it.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Seen {
    /// The room for columns, in pixels.
    pub room: f64,
    /// The width of the labels before them, in pixels.
    pub label: f64,
    /// Whether the table is seen.
    pub table: bool,
    /// Whether one of them scrolls up and down.
    pub gutter: bool,
    /// The columns to draw.
    pub columns: Range<u32>,
    /// The lanes to draw.
    pub lanes: Range<usize>,
    /// The rows of the table to draw.
    pub rows: Range<usize>,
}

impl Seen {
    /// Looks at the two places that scroll.
    pub(super) fn look(extent: Extent, lanes: &NodeRef, table: &NodeRef) -> Self {
        let (lanes, table) = (lanes.cast::<Element>(), table.cast::<Element>());
        let is_shown = |place: &&Element| place.client_width() > 0;
        let (lanes, table) = (
            lanes.as_ref().filter(is_shown),
            table.as_ref().filter(is_shown),
        );
        let Some(place) = lanes.or(table) else {
            return Self::default();
        };
        let label = place.query_selector(".lab").ok().flatten();
        let label = label.map_or(0.0, |label| label.get_bounding_client_rect().width());
        let mut seen = Self {
            room: f64::from(place.client_width()) - label - END,
            label,
            table: table.is_some(),
            gutter: [lanes, table].into_iter().flatten().any(scrolls_down),
            ..Self::default()
        };
        let left = f64::from(place.scroll_left());
        seen.columns = seen.axis(extent).seen(left, left + seen.room);
        if let Some(lanes) = lanes {
            seen.lanes = rows(lanes, extent.lane, extent.lanes);
        }
        if let Some(table) = table {
            seen.rows = rows(table, TABLE_ROW, extent.rows);
        }
        seen
    }

    /// The same of another plan, as far as that goes: it can be shorter and have
    /// fewer lanes than the one that was looked at.
    #[must_use]
    pub(super) fn within(&self, extent: Extent) -> Self {
        let cut = |range: &Range<usize>, count: usize| range.start.min(count)..range.end.min(count);
        let columns = extent.last.saturating_add(1);
        Self {
            columns: self.columns.start.min(columns)..self.columns.end.min(columns),
            lanes: cut(&self.lanes, extent.lanes),
            rows: cut(&self.rows, extent.rows),
            ..self.clone()
        }
    }

    /// The columns that lanes and table share.
    pub(super) fn axis(&self, extent: Extent) -> Axis {
        let least = if self.table { extent.least } else { MIN_COLUMN };
        Axis::fit(extent.last, self.room, least)
    }

    /// The room above and below the rows that are drawn, in pixels.
    pub(super) fn beyond(drawn: &Range<usize>, count: usize, height: f64) -> (f64, f64) {
        let below = count.saturating_sub(drawn.end);
        (drawn.start as f64 * height, below as f64 * height)
    }

    /// The same for the table.
    pub(super) fn beyond_rows(&self, extent: Extent) -> (f64, f64) {
        Self::beyond(&self.rows, extent.rows, TABLE_ROW)
    }
}

fn scrolls_down(place: &Element) -> bool {
    place.scroll_height() > place.client_height() + 1
}

/// The rows of one height that are seen in a place that scrolls.
fn rows(place: &Element, height: f64, count: usize) -> Range<usize> {
    let top = f64::from(place.scroll_top());
    let bottom = top + f64::from(place.client_height());
    let first = whole(top / height) as usize;
    let last = whole(bottom / height) as usize + 1;
    first.saturating_sub(MORE).min(count)..(last + MORE).min(count)
}
