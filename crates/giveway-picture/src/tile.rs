//! The floor of a tile of the map, as few shapes.

use std::collections::BTreeSet;
use std::fmt::Write;
use std::rc::Rc;

use giveway_model::{Cell, Grid, Ground};

use crate::floor::{FloorLook, Layer};
use crate::outline::{Area, Pen, Region};

/// The `d` of the path of each layer.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Tile([Rc<str>; Layer::COUNT]);

impl Tile {
    /// The floor of an area; the bolts of chargers make way where a star lies on
    /// them.
    pub fn new(grid: &Grid, starred: &BTreeSet<Cell>, area: Area, look: FloorLook) -> Self {
        let region = |is_part: fn(Ground) -> bool| {
            Region::new(area, |cell| grid.ground(cell).is_some_and(is_part))
        };
        let pen = |inset: i64, radius: i64| {
            let (inset, radius) = if look.is_fine {
                (inset, radius)
            } else {
                (0, 0)
            };
            let overlap = i64::from(look.overlap);
            Pen {
                inset,
                radius,
                overlap,
            }
        };
        let slow = region(Ground::is_slow);
        let obstacles = region(|ground| ground == Ground::Obstacle);
        let (slow_pen, obstacle_pen) = (pen(4, 14), pen(6, 16));
        // A hatch is not opaque: where two overlap that would be seen.
        let overlap = if look.is_fine { 0 } else { slow_pen.overlap };
        let hatch = Pen {
            overlap,
            ..slow_pen
        };
        let mut shapes = [
            slow.fill(pen(0, 0)),
            slow.fill(hatch),
            String::new(),
            obstacles.fill(obstacle_pen),
            String::new(),
            String::new(),
            String::new(),
        ];
        if look.is_fine {
            shapes[Layer::SlowEdge as usize] = slow.edge(slow_pen);
            shapes[Layer::ObstacleEdge as usize] = obstacles.edge(obstacle_pen);
            let (plates, bolts) = chargers(grid, starred, area);
            shapes[Layer::Charger as usize] = plates;
            shapes[Layer::Bolt as usize] = bolts;
        } else {
            // Without lines around them shapes are all that is seen.
            shapes[Layer::Charger as usize] = region(Ground::is_charger).fill(pen(0, 0));
        }
        Self(shapes.map(Rc::from))
    }

    /// The `d` of the path of a layer; empty where there is nothing to draw.
    pub const fn shape(&self, layer: Layer) -> &Rc<str> {
        &self.0[layer as usize]
    }
}

/// A plate for each charger, and a bolt on it.
fn chargers(grid: &Grid, starred: &BTreeSet<Cell>, area: Area) -> (String, String) {
    let (mut plates, mut bolts) = (String::new(), String::new());
    for cell in area.cells().filter(|&cell| grid.is_charger(cell)) {
        let (x, y) = (100 * cell.x, 100 * cell.y);
        // Writing to a string cannot fail.
        let _ = write!(
            plates,
            "M{} {}h54a16 16 0 0 1 16 16v54a16 16 0 0 1-16 16h-54a16 16 0 0 1-16-16v-54a16 16 0 0 1 16-16Z",
            x + 23,
            y + 7,
        );
        let _ = if starred.contains(&cell) {
            // Smaller, in the upper left corner.
            write!(bolts, "M{} {}l-10 15h7l-2 11 11-16h-7Z", x + 22, y + 12)
        } else {
            write!(bolts, "M{} {}l-25 35h17l-5 26 27-38h-17Z", x + 55, y + 20)
        };
    }
    (plates, bolts)
}
