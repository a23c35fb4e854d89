//! Zooming and moving over a map of ten by three cells.

use super::*;

const BOARD: (u32, u32) = (10, 3);
const SCREEN: (f64, f64) = (898.0, 440.0);

fn fit() -> Frame {
    Camera::default().frame(BOARD, SCREEN)
}

#[track_caller]
fn near(a: f64, b: f64) {
    assert!((a - b).abs() < 1e-6, "{a} {b}");
}

#[test]
fn all_fits_with_its_axis() {
    let frame = fit();
    near(frame.cell_px, 898.0 / 10.44);
    near(frame.x, -34.0);
    near(frame.width, 1044.0);
    near(frame.y + frame.height / 2.0, 138.0);
    assert_eq!(frame.detail(), Detail::All);
}

#[test]
fn a_small_map_is_not_stretched() {
    let frame = Camera::default().frame((2, 2), (1000.0, 1000.0));
    near(frame.cell_px, 148.0);
    near(frame.x + frame.width / 2.0, 88.0);
    assert!(Camera::default().is_nearest((2, 2), (1000.0, 1000.0)));
}

#[test]
fn small_cells_have_no_axis() {
    let frame = Camera::default().frame(BOARD, (358.0, 240.0));
    near(frame.cell_px, 35.2);
    near(frame.x, -RIM_PX * CELL / 35.2);
}

#[test]
fn small_cells_have_an_axis_where_the_screen_is_wide() {
    let floor = (40, 24);
    let frame = Camera::default().frame(floor, (900.0, 440.0));
    near(frame.cell_px, (440.0 - AXIS_PX - RIM_PX) / 24.0);
    near(frame.y, -frame.units(AXIS_PX));
    assert_eq!(frame.axis(), Some(5));
    let phone = Camera::default().frame(floor, (358.0, 240.0));
    near(phone.y + phone.height / 2.0, 1200.0);
    near(phone.cell_px, (358.0 - 2.0 * RIM_PX) / 40.0);
    assert_eq!(phone.axis(), None);
}

#[test]
fn an_area_without_size_does_no_harm() {
    let frame = Camera::default().frame((256, 256), (0.0, 0.0));
    assert!(frame.cell_px > 0.0 && frame.x.is_finite());
}

#[test]
fn zoom_keeps_the_point_under_the_pointer() {
    let at = (700.0, 200.0);
    let before = fit().point(at);
    let camera = Camera::default().zoom(1.5, at, BOARD, SCREEN);
    let after = camera.frame(BOARD, SCREEN);
    near(after.cell_px, 898.0 / 10.44 * 1.5);
    near(after.point(at).x, before.x);
    let back = camera.zoom(0.1, at, BOARD, SCREEN);
    assert!(back.is_fit());
    assert_eq!(back.frame(BOARD, SCREEN), fit());
}

#[test]
fn cells_grow_to_their_largest_only() {
    let camera = Camera::default().zoom(100.0, (0.0, 0.0), BOARD, SCREEN);
    near(camera.frame(BOARD, SCREEN).cell_px, 148.0);
    assert!(camera.is_nearest(BOARD, SCREEN));
}

#[test]
fn nothing_is_dragged_beyond_the_edge() {
    let near_by = Camera::default().zoom(1.6, (449.0, 220.0), BOARD, SCREEN);
    let left = near_by.pan((9999.0, 0.0), BOARD, SCREEN);
    near(left.frame(BOARD, SCREEN).x, -34.0);
    let back = left.pan((-10.0, 0.0), BOARD, SCREEN);
    let moved = back.frame(BOARD, SCREEN);
    near(moved.x, -34.0 + moved.units(10.0));
    assert_eq!(
        Camera::default()
            .pan((50.0, 50.0), BOARD, SCREEN)
            .frame(BOARD, SCREEN),
        fit()
    );
}

#[test]
fn a_cell_out_of_sight_is_shown() {
    let camera = Camera::default().zoom(1.7, (0.0, 220.0), BOARD, SCREEN);
    let shown = camera.show(Cell::new(9, 2), BOARD, SCREEN);
    let frame = shown.frame(BOARD, SCREEN);
    near(frame.x + frame.width, 1000.0);
    assert_eq!(
        shown
            .show(Cell::new(8, 1), BOARD, SCREEN)
            .frame(BOARD, SCREEN),
        frame
    );
}

#[test]
fn a_point_is_in_the_middle_as_far_as_the_map_goes() {
    let near_by = Camera::default().zoom(1.7, (0.0, 220.0), BOARD, SCREEN);
    let middle = |x| {
        let camera = near_by.centred(Point { x, y: 1.0 }, BOARD, SCREEN);
        let frame = camera.frame(BOARD, SCREEN);
        frame.x + frame.width / 2.0
    };
    near(middle(4.25), 475.0);
    near(
        middle(9.0),
        1010.0 - near_by.frame(BOARD, SCREEN).width / 2.0,
    );
    assert!(
        Camera::default()
            .centred(Point { x: 4.0, y: 1.0 }, BOARD, SCREEN)
            .is_fit()
    );
}

#[test]
fn the_cells_in_sight() {
    assert_eq!(fit().cells(BOARD), ((0, 9), (0, 2)));
    let camera = Camera::default().zoom(1.7, (0.0, 220.0), BOARD, SCREEN);
    assert_eq!(camera.frame(BOARD, SCREEN).cells(BOARD).0, (0, 5));
}

#[test]
fn a_robot_that_is_looked_for_is_found() {
    let large = (256, 256);
    let cell = Cell::new(200, 100);
    let found = Camera::default().find(cell, large, SCREEN);
    let frame = found.frame(large, SCREEN);
    near(frame.cell_px, FOUND_PX);
    let middle = frame.point((SCREEN.0 / 2.0, SCREEN.1 / 2.0));
    near(middle.x, 200.0);
    near(middle.y, 100.0);
    // What is in sight and large enough stays where it is; else it comes to the middle.
    assert_eq!(found.find(Cell::new(201, 101), large, SCREEN), found);
    let other = found.find(Cell::new(20, 200), large, SCREEN);
    near(other.frame(large, SCREEN).cell_px, FOUND_PX);
    assert!(other.frame(large, SCREEN).x < 100.0);
    let small = Camera::default();
    assert_eq!(small.find(Cell::new(9, 2), BOARD, SCREEN), small);
}
