//! The floor in tiles: each shape as it was in one, and little drawn anew.

mod path;

use std::rc::Rc;

use giveway_model::{Agent, Cell, Ground, Scene};

use super::*;
use giveway_picture::{Pen, Region, lines};
use path::{crossings, is_inside, points};

const FINE: f64 = 60.0;
const COARSE: f64 = 2.0;

fn draft(rows: Vec<String>) -> Rc<Draft> {
    let scene = Scene {
        map: rows,
        ..Scene::default()
    };
    Rc::new(Draft::new(scene).unwrap())
}

fn of(rows: &[&str], cell_px: f64) -> Floor {
    let rows = rows.iter().map(|&row| row.to_owned()).collect();
    Floor::new(&draft(rows), FloorLook::of(cell_px))
}

/// All that a layer draws.
fn shape(floor: &Floor, layer: Layer) -> String {
    let bands = floor.bands().iter();
    let shapes = bands.flat_map(|band| band.shapes(layer).map(|(_, shape)| shape.to_string()));
    shapes.collect()
}

#[test]
fn a_charger_in_the_slow_zone_is_part_of_both() {
    let floor = of(&["~*~"], FINE);
    assert_eq!(shape(&floor, Layer::SlowTint), "M0 0H300V100H0V0Z");
    assert!(shape(&floor, Layer::Slow).starts_with("M18 4H282a14 14"));
    assert!(shape(&floor, Layer::Charger).starts_with("M123 7h54"));
    assert!(shape(&floor, Layer::Bolt).starts_with("M155 20"));
    assert_eq!(shape(&floor, Layer::Obstacle), "");
}

#[test]
fn small_cells_are_plain() {
    let floor = of(&["#+."], COARSE);
    assert_eq!(shape(&floor, Layer::Obstacle), "M0 0H100V100H0V0Z");
    assert_eq!(shape(&floor, Layer::Charger), "M100 0H200V100H100V0Z");
    for layer in [Layer::ObstacleEdge, Layer::Bolt] {
        assert_eq!(shape(&floor, layer), "");
    }
}

#[test]
fn lines_part_cells() {
    assert_eq!(lines(2, 2, 1), "M100 0V200M0 100H200");
    assert_eq!(lines(1, 1, 1), "");
    assert_eq!(lines(11, 3, 5), "M500 0V300M1000 0V300");
}

#[test]
fn tiles_overlap_by_one_to_two_pixels() {
    let overlaps = [148.0, 60.0, 30.0, 13.0, 2.24, 1.4];
    let overlaps = overlaps.map(|px| FloorLook::of(px).overlap);
    assert_eq!(overlaps, [1, 2, 4, 8, 64, 100]);
}

#[test]
fn a_bolt_makes_way_for_a_star() {
    let plain = draft(vec!["++".to_owned()]);
    let scene = Scene {
        agents: vec![Agent {
            name: "A".to_owned(),
            start: Cell::new(0, 0),
            goal: Some(Cell::new(0, 0)),
            waypoints: vec![Cell::new(1, 0)],
            battery: None,
            heading: None,
        }],
        ..plain.scene().clone()
    };
    let starred = Rc::new(Draft::new(scene).unwrap());
    let floor = Floor::new(&plain, FloorLook::of(FINE)).renewed(&starred, FloorLook::of(FINE));
    let bolts = shape(&floor, Layer::Bolt);
    let bolts: Vec<&str> = bolts.split_inclusive('Z').collect();
    assert!(bolts[0].starts_with("M55 20l-25 35"), "{}", bolts[0]);
    assert!(bolts[1].starts_with("M122 12l-10 15"), "{}", bolts[1]);
}

/// A map with shapes of all kinds on all borders of tiles.
fn mixed(width: u32, height: u32) -> Vec<String> {
    let mut random = fastrand::Rng::with_seed(7);
    let mut row = || -> String {
        let cells = 0..width;
        cells
            .map(|_| ['#', '#', '.', '~', '+'][random.usize(..5)])
            .collect()
    };
    (0..height).map(|_| row()).collect()
}

/// The numbers of the tiles that are not those of another floor.
fn changed(before: &Floor, after: &Floor) -> Vec<(usize, usize)> {
    let mut changed = Vec::new();
    for (y, (old, new)) in before.bands.iter().zip(&after.bands).enumerate() {
        for (x, (old, new)) in old.0.iter().zip(&new.0).enumerate() {
            if !Rc::ptr_eq(old, new) {
                changed.push((x, y));
            }
        }
    }
    changed
}

fn painted(draft: &Draft, cell: Cell) -> Rc<Draft> {
    let mut grid = draft.grid().clone();
    assert!(grid.set_ground(cell, Ground::SlowCharger));
    self::draft(grid.rows())
}

#[test]
fn a_painted_cell_changes_one_tile_only() {
    let before = draft(vec![".".repeat(64); 40]);
    let floor = Floor::new(&before, FloorLook::of(FINE));
    let renewed = |x, y| {
        let after = painted(&before, Cell::new(x, y));
        let renewed = floor.renewed(&after, FloorLook::of(FINE));
        let whole = Floor::new(&after, FloorLook::of(FINE));
        assert_eq!(renewed.bands, whole.bands);
        changed(&floor, &renewed)
    };
    assert_eq!(renewed(20, 8), [(1, 0)]);
    // On a border also the tile beyond, and in a corner all four.
    assert_eq!(renewed(31, 8), [(1, 0), (2, 0)]);
    assert_eq!(renewed(16, 16), [(0, 0), (1, 0), (0, 1), (1, 1)]);
    assert_eq!(renewed(63, 39), [(3, 2)]);
}

#[test]
fn bands_without_a_change_are_the_same() {
    let before = draft(vec![".".repeat(64); 40]);
    let floor = Floor::new(&before, FloorLook::of(FINE));
    let after = floor.renewed(&painted(&before, Cell::new(5, 20)), FloorLook::of(FINE));
    let same = floor.bands.iter().zip(&after.bands);
    let same: Vec<bool> = same.map(|(old, new)| Rc::ptr_eq(old, new)).collect();
    assert_eq!(same, [true, false, true]);
}

#[test]
fn another_map_or_look_is_drawn_anew() {
    let small = of(&["#."], FINE);
    let large = draft(vec!["##.".to_owned()]);
    let renewed = small.renewed(&large, FloorLook::of(FINE));
    assert_eq!(renewed.bands, Floor::new(&large, FloorLook::of(FINE)).bands);
    let coarse = renewed.renewed(&large, FloorLook::of(COARSE));
    assert_eq!(
        coarse.bands,
        Floor::new(&large, FloorLook::of(COARSE)).bands
    );
}

#[test]
fn the_outlines_of_tiles_together_are_the_whole_outline() {
    let draft = draft(mixed(20, 19));
    for (cell_px, pens) in [(FINE, [(6, 16), (4, 14)]), (COARSE, [(0, 0), (0, 0)])] {
        let look = FloorLook::of(cell_px);
        let floor = Floor::new(&draft, look);
        let layers = [
            (Layer::Obstacle, Layer::ObstacleEdge, pens[0]),
            (Layer::Slow, Layer::SlowEdge, pens[1]),
        ];
        for (fill, edge, (inset, radius)) in layers {
            let pen = Pen {
                inset,
                radius,
                overlap: i64::from(look.overlap),
            };
            let area = Area {
                first: Cell::new(0, 0),
                size: (20, 19),
            };
            let whole = Region::new(area, |cell| {
                let ground = draft.grid().ground(cell);
                ground.is_some_and(|ground| match fill {
                    Layer::Slow => ground.is_slow(),
                    _ => ground == Ground::Obstacle,
                })
            });
            // The line that is drawn around what is filled is the same line.
            let lines = points(&whole.fill(pen));
            assert_eq!(lines, points(&whole.edge(pen)));
            if look.is_fine {
                assert_eq!(lines, points(&shape(&floor, edge)), "{edge:?}");
            }
            let tiles = floor.bands().iter().flat_map(|band| band.shapes(fill));
            let tiles: Vec<_> = tiles.map(|(_, tile)| crossings(tile)).collect();
            let whole = crossings(&whole.fill(pen));
            for sample in samples() {
                let is_filled = tiles.iter().any(|tile| is_inside(tile, sample));
                assert_eq!(is_filled, is_inside(&whole, sample), "{fill:?} {sample:?}");
            }
        }
    }
}

/// Points all over the map, most of them near the borders of cells; none where a
/// line is straight.
fn samples() -> impl Iterator<Item = (f64, f64)> {
    let places = |cells: i32| {
        let within = [-8.7, -4.7, 0.7, 5.3, 47.1];
        (0..cells).flat_map(move |cell| within.map(|part| f64::from(100 * cell) + part))
    };
    places(19).flat_map(move |y| places(20).map(move |x| (x, y)))
}
